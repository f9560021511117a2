#include "params/ParamPanel.h"
#include "params/CurveEditor.h"
#include "params/CurveGroup.h"
#include "params/LanguageEditor.h"
#include "params/ParamEditor.h"
#include "params/ParamRow.h"
#include "params/ValuesMenu.h"
#include "window/Keys.h"
#include "window/QtText.h"
#include "window/SearchField.h"
#include "stromar/app/Methods.h"
#include "stromar/mesh/LeafMeshes.h"
#include "stromar/params/BuiltInMesh.h"
#include "stromar/texture/Draw.h"
#include "stromar/util/Translatable.h"
#include <QAbstractButton>
#include <QApplication>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStyleOptionFocusRect>
#include <QStyleOptionTab>
#include <QStylePainter>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>
#include <functional>

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
            if (i == currentIndex()) painter.fillRect(QRect(tabRect(i).topLeft(), QSize(3, tabRect(i).height())), palette().highlight());
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

class CSideTabs : public QTabWidget {
public:
    CSideTabs() {
        setTabBar(new CSideTabBar);
        setTabPosition(QTabWidget::West);
    }
};

/// A heading that folds what stands below it.
class CFoldButton : public QAbstractButton {
public:
    explicit CFoldButton(const QString& text) {
        setText(text);
        setAccessibleName(text);
        setCheckable(true);
        setFocusPolicy(Qt::TabFocus);
        QFont bold = font();
        bold.setBold(true);
        setFont(bold);
    }
    QSize sizeHint() const override {
        return {fontMetrics().horizontalAdvance(text()) + 40, fontMetrics().height() + 12};
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QStylePainter painter(this);
        QStyleOption arrow;
        arrow.initFrom(this);
        arrow.rect = QRect(4, height() / 2 - 3, 10, 10);
        painter.drawPrimitive(isChecked() ? QStyle::PE_IndicatorArrowDown : QStyle::PE_IndicatorArrowRight, arrow);
        const QRect place = rect().adjusted(20, 6, 0, 0);
        painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft, text());
        const int end = 26 + fontMetrics().horizontalAdvance(text());
        painter.setPen(palette().color(QPalette::Mid));
        painter.drawLine(end, place.center().y() + 1, width(), place.center().y() + 1);
        if (!hasFocus()) return;
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        focus.rect = rect().adjusted(0, 5, -1, 0);
        painter.drawPrimitive(QStyle::PE_FrameFocusRect, focus);
    }
};

constexpr int kTouchMs = 80;
constexpr const char* kLockedKey = "panel/lockedOf"; // by tree
constexpr int kNarrowLabel = 104, kScrollBar = 20, kArrow = 12; // pixels
QString foldedKey(const QString& name) { return QStringLiteral("panel/folded/") + name; }
} // namespace

CParamPanel::CParamPanel(QWidget* parent) : QWidget(parent), m_filter(new CSearchField(tr("Find a parameter"))), m_nothing(new QLabel), m_tabs(new CSideTabs) {
    m_tabs->setAccessibleName(tr("Parameters"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 0);
    m_nothing->setWordWrap(true);
    m_nothing->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    auto* values = new QPushButton;
    values->setObjectName(QStringLiteral("values"));
    values->setText(tr("Values"));
    values->setToolTip(tr("Copies, pastes and keeps the values of this tab; a right click on a heading does it with what stands below"));
    values->setAutoDefault(false);
    auto* menu = new QMenu(values);
    values->setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        addValues(*menu, setOfTab(m_tabs->currentIndex()));
    });
    auto* top = new QHBoxLayout;
    top->addWidget(m_filter, 1);
    top->addWidget(values);
    column->addLayout(top);
    column->addWidget(m_tabs, 1);
    column->addWidget(m_nothing, 1);

    connect(m_filter, &QLineEdit::textChanged, this, &CParamPanel::updateVisibility);
    connect(qApp, &QApplication::focusChanged, &m_touch, qOverload<>(&QTimer::start));
    connect(&m_touch, &QTimer::timeout, this, &CParamPanel::updateTouched);
    m_touch.setSingleShot(true);
    m_touch.setInterval(kTouchMs);
    updateVisibility();
    const CParams defaults;
    showParams(defaults, defaults);
}

void CParamPanel::showBlock(const ParamBlock& block) {
    if (m_block == &block) return;
    m_block = &block;
    m_hovered = nullptr;
    m_rows.clear();
    m_lines.clear();
    m_sections.clear();
    m_groups.clear();
    m_leafRows.clear();
    m_leafSection.reset();
    m_wide = 0;
    while (m_tabs->count() > 0) {
        QWidget* tab = m_tabs->widget(0);
        m_tabs->removeTab(0);
        tab->deleteLater();
    }
    for (const ParamPage& page : pagesOf(block)) addTab(page);
    updateVisibility();
}

void CParamPanel::addTab(const ParamPage& shown) {
    auto* page = new QWidget;
    m_page = new QVBoxLayout(page);
    m_page->setContentsMargins(6, 4, 8, 8);
    m_page->setSpacing(3);
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_tabs->addTab(scroll, groupTitle(shown.group, shown.level));
    m_groups.emplace_back(shown.group, shown.level);
    const auto isVariation = [&](const ParamRef& ref) {
        return std::ranges::any_of(shown.rows, [&](const ParamRef& r) { return variationOf(*r.info) == ref.info; });
    };
    std::string_view section;
    for (const ParamRef& ref : shown.rows) {
        if (ref.info->unused() || !ref.info->shown || isVariation(ref)) continue;
        if (ref.info->section != section) addSection(ref.info->section);
        section = ref.info->section;
        if (ref.info->kind() == ParamKind::Text && !ref.info->block)
            addText(ref);
        else
            addRow(ref);
    }
    groupCurves();
    addLeafSection(shown);
    finishTab();
}

/// For the values of a level without stems that say where leaves stand.
void CParamPanel::addLeafSection(const ParamPage& page) {
    const auto levels = allParams(*m_block);
    if (page.group != Group::Leaves || std::ranges::none_of(levels, [](const ParamRef& ref) { return ref.info->placesLeaves; })) return;
    addSection(N_("Where they point"));
    m_leafSection = m_sections.size() - 1;
}

namespace {
/// That of a row's values which may place leaves; null where none does.
const CParamEditor* leafEditorOf(const CParamRow& row) {
    const auto found = std::ranges::find_if(row.editors(), [](const CParamEditor* editor) { return editor->ref().info->placesLeaves; });
    return found == row.editors().end() ? nullptr : *found;
}
} // namespace

void CParamPanel::placeLeafRows(const CParams& params) {
    if (!m_leafSection) return;
    for (const auto& [row, home] : m_leafRows) {
        const bool ofLeaves = methodOf(params).generationOf(leafEditorOf(*row)->ref(), params) == TreeMethod::kLeaves;
        Section &is = sectionOf(row), &wanted = m_sections[ofLeaves ? *m_leafSection : home];
        if (&is != &wanted) move(row, is, wanted);
    }
}

/// To its place in the order of all rows.
void CParamPanel::move(CParamRow* row, Section& from, Section& to) {
    const auto orderOf = [&](const QWidget* one) { return std::find(m_rows.begin(), m_rows.end(), one) - m_rows.begin(); };
    const auto next = std::ranges::find_if(to.rows, [&](const QWidget* other) { return orderOf(other) > orderOf(row); });
    QWidget* before = next == to.rows.begin() ? static_cast<QWidget*>(to.heading) : *(next - 1);
    auto* page = static_cast<QVBoxLayout*>(to.heading->parentWidget()->layout());
    page->insertWidget(page->indexOf(before) + 1, row);
    to.rows.insert(next, row);
    std::erase(from.rows, row);
    alignLabels(*page->parentWidget());
    updateVisibility();
}

CParamPanel::Section& CParamPanel::sectionOf(const QWidget* row) {
    return *std::ranges::find_if(m_sections, [&](const Section& section) { return std::ranges::find(section.rows, row) != section.rows.end(); });
}

/// Several curves of one section are one picture.
void CParamPanel::groupCurves() {
    for (const Section& section : m_sections) {
        if (section.tab != m_tabs->count() - 1) continue;
        std::vector<CCurveEditor*> curves;
        for (const QWidget* widget : section.rows)
            if (const auto* row = qobject_cast<const CParamRow*>(widget))
                if (CCurveEditor* curve = row->editors().front()->curve()) curves.push_back(curve);
        if (curves.size() < 2) continue;
        for (const CCurveEditor* curve : curves)
            connect(curve, &CCurveEditor::unfoldWanted, this, &CParamPanel::curveUnfolded, Qt::QueuedConnection);
        new CCurveGroup(std::move(curves), m_page->parentWidget());
    }
}

std::vector<CParamEditor*> CParamPanel::curves() const {
    std::vector<CParamEditor*> found;
    for (const CParamRow* row : m_rows)
        if (row->editors().front()->curve()) found.push_back(row->editors().front());
    return found;
}

/// One column for all labels of a tab.
void CParamPanel::alignLabels(const QWidget& page) const {
    int widest = 0;
    const auto ofPage = page.findChildren<CParamRow*>();
    for (const CParamRow* row : ofPage) widest = std::max(widest, row->labelWidth());
    if (m_narrow) widest = std::min(widest, kNarrowLabel);
    for (CParamRow* row : ofPage) {
        row->setLabelWidth(widest);
        row->setNarrow(m_narrow);
    }
}

void CParamPanel::setNarrow(bool narrow) {
    if (narrow == m_narrow) return;
    m_narrow = narrow;
    for (int tab = 0; tab < m_tabs->count(); ++tab) alignLabels(*m_tabs->widget(tab));
}

void CParamPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    setNarrow(width() < m_wide);
}

/// It is as narrow as its rows can be, and prefers the room that they like to have.
void CParamPanel::finishTab() {
    m_page->addStretch(1);
    auto* scroll = qobject_cast<QScrollArea*>(m_tabs->widget(m_tabs->count() - 1));
    const bool now = m_narrow;
    for (const bool narrow : {false, true}) {
        m_narrow = narrow;
        alignLabels(*m_page->parentWidget());
        m_page->invalidate();
        const int needed = m_page->minimumSize().width() + kScrollBar;
        if (narrow)
            scroll->setMinimumWidth(needed);
        else
            m_wide = std::max(m_wide, needed + m_tabs->tabBar()->sizeHint().width());
    }
    m_narrow = now;
    alignLabels(*m_page->parentWidget());
}

QSize CParamPanel::sizeHint() const { return {m_wide, QWidget::sizeHint().height()}; }

void CParamPanel::addSection(std::string_view title) {
    auto* heading = new CFoldButton(trText(title));
    const int tab = m_tabs->count() - 1;
    const QString name = QStringLiteral("%1/%2").arg(tab).arg(toQString(title));
    heading->setObjectName(name);
    heading->setChecked(!QSettings().value(foldedKey(name)).toBool());
    connect(heading, &QAbstractButton::toggled, this, [this, name](bool open) {
        QSettings().setValue(foldedKey(name), !open);
        updateVisibility();
    });
    heading->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(heading, &QWidget::customContextMenuRequested, this, [this, heading](const QPoint& at) {
        const auto section = std::ranges::find(m_sections, heading, &Section::heading);
        QMenu menu;
        addValues(menu, setOfSection(*section));
        menu.exec(heading->mapToGlobal(at));
    });
    m_page->addWidget(heading);
    m_sections.push_back({heading, tab, {}, {}});
}

void CParamPanel::addValues(QMenu& menu, const ValueSet& set) {
    addValuesMenu(menu, set, m_params, [this](const QString& text, const ParamValues& values) { emit assigned(text, values); }, this);
}

ValueSet CParamPanel::setOfTab(int tab) const {
    const auto& [group, level] = m_groups[std::size_t(tab)];
    ValueSet set{m_tabs->tabText(tab), toQString(group.name), {}};
    for (const Section& section : m_sections)
        if (section.tab == tab) set.refs.insert(set.refs.end(), section.refs.begin(), section.refs.end());
    return set;
}

ValueSet CParamPanel::setOfSection(const Section& section) const {
    const QString tab = m_tabs->tabText(section.tab);
    return {QStringLiteral("%1 ▸ %2").arg(tab, section.heading->text()),
            toQString(m_groups[std::size_t(section.tab)].first.name) + QLatin1Char(' ') + section.heading->objectName().section(QLatin1Char('/'), 1), section.refs};
}

void CParamPanel::addRow(const ParamRef& ref) {
    auto* row = new CParamRow(ref);
    row->installEventFilter(this);
    m_page->addWidget(row);
    m_sections.back().rows.push_back(row);
    for (const CParamEditor* editor : row->editors()) m_sections.back().refs.push_back(editor->ref());
    m_rows.push_back(row);
    if (leafEditorOf(*row)) m_leafRows.emplace(row, m_sections.size() - 1);
    connect(row, &CParamRow::edited, this, &CParamPanel::edited);
    connect(row, &CParamRow::assigned, this, &CParamPanel::assigned);
    connect(row, &CParamRow::released, this, &CParamPanel::released);
    connect(row, &CParamRow::lineTouched, this, &CParamPanel::lineTouched);
    connect(row, &CParamRow::rangeHeld, this, &CParamPanel::rangeHeld);
    connect(row, &CParamRow::lockToggled, this, [this, ref](bool locked) { setLocked(ref, locked); });
}

/// A line of text.
void CParamPanel::addText(const ParamRef& ref) {
    auto* line = new QLineEdit;
    line->setObjectName(toQString(ref.key()));
    line->setAccessibleName(trText(ref.info->label));
    auto* row = new QWidget;
    row->setToolTip(trText(ref.info->help));
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(20, 0, 0, 0);
    auto* label = new QLabel(trText(ref.info->label));
    label->setMinimumWidth(100);
    layout->addWidget(label);
    layout->addWidget(ref.info->file() ? makePathEditor(ref, line) : line, 1);
    m_page->addWidget(row);
    m_sections.back().rows.push_back(row);
    m_sections.back().refs.push_back(ref);
    m_lines.emplace_back(ref, line);
    line->installEventFilter(this);
    connect(line, &QLineEdit::editingFinished, this, [this, ref, line] {
        if (line->isModified()) emit edited(ref, line->text().toStdString(), 0);
        line->setModified(false);
    });
}

QWidget* CParamPanel::makePathEditor(const ParamRef& ref, QLineEdit* line) {
    line->setPlaceholderText(trText(ref.info->whenEmpty));
    line->setClearButtonEnabled(true);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* choose = new QToolButton;
    choose->setText(tr("Load…"));
    choose->setToolTip(ref.info->picture() ? tr("Choose a picture") : tr("Choose a mesh"));
    layout->addWidget(line, 1);
    layout->addWidget(choose);
    connect(choose, &QToolButton::clicked, this, [this, ref] { emit pathWanted(ref); });
    auto* drawn = new QToolButton;
    drawn->setPopupMode(QToolButton::InstantPopup);
    drawn->setMenu(makeBuiltInMenu(ref, drawn));
    drawn->setText(ref.info->picture() ? tr("Draw") : tr("Built in"));
    drawn->setToolTip(ref.info->picture() ? tr("A picture that Stromar draws; the words behind its name can be changed")
                                          : tr("A mesh that comes with Stromar"));
    drawn->setMinimumWidth(drawn->sizeHint().width() + kArrow);
    layout->addWidget(drawn);
    return row;
}

QMenu* CParamPanel::makeBuiltInMenu(const ParamRef& ref, QWidget* parent) {
    auto* menu = new QMenu(parent);
    const auto add = [&](std::string_view label, const std::string& text) {
        menu->addAction(trText(label), this, [this, ref, text] { emit edited(ref, text, 0); });
    };
    if (!ref.info->picture()) {
        for (const BuiltInLeaf& leaf : builtInLeaves()) add(leaf.label, std::string(kBuiltInMesh) + std::string(leaf.name));
        return menu;
    }
    const std::size_t start = ref.info->recipes.size() + 1;
    for (const std::string& recipe : plainRecipes(ref.info->recipes)) add(std::string_view(recipe).substr(start), recipe);
    menu->addSeparator();
    menu->addAction(tr("Texture Workshop…"), this, [this, ref] { emit workshopWanted(ref); });
    return menu;
}

void CParamPanel::showParams(const CParams& params, const CParams& saved) {
    showBlock(params.block());
    m_params = params;
    for (CParamRow* row : m_rows) row->show(params, saved);
    placeLeafRows(params);
    for (const auto& [text, line] : m_lines)
        if (const QString value = toQString(text.text(params)); line->text() != value) {
            line->setText(value);
            line->setCursorPosition(0);
        }
}

CParamRow* CParamPanel::row(const ParamRef& ref) const {
    const auto found = std::ranges::find_if(m_rows, [&](const CParamRow* row) {
        return std::ranges::any_of(row->editors(), [&](const CParamEditor* e) { return e->ref() == ref; });
    });
    return found == m_rows.end() ? nullptr : *found;
}

CParamEditor* CParamPanel::editor(const ParamRef& ref) const {
    const CParamRow* owner = row(ref);
    if (!owner) return nullptr;
    return *std::ranges::find_if(owner->editors(), [&](const CParamEditor* e) { return e->ref() == ref; });
}

bool CParamPanel::held() const {
    return std::ranges::any_of(
        m_rows, [](const CParamRow* row) { return std::ranges::any_of(row->editors(), &CParamEditor::held); });
}

bool CParamPanel::locked(const ParamRef& ref) const {
    const CParamRow* owner = row(ref);
    return owner && owner->locked();
}

void CParamPanel::showLocksOf(const QString& tree) {
    m_locksOf = tree;
    const QStringList keys = QSettings().value(QLatin1String(kLockedKey)).toMap().value(tree).toStringList();
    for (CParamRow* row : m_rows) row->setLocked(keys.contains(toQString(row->ref().key())));
}

void CParamPanel::setLocked(const ParamRef& ref, bool locked) {
    row(ref)->setLocked(locked);
    keepLocksFor(m_locksOf);
}

void CParamPanel::keepLocksFor(const QString& tree) {
    m_locksOf = tree;
    if (tree.isEmpty()) return; // until it is saved
    QStringList keys;
    for (const CParamRow* one : m_rows)
        if (one->locked()) keys << toQString(one->ref().key());
    QVariantMap all = QSettings().value(QLatin1String(kLockedKey)).toMap();
    all.insert(m_locksOf, keys);
    if (keys.isEmpty()) all.remove(m_locksOf);
    QSettings().setValue(QLatin1String(kLockedKey), all);
}

/// The filter reaches across all tabs: tabs without a hit disappear, folded sections open.
void CParamPanel::updateVisibility() {
    const QStringList words = m_filter->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<bool> hasHit(std::size_t(m_tabs->count()), words.empty());
    for (const Section& section : m_sections) {
        bool any = false;
        for (QWidget* widget : section.rows) {
            const auto* row = qobject_cast<CParamRow*>(widget);
            const bool hit = words.empty() || (row && row->matches(words, m_tabs->tabText(section.tab)));
            widget->setVisible(hit && (section.heading->isChecked() || !words.empty()));
            any = any || hit;
        }
        section.heading->setVisible(any);
        if (any) hasHit[std::size_t(section.tab)] = true;
    }
    for (int tab = 0; tab < m_tabs->count(); ++tab) m_tabs->setTabVisible(tab, hasHit[std::size_t(tab)]);
    const bool nothing = !words.empty() && std::ranges::none_of(hasHit, std::identity());
    m_tabs->setVisible(!nothing);
    m_nothing->setVisible(nothing);
    m_nothing->setText(tr("No parameter is called “%1”.").arg(m_filter->text().trimmed()));
}

int CParamPanel::tabOf(Group group, int level) const {
    const auto found = std::ranges::find(m_groups, std::pair(group, group == Group::Branches ? level : 0));
    return static_cast<int>(found - m_groups.begin());
}

void CParamPanel::showGeneration(int generation) {
    if (tabOf(Group::Branches) >= m_tabs->count()) return; // its values know no levels
    const int level = std::min(generation, kParamLevels - 1);
    m_tabs->setCurrentIndex(level == 0 ? tabOf(Group::Trunk) : tabOf(Group::Branches, level));
}

void CParamPanel::showLeaves() { m_tabs->setCurrentIndex(tabOf(Group::Leaves)); }

void CParamPanel::showCurves() {
    if (const auto all = curves(); !all.empty()) m_tabs->setCurrentIndex(tabOf(all.front()->ref().group(), all.front()->ref().level));
}

void CParamPanel::showParam(const ParamRef& ref) {
    CParamRow* shown = row(ref);
    m_tabs->setCurrentIndex(shown ? sectionOf(shown).tab : tabOf(ref.group(), ref.level));
    if (QWidget* first = editor(ref)->findChild<QWidget*>()) first->setFocus();
}

void CParamPanel::showLine(const ParamRef& ref, int line) {
    m_tabs->setCurrentIndex(tabOf(ref.group(), ref.level));
    if (CLanguageEditor* language = editor(ref)->language()) language->showLine(line);
}

bool CParamPanel::eventFilter(QObject* watched, QEvent* event) {
    if (const auto* line = qobject_cast<QLineEdit*>(watched)) {
        const bool isDocuments = event->type() == QEvent::ShortcutOverride && isUndo(*static_cast<QKeyEvent*>(event)) && !line->isModified();
        if (isDocuments) event->ignore();
        return isDocuments;
    }
    if (event->type() == QEvent::Enter || event->type() == QEvent::Leave) {
        auto* row = static_cast<CParamRow*>(watched);
        m_hovered = event->type() == QEvent::Enter ? row : m_hovered == row ? nullptr : m_hovered;
        m_touch.start();
    }
    return QWidget::eventFilter(watched, event);
}

void CParamPanel::updateTouched() {
    const QWidget* focus = QApplication::focusWidget();
    const auto holdsFocus = [focus](const CParamRow* row) { return focus && row->isAncestorOf(focus); };
    const auto focused = std::ranges::find_if(m_rows, holdsFocus);
    const CParamRow* row = m_hovered ? m_hovered : focused == m_rows.end() ? nullptr : *focused;
    emit touched(row ? std::optional(row->ref()) : std::nullopt);
}

} // namespace stromar
