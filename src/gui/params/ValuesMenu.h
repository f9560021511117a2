#pragma once
#include "stromar/params/ParamTable.h"
#include <QString>
#include <functional>
#include <vector>

class QMenu;
class QWidget;

namespace stromar {

/// Several values that belong together: those of a level, of a bark, of the leaves.
struct ValueSet {
    QString title;        ///< that a user knows them by
    QString kind;         ///< sets of the same kind take each other's values: the names of group and section in the source
    std::vector<ParamRef> refs;
};

/// Entries that copy a set as lines of a .tree file, paste such lines, and keep sets under names of their own. Values of
/// one level go to another. `params` are the tree's; `assign` takes what is pasted, with a name for the step.
void addValuesMenu(QMenu& menu, const ValueSet& set, const CParams& params,
                   const std::function<void(const QString& text, const ParamValues& values)>& assign, QWidget* parent);

/// What of `text`, lines of a .tree file, a set takes: the rest is left out. Throws CInputError for lines that are none.
ParamValues valuesFor(const ValueSet& set, const ParamBlock& block, const std::string& text);

} // namespace stromar
