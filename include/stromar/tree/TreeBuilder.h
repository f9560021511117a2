#pragma once
#include "stromar/params/ParamTable.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <memory>

namespace stromar {

/// A way to grow a tree from parameters.
class ITreeBuilder {
public:
    virtual ~ITreeBuilder() = default;

    /// Grows the tree. Generations before `firstInvalid` are taken over from `previous`, which was grown by the same
    /// builder from parameters that differ only as invalidationOf() says; null grows everything. Throws CCancelled.
    virtual std::shared_ptr<const CTree> build(const CParams& params, const CTree* previous, int firstInvalid,
                                               const CProgress& progress) const = 0;
};

/// The model of Weber & Penn, "Creation and Rendering of Realistic Trees", SIGGRAPH '95.
class CWeberPennBuilder : public ITreeBuilder {
public:
    /// `varied` false replaces every random number by its middle value.
    explicit CWeberPennBuilder(bool varied = true) : m_varied(varied) {}

    std::shared_ptr<const CTree> build(const CParams& params, const CTree* previous, int firstInvalid,
                                       const CProgress& progress) const override;

private:
    bool m_varied;
};

/// The height of the tree that a seed gives, metres (Weber & Penn §4.3).
double scaleOfTree(const CParams& params, bool varied);

} // namespace stromar
