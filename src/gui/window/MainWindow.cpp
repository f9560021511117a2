#include "window/MainWindow.h"
#include "document/Autosave.h"
#include "window/Commands.h"
#include "window/Display.h"
#include "work/ExportJob.h"
#include "document/Gesture.h"
#include "window/HelpWindow.h"
#include "view/LightPanel.h"
#include "window/MessageBar.h"
#include "params/ParamPanel.h"
#include "window/PreferencesDialog.h"
#include "library/PresetBrowser.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "window/Theme.h"
#include "library/Thumbnails.h"
#include "library/Variants.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Prediction.h"
#include "stromar/app/Randomise.h"
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressBar>
#include <QRandomGenerator>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoView>
#include <QVBoxLayout>
#include <utility>

/// Resources of a static library are only there when asked for.
static void initResources() { Q_INIT_RESOURCE(stromar); }

namespace stromar {

namespace {
constexpr const char* kAboutSize = "size";
constexpr const char* kAboutFile = "file";

QString tr2(const char* text) { return QCoreApplication::translate("Commands", text); }
QString switchKey(const QString& name) { return QStringLiteral("view/") + name; }
} // namespace

CMainWindow::CMainWindow(const SizeLimits& limits, std::shared_ptr<CDocument> document, QWidget* parent)
    : QMainWindow(parent), m_document(document ? std::move(document) : std::make_shared<CDocument>()),
      m_thumbnails(new CThumbnails(this)), m_viewport(new CViewport), m_panel(new CParamPanel),
      m_presets(new CPresetBrowser(*m_thumbnails)), m_variants(new CVariants(*m_thumbnails)), m_bar(new CMessageBar),
      m_viewController(new CViewController(*m_viewport, *m_panel, *m_document, this)),
      m_autosave(std::make_unique<CAutosave>(CAutosave::standardFolder())), m_limits(limits), m_givenMemory(limits.bytes),
      m_thread(std::make_unique<CTreeCreatorThread>(std::make_unique<CTreeCreator>(true, limits))) {
    initResources();
    setAcceptDrops(true);
    qApp->installEventFilter(this);
    setWindowIcon(QIcon(QStringLiteral(":/icons/stromar.svg")));
    makeCentre();
    makeDocks();
    makeActions();
    makeStatusBar();
    connectParts();
    connectDocument();
    resize(QSize(1280, 800).boundedTo(screen()->availableSize()));
    restoreLayout();
    restoreSwitches();
    for (const char* key : {"navigation", "threads", "fullModelDelay", "maxMemory", "autosave"}) onSetting(QLatin1String(key));
    onReplaced();
}

CMainWindow::~CMainWindow() = default;

bool CMainWindow::busy() const {
    return !m_started || m_thumbnails->busy() || m_thread->progress() || m_viewport->settling();
}

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
    addDock("parameters", tr("Parameters"), m_panel, Qt::RightDockWidgetArea);
    QDockWidget* presets = addDock("presets", tr("Presets"), m_presets, Qt::LeftDockWidgetArea);
    auto* scroll = new QScrollArea;
    scroll->setWidget(m_variants);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QDockWidget* variants = addDock("variants", tr("Variants"), scroll, Qt::LeftDockWidgetArea);
    auto* steps = new QUndoView(&m_document->history());
    steps->setEmptyLabel(tr("As opened"));
    steps->setAccessibleName(tr("History"));
    QDockWidget* history = addDock("history", tr("History"), steps, Qt::LeftDockWidgetArea);
    m_light = new CLightPanel;
    QDockWidget* light = addDock("light", tr("Light"), m_light, Qt::LeftDockWidgetArea);
    m_messages = new QListWidget;
    m_messages->setObjectName(QStringLiteral("messageList"));
    m_messages->setAlternatingRowColors(true);
    m_messages->setAccessibleName(tr("Messages of the file"));
    m_messageDock = addDock("messages", tr("Messages"), m_messages, Qt::BottomDockWidgetArea);
    m_messageDock->hide();
    tabifyDockWidget(presets, variants);
    tabifyDockWidget(variants, history);
    tabifyDockWidget(history, light);
    presets->raise();
    resizeDocks({presets}, {200}, Qt::Horizontal);
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

void CMainWindow::makeActions() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    QMap<QString, QActionGroup*> groups;
    QMenu* menu = nullptr;
    Menu last = Menu::File;
    for (const Command& command : commandTable()) {
        const bool newMenu = !menu || command.menu != last;
        if (newMenu) menu = menuBar()->addMenu(tr2(menuTitle(command.menu)));
        if (newMenu && command.menu == Menu::Window)
            for (QDockWidget* dock : findChildren<QDockWidget*>()) menu->addAction(dock->toggleViewAction());
        if (!menu->isEmpty() && command.startsGroup) menu->addSeparator();
        last = command.menu;
        QAction* action = makeAction(command);
        menu->addAction(action);
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
    }
    fillRecentMenu();
}

/// A new tree of each way to grow.
void CMainWindow::addMethods(QMenu& menu) {
    if (treeMethods().size() < 2) return; // the command itself starts the only one
    QMenu* methods = menu.addMenu(tr("New &Tree by"));
    for (const TreeMethod& method : treeMethods()) {
        const ParamBlock& block = *method.block;
        QAction* action = methods->addAction(trText(block.label), this, [this, &block] { startNew(block); });
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

void CMainWindow::connectParts() {
    connect(m_panel, &CParamPanel::pathWanted, this,
            [this](const ParamRef& text) { chooseTexture(QByteArray::fromStdString(text.key())); });
    connect(m_panel, &CParamPanel::workshopWanted, this, [this](const ParamRef& text) { openWorkshop(text); });
    connect(m_panel, &CParamPanel::released, this, [this] { m_pause.start(); });
    connect(m_viewController, &CViewController::released, this, [this] { m_pause.start(); });
    const auto relight = [this] { m_viewController->setLook([this](ViewLook& look) { m_light->applyTo(look); }); };
    connect(m_light, &CLightPanel::changed, this, relight);
    relight();
    connect(m_viewController, &CViewController::notice, m_notice, &QLabel::setText);
    connect(m_presets, &CPresetBrowser::chosen, this, &CMainWindow::openPreset);
    connect(m_presets, &CPresetBrowser::saveWanted, this, &CMainWindow::savePreset);
    connect(m_thread.get(), &CTreeCreatorThread::created, this, &CMainWindow::onCreated);
    connect(m_thread.get(), &CTreeCreatorThread::picturesMade, this, &CMainWindow::updateTextures);
    connect(m_thread.get(), &CTreeCreatorThread::failed, this, &CMainWindow::onFailed);
    connect(m_viewport, &CViewport::contextLost, this, &CMainWindow::onContextLost, Qt::QueuedConnection);
    connect(&m_watch, &CFileWatch::changed, this, &CMainWindow::onFileChanged);
    connect(m_autosave.get(), &CAutosave::failed, this,
            [this](const QString& why) { onFailed(tr("Autosave: %1").arg(why)); });
    connect(&CSettings::instance(), &CSettings::changed, this, &CMainWindow::onSetting);
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &CMainWindow::requestFull);
    m_progressTimer.setInterval(100);
    connect(&m_progressTimer, &QTimer::timeout, this, &CMainWindow::updateProgress);
}

void CMainWindow::connectDocument() {
    CDocument* document = m_document.get();
    connect(m_panel, &CParamPanel::edited, document,
            qOverload<const ParamRef&, const ParamValue&, int>(&CDocument::setValue));
    connect(m_panel, &CParamPanel::assigned, document, &CDocument::setValues);
    connect(m_variants, &CVariants::seedChosen, document,
            [document](int seed) { document->setValue(*findParam("Seed", document->params().block()), double(seed), 0); });
    connect(m_variants, &CVariants::likedChanged, document, [document](const QString& seeds) {
        document->setValue(*findParam("LikedSeeds", document->params().block()), seeds.toStdString(), 0);
    });
    connect(m_variants, &CVariants::randomiseWanted, this, [this](std::vector<ParamRef> refs, double amount) {
        std::erase_if(refs, [this](const ParamRef& ref) { return m_panel->locked(ref); });
        m_document->setValues(tr("Randomise"),
                              randomised(m_document->params(), refs, amount, QRandomGenerator::global()->generate64()));
    });
    connect(document, &CDocument::replaced, this, &CMainWindow::onReplaced);
    connect(document, &CDocument::changed, this, &CMainWindow::onChanged);
    connect(document, &CDocument::nameChanged, this, &CMainWindow::updateTitle);
    QUndoStack& history = document->history();
    for (const auto& [name, can, signal] : {std::tuple{"undo", history.canUndo(), &QUndoStack::canUndoChanged},
                                            {"redo", history.canRedo(), &QUndoStack::canRedoChanged}}) {
        auto* action = findChild<QAction*>(QLatin1String(name));
        action->setEnabled(can);
        connect(&history, signal, action, &QAction::setEnabled);
    }
}

// The layout

void CMainWindow::restoreLayout() {
    m_firstLayout = saveState(kLayoutVersion);
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("layout")).toByteArray(), kLayoutVersion);
}

void CMainWindow::keepLayout() const {
    QSettings settings;
    settings.setValue(QStringLiteral("geometry"), saveGeometry());
    settings.setValue(QStringLiteral("layout"), saveState(kLayoutVersion));
}

void CMainWindow::resetLayout() { restoreState(m_firstLayout, kLayoutVersion); }

/// A widget that changes its parent gets a context of its own; the scene goes to the graphics card again.
void CMainWindow::onContextLost() {
    auto* column = static_cast<QVBoxLayout*>(centralWidget()->layout());
    column->removeWidget(m_viewport);
    m_viewport->setParent(nullptr);
    column->addWidget(m_viewport, 1);
    m_viewport->QWidget::show();
    m_notice->setText(tr("The graphics driver has started again"));
}

/// Keys without Ctrl belong to the widget that has the focus when it has a use for them, else to the commands.
bool CMainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return QMainWindow::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool plain = !(key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) && !key->text().isEmpty();
    const bool presses = qobject_cast<QAbstractButton*>(watched) && key->key() == Qt::Key_Space;
    const bool searches = qobject_cast<QComboBox*>(watched) || qobject_cast<QAbstractItemView*>(watched);
    if (plain && key->key() != Qt::Key_Escape && (presses || searches)) {
        event->accept();
        return true;
    }
    return QMainWindow::eventFilter(watched, event);
}

// From the document to the picture

void CMainWindow::showOnly(Model model) {
    m_only = model;
    onChanged();
}

void CMainWindow::onReplaced() {
    m_recentreNext = true;
    m_viewController->clearSelection();
    m_watch.watch(m_document->path());
    m_bar->dismiss(QLatin1String(kAboutFile));
    updateTitle();
    updateMessages();
    onChanged();
}

void CMainWindow::onChanged() {
    m_panel->showParams(m_document->params(), m_document->savedParams());
    m_variants->showParams(m_document->params(), m_document->folder());
    m_viewController->updateOverlay();
    updateTextures();
    updateAutosave();
    m_notice->clear();
    if (!mayGrow()) return;
    request(m_only.value_or(Model::Simple));
    if (!m_only) m_pause.start();
}

bool CMainWindow::mayGrow() {
    const CParams& params = m_document->params();
    const Prediction size = predictSize(params, detailOf(Model::Full));
    if (m_limits.allow(size) || params == m_allowed) {
        if (m_limits.allow(size)) m_fitting = params;
        m_bar->dismiss(QLatin1String(kAboutSize));
        return true;
    }
    m_pause.stop();
    offerSmaller(size);
    showPresets();
    return false;
}

/// When one value alone makes the tree too large, the nearest that does not is on offer.
void CMainWindow::offerSmaller(const Prediction& size) {
    const CParams& params = m_document->params();
    std::vector<CMessageBar::Choice> choices;
    std::vector<ParamRef> changed;
    for (const ParamRef& ref : allParams(params.block()))
        if (&m_fitting.block() == &params.block() && ref.differs(params, m_fitting)) changed.push_back(ref);
    if (changed.size() == 1 && changed.front().info->numeric()) {
        const ParamRef ref = changed.front();
        const double value = nearestThatFits(params, ref, ref.get(m_fitting), detailOf(Model::Full), m_limits);
        const QString shown = ref.info->unit == Unit::Metre ? lengthText(value) : QLocale().toString(value, 'g', 6);
        choices.push_back({tr("%1 = %2 fits").arg(trText(ref.info->label), shown),
                           [this, ref, value] { m_document->setValue(ref, value, 0); }});
    }
    if (size.bytes < 2 * SizeLimits::defaultMemory())
        choices.push_back({tr("Grow it anyway"), [this] {
                               m_allowed = m_document->params();
                               onChanged();
                           }});
    choices.push_back({tr("Undo"), [this] { m_document->history().undo(); }});
    const QLocale numbers;
    m_bar->ask(QLatin1String(kAboutSize),
               tr("This tree may have up to %1 stems, %2 leaves and %3 million vertices and take %4 GB of memory; the limit is "
                  "%5 million vertices and %6 GB.")
                   .arg(numbers.toString(size.stems, 'f', 0), numbers.toString(size.leaves, 'f', 0),
                        numbers.toString(size.vertices / 1e6, 'f', 0), numbers.toString(size.bytes / 1e9, 'f', 1),
                        numbers.toString(m_limits.vertices / 1e6, 'f', 0), numbers.toString(m_limits.bytes / 1e9, 'f', 1)),
               choices);
}

SizeLimits CMainWindow::limits() const { return m_document->params() == m_allowed ? SizeLimits::none() : m_limits; }

/// The first tree comes before the thumbnails.
void CMainWindow::showPresets() {
    if (!std::exchange(m_started, true)) m_presets->refresh();
}

void CMainWindow::request(Model model, bool anew) {
    m_thread->request(m_document->params(), detailOf(model), anew, limits());
    m_progressTimer.start();
}

/// The full model follows when the hand rests.
void CMainWindow::requestFull() {
    if (m_panel->held() || m_viewController->held() || m_only) return;
    request(Model::Full);
}

void CMainWindow::onCreated(const std::shared_ptr<const ViewModel>& view) {
    m_shown = view;
    m_viewController->show(view);
    if (m_recentreNext && view->model->params == m_document->params()) { // not a late picture of the document before
        m_viewport->recentre();
        m_recentreNext = false;
    }
    updateTextures();
    updateCounts(*view->model);
    showPresets();
    emit modelShown();
}

void CMainWindow::updateCounts(const TreeModel& model) {
    const QLocale numbers;
    m_counts->setText(tr("%1   %2 stems   %3 leaves   %4 vertices   %5 triangles   %6 ms")
                          .arg(model.detail->model == Model::Simple ? tr("Simple model") : tr("Full model"),
                               numbers.toString(qulonglong(model.tree->stemCount())),
                               numbers.toString(qulonglong(model.tree->organs(Organ::Leaf)->total)),
                               numbers.toString(qulonglong(model.vertexCount())),
                               numbers.toString(qulonglong(model.triangleCount())),
                               numbers.toString(model.milliseconds.total, 'f', 1)));
}

void CMainWindow::onFailed(const QString& why) {
    showPresets();
    m_notice->setText(why);
    m_notice->setToolTip(why);
}

void CMainWindow::onSetting(const QString& key) {
    CSettings& settings = CSettings::instance();
    if (key == QLatin1String("navigation")) m_viewport->setNavigation(navigationNamed(settings.text("navigation")));
    if (key == QLatin1String("threads")) m_thread->setThreads(settings.number("threads"));
    if (key == QLatin1String("fullModelDelay")) m_pause.setInterval(settings.number("fullModelDelay"));
    if (key == QLatin1String("maxMemory")) setMaxMemory(settings.number("maxMemory"));
    if (key == QLatin1String("autosave")) m_autosave->setInterval(settings.number("autosave"));
    if (key == QLatin1String("theme")) applyTheme(settings.text("theme"));
    if (key != QLatin1String("language") && key != QLatin1String("units")) return;
    if (m_preferencesOpen)
        m_rebuildLater = true; // the window must outlive its dialog
    else
        emit rebuildWanted();
}

/// Gigabytes; 0 is what the window was made with.
void CMainWindow::setMaxMemory(int gigabytes) { m_limits.bytes = gigabytes > 0 ? 1e9 * gigabytes : m_givenMemory; }

void CMainWindow::onFileChanged() {
    const QString path = m_document->path();
    const QString text = m_document->isModified()
                             ? tr("Another program has changed %1. Opening it again loses your changes.")
                             : tr("Another program has changed %1.");
    m_bar->ask(QLatin1String(kAboutFile), text.arg(m_document->displayName()),
               {{tr("Open it again"), [this, path] { open(path); }}, {tr("Keep mine"), [this] {
                                                                          m_document->keepAgainstFile();
                                                                          updateAutosave();
                                                                      }}});
}

void CMainWindow::updateProgress() {
    const auto done = m_export ? std::optional(m_export->progress()) : m_thread->progress();
    m_progress->setVisible(done.has_value());
    if (done)
        m_progress->setValue(static_cast<int>(*done * m_progress->maximum()));
    else
        m_progressTimer.stop();
}

void CMainWindow::updateTitle() {
    setWindowTitle(QStringLiteral("%1[*] — Stromar").arg(m_document->displayName()));
    setWindowModified(m_document->isModified());
}

void CMainWindow::updateMessages() {
    m_messages->clear();
    for (const Message& message : m_document->warnings())
        m_messages->addItem(QString::fromStdString(message.toString()));
    m_messageDock->setVisible(!m_document->warnings().empty());
}

void CMainWindow::tellError(const QString& title, const QString& text) { QMessageBox::critical(this, title, text); }

// Commands

void CMainWindow::findParameter() {
    m_panel->filter().setFocus();
    m_panel->filter().selectAll();
}

void CMainWindow::showPreferences() {
    CPreferencesDialog dialog(this);
    m_preferencesOpen = true;
    dialog.exec();
    m_preferencesOpen = false;
    if (std::exchange(m_rebuildLater, false)) emit rebuildWanted();
}

void CMainWindow::throwDice() {
    const ParamRef seed = *findParam("Seed");
    m_document->setValue(seed, double(randomSeed()), 0);
}

void CMainWindow::generate() { request(m_only.value_or(Model::Full), true); }

void CMainWindow::showFullModel() {
    m_pause.stop();
    m_only.reset();
    request(Model::Full);
}

void CMainWindow::stop() {
    m_pause.stop();
    if (m_thread->progress()) m_notice->setText(tr("Stopped; F6 grows the full model"));
    m_thread->cancel();
    m_viewController->clearSelection();
}

void CMainWindow::setWireframe(Wireframe wireframe, const char* other) {
    if (wireframe != Wireframe::Off) findChild<QAction*>(QLatin1String(other))->setChecked(false);
    m_viewController->setLook([wireframe](ViewLook& look) { look.wireframe = wireframe; });
}

void CMainWindow::showManual() {
    if (!CHelpWindow::available()) return tellError(tr("No manual"), tr("The pages of the manual are not installed."));
    if (!m_help) m_help = new CHelpWindow(this);
    m_help->open(QStringLiteral("manual"));
    m_help->show();
    m_help->raise();
}

void CMainWindow::showShortcuts() {
    const auto row = [](const QString& key, const QString& what) {
        return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>").arg(key, what);
    };
    QString text = QStringLiteral("<p><b>%1</b></p><table>").arg(tr("In the picture"));
    for (const MouseGesture& gesture : navigationNamed(CSettings::instance().text("navigation")).gestures)
        text += row(gestureText(gesture), motionText(gesture.motion));
    text += row(tr("Wheel"), tr("Nearer and farther")) + row(tr("Click"), tr("Show details of the stem or leaf")) +
            QStringLiteral("</table><p><b>%1</b></p><table>").arg(tr("In the parameters")) +
            row(tr("Wheel"), tr("Scroll; changes an editor only after a click into it")) +
            row(tr("Shift"), tr("Finer steps of a slider")) + row(tr("Ctrl"), tr("Larger steps of a slider")) +
            row(tr("Double click on a name"), tr("Back to the default")) +
            row(tr("Right click on a name"), tr("Copy, paste, lock")) +
            QStringLiteral("</table><p><b>%1</b></p><table>").arg(tr("Keys"));
    for (const Command& command : commandTable())
        if (*command.shortcut)
            text += row(QKeySequence(QLatin1String(command.shortcut)).toString(QKeySequence::NativeText),
                        tr2(command.text).remove(QLatin1Char('&')).remove(QChar(0x2026)));
    QMessageBox box(QMessageBox::NoIcon, tr("Mouse and keys"), text + QStringLiteral("</table>"), QMessageBox::Close,
                    this);
    box.exec();
}

void CMainWindow::showAbout() {
    QMessageBox::about(this, tr("About Stromar"),
                       tr("<p><b>Stromar %1</b></p><p>Grows trees by the model of Weber and Penn, "
                          "“Creation and Rendering of Realistic Trees”, SIGGRAPH ’95.</p>")
                           .arg(QApplication::applicationVersion()));
}

} // namespace stromar
