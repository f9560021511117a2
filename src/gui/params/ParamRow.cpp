#include "params/ParamRow.h"
#include "params/HelpPictures.h"
#include "params/ParamEditor.h"
#include "window/QtText.h"
#include "stromar/params/TreeFile.h"
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

namespace stromar {

namespace {
constexpr int kLabelAir = 4; // pixels

/// What a row wants to say about itself without words: changed since it was saved, locked.
class CMark : public QWidget {
public:
    explicit CMark(QWidget* parent) : QWidget(parent) { setFixedSize(16, 16); }
    void show(bool changed, bool locked) {
        m_changed = changed;
        m_locked = locked;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        if (m_changed) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(palette().color(QPalette::Active, QPalette::Highlight));
            painter.drawEllipse(QPointF(m_locked ? 3 : 8, 8), 3, 3);
        }
        if (!m_locked) return;
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1.4));
        painter.setBrush(Qt::NoBrush);
        painter.drawArc(QRectF(8.4, 2.6, 5.2, 7), 0, 180 * 16);
        painter.setBrush(palette().color(QPalette::WindowText));
        painter.drawRoundedRect(QRectF(7, 7, 8, 6.4), 1, 1);
    }

private:
    bool m_changed = false, m_locked = false;
};


/// The values of lines of a .tree file; none when they cannot be read.
ParamValues pasted(const std::string& text, const ParamBlock& block) {
    try {
        return CTreeFile::parse("Method = " + std::string(block.method) + "\n" + text, "clipboard").givenValues();
    } catch (const CInputError&) {
        return {};
    }
}
} // namespace

CParamRow::CParamRow(const ParamRef& ref, QWidget* parent)
    : QWidget(parent), m_mark(new CMark(this)), m_label(new QLabel) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    m_label->setText(trText(ref.info->label));
    m_label->setWordWrap(false);
    m_label->installEventFilter(this);
    row->addWidget(m_mark);
    row->addWidget(m_label);
    addEditor(new CParamEditor(ref));
    if (!ref.info->numeric()) row->setAlignment(m_label, Qt::AlignTop);
    m_label->setVisible(!m_editors.front()->language()); // it needs the width
    if (const ParamInfo* variation = variationOf(*ref.info))
        addEditor(new CParamEditor({variation, ref.level}, CParamEditor::Form::Variation));
    setToolTip(helpText());
}

void CParamRow::addEditor(CParamEditor* editor) {
    static_cast<QHBoxLayout*>(layout())->addWidget(editor, m_editors.empty() ? 1 : 0);
    m_editors.push_back(editor);
    connect(editor, &CParamEditor::edited, this, &CParamRow::edited);
    connect(editor, &CParamEditor::released, this, &CParamRow::released);
    connect(editor, &CParamEditor::lineTouched, this, &CParamRow::lineTouched);
    connect(editor, &CParamEditor::rangeHeld, this, &CParamRow::rangeHeld);
}

const ParamRef& CParamRow::ref() const { return m_editors.front()->ref(); }

void CParamRow::show(const CParams& params, const CParams& saved) {
    m_params = params;
    m_saved = saved;
    m_marked = false;
    const ParamInfo* named = nullptr; // the first that has an effect
    for (CParamEditor* editor : m_editors) {
        const ParamRef& ref = editor->ref();
        editor->showValue(ref.value(params));
        editor->showTree(params);
        m_marked = m_marked || ref.differs(params, saved);
        const std::string_view why = inactiveReason(ref, params);
        if (editor->isEnabled() != why.empty()) editor->setEnabled(why.empty());
        if (editor == m_editors.front()) m_inactive = why.empty() ? QString() : trText(why);
        if (why.empty() && !named) named = ref.info;
    }
    if (named) m_inactive.clear();
    m_label->setEnabled(named);
    m_label->setText(trText((named ? named : ref().info)->label));
    static_cast<CMark*>(m_mark)->show(m_marked, m_locked);
}

void CParamRow::setLocked(bool locked) {
    m_locked = locked;
    static_cast<CMark*>(m_mark)->show(m_marked, m_locked);
}

bool CParamRow::matches(const QStringList& words, const QString& tab) const {
    QString text = tab + QLatin1Char(' ') + trText(ref().info->section);
    for (const CParamEditor* editor : m_editors)
        text +=
            QLatin1Char(' ') + trText(editor->ref().info->label) + QLatin1Char(' ') + toQString(editor->ref().key()) +
            QLatin1Char(' ') + trText(editor->ref().info->synonyms);
    return std::ranges::all_of(words, [&](const QString& w) { return text.contains(w, Qt::CaseInsensitive); });
}

int CParamRow::labelWidth() const { return fontMetrics().horizontalAdvance(trText(ref().info->label)) + kLabelAir; }

void CParamRow::setLabelWidth(int width) {
    m_label->setMinimumWidth(0); // a label measures itself by its text and what it had to be at least
    m_label->clear();
    m_label->setText(fontMetrics().elidedText(trText(ref().info->label), Qt::ElideRight, width));
    m_label->setFixedWidth(width);
}

void CParamRow::setNarrow(bool narrow) {
    for (CParamEditor* editor : m_editors) editor->setNarrow(narrow);
    updateGeometry();
}

QString CParamRow::helpText() const {
    QString text;
    for (const CParamEditor* editor : m_editors) {
        const ParamRef& ref = editor->ref();
        text += QStringLiteral("<p><b>%1</b> (%2)<br>%3</p>")
                    .arg(trText(ref.info->label).toHtmlEscaped(), toQString(ref.key()),
                         trText(ref.info->help).toHtmlEscaped());
    }
    return text;
}

void CParamRow::showToolTip(const QPoint& at) {
    QString text = helpText();
    if (!m_inactive.isEmpty())
        text.prepend(QStringLiteral("<p><i>%1</i></p>").arg(tr("Without effect: %1").arg(m_inactive).toHtmlEscaped()));
    QToolTip::showText(at,
                       QStringLiteral("<table width=340><tr><td>%1</td></tr></table>")
                           .arg(text + helpPictureHtml(ref(), palette(), devicePixelRatioF())),
                       this);
}

bool CParamRow::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    showToolTip(static_cast<QHelpEvent*>(event)->globalPos());
    return true;
}

bool CParamRow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_label && event->type() == QEvent::MouseButtonDblClick) reset();
    return QWidget::eventFilter(watched, event);
}

/// Takes the row's values from other parameters, as one step.
void CParamRow::assign(const QString& text, const CParams& from) {
    ParamValues values;
    for (const CParamEditor* editor : m_editors) values.emplace_back(editor->ref(), editor->ref().value(from));
    emit assigned(text, values);
}

void CParamRow::reset() { assign(tr("Reset %1").arg(toQString(ref().key())), CParams(m_params.block())); }

/// As lines of a .tree file, which paste reads.
void CParamRow::copy() const {
    std::vector<ParamRef> refs;
    for (const CParamEditor* editor : m_editors) refs.push_back(editor->ref());
    QGuiApplication::clipboard()->setText(toQString(CTreeFile::lines(m_params, refs)));
}

/// The copied values, given to the rows of the same kind at this or another level.
void CParamRow::addPasteMenu(QMenu& menu) {
    const ParamValues copied = pasted(QGuiApplication::clipboard()->text().toStdString(), m_params.block());
    const bool fits = !copied.empty() && copied.front().first.info == ref().info;
    const auto pasteTo = [this, copied](int level) {
        auto values = copied;
        for (auto& [to, value] : values) to.level = level;
        emit assigned(tr("Paste %1").arg(toQString(values.front().first.key())), values);
    };
    QAction* paste = menu.addAction(tr("&Paste"), this, [this, pasteTo] { pasteTo(ref().level); });
    paste->setEnabled(fits);
    if (!ref().info->perLevel()) return;
    QMenu* levels = menu.addMenu(tr("Copy to &Level"));
    for (int level = ref().info->firstLevel; level < kParamLevels; ++level) {
        if (level == ref().level) continue;
        levels->addAction(levelTitle(level), this, [this, level] {
            ParamValues values;
            for (const CParamEditor* editor : m_editors)
                values.emplace_back(ParamRef{editor->ref().info, level}, editor->ref().value(m_params));
            emit assigned(tr("Paste %1").arg(toQString(values.front().first.key())), values);
        });
    }
}

void CParamRow::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu;
    const bool isDefault = std::ranges::all_of(
        m_editors, [&](const CParamEditor* e) { return e->ref().value(m_params) == defaultOf(e->ref(), m_params.block()); });
    menu.addAction(tr("&Reset to Default"), this, &CParamRow::reset)->setEnabled(!isDefault);
    menu.addAction(tr("Back to the &Saved Value"), this,
                   [this] { assign(tr("Saved %1").arg(toQString(ref().key())), m_saved); })
        ->setEnabled(m_marked);
    menu.addSeparator();
    menu.addAction(tr("&Copy"), this, &CParamRow::copy);
    addPasteMenu(menu);
    menu.addSeparator();
    QAction* lock = menu.addAction(tr("&Lock against Randomise"));
    lock->setCheckable(true);
    lock->setChecked(m_locked);
    connect(lock, &QAction::toggled, this, &CParamRow::lockToggled);
    menu.exec(event->globalPos());
}

} // namespace stromar
