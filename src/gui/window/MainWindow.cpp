#include "window/MainWindow.h"
#include "document/FileController.h"
#include "window/Commands.h"
#include "window/Display.h"
#include "work/ExportController.h"
#include "work/GrowthController.h"
#include "document/Gesture.h"
#include "window/DockFolder.h"
#include "window/HelpWindow.h"
#include "view/Comparison.h"
#include "view/LightPanel.h"
#include "view/SavedCameras.h"
#include "motion/FallController.h"
#include "motion/Recorder.h"
#include "motion/Timeline.h"
#include "motion/WindController.h"
#include "motion/WindPanel.h"
#include "window/MessageBar.h"
#include "params/ParamPanel.h"
#include "window/PreferencesDialog.h"
#include "library/PresetBrowser.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "window/ShortcutsDialog.h"
#include "window/Theme.h"
#include "window/WheelGuard.h"
#include "library/Thumbnails.h"
#include "library/Variants.h"
#include "work/Randomiser.h"
#include "library/WelcomeCard.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Pictures.h"
#include "stromar/app/Prediction.h"
#include "stromar/app/Randomise.h"
#include <QAbstractButton>
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QDragEnterEvent>
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
#include <QSettings>
#include <QVBoxLayout>
#include <utility>

/// Resources of a static library are only there when asked for.
static void initResources() { Q_INIT_RESOURCE(stromar); }

namespace stromar {

namespace {
constexpr const char* kStartPreset = "japanese_maple.tree";
} // namespace

CMainWindow::CMainWindow(const SizeLimits& limits, std::shared_ptr<CDocument> document, QWidget* parent)
    : QMainWindow(parent), m_document(document ? std::move(document) : std::make_shared<CDocument>()),
      m_thumbnails(new CThumbnails(this)), m_viewport(new CViewport), m_panel(new CParamPanel),
      m_presets(new CPresetBrowser(*m_thumbnails)), m_variants(new CVariants(*m_thumbnails)), m_bar(new CMessageBar),
      m_timeline(new CTimeline), m_wind(new CWindPanel), m_recorder(new CRecorder(*this)),
      m_randomiser(new CRandomiser(this)), m_comparison(new CComparison(*m_viewport, this)),
      m_cameras(new CSavedCameras(*m_viewport, this)), m_sideBySide(new CSideBySide(*m_viewport, this)),
      m_viewController(new CViewController(*m_viewport, *m_panel, *m_document, this)),
      m_files(new CFileController(*m_document, *m_bar, this)),
      m_exporter(new CExportController(
          *m_document, [this] { return shownModel(); }, [this] { return m_growth->limits(); },
          [this] {
              return CExportController::Motion{m_growth->age(), m_wind->wind(), m_fall->felling()};
          },
          [this] { return m_sideBySide->trees(); }, this)),
      m_growth(std::make_unique<CGrowthController>(*m_document, *m_bar, limits)) {
    initResources();
    setAcceptDrops(true);
    qApp->installEventFilter(this);
    qApp->installEventFilter(new CWheelGuard(this));
    setWindowIcon(QIcon(QStringLiteral(":/icons/stromar.svg")));
    makeCentre();
    makeDocks();
    makeActions();
    makeStatusBar();
    connectParts();
    connectControllers();
    connectMotion();
    connectDocument();
    resize(QSize(1280, 800).boundedTo(screen()->availableSize()));
    restoreLayout();
    restoreSwitches();
    for (const Setting& setting : settingTable()) onSetting(QLatin1String(setting.key));
    onReplaced();
}

/// Closing takes the focus out of an editor, which tells of it: nobody is there to hear it.
CMainWindow::~CMainWindow() { m_panel->disconnect(); }

bool CMainWindow::busy() const {
    return !m_started || m_thumbnails->busy() || m_sideBySide->busy() || m_randomiser->busy() || m_growth->progress() || m_viewport->settling();
}

void CMainWindow::connectParts() {
    connect(m_panel, &CParamPanel::pathWanted, m_files, &CFileController::chooseFile);
    connect(m_panel, &CParamPanel::workshopWanted, m_files, &CFileController::openWorkshop);
    const auto relight = [this] { m_viewController->setLook([this](ViewLook& look) { m_light->applyTo(look); }); };
    connect(m_light, &CLightPanel::changed, this, relight);
    relight();
    connect(m_comparison, &CComparison::shownChanged, this, [this](bool before) {
        findChild<QAction*>(QStringLiteral("showBefore"))->setChecked(before);
        if (before)
            m_windController->setPaused(true);
        else if (m_shown)
            showNow();
        else
            showNothing();
    });
    connect(m_comparison, &CComparison::wipingChanged, this, [this](bool on) {
        findChild<QAction*>(QStringLiteral("wipe"))->setChecked(on);
        m_windController->setPaused(on || m_fall->felling().has_value());
    });
    connect(m_cameras, &CSavedCameras::orthographicWanted, findChild<QAction*>(QStringLiteral("orthographic")), &QAction::setChecked);
    connect(m_comparison, &CComparison::notice, m_notice, &QLabel::setText);
    connect(m_viewController, &CViewController::notice, m_notice, &QLabel::setText);
    connect(m_presets, &CPresetBrowser::chosen, m_files, &CFileController::openPreset);
    connect(m_presets, &CPresetBrowser::saveWanted, m_files, &CFileController::savePreset);
    connect(m_viewport, &CViewport::contextLost, this, &CMainWindow::onContextLost, Qt::QueuedConnection);
    connect(&CSettings::instance(), &CSettings::changed, this, &CMainWindow::onSetting);
    m_progressTimer.setInterval(100);
    connect(&m_progressTimer, &QTimer::timeout, this, &CMainWindow::updateProgress);
}

void CMainWindow::connectControllers() {
    CGrowthController* growth = m_growth.get();
    growth->setHeld([this] { return m_panel->held() || m_viewController->held() || m_timeline->held() || m_wind->held(); });
    connect(m_panel, &CParamPanel::released, growth, &CGrowthController::handReleased);
    connect(m_viewController, &CViewController::released, growth, &CGrowthController::handReleased);
    connect(growth, &CGrowthController::created, this, &CMainWindow::onCreated);
    connect(growth, &CGrowthController::surfaceRead, this, &CMainWindow::onSurfaceRead);
    connect(growth, &CGrowthController::failed, this, &CMainWindow::onFailed);
    connect(growth, &CGrowthController::refused, this, &CMainWindow::onRefused);
    connect(growth, &CGrowthController::started, &m_progressTimer, qOverload<>(&QTimer::start));
    connect(m_files, &CFileController::notice, m_notice, &QLabel::setText);
    connect(m_files, &CFileController::failed, this, &CMainWindow::onFailed);
    connect(m_files, &CFileController::presetSaved, m_presets, &CPresetBrowser::refresh);
    connect(m_files, &CFileController::recentChanged, this, [this] { m_files->fillRecentMenu(*m_recentMenu); });
    connect(m_files, &CFileController::saved, this,
            [this] {
                m_panel->keepLocksFor(m_document->path());
                m_panel->showParams(m_document->params(), m_document->savedParams());
            });
    connect(m_exporter, &CExportController::notice, m_notice, &QLabel::setText);
    connect(m_exporter, &CExportController::started, &m_progressTimer, qOverload<>(&QTimer::start));
}

void CMainWindow::connectMotion() {
    CGrowthController* growth = m_growth.get();
    m_windController = new CWindController(*m_viewport, *m_wind, *growth, this);
    m_fall = new CFallController(*m_viewport, *m_timeline, *growth, this);
    connect(m_fall, &CFallController::changed, m_windController, &CWindController::setPaused);
    connect(m_fall, &CFallController::changed, this, [this](bool felled) { findChild<QAction*>(QStringLiteral("fell"))->setChecked(felled); });
    connect(m_timeline, &CTimeline::ageChanged, growth, &CGrowthController::setAge);
    connect(m_timeline, &CTimeline::playingChanged, growth, &CGrowthController::setPlaying);
    connect(m_timeline, &CTimeline::playingChanged, this, [this](bool on) { findChild<QAction*>(QStringLiteral("play"))->setChecked(on); });
    connect(m_timeline, &CTimeline::recordWanted, this, &CMainWindow::record);
    connect(m_recorder, &CRecorder::notice, m_notice, &QLabel::setText);
    connect(m_timeline, &CTimeline::released, growth, &CGrowthController::handReleased);
    connect(growth, &CGrowthController::refused, m_timeline, [this] { m_timeline->setPlaying(false); });
    connect(m_wind, &CWindPanel::released, growth, &CGrowthController::handReleased);
    connect(m_wind, &CWindPanel::switched, this, [this](bool on) { findChild<QAction*>(QStringLiteral("wind"))->setChecked(on); });
    connect(m_wind, &CWindPanel::flexibilityEdited, this, [this](double flexibility, int gesture) {
        m_document->setValue(*findParam("Flexibility", m_document->params().block()), flexibility, gesture);
    });
}

void CMainWindow::connectDocument() {
    CDocument* document = m_document.get();
    connect(m_panel, &CParamPanel::edited, document,
            qOverload<const ParamRef&, const ParamValue&, int>(&CDocument::setValue));
    connect(m_panel, &CParamPanel::assigned, document, &CDocument::setValues);
    connect(m_variants, &CVariants::seedChosen, document,
            [document](int seed) { document->setValue(*findParam("Seed", document->params().block()), double(seed), 0); });
    connect(m_variants, &CVariants::ageChosen, m_timeline, &CTimeline::setAge);
    connect(m_variants, &CVariants::likedChanged, document, [document](const QString& seeds) {
        document->setValue(*findParam("LikedSeeds", document->params().block()), seeds.toStdString(), 0);
    });
    connect(m_variants, &CVariants::randomiseWanted, this, [this](std::vector<ParamRef> refs, double amount) {
        std::erase_if(refs, [this](const ParamRef& ref) { return m_panel->locked(ref); });
        m_randomiser->start({m_document->params(), std::move(refs), amount, QRandomGenerator::global()->generate64(), m_growth->limits()});
    });
    connect(m_randomiser, &CRandomiser::found, this, [this](const CParams& from, const ParamValues& values) {
        if (from != m_document->params()) return; // the hand was quicker
        if (values.empty())
            m_notice->setText(tr("No tree was found among these random values; a smaller amount finds some"));
        else
            m_document->setValues(tr("Randomise"), values);
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

/// A widget that changes its parent gets a context of its own; the scene goes to the graphics card again.
void CMainWindow::onContextLost() {
    auto* column = static_cast<QVBoxLayout*>(centralWidget()->layout());
    column->removeWidget(m_viewport);
    m_viewport->setParent(nullptr);
    column->addWidget(m_viewport, 1);
    m_viewport->QWidget::show();
    m_notice->setText(tr("The graphics driver has started again"));
}

namespace {
/// Fields take what other systems' editors do, as Ctrl+E for the end of the line; here it is a command's. What edits
/// text is the field's.
bool belongsToCommand(const QObject& watched, const QKeyEvent& key) {
    if (!watched.inherits("QLineEdit") && !watched.inherits("QAbstractSpinBox")) return false;
    constexpr QKeySequence::StandardKey kEditing[] = {QKeySequence::Copy, QKeySequence::Cut,  QKeySequence::Paste,
                                                      QKeySequence::Undo, QKeySequence::Redo, QKeySequence::SelectAll};
    if (std::ranges::any_of(kEditing, [&](QKeySequence::StandardKey own) { return key.matches(own); })) return false;
    const QKeySequence pressed(key.keyCombination());
    return (key.modifiers() & Qt::ControlModifier) && std::ranges::any_of(commandTable(), [&](const Command& command) {
               return pressed == QKeySequence(QLatin1String(command.shortcut));
           });
}
} // namespace

/// Keys without Ctrl belong to what is popped up, or to the widget that has the focus when it has a use for them, else to the
/// commands.
bool CMainWindow::eventFilter(QObject* watched, QEvent* event) {
    const bool asks = event->type() == QEvent::ShortcutOverride, presses = event->type() == QEvent::KeyPress;
    if ((!asks && !presses) || QApplication::activePopupWidget()) return QMainWindow::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool plain = !(key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) && !key->text().isEmpty();
    if (presses) // a closed list is no place to type in
        return (plain && key->text()[0].isPrint() && key->key() != Qt::Key_Space &&
                qobject_cast<QComboBox*>(watched)) ||
               QMainWindow::eventFilter(watched, event);
    if (plain && qobject_cast<QAbstractButton*>(watched) && key->key() == Qt::Key_Space) {
        event->accept();
        return true;
    }
    return belongsToCommand(*watched, *key) || QMainWindow::eventFilter(watched, event);
}

void CMainWindow::closeEvent(QCloseEvent* event) {
    if (!m_files->mayLoseChanges()) return event->ignore();
    keepLayout();
    event->accept();
}

void CMainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!CFileController::droppedFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void CMainWindow::dropEvent(QDropEvent* event) {
    const QString path = CFileController::droppedFile(*event->mimeData());
    if (path.isEmpty()) return;
    event->acceptProposedAction();
    m_files->drop(path, mapToGlobal(event->position().toPoint()));
}

void CMainWindow::showStart() {
    m_files->startWith(fromPath(dataFolder() / "presets" / kStartPreset));
    if (CWelcomeCard::wanted()) showWelcome();
}

void CMainWindow::showWelcome() {
    if (findChild<CWelcomeCard*>()) return;
    auto* card = new CWelcomeCard(m_viewport);
    connect(card, &CWelcomeCard::presetWanted, m_files, &CFileController::openPreset);
    connect(card, &CWelcomeCard::fileWanted, m_files, &CFileController::chooseAndOpen);
    connect(card, &CWelcomeCard::methodWanted, m_files, &CFileController::startNew);
    connect(card, &CWelcomeCard::allPresetsWanted, this, [this] {
        m_folder->show(findChild<QDockWidget*>(QStringLiteral("presets")));
        m_presets->filter().setFocus();
    });
    connect(m_document.get(), &CDocument::replaced, card, &CWelcomeCard::finish);
    connect(card, &CWelcomeCard::placed, m_viewport, &CViewport::setCovered);
    m_viewport->setCovered(card->height());
}

// From the document to the picture

void CMainWindow::onReplaced() {
    m_recentreNext = true;
    m_replacedBy = m_document->params();
    m_fall->raise();
    m_timeline->setAge(1);
    m_viewController->clearSelection();
    m_files->watchFile();
    updateTitle();
    updateMessages();
    onChanged();
    m_panel->showLocksOf(m_document->path());
}

void CMainWindow::onChanged() {
    m_panel->showParams(m_document->params(), m_document->savedParams());
    m_variants->showParams(m_document->params(), m_document->folder());
    m_wind->showFlexibility(m_document->params().common.flexibility);
    m_viewController->updateOverlay();
    m_files->keepAside();
    m_notice->clear();
    m_growth->follow();
}

/// The first tree comes before the thumbnails.
void CMainWindow::showPresets() {
    if (!std::exchange(m_started, true)) m_presets->refresh();
}

void CMainWindow::onCreated(const std::shared_ptr<const ViewModel>& view) {
    const bool own = view->model->params == m_document->params();
    if (m_recentreNext && !own && m_document->params() == m_replacedBy) return; // late, of the document before
    if (view->model->detail->model == Model::Simple) m_simple = view;
    m_shown = view;
    m_comparison->setNow(view);
    showNow();
    m_timeline->shown();
    if (m_recentreNext && own) {
        m_viewport->recentre();
        m_recentreNext = false;
    }
    updateCounts(*view->model);
    showPresets();
    emit modelShown();
}

void CMainWindow::showNow() {
    m_viewport->overlay().model().badge.clear();
    m_windController->setPaused(m_fall->felling().has_value());
    m_fall->show(m_shown);
    m_viewport->setStandIn(standInParts(), showsSimple() ? CViewport::StandIn::UntilRest : CViewport::StandIn::InMotion);
    m_viewController->show(m_shown);
    m_windController->show(m_shown);
    m_sideBySide->follow(m_shown, m_document->folder(), m_growth->limits());
}

bool CMainWindow::showsSimple() const { return m_shown->model->detail->model == Model::Simple; }

/// The wood of the simple model, which came before the full one, with the leaves of the full one: a view draws as many
/// as it has time for. The simple model, while it follows a slider, stands in for itself: the scene leaves out what its
/// leaves hide, unless that is what one edits.
std::vector<ViewPart> CMainWindow::standInParts() const {
    if (!m_simple || m_fall->felling()) return {};
    const TreeModel& shown = *m_shown->model;
    if (showsSimple() && m_viewController->touched() >= static_cast<int>(shown.stems.size()) - 1) return {};
    if (!showsSimple() && shown.detail != &detailOf(Model::Full)) return {};
    const bool same = m_simple->model->params == shown.params && m_simple->model->age == shown.age;
    std::vector<ViewPart> parts;
    if (!same) return parts;
    std::ranges::copy_if(m_simple->parts, std::back_inserter(parts),
                         [](const ViewPart& part) { return part.mesh != nullptr; });
    std::ranges::copy_if(m_shown->parts, std::back_inserter(parts),
                         [](const ViewPart& part) { return part.organs != nullptr; });
    return parts;
}

void CMainWindow::onSurfaceRead(Surface surface, const std::shared_ptr<const SurfaceMaps>& maps) {
    m_comparison->setSurface(surface, maps);
    if (!maps->problem.empty()) onFailed(QString::fromStdString(maps->problem));
}

/// Of a tree that was opened there is nothing to see; one that was changed stays as it was.
void CMainWindow::onRefused() {
    showPresets();
    if (!m_recentreNext) return;
    m_shown.reset();
    m_comparison->setNow(nullptr);
    showNothing();
    m_counts->clear();
}

void CMainWindow::showNothing() {
    m_viewController->show(nullptr);
    m_windController->setPaused(true);
    m_viewport->show(std::vector<ViewPart>());
    m_viewport->overlay().model().badge = tr("Nothing has grown yet");
    m_viewport->overlay().update();
}

std::shared_ptr<const TreeModel> CMainWindow::shownModel() const {
    const bool current = m_shown && m_shown->model->params == m_document->params() && m_shown->model->age == m_growth->age();
    return current ? m_shown->model : nullptr;
}

void CMainWindow::updateCounts(const TreeModel& model) {
    const QLocale numbers;
    m_counts->setText(tr("%1   %2   %3 leaves   %4 vertices   %5 triangles   %6 ms")
                          .arg(detailTitle(*model.detail),
                               stemsText(model.tree->stemCount()),
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
    if (key == QLatin1String("threads")) m_growth->setThreads(settings.number("threads"));
    if (key == QLatin1String("fullModelDelay")) m_growth->setFullModelDelay(settings.number("fullModelDelay"));
    if (key == QLatin1String("maxMemory")) m_growth->setMaxMemory(settings.number("maxMemory"));
    if (key == QLatin1String("pictureCache")) m_growth->setPictureCache(settings.number("pictureCache"));
    if (key == QLatin1String("autosave")) m_files->autosave().setInterval(settings.number("autosave"));
    if (key == QLatin1String("theme")) applyTheme(settings.text("theme"));
    if (key != QLatin1String("language") && key != QLatin1String("units")) return;
    if (m_preferencesOpen)
        m_rebuildLater = true; // the window must outlive its dialog
    else
        emit rebuildWanted();
}

void CMainWindow::updateProgress() {
    const auto exported = m_exporter->progress(), done = exported ? exported : m_growth->progress();
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

void CMainWindow::chooseTexture(const char* key) {
    m_files->chooseFile(*findParam(key, m_document->params().block()));
}

void CMainWindow::chooseBackdrop() {
    if (!m_viewController->chooseBackdrop(this)) return;
    QActionGroup* backdrops = findChild<QAction*>(QStringLiteral("backdropSky"))->actionGroup();
    backdrops->setExclusionPolicy(QActionGroup::ExclusionPolicy::None); // none of them is on
    if (QAction* before = backdrops->checkedAction()) before->setChecked(false);
    backdrops->setExclusionPolicy(QActionGroup::ExclusionPolicy::Exclusive);
}

void CMainWindow::setReference(bool on) {
    if (!on)
        m_viewController->setLook([](ViewLook& look) { look.reference.reset(); });
    else if (!m_viewController->chooseReference(this))
        findChild<QAction*>(QStringLiteral("reference"))->setChecked(false);
}

void CMainWindow::setRow(CSideBySide::Row row) {
    if (row != CSideBySide::Row::Alone) findChild<QAction*>(QStringLiteral("wipe"))->setChecked(false);
    m_sideBySide->setSeeds(m_variants->seeds());
    m_sideBySide->setRow(row);
}

void CMainWindow::saveCamera() { m_cameras->save(this); }

void CMainWindow::stop() {
    if (m_growth->stop()) m_notice->setText(tr("Stopped; F6 grows the full model"));
    m_viewController->clearSelection();
    if (auto* card = findChild<CWelcomeCard*>()) card->finish();
}

void CMainWindow::setFelled(bool felled) {
    if (!felled)
        m_fall->raise();
    else if (!m_fall->felling() && !m_fall->askAndFell(this))
        findChild<QAction*>(QStringLiteral("fell"))->setChecked(false);
}

void CMainWindow::record() {
    m_timeline->setPlaying(false);
    CRecordDialog dialog(m_viewport->size() * m_viewport->devicePixelRatioF(), m_wind->blowing(), m_fall->felling().has_value(), this);
    if (dialog.exec() != QDialog::Accepted) return;
    m_recorder->record({m_document->params(), m_document->folder(), m_growth->age(), m_wind->wind(), m_fall->felling(), m_growth->limits(), m_viewport->look(),
                        m_viewport->camera()},
                       dialog.options());
}

void CMainWindow::setWireframe(Wireframe wireframe, const char* other) {
    if (wireframe != Wireframe::Off) findChild<QAction*>(QLatin1String(other))->setChecked(false);
    m_viewController->setLook([wireframe](ViewLook& look) { look.wireframe = wireframe; });
}

void CMainWindow::showManual() {
    if (!CHelpWindow::available()) {
        QMessageBox::critical(this, tr("No manual"), tr("The pages of the manual are not installed."));
        return;
    }
    if (!m_help) m_help = new CHelpWindow(this);
    m_help->open(QStringLiteral("manual"));
    m_help->show();
    m_help->raise();
}

void CMainWindow::showShortcuts() { CShortcutsDialog(this).exec(); }

void CMainWindow::showAbout() {
    QMessageBox::about(this, tr("About Stromar"),
                       tr("<p><b>Stromar %1</b></p><p>Grows trees by the model of Weber and Penn, "
                          "“Creation and Rendering of Realistic Trees”, SIGGRAPH ’95.</p>")
                           .arg(QApplication::applicationVersion()));
}

} // namespace stromar
