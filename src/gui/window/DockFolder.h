#pragma once
#include <QByteArray>
#include <QObject>
#include <vector>

class QDockWidget;
class QMainWindow;
class QToolBar;

namespace stromar {

/// Gives the picture room in a narrow window: the docks at the left fold to a bar of their names, from which one at a time
/// comes back. In a wide window they stand as the user had them.
class CDockFolder : public QObject {
    Q_OBJECT
public:
    static constexpr int kNarrow = 1200; ///< pixels: narrower windows fold

    /// `shrinks` is no wider than it must be in a narrow window. `version`: of the window's layouts.
    CDockFolder(QMainWindow& window, std::vector<QDockWidget*> docks, QDockWidget* shrinks, int version);

    /// After the window's size has changed.
    void follow();
    bool folded() const { return m_folded; }
    /// Brings a dock to the front, unfolded where it is folded.
    void show(QDockWidget* dock);
    /// After all docks have got another layout.
    void followLayout();
    /// The layout of the wide window, also while it is folded.
    QByteArray layout() const;

private:
    void fold();
    void unfold();
    void open(QDockWidget* dock, bool on);

    QMainWindow& m_window;
    std::vector<QDockWidget*> m_docks;
    std::vector<QDockWidget*> m_hidden; ///< by folding
    QDockWidget* m_front = nullptr;     ///< of the wide window
    QDockWidget* m_shrinks;
    QToolBar* m_bar;
    QByteArray m_wide;
    int m_version, m_shrinkWidth = 0;
    bool m_folded = false;
};

} // namespace stromar
