#include "params/LanguageEditor.h"
#include "document/Gesture.h"
#include "params/CodeEditor.h"
#include "params/DefineSlider.h"
#include "window/Keys.h"
#include "window/QtText.h"
#include "window/SearchField.h"
#include "stromar/params/ParamText.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include <QEvent>
#include <QFileDialog>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace stromar {

namespace {
constexpr int kTypedMs = 350;  // from the last key until the text is read
constexpr int kTypingMs = 2000; // typing that pauses longer is another step of the history
constexpr int kStepMs = 150;
} // namespace

CLanguageEditor::CLanguageEditor(const TextLanguage& language, QWidget* parent)
    : QWidget(parent), m_language(language), m_inner(new QWidget), m_code(new CCodeEditor(language)),
      m_find(new CSearchField(tr("Find"))), m_problems(new QListWidget), m_sliderColumn(new QVBoxLayout), m_step(new QSpinBox),
      m_rules(new QLabel), m_word(new QPlainTextEdit), m_reader(*this) {
    m_code->setObjectName(QStringLiteral("code"));
    m_code->installEventFilter(this);
    m_problems->setObjectName(QStringLiteral("problems"));
    m_problems->setAccessibleName(tr("What is wrong"));
    m_problems->setWordWrap(true);
    m_problems->hide();
    m_sliderColumn->setSpacing(2);
    auto* column = new QVBoxLayout(m_inner);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    column->addWidget(makeToolBar());
    column->addWidget(m_code, 1);
    column->addWidget(m_problems);
    column->addLayout(m_sliderColumn);
    column->addWidget(makeSteps());
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(m_inner);
    m_typed.setSingleShot(true);
    m_typed.setInterval(kTypedMs);
    m_stepPause.setSingleShot(true);
    m_stepPause.setInterval(kStepMs);
    connect(&m_typed, &QTimer::timeout, this, &CLanguageEditor::check);
    connect(&m_stepPause, &QTimer::timeout, this, &CLanguageEditor::readStep);
    connect(m_code, &QPlainTextEdit::textChanged, this, &CLanguageEditor::onTyped);
    connect(m_code, &QPlainTextEdit::cursorPositionChanged, this, &CLanguageEditor::tellLine);
    connect(m_problems, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        const auto& fault = m_code->faults()[static_cast<std::size_t>(m_problems->row(item))];
        m_code->goTo(fault.line, fault.column);
        m_code->setFocus();
    });
    connect(m_problems, &QListWidget::itemClicked, m_problems, &QListWidget::itemActivated);
}

CLanguageEditor::~CLanguageEditor() { delete m_window.data(); }

QWidget* CLanguageEditor::makeToolBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    m_find->setObjectName(QStringLiteral("find"));
    m_find->installEventFilter(this);
    row->addWidget(m_find, 1);
    const auto addButton = [&](const char* name, const QString& text, const QString& tip, auto&& does) {
        auto* button = new QToolButton;
        button->setObjectName(QLatin1String(name));
        button->setText(text);
        button->setToolTip(tip);
        connect(button, &QToolButton::clicked, this, does);
        row->addWidget(button);
    };
    addButton("import", tr("Import…"), tr("Take the text of a file"), [this] { importFile(); });
    addButton("export", tr("Export…"), tr("Write the text to a file of its own"), [this] { exportFile(); });
    addButton("detach", tr("Detach"), tr("Show the editor in a window of its own, or back in its tab"), [this] { setDetached(!detached()); });
    return bar;
}

QWidget* CLanguageEditor::makeSteps() {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 4, 0, 0);
    auto* row = new QHBoxLayout;
    m_step->setObjectName(QStringLiteral("step"));
    m_step->setPrefix(tr("Step") + QLatin1Char(' '));
    m_step->setAccessibleName(tr("Step"));
    m_rules->setWordWrap(true);
    m_rules->setObjectName(QStringLiteral("rules"));
    m_word->setObjectName(QStringLiteral("word"));
    m_word->setAccessibleName(tr("The word after this step"));
    m_word->setReadOnly(true);
    m_word->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_word->setWordWrapMode(QTextOption::WrapAnywhere);
    m_word->setFixedHeight(5 * fontMetrics().height());
    row->addWidget(m_step);
    row->addWidget(m_rules, 1);
    column->addLayout(row);
    column->addWidget(m_word);
    connect(m_step, &QSpinBox::valueChanged, &m_stepPause, qOverload<>(&QTimer::start));
    return box;
}

void CLanguageEditor::showText(const QString& text) {
    m_committed = text;
    m_code->showText(text);
    m_typed.stop();
    check();
}

void CLanguageEditor::showParams(const CParams& params) {
    if (m_params && *m_params == params) return;
    m_params = std::make_unique<CParams>(params);
    const int steps = static_cast<int>(findParam(std::string(m_language.steps), params.block())->get(params));
    const bool atEnd = m_step->value() == m_step->maximum();
    m_step->setMaximum(steps);
    m_step->setSuffix(tr(" of %1").arg(steps));
    if (atEnd && m_step->value() == 0) m_step->setValue(std::min(1, steps));
    m_stepPause.start();
}

void CLanguageEditor::tellLine() {
    if (!m_code->hasFocus() || m_code->currentLine() == m_line) return;
    m_line = m_code->currentLine();
    emit lineTouched(m_line);
}

// What is typed.

void CLanguageEditor::onTyped() {
    m_typed.start();
    m_code->markLine(0);
}

/// Reads the text; what is right becomes the document's.
void CLanguageEditor::check() {
    m_code->showFaults(m_language.faults(m_code->toPlainText().toStdString()));
    showFaults();
    const bool isWrong = std::ranges::any_of(m_code->faults(), [](const auto& f) { return f.severity == Severity::Error; });
    if (isWrong) return;
    updateSliders();
    if (m_code->toPlainText() != m_committed) commit();
}

void CLanguageEditor::commit() {
    if (m_gesture == 0 || !m_sinceCommit.isValid() || m_sinceCommit.elapsed() > kTypingMs) m_gesture = nextGesture();
    m_sinceCommit.start();
    m_committed = m_code->toPlainText();
    emit edited(m_committed, m_gesture);
}

void CLanguageEditor::showFaults() {
    m_problems->clear();
    for (const TextLanguage::Fault& fault : m_code->faults())
        m_problems->addItem(QStringLiteral("%1:%2  %3").arg(fault.line).arg(fault.column).arg(toQString(fault.text)));
    const int rows = std::min(3, m_problems->count());
    m_problems->setFixedHeight(rows * 2 * fontMetrics().height() + 6);
    m_problems->setVisible(rows > 0);
}

/// Ctrl+Z takes back letters that are not yet the document's; after that it is the document's.
bool CLanguageEditor::eventFilter(QObject* watched, QEvent* event) {
    const auto* key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride ? static_cast<QKeyEvent*>(event) : nullptr;
    if (watched == m_code && event->type() == QEvent::FocusOut) {
        m_line = 0;
        emit lineTouched(0);
        if (m_typed.isActive()) {
            m_typed.stop();
            check();
        }
        m_gesture = 0;
    }
    if (watched == m_code && event->type() == QEvent::FocusIn) QTimer::singleShot(0, this, &CLanguageEditor::tellLine);
    if (watched == m_window && event->type() == QEvent::Close) {
        setDetached(false);
        return true;
    }
    if (!key) return QWidget::eventFilter(watched, event);
    const bool isHistory = isUndo(*key);
    if (watched == m_code && isHistory && m_code->toPlainText() == m_committed) {
        event->ignore(); // the document's
        return true;
    }
    const bool finds = key->matches(QKeySequence::Find) || key->matches(QKeySequence::FindNext);
    if (watched == m_code && finds && event->type() == QEvent::ShortcutOverride) {
        event->accept(); // not the panel's
        return true;
    }
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const bool isReturn = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (watched == m_code && key->matches(QKeySequence::Find)) {
        m_find->setFocus();
        m_find->selectAll();
        return true;
    }
    if (watched == m_find && isReturn) {
        find(key->modifiers() & Qt::ShiftModifier);
        return true;
    }
    if (watched == m_code && key->matches(QKeySequence::FindNext)) {
        find(false);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void CLanguageEditor::find(bool backwards) {
    const QTextDocument::FindFlags flags = backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
    if (m_find->text().isEmpty() || m_code->find(m_find->text(), flags)) return;
    QTextCursor cursor = m_code->textCursor(); // once more from the other end
    cursor.movePosition(backwards ? QTextCursor::End : QTextCursor::Start);
    m_code->setTextCursor(cursor);
    m_code->find(m_find->text(), flags);
}

// Sliders.

void CLanguageEditor::updateSliders() {
    const auto offered = m_language.sliders(m_code->toPlainText().toStdString());
    while (m_sliders.size() > offered.size()) {
        m_sliders.back()->deleteLater();
        m_sliders.pop_back();
    }
    while (m_sliders.size() < offered.size()) {
        auto* slider = new CDefineSlider;
        m_sliderColumn->addWidget(slider);
        m_sliders.push_back(slider);
        connect(slider, &CDefineSlider::moved, this, [this, slider](double value) { moveSlider(*slider, value); });
        connect(slider, &CDefineSlider::released, this, [this] {
            m_gesture = 0;
            emit released();
        });
    }
    for (std::size_t i = 0; i < offered.size(); ++i) m_sliders[i]->show(offered[i]);
}

/// Rewrites just that number.
void CLanguageEditor::moveSlider(const CDefineSlider& slider, double value) {
    std::string text = m_code->toPlainText().toStdString();
    for (const TextLanguage::Slider& now : m_language.sliders(text)) {
        if (now.name != slider.name()) continue;
        text.replace(now.at, now.length, numberText(value));
        break;
    }
    m_code->showText(toQString(text));
    m_typed.stop();
    check();
}

bool CLanguageEditor::held() const { return std::ranges::any_of(m_sliders, &CDefineSlider::held); }

// Files, and a window of its own.

void CLanguageEditor::importFile() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Import a Text"), {}, trText(m_language.files) + QStringLiteral(";;") + tr("All files (*)"));
    if (path.isEmpty()) return;
    try {
        m_code->showText(toQString(readFile(toPath(path))));
        m_typed.stop();
        check();
    } catch (const CError& e) {
        QMessageBox::critical(this, tr("Cannot import the text"), errorText(e));
    }
}

void CLanguageEditor::exportFile() {
    const QString suffix = toQString(m_language.suffix);
    QString path = QFileDialog::getSaveFileName(this, tr("Export the Text"), {}, trText(m_language.files));
    if (path.isEmpty()) return;
    if (!path.contains(QLatin1Char('.'))) path += QLatin1Char('.') + suffix;
    try {
        writeFile(toPath(path), m_code->toPlainText().toStdString());
    } catch (const CError& e) {
        QMessageBox::critical(this, tr("Cannot export the text"), errorText(e));
    }
}

void CLanguageEditor::setDetached(bool detach) {
    if (detach == detached()) return;
    if (detach) {
        m_window = new QWidget(window(), Qt::Window);
        m_window->setWindowTitle(m_code->accessibleName());
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        auto* column = new QVBoxLayout(m_window);
        column->addWidget(m_inner);
        m_window->installEventFilter(this);
        m_window->resize(760, 640);
        m_window->show();
    } else {
        layout()->addWidget(m_inner);
        m_window->removeEventFilter(this);
        m_window->deleteLater();
        m_window.clear();
    }
    m_inner->findChild<QToolButton*>(QStringLiteral("detach"))->setText(detach ? tr("Attach") : tr("Detach"));
    m_inner->show();
}

void CLanguageEditor::showLine(int line) { m_code->markLine(line); }

// Steps.

void CLanguageEditor::readStep() {
    if (!m_params || !m_inner->isVisible()) return;
    m_reader.cancel(); // words grow large
    m_reader.run([this, params = *m_params, step = m_step->value()](const CProgress& progress) -> CLatestTask::Then {
        TextLanguage::Step shown;
        try {
            shown = m_language.step(params, step, progress);
        } catch (const CCancelled&) {
            throw;
        } catch (const std::exception& e) {
            shown = {e.what(), 0, {}};
        }
        return [this, shown] { showStep(shown); };
    });
}

void CLanguageEditor::showStep(const TextLanguage::Step& step) {
    QString word = toQString(step.shown);
    if (step.more > 0) word += tr(" … %1 more").arg(QLocale().toString(qulonglong(step.more)));
    m_word->setPlainText(word);
    QStringList rules;
    for (const auto& [line, times] : step.applied)
        rules << tr("line %1 × %2").arg(line).arg(QLocale().toString(qulonglong(times)));
    m_rules->setText(rules.isEmpty() ? tr("No rule applies to this word.") : tr("To the next: %1").arg(rules.join(QStringLiteral(", "))));
}

} // namespace stromar
