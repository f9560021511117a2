#pragma once
#include <QMainWindow>

class QTextBrowser;

namespace stromar {

/// The manual: the pages of docs/, read from the program's data folder.
class CHelpWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit CHelpWindow(QWidget* parent = nullptr);
    /// A page by its file name without the ending.
    void open(const QString& page);
    /// False when the manual is not installed.
    static bool available();
    QTextBrowser& browser() { return *m_browser; }

private:
    QTextBrowser* m_browser;
};

} // namespace stromar
