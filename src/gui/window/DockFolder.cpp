#include "window/DockFolder.h"
#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QSignalBlocker>
#include <QToolBar>
#include <algorithm>

namespace stromar {

CDockFolder::CDockFolder(QMainWindow& window, std::vector<QDockWidget*> docks, QDockWidget* shrinks, int version)
    : QObject(&window), m_window(window), m_docks(std::move(docks)), m_shrinks(shrinks), m_bar(new QToolBar(tr("Folded docks"))), m_version(version) {
    m_bar->setObjectName(QStringLiteral("foldedDocks"));
    m_bar->setMovable(false);
    m_bar->toggleViewAction()->setVisible(false);
    for (QDockWidget* dock : m_docks) {
        QAction* action = m_bar->addAction(QIcon(QStringLiteral(":/icons/%1.svg").arg(dock->objectName())), dock->windowTitle());
        action->setObjectName(QStringLiteral("fold:") + dock->objectName());
        action->setCheckable(true);
        connect(action, &QAction::toggled, this, [this, dock](bool on) { open(dock, on); });
        connect(dock, &QDockWidget::visibilityChanged, action, [dock, action] {
            const QSignalBlocker quiet(action);
            action->setChecked(!dock->isHidden());
        });
    }
    m_window.addToolBar(Qt::LeftToolBarArea, m_bar);
    m_bar->hide();
}

void CDockFolder::follow() {
    const bool narrow = m_window.width() < kNarrow;
    if (narrow == m_folded) return;
    narrow ? fold() : unfold();
}

void CDockFolder::followLayout() {
    m_folded = false;
    m_bar->hide();
    follow();
}

void CDockFolder::fold() {
    m_wide = m_window.saveState(m_version);
    m_folded = true;
    m_hidden.clear();
    for (QDockWidget* dock : m_docks) {
        if (dock->isHidden() || dock->isFloating()) continue;
        if (!dock->visibleRegion().isEmpty()) m_front = dock;
        m_hidden.push_back(dock);
    }
    for (QDockWidget* dock : m_hidden) dock->hide();
    m_bar->show();
    m_shrinkWidth = m_shrinks->width();
    m_window.resizeDocks({m_shrinks}, {m_shrinks->minimumSizeHint().width()}, Qt::Horizontal);
}

void CDockFolder::unfold() {
    m_folded = false;
    m_bar->hide();
    for (QDockWidget* dock : m_hidden) dock->show();
    if (m_front) m_front->raise();
    m_window.resizeDocks({m_shrinks}, {std::max(m_shrinkWidth, m_shrinks->sizeHint().width())}, Qt::Horizontal);
}

void CDockFolder::show(QDockWidget* dock) {
    m_folded ? open(dock, true) : dock->show();
    dock->raise();
}

/// One at a time.
void CDockFolder::open(QDockWidget* dock, bool on) {
    for (QDockWidget* other : m_docks)
        if (other != dock && !other->isFloating()) other->hide();
    dock->setVisible(on);
}

QByteArray CDockFolder::layout() const { return m_folded ? m_wide : m_window.saveState(m_version); }

} // namespace stromar
