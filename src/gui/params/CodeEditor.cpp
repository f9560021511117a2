#include "params/CodeEditor.h"
#include "window/QtText.h"
#include <QAbstractItemView>
#include <QCompleter>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStringListModel>
#include <QSyntaxHighlighter>
#include <QTextBlock>
#include <QToolTip>
#include <algorithm>

namespace stromar {

namespace {
constexpr int kFewLetters = 2; // of a word, before it is completed unasked

QColor colourOf(TextLanguage::Token token, const QPalette& palette) {
    const bool dark = palette.color(QPalette::Base).lightness() < 128;
    using Token = TextLanguage::Token;
    switch (token) {
    case Token::Comment: return dark ? QColor(0x8a, 0x9a, 0x84) : QColor(0x5f, 0x74, 0x58);
    case Token::Directive: return dark ? QColor(0xd7, 0x9c, 0xe0) : QColor(0x8a, 0x2c, 0x96);
    case Token::Number: return dark ? QColor(0x8f, 0xc4, 0xf2) : QColor(0x0b, 0x5c, 0xa8);
    case Token::Name: return dark ? QColor(0xe8, 0xc7, 0x86) : QColor(0x86, 0x58, 0x08);
    case Token::Turtle: return dark ? QColor(0x86, 0xd9, 0xc4) : QColor(0x04, 0x6f, 0x5e);
    case Token::Organ: return dark ? QColor(0xa5, 0xdd, 0x6f) : QColor(0x3d, 0x7a, 0x06);
    case Token::Bracket:
    case Token::Arrow: return dark ? QColor(0xf2, 0x9d, 0x83) : QColor(0xb0, 0x3a, 0x16);
    }
    return palette.color(QPalette::Text);
}

/// Where a byte of a line is, in QChars.
int charOf(const QString& line, std::size_t byte) {
    return static_cast<int>(QString::fromUtf8(line.toUtf8().left(static_cast<qsizetype>(byte))).size());
}

bool isWordLetter(QChar c) { return c.isLetterOrNumber() || c == QLatin1Char('_'); }
bool opens(QChar c) { return c == QLatin1Char('[') || c == QLatin1Char('('); }
bool closes(QChar c) { return c == QLatin1Char(']') || c == QLatin1Char(')'); }
} // namespace

class CCodeEditor::CGutter : public QWidget {
public:
    explicit CGutter(CCodeEditor* editor) : QWidget(editor), m_editor(editor) {}
    QSize sizeHint() const override { return {m_editor->gutterWidth(), 0}; }

protected:
    void paintEvent(QPaintEvent* event) override { m_editor->paintGutter(event); }

private:
    CCodeEditor* m_editor;
};

class CCodeEditor::CHighlighter : public QSyntaxHighlighter {
public:
    explicit CHighlighter(CCodeEditor& editor) : QSyntaxHighlighter(editor.document()), m_editor(editor) {}

protected:
    void highlightBlock(const QString& line) override {
        bool inComment = previousBlockState() == 1;
        const std::string letters = line.toStdString();
        for (const TextLanguage::Span& span : m_editor.m_language.spans(letters, inComment)) {
            const int first = charOf(line, span.first), end = charOf(line, span.first + span.length);
            QTextCharFormat format;
            format.setForeground(colourOf(span.token, m_editor.palette()));
            format.setFontItalic(span.token == TextLanguage::Token::Comment);
            setFormat(first, end - first, format);
        }
        setCurrentBlockState(inComment ? 1 : 0);
    }

private:
    const CCodeEditor& m_editor;
};

CCodeEditor::CCodeEditor(const TextLanguage& language, QWidget* parent)
    : QPlainTextEdit(parent), m_language(language), m_gutter(new CGutter(this)),
      m_highlighter(new CHighlighter(*this)), m_completer(new QCompleter(new QStringListModel(this), this)) {
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setTabChangesFocus(true);
    setMinimumHeight(14 * fontMetrics().height());
    m_completer->setWidget(this);
    m_completer->setCaseSensitivity(Qt::CaseSensitive);
    connect(m_completer, qOverload<const QString&>(&QCompleter::activated), this, &CCodeEditor::complete);
    connect(this, &QPlainTextEdit::blockCountChanged, this, [this] { setViewportMargins(gutterWidth(), 0, 0, 0); });
    connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& rect, int dy) {
        if (dy != 0)
            m_gutter->scroll(0, dy);
        else
            m_gutter->update(0, rect.y(), m_gutter->width(), rect.height());
    });
    connect(this, &QPlainTextEdit::cursorPositionChanged, this, &CCodeEditor::updateExtraSelections);
    setViewportMargins(gutterWidth(), 0, 0, 0);
}

void CCodeEditor::showText(const QString& text) {
    const QString old = toPlainText();
    if (old == text) return;
    qsizetype first = 0, oldEnd = old.size(), newEnd = text.size();
    while (first < std::min(oldEnd, newEnd) && old[first] == text[first]) ++first;
    while (oldEnd > first && newEnd > first && old[oldEnd - 1] == text[newEnd - 1]) --oldEnd, --newEnd;
    QTextCursor cursor(document());
    cursor.setPosition(static_cast<int>(first));
    cursor.setPosition(static_cast<int>(oldEnd), QTextCursor::KeepAnchor);
    cursor.insertText(text.mid(first, newEnd - first));
}

void CCodeEditor::showFaults(std::vector<TextLanguage::Fault> faults) {
    m_faults = std::move(faults);
    updateExtraSelections();
}

void CCodeEditor::markLine(int line) {
    m_markedLine = line;
    if (line > 0) goTo(line, 1);
    updateExtraSelections();
}

int CCodeEditor::positionOf(int line, int column) const {
    const QTextBlock block = document()->findBlockByNumber(std::max(0, line - 1));
    if (!block.isValid()) return 0;
    return block.position() + std::min(block.length() - 1, charOf(block.text(), static_cast<std::size_t>(std::max(0, column - 1))));
}

void CCodeEditor::goTo(int line, int column) {
    QTextCursor cursor(document());
    cursor.setPosition(positionOf(line, column));
    setTextCursor(cursor);
    centerCursor();
}

int CCodeEditor::matchingBracket(int at) const {
    const QChar own = document()->characterAt(at);
    if (!opens(own) && !closes(own)) return -1;
    const int way = opens(own) ? 1 : -1;
    const bool square = own == QLatin1Char('[') || own == QLatin1Char(']');
    const QChar open = QLatin1Char(square ? '[' : '('), close = QLatin1Char(square ? ']' : ')');
    int depth = 0;
    for (int i = at; i >= 0 && i < document()->characterCount(); i += way) {
        const QChar c = document()->characterAt(i);
        if (c == open) ++depth;
        if (c == close) --depth;
        if (depth == 0) return i;
    }
    return -1;
}

void CCodeEditor::updateExtraSelections() {
    QList<QTextEdit::ExtraSelection> all;
    const auto add = [&](int from, int to, const QTextCharFormat& format) {
        QTextEdit::ExtraSelection selection;
        selection.cursor = QTextCursor(document());
        selection.cursor.setPosition(from);
        selection.cursor.setPosition(to, QTextCursor::KeepAnchor);
        selection.format = format;
        all.push_back(selection);
    };
    QColor tint = palette().color(QPalette::Highlight);
    tint.setAlpha(60);
    if (m_markedLine > 0) {
        QTextCharFormat marked;
        marked.setBackground(tint);
        marked.setProperty(QTextFormat::FullWidthSelection, true);
        add(positionOf(m_markedLine, 1), positionOf(m_markedLine, 1), marked);
    }
    QTextCharFormat paired;
    paired.setBackground(tint);
    paired.setFontWeight(QFont::Bold);
    const int cursor = textCursor().position();
    for (const int at : {cursor, cursor - 1})
        if (const int other = at >= 0 ? matchingBracket(at) : -1; other >= 0) {
            add(at, at + 1, paired);
            add(other, other + 1, paired);
            break;
        }
    for (const TextLanguage::Fault& fault : m_faults) {
        QTextCharFormat wrong;
        wrong.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        wrong.setUnderlineColor(fault.severity == Severity::Error ? Qt::red : QColor(0xd0, 0x8a, 0x10));
        const int at = positionOf(fault.line, fault.column);
        const QTextBlock block = document()->findBlock(at);
        int end = at;
        while (end < block.position() + block.length() - 1 && isWordLetter(document()->characterAt(end))) ++end;
        if (end == at) end = std::min(at + 1, block.position() + block.length() - 1);
        add(end > at ? at : std::max(block.position(), at - 1), std::max(end, at), wrong);
    }
    setExtraSelections(all);
}

// The numbers of the lines.

int CCodeEditor::gutterWidth() const {
    const auto digits = QString::number(std::max(10, blockCount())).size();
    return 10 + fontMetrics().horizontalAdvance(QLatin1Char('9')) * static_cast<int>(digits);
}

void CCodeEditor::paintGutter(QPaintEvent* event) {
    QPainter painter(m_gutter);
    painter.fillRect(event->rect(), palette().color(QPalette::AlternateBase));
    painter.setFont(font());
    QTextBlock block = firstVisibleBlock();
    double top = blockBoundingGeometry(block).translated(contentOffset()).top();
    for (; block.isValid() && top <= event->rect().bottom(); block = block.next()) {
        const double height = blockBoundingRect(block).height();
        const int line = block.blockNumber() + 1;
        const bool wrong = std::ranges::any_of(m_faults, [&](const auto& f) { return f.line == line; });
        painter.setPen(wrong ? QColor(Qt::red) : palette().color(QPalette::PlaceholderText));
        painter.drawText(0, static_cast<int>(top), m_gutter->width() - 5, static_cast<int>(height), Qt::AlignRight, QString::number(line));
        top += height;
    }
}

void CCodeEditor::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    const QRect inner = contentsRect();
    m_gutter->setGeometry(inner.left(), inner.top(), gutterWidth(), inner.height());
}

void CCodeEditor::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) m_highlighter->rehighlight();
}

/// What is wrong under the mouse.
bool CCodeEditor::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QPlainTextEdit::event(event);
    auto* help = static_cast<QHelpEvent*>(event);
    const int line = cursorForPosition(viewport()->mapFromParent(help->pos())).blockNumber() + 1;
    const auto fault = std::ranges::find(m_faults, line, &TextLanguage::Fault::line);
    QToolTip::showText(help->globalPos(), fault == m_faults.end() ? QString() : toQString(fault->text), this);
    return true;
}

// Completion.

QString CCodeEditor::wordBegun() const {
    const QString line = textCursor().block().text();
    const int end = textCursor().positionInBlock();
    int start = end;
    while (start > 0 && (isWordLetter(line[start - 1]) || line[start - 1] == QLatin1Char('#') || line[start - 1] == QLatin1Char('~')))
        --start;
    return line.mid(start, end - start);
}

void CCodeEditor::keyPressEvent(QKeyEvent* event) {
    QAbstractItemView* popup = m_completer->popup();
    const bool chooses = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Tab ||
                         event->key() == Qt::Key_Escape;
    if (popup->isVisible() && chooses) return event->ignore(); // the list takes it
    const bool asked = event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier;
    if (!asked) QPlainTextEdit::keyPressEvent(event);
    if (asked || !event->text().isEmpty() || popup->isVisible()) offerWords(asked);
}

void CCodeEditor::offerWords(bool asked) {
    const QString begun = wordBegun();
    if (!asked && (begun.size() < kFewLetters || !isWordLetter(begun.back()))) return m_completer->popup()->hide();
    QStringList words;
    for (const std::string& word : m_language.words(toPlainText().toStdString())) words << toQString(word);
    words.removeAll(begun);
    static_cast<QStringListModel*>(m_completer->model())->setStringList(words);
    m_completer->setCompletionPrefix(begun);
    if (m_completer->completionCount() == 0) return m_completer->popup()->hide();
    m_completer->popup()->setCurrentIndex(m_completer->completionModel()->index(0, 0));
    QRect place = cursorRect().translated(gutterWidth(), 0);
    place.setWidth(m_completer->popup()->sizeHintForColumn(0) + 24);
    m_completer->complete(place);
}

void CCodeEditor::complete(const QString& word) {
    QTextCursor cursor = textCursor();
    cursor.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor, static_cast<int>(wordBegun().size()));
    cursor.insertText(word);
    setTextCursor(cursor);
}

} // namespace stromar
