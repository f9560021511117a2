// How the window is built: its parts, docks, menus and bars, and where they stand.
#include "window/MainWindow.h"
#include "document/FileController.h"
#include "library/PresetBrowser.h"
#include "library/Variants.h"
#include "motion/Timeline.h"
#include "motion/WindPanel.h"
#include "params/ParamPanel.h"
#include "view/LightPanel.h"
#include "view/SavedCameras.h"
#include "window/Commands.h"
#include "window/Display.h"
#include "window/DockFolder.h"
#include "window/MessageBar.h"
#include "window/Mnemonics.h"
#include "window/QtText.h"
#include "stromar/app/Methods.h"
#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QProgressBar>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoView>
#include <QVBoxLayout>

namespace stromar {

namespace {
QString tr2(const char* text) { return QCoreApplication::translate("Commands", text); }
QString switchKey(const QString& name) { return QStringLiteral("view/") + name; }
} // namespace

void CMainWindow::makeCentre() {
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_bar);
    if (QString why; display::available(why))
        column->addWidget(m_viewport, 1);
    else {
        m_withoutPicture.reset(m_viewport); // Qt fails when a window without OpenGL holds it
        auto* message = new QLabel(why);
        message->setObjectName(QStringLiteral("noPicture"));
        message->setAlignment(Qt::AlignCenter);
        message->setWordWrap(true);
        message->setMargin(40);
        column->addWidget(message, 1);
    }
    m_timeline->setObjectName(QStringLiteral("timeline"));
    column->addWidget(m_timeline);
    setCentralWidget(centre);
}

QDockWidget* CMainWindow::addDock(const char* name, const QString& title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(widget);
    addDockWidget(area, dock);
    return dock;
}

void CMainWindow::makeDocks() {
    setDockNestingEnabled(true);
    setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::West);
    QDockWidget* parameters = addDock("parameters", tr("Parameters"), m_panel, Qt::RightDockWidgetArea);
    QDockWidget* presets = addDock("presets", tr("Presets"), m_presets, Qt::LeftDockWidgetArea);
    auto* scroll = new QScrollArea;
    scroll->setWidget(m_variants);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QDockWidget* variants = addDock("variants", tr("Variants"), scroll, Qt::LeftDockWidgetArea);
    connect(variants, &QDockWidget::visibilityChanged, m_variants, &CVariants::setShown);
    auto* steps = new QUndoView(&m_document->history());
    steps->setEmptyLabel(tr("As opened"));
    steps->setAccessibleName(tr("History"));
    steps->setWordWrap(true);
    steps->setResizeMode(QListView::Adjust); // lines break anew
    QDockWidget* history = addDock("history", tr("History"), steps, Qt::LeftDockWidgetArea);
    m_light = new CLightPanel;
    QDockWidget* light = addDock("light", tr("Light"), m_light, Qt::LeftDockWidgetArea);
    QDockWidget* wind = addDock("windDock", tr("Wind"), m_wind, Qt::LeftDockWidgetArea);
    m_messages = new QListWidget;
    m_messages->setObjectName(QStringLiteral("messageList"));
    m_messages->setAlternatingRowColors(true);
    m_messages->setAccessibleName(tr("Messages of the file"));
    m_messageDock = addDock("messages", tr("Messages"), m_messages, Qt::BottomDockWidgetArea);
    m_messageDock->hide();
    tabifyDockWidget(presets, variants);
    tabifyDockWidget(variants, history);
    tabifyDockWidget(history, light);
    tabifyDockWidget(light, wind);
    presets->raise();
    resizeDocks({presets}, {200}, Qt::Horizontal);
    m_folder = new CDockFolder(*this, {presets, variants, history, light, wind}, parameters, kLayoutVersion);
}

QAction* CMainWindow::makeAction(const Command& command) {
    auto* action = new QAction(tr2(command.text), this);
    action->setObjectName(QLatin1String(command.name));
    action->setShortcut(QKeySequence(QLatin1String(command.shortcut)));
    action->setStatusTip(tr2(command.help));
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(key.isEmpty() ? tr2(command.help) : QStringLiteral("%1 (%2)").arg(tr2(command.help), key));
    action->setCheckable(command.kind != Command::Kind::Plain);
    if (*command.icon) action->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(command.icon))));
    const auto run = command.run;
    if (!action->isCheckable()) {
        connect(action, &QAction::triggered, this, [this, run] { run(*this, true); });
        return action;
    }
    const bool kept = command.kind == Command::Kind::KeptSwitch, grouped = *command.group;
    connect(action, &QAction::toggled, this, [this, run, kept, grouped, name = action->objectName()](bool on) {
        if (on || !grouped) run(*this, on);
        if (kept) QSettings().setValue(switchKey(name), on);
    });
    return action;
}

namespace {
/// The one of that title, perhaps new.
QMenu& submenuOf(QMenu& menu, const QString& title) {
    for (QAction* action : menu.actions())
        if (action->menu() && action->text() == title) return *action->menu();
    return *menu.addMenu(title);
}
} // namespace

void CMainWindow::makeActions() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    QMap<QString, QActionGroup*> groups;
    QMenu* menu = nullptr;
    Menu last = Menu::File;
    const char* lastSubmenu = "";
    for (const Command& command : commandTable()) {
        const bool newMenu = !menu || command.menu != last;
        if (newMenu) menu = menuBar()->addMenu(tr2(menuTitle(command.menu)));
        if (newMenu && command.menu == Menu::Window)
            for (QDockWidget* dock : findChildren<QDockWidget*>()) menu->addAction(dock->toggleViewAction());
        if (!menu->isEmpty() && command.startsGroup && (!*command.submenu || !*lastSubmenu)) menu->addSeparator();
        lastSubmenu = command.submenu;
        last = command.menu;
        QAction* action = makeAction(command);
        (*command.submenu ? submenuOf(*menu, tr2(command.submenu)) : *menu).addAction(action);
        if (*command.group) {
            QActionGroup*& group = groups[QLatin1String(command.group)];
            if (!group) group = new QActionGroup(this);
            if (group->actions().isEmpty()) action->setChecked(true);
            group->addAction(action);
        }
        if (command.onToolBar) {
            if (bar->actions().size() > 0 && (command.startsGroup || newMenu)) bar->addSeparator();
            bar->addAction(action);
        }
        if (QLatin1String(command.name) == QLatin1String("new")) addMethods(*menu);
        if (QLatin1String(command.name) == QLatin1String("open")) m_recentMenu = menu->addMenu(tr("Open &Recent"));
        if (QLatin1String(command.name) == QLatin1String("saveCamera")) m_cameras->addTo(*menu->addMenu(tr("Saved Cameras")));
    }
    assignMnemonics(menuBar()->actions());
    for (const QMenu* each : menuBar()->findChildren<QMenu*>()) assignMnemonics(each->actions());
    m_files->fillRecentMenu(*m_recentMenu);
    auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    more->setText(QStringLiteral("»")); // the style's picture is black in every theme
    more->setToolButtonStyle(Qt::ToolButtonTextOnly);
}

/// A new tree of each way to grow.
void CMainWindow::addMethods(QMenu& menu) {
    if (treeMethods().size() < 2) return; // the command itself starts the only one
    QMenu* methods = menu.addMenu(tr("New &Tree by"));
    for (const TreeMethod& method : treeMethods()) {
        const ParamBlock& block = *method.block;
        QAction* action = methods->addAction(trText(block.label), this, [this, &block] { m_files->startNew(block); });
        action->setObjectName(QStringLiteral("new:") + toQString(block.method));
        action->setStatusTip(trText(block.help));
    }
}

void CMainWindow::restoreSwitches() {
    for (const Command& command : commandTable())
        if (command.kind == Command::Kind::KeptSwitch)
            if (const QVariant kept = QSettings().value(switchKey(QLatin1String(command.name))); kept.toBool())
                findChild<QAction*>(QLatin1String(command.name))->setChecked(true);
}

void CMainWindow::makeStatusBar() {
    m_notice = new QLabel;
    m_notice->setObjectName(QStringLiteral("notice"));
    m_notice->setTextFormat(Qt::PlainText);
    m_notice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long one gives way to the counts
    m_counts = new QLabel;
    m_counts->setObjectName(QStringLiteral("counts"));
    m_progress = new QProgressBar;
    m_progress->setRange(0, 1000);
    m_progress->setFixedWidth(110);
    m_progress->setTextVisible(false);
    m_progress->setToolTip(tr("The tree is growing; Esc cancels"));
    QSizePolicy keepsRoom = m_progress->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsRoom);
    m_progress->hide();
    statusBar()->addWidget(m_notice, 1);
    statusBar()->addPermanentWidget(m_progress);
    statusBar()->addPermanentWidget(m_counts);
}

void CMainWindow::restoreLayout() {
    m_firstLayout = saveState(kLayoutVersion);
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("layout")).toByteArray(), kLayoutVersion);
}

void CMainWindow::keepLayout() const {
    QSettings settings;
    settings.setValue(QStringLiteral("geometry"), saveGeometry());
    settings.setValue(QStringLiteral("layout"), m_folder->layout());
}

void CMainWindow::resetLayout() {
    restoreState(m_firstLayout, kLayoutVersion);
    m_folder->followLayout();
}

void CMainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    m_folder->follow();
}

} // namespace stromar
