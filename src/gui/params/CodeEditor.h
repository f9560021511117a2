#pragma once
#include "stromar/app/TextLanguage.h"
#include <QPlainTextEdit>
#include <vector>

class QCompleter;

namespace stromar {

/// A text editor for a language: coloured, with numbers of lines, brackets that are shown in pairs, words that complete
/// what was begun, and faults underlined where they are.
class CCodeEditor : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit CCodeEditor(const TextLanguage& language, QWidget* parent = nullptr);

    /// Replaces what differs, so that the cursor stays and the editor's own history goes on.
    void showText(const QString& text);
    void showFaults(std::vector<TextLanguage::Fault> faults);
    const std::vector<TextLanguage::Fault>& faults() const { return m_faults; }
    /// Lines and columns from 1; columns in bytes, as messages have them.
    void goTo(int line, int column);
    int currentLine() const { return textCursor().blockNumber() + 1; }
    /// Shows a line as the one that is meant; 0: none.
    void markLine(int line);
    QCompleter& completer() { return *m_completer; }
    /// The bracket that belongs to the one at the cursor, as a place in the text; −1: none.
    int matchingBracket(int at) const;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    class CGutter;
    class CHighlighter;

    int gutterWidth() const;
    void paintGutter(QPaintEvent* event);
    void updateExtraSelections();
    void offerWords(bool asked);
    void complete(const QString& word);
    QString wordBegun() const;
    int positionOf(int line, int column) const;

    const TextLanguage& m_language;
    CGutter* m_gutter;
    CHighlighter* m_highlighter;
    QCompleter* m_completer;
    std::vector<TextLanguage::Fault> m_faults;
    int m_markedLine = 0;
};

} // namespace stromar
