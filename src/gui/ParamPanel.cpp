#include "ParamPanel.h"
#include "ParamEditor.h"
#include "QtText.h"
#include <QFormLayout>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QStyleOptionFocusRect>
#include <QStyleOptionTab>
#include <QStylePainter>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>

namespace stromar {

namespace {
/// Tabs at the side with upright text: all eight are seen at once in a narrow panel.
class CSideTabBar : public QTabBar {
protected:
    QSize tabSizeHint(int) const override {
        int widest = 0;
        for (int i = 0; i < count(); ++i) widest = std::max(widest, fontMetrics().horizontalAdvance(tabText(i)));
        return {widest + fontMetrics().height(), 2 * fontMetrics().height()};
    }
    void paintEvent(QPaintEvent*) override {
        QStylePainter painter(this);
        for (int i = 0; i < count(); ++i) {
            QStyleOptionTab option;
            initStyleOption(&option, i);
            painter.drawControl(QStyle::CE_TabBarTabShape, option);
            const QRect text = tabRect(i).adjusted(fontMetrics().height() / 2, 0, 0, 0);
            painter.drawItemText(text, Qt::AlignVCenter | Qt::AlignLeft, palette(), isTabEnabled(i), tabText(i),
                                 QPalette::WindowText);
            if (i == currentIndex() && hasFocus()) {
                QStyleOptionFocusRect focus;
                focus.initFrom(this);
                focus.rect = tabRect(i).adjusted(3, 3, -3, -3);
                painter.drawPrimitive(QStyle::PE_FrameFocusRect, focus);
            }
        }
    }
};
} // namespace

CParamPanel::CParamPanel(QWidget* parent) : QTabWidget(parent) {
    setTabBar(new CSideTabBar);
    setTabPosition(QTabWidget::West);
    QFormLayout* tree = addTab(tr("Tree"));
    addTexts(tree, Group::Tree);
    addGlobals(tree, Group::Tree);
    QFormLayout* trunk = addTab(tr("Trunk"));
    addGlobals(trunk, Group::Trunk);
    addLevel(trunk, 0);
    for (int level = 1; level < kParamLevels; ++level) addLevel(addTab(tr("Branches %1").arg(level)), level);
    for (const Group group : {Group::Leaves, Group::Pruning, Group::Textures}) {
        QFormLayout* form = addTab(toQString(groupName(group)));
        addTexts(form, group);
        addGlobals(form, group);
    }
    showParams(CParams());
}

QFormLayout* CParamPanel::addTab(const QString& title) {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    form->setVerticalSpacing(4);
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    QTabWidget::addTab(scroll, title);
    m_section = {};
    return form;
}

void CParamPanel::addGlobals(QFormLayout* form, Group group) {
    // Rows of one section stay together, whatever order the table has.
    std::vector<ParamRef> refs;
    for (const ParamRef& ref : allParams())
        if (!ref.info->perLevel() && ref.group() == group && !ref.info->unused()) refs.push_back(ref);
    std::vector<std::string_view> sections;
    for (const ParamRef& ref : refs)
        if (std::ranges::find(sections, ref.info->section) == sections.end()) sections.push_back(ref.info->section);
    for (const std::string_view section : sections)
        for (const ParamRef& ref : refs)
            if (ref.info->section == section) addEditor(form, ref);
}

void CParamPanel::addLevel(QFormLayout* form, int level) {
    for (const ParamRef& ref : allParams())
        if (ref.info->perLevel() && ref.level == level) addEditor(form, ref);
}

void CParamPanel::addEditor(QFormLayout* form, const ParamRef& ref) {
    addHeading(form, ref.info->section);
    auto* editor = new CParamEditor(ref);
    auto* label = new QLabel(toQString(ref.info->label));
    label->setToolTip(editor->toolTip());
    form->addRow(label, editor);
    m_editors.push_back(editor);
    connect(editor, &CParamEditor::edited, this, &CParamPanel::edited);
    connect(editor, &CParamEditor::released, this, &CParamPanel::released);
}

void CParamPanel::addHeading(QFormLayout* form, std::string_view section) {
    if (section == m_section) return;
    m_section = section;
    auto* heading = new QLabel(QStringLiteral("<b>%1</b>").arg(toQString(section)));
    heading->setContentsMargins(0, form->rowCount() > 0 ? 10 : 0, 0, 2);
    form->addRow(heading);
}

void CParamPanel::addTexts(QFormLayout* form, Group group) {
    for (const TextInfo& text : textTable()) {
        if (text.group != group || text.field == &TextParams::method) continue; // there is only one method
        auto* line = new QLineEdit;
        line->setObjectName(toQString(text.key));
        line->setToolTip(toQString(text.help));
        line->setAccessibleName(toQString(text.label));
        form->addRow(toQString(text.label), text.path ? makePathEditor(text, line) : line);
        m_lines.emplace_back(&text, line);
        connect(line, &QLineEdit::editingFinished, this, [this, &text, line] {
            if (line->isModified()) emit textEdited(&text, line->text());
            line->setModified(false);
        });
    }
}

QWidget* CParamPanel::makePathEditor(const TextInfo& text, QLineEdit* line) {
    line->setPlaceholderText(tr("built in"));
    line->setClearButtonEnabled(true);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* choose = new QToolButton;
    choose->setText(tr("Load…"));
    choose->setToolTip(tr("Choose a picture"));
    layout->addWidget(line, 1);
    layout->addWidget(choose);
    connect(choose, &QToolButton::clicked, this, [this, &text] { emit pathWanted(&text); });
    return row;
}

void CParamPanel::showParams(const CParams& params) {
    for (CParamEditor* editor : m_editors) editor->showValue(editor->ref().get(params));
    for (const auto& [text, line] : m_lines)
        if (const QString value = toQString(params.text.*text->field); line->text() != value) {
            line->setText(value);
            line->setCursorPosition(0);
        }
}

CParamEditor* CParamPanel::editor(const ParamRef& ref) const {
    const auto found = std::ranges::find_if(m_editors, [&](const CParamEditor* e) { return e->ref() == ref; });
    return found == m_editors.end() ? nullptr : *found;
}

bool CParamPanel::held() const {
    return std::ranges::any_of(m_editors, [](const CParamEditor* e) { return e->held(); });
}

} // namespace stromar
