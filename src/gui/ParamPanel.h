#pragma once
#include "stromar/params/ParamTable.h"
#include <QTabWidget>
#include <vector>

class QFormLayout;
class QLineEdit;

namespace stromar {

class CParamEditor;

/// All values of a tree in tabs, made from the parameter table. Knows nothing of trees or files.
class CParamPanel : public QTabWidget {
    Q_OBJECT
public:
    explicit CParamPanel(QWidget* parent = nullptr);

    /// Shows the values without telling.
    void showParams(const CParams& params);
    CParamEditor* editor(const ParamRef& ref) const;
    /// Whether a slider is held.
    bool held() const;

signals:
    void edited(const stromar::ParamRef& ref, double value, int gesture);
    void released();
    void textEdited(const stromar::TextInfo* text, const QString& value);
    /// The user wants to choose a file for this path.
    void pathWanted(const stromar::TextInfo* text);

private:
    QFormLayout* addTab(const QString& title);
    void addGlobals(QFormLayout* form, Group group);
    void addLevel(QFormLayout* form, int level);
    void addTexts(QFormLayout* form, Group group);
    void addEditor(QFormLayout* form, const ParamRef& ref);
    void addHeading(QFormLayout* form, std::string_view section);
    QWidget* makePathEditor(const TextInfo& text, QLineEdit* line);

    std::vector<CParamEditor*> m_editors;
    std::vector<std::pair<const TextInfo*, QLineEdit*>> m_lines;
    std::string_view m_section;
};

} // namespace stromar
