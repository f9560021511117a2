#include "MainWindow.h"
#include "Commands.h"
#include "ExportDialog.h"
#include "ExportJob.h"
#include "ParamEditor.h"
#include "ParamPanel.h"
#include "QtText.h"
#include "Viewport.h"
#include "stromar/app/Formats.h"
#include "stromar/app/Prediction.h"
#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressBar>
#include <QProgressDialog>
#include <QRandomGenerator>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>

/// Resources of a static library are only there when asked for.
static void initResources() { Q_INIT_RESOURCE(stromar); }

namespace stromar {

namespace {
constexpr int kPauseMs = 350;
constexpr int kMostRecent = 10;
constexpr int kMostSeed = 9999;
constexpr const char* kRecentKey = "recentFiles";

QString tr2(const char* text) { return QCoreApplication::translate("Commands", text); }

QString treeFilter() { return CMainWindow::tr("Trees (*.tree);;All files (*)"); }
} // namespace

CMainWindow::CMainWindow(double mostVertices, QWidget* parent)
    : QMainWindow(parent), m_viewport(new CViewport), m_panel(new CParamPanel), m_mostVertices(mostVertices),
      m_thread(std::make_unique<CTreeCreatorThread>(std::make_unique<CTreeCreator>(true, mostVertices))) {
    initResources();
    setCentralWidget(m_viewport);
    makeDocks();
    makeActions();
    makeStatusBar();
    connectParts();
    resize(1280, 800);
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
    startNew();
}

CMainWindow::~CMainWindow() = default;

void CMainWindow::makeDocks() {
    auto* params = new QDockWidget(tr("Parameters"));
    params->setObjectName(QStringLiteral("parameters"));
    params->setWidget(m_panel);
    params->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
    m_panel->setMinimumWidth(470);
    addDockWidget(Qt::RightDockWidgetArea, params);

    m_messages = new QListWidget;
    m_messages->setAlternatingRowColors(true);
    m_messages->setAccessibleName(tr("Messages of the file"));
    m_messageDock = new QDockWidget(tr("Messages"));
    m_messageDock->setObjectName(QStringLiteral("messages"));
    m_messageDock->setWidget(m_messages);
    addDockWidget(Qt::BottomDockWidgetArea, m_messageDock);
    m_messageDock->hide();
}

void CMainWindow::makeActions() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    QMenu* menu = nullptr;
    Menu last = Menu::File;
    for (const Command& command : commandTable()) {
        if (!menu || command.menu != last) menu = menuBar()->addMenu(tr2(menuTitle(command.menu)));
        if (menu->actions().size() > 0 && command.startsGroup) menu->addSeparator();
        last = command.menu;
        QAction* action = menu->addAction(tr2(command.text));
        action->setObjectName(QString::fromLatin1(command.name));
        action->setShortcut(QKeySequence(QString::fromLatin1(command.shortcut)));
        action->setStatusTip(tr2(command.help));
        action->setToolTip(tr2(command.help) +
                           (action->shortcut().isEmpty()
                                ? QString()
                                : QStringLiteral(" (%1)").arg(action->shortcut().toString(QKeySequence::NativeText))));
        action->setCheckable(command.checkable);
        if (*command.icon) action->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(command.icon))));
        if (command.onToolBar) {
            if (command.startsGroup || command.menu != Menu::File) bar->addSeparator();
            bar->addAction(action);
        }
        const auto run = command.run;
        connect(action, &QAction::triggered, this, [this, run] { (this->*run)(); });
        if (command.run == &CMainWindow::chooseAndOpen) m_recentMenu = menu->addMenu(tr("Open &Recent"));
    }
    menuBar()->actions().at(static_cast<int>(Menu::View))->menu()->addAction(m_messageDock->toggleViewAction());
    fillRecentMenu();
}

void CMainWindow::makeStatusBar() {
    m_notice = new QLabel;
    m_notice->setObjectName(QStringLiteral("notice"));
    m_notice->setTextFormat(Qt::PlainText);
    m_counts = new QLabel;
    m_counts->setObjectName(QStringLiteral("counts"));
    m_progress = new QProgressBar;
    m_progress->setRange(0, 1000);
    m_progress->setFixedWidth(140);
    m_progress->setTextVisible(false);
    QSizePolicy keepsRoom = m_progress->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsRoom);
    m_progress->hide();
    statusBar()->addWidget(m_notice, 1);
    statusBar()->addPermanentWidget(m_progress);
    statusBar()->addPermanentWidget(m_counts);
}

void CMainWindow::connectParts() {
    connect(m_panel, &CParamPanel::edited, &m_document, &CDocument::setValue);
    connect(m_panel, &CParamPanel::textEdited, this,
            [this](const TextInfo* text, const QString& value) { m_document.setText(*text, value); });
    connect(m_panel, &CParamPanel::pathWanted, this, [this](const TextInfo* text) { chooseTexture(*text); });
    connect(m_panel, &CParamPanel::released, this, [this] { m_pause.start(); });
    connect(&m_document, &CDocument::replaced, this, &CMainWindow::onReplaced);
    connect(&m_document, &CDocument::changed, this, &CMainWindow::onChanged);
    connect(&m_document, &CDocument::nameChanged, this, &CMainWindow::updateTitle);
    connect(m_thread.get(), &CTreeCreatorThread::created, this, &CMainWindow::onCreated);
    connect(m_thread.get(), &CTreeCreatorThread::failed, this, &CMainWindow::onFailed);
    connect(m_viewport, &CViewport::unusable, this, [this](const QString& why) { tellError(tr("No picture"), why); });
    for (const auto& [name, signal] :
         {std::pair{"undo", &QUndoStack::canUndoChanged}, {"redo", &QUndoStack::canRedoChanged}}) {
        auto* action = findChild<QAction*>(QLatin1String(name));
        action->setEnabled(false);
        connect(&m_document.history(), signal, action, &QAction::setEnabled);
    }
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &CMainWindow::requestFull);
    m_progressTimer.setInterval(100);
    connect(&m_progressTimer, &QTimer::timeout, this, &CMainWindow::updateProgress);
}

bool CMainWindow::open(const QString& path) {
    try {
        m_document.open(path);
    } catch (const CError& e) {
        tellError(tr("Cannot open the tree"), QString::fromUtf8(e.what()));
        return false;
    }
    remember(m_document.path());
    return true;
}

bool CMainWindow::save(const QString& path) {
    try {
        m_document.save(path);
    } catch (const CError& e) {
        tellError(tr("Cannot save the tree"), QString::fromUtf8(e.what()));
        return false;
    }
    remember(m_document.path());
    m_panel->showParams(m_document.params());
    m_notice->setText(tr("Saved %1").arg(m_document.path()));
    return true;
}

void CMainWindow::showOnly(Model model) {
    m_only = model;
    onChanged();
}

void CMainWindow::onReplaced() {
    m_recentreNext = true;
    updateMessages();
    onChanged();
}

void CMainWindow::onChanged() {
    m_panel->showParams(m_document.params());
    updateTextures();
    m_notice->clear();
    m_thread->request(m_document.params(), detailOf(m_only.value_or(Model::Simple)));
    m_progressTimer.start();
    if (!m_only) m_pause.start();
}

/// The full model follows when the hand rests.
void CMainWindow::requestFull() {
    if (m_panel->held() || m_only) return;
    m_thread->request(m_document.params(), detailOf(Model::Full));
    m_progressTimer.start();
}

void CMainWindow::onCreated(const std::shared_ptr<const ViewModel>& view) {
    m_shown = view;
    m_viewport->show(view->parts);
    const TreeModel& model = *view->model;
    if (m_recentreNext && model.params == m_document.params()) { // not a late picture of the document before
        m_viewport->recentre();
        m_recentreNext = false;
    }
    const QLocale numbers;
    m_counts->setText(tr("%1   %2 stems   %3 leaves   %4 vertices   %5 triangles   %6 ms")
                          .arg(model.detail->model == Model::Simple ? tr("Simple model") : tr("Full model"),
                               numbers.toString(qulonglong(model.tree->stemCount())),
                               numbers.toString(qulonglong(model.tree->leaves().size())),
                               numbers.toString(qulonglong(model.vertexCount())),
                               numbers.toString(qulonglong(model.triangleCount())),
                               numbers.toString(model.milliseconds.total, 'f', 1)));
    emit modelShown();
}

void CMainWindow::onFailed(const QString& why) {
    m_notice->setText(why);
    m_notice->setToolTip(why);
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
    setWindowTitle(QStringLiteral("%1[*] — Stromar").arg(m_document.displayName()));
    setWindowModified(!m_document.history().isClean());
}

void CMainWindow::updateTextures() {
    const auto update = [this](Surface surface, QString& shown) {
        const QString file = fromPath(textureOf(m_document.params(), surface, m_document.folder()));
        if (file == shown) return;
        shown = file;
        if (const QString problem = m_viewport->setTexture(surface, file); !problem.isEmpty()) onFailed(problem);
    };
    update(Surface::Bark, m_shownBark);
    update(Surface::Leaf, m_shownLeaf);
}

void CMainWindow::updateMessages() {
    m_messages->clear();
    for (const Message& message : m_document.warnings())
        m_messages->addItem(QString::fromStdString(message.toString()));
    m_messageDock->setVisible(!m_document.warnings().empty());
}

void CMainWindow::tellError(const QString& title, const QString& text) { QMessageBox::critical(this, title, text); }

// The commands

void CMainWindow::startNew() {
    if (mayLoseChanges()) m_document.startNew();
}

void CMainWindow::chooseAndOpen() {
    if (!mayLoseChanges()) return;
    const QString start = m_document.path().isEmpty() ? fromPath(dataFolder() / "presets") : m_document.path();
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a tree"), start, treeFilter());
    if (!path.isEmpty()) open(path);
}

void CMainWindow::saveAgain() { saveOrChoose(); }

bool CMainWindow::saveOrChoose() {
    if (!m_document.path().isEmpty()) return save(m_document.path());
    chooseAndSave();
    return m_document.history().isClean();
}

void CMainWindow::chooseAndSave() {
    const QString start = m_document.path().isEmpty() ? m_document.displayName() : m_document.path();
    QFileDialog dialog(this, tr("Save the tree"), start, treeFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("tree"));
    dialog.selectFile(start);
    if (dialog.exec() == QDialog::Accepted) save(dialog.selectedFiles().front());
}

void CMainWindow::chooseAndExport() {
    const bool full = m_shown && m_shown->model->detail == &detailOf(Model::Full);
    const double vertices =
        full ? double(m_shown->model->vertexCount()) : predictSize(m_document.params(), detailOf(Model::Full)).vertices;
    CExportDialog dialog(QFileInfo(m_document.displayName()).completeBaseName(), vertices, this);
    if (dialog.exec() == QDialog::Accepted) exportTo(dialog.path(), dialog.options());
}

void CMainWindow::exportTo(const QString& path, const ExportOptions& options) {
    if (m_export) return;
    const bool ready = m_shown && m_shown->model->params == m_document.params();
    m_export =
        std::make_unique<CExportJob>(CExportJob::Task{m_document.params(), ready ? m_shown->model : nullptr, options,
                                                      m_document.folder(), toPath(path), m_mostVertices});
    auto* dialog = new QProgressDialog(tr("Writing %1").arg(QFileInfo(path).fileName()), tr("Cancel"), 0, 1000, this);
    dialog->setWindowModality(Qt::WindowModal);
    dialog->setMinimumDuration(300);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    auto* poll = new QTimer(dialog);
    connect(poll, &QTimer::timeout, dialog, [this, dialog] {
        if (m_export) dialog->setValue(std::min(999, static_cast<int>(m_export->progress() * 1000)));
    });
    poll->start(100);
    connect(dialog, &QProgressDialog::canceled, this, [this] {
        if (m_export) m_export->cancel();
    });
    connect(
        m_export.get(), &CExportJob::finished, this,
        [this, dialog, path](const QString& why, bool cancelled) {
            dialog->disconnect(this);
            dialog->close();
            m_export.reset();
            if (!why.isEmpty())
                tellError(tr("Cannot export the tree"), why);
            else
                m_notice->setText(cancelled ? tr("Export cancelled; no file was changed")
                                            : tr("Exported %1").arg(path));
            emit exportEnded(why, cancelled);
        },
        Qt::QueuedConnection);
    m_export->start();
    m_progressTimer.start();
}

void CMainWindow::chooseTexture(const TextInfo& text) {
    const QString start =
        m_document.folder().empty() ? fromPath(dataFolder() / "textures") : fromPath(m_document.folder());
    const QString path =
        QFileDialog::getOpenFileName(this, toQString(text.label), start,
                                     tr("Pictures (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;All files (*)"));
    if (path.isEmpty()) return;
    const bool saved = !m_document.path().isEmpty();
    const std::string own = saved ? rebasedPath(QFileInfo(path).fileName().toStdString(),
                                                toPath(QFileInfo(path).absolutePath()), m_document.folder())
                                  : path.toStdString();
    m_document.setText(text, QString::fromStdString(own));
}

void CMainWindow::chooseBark() { chooseTexture(*std::get<const TextInfo*>(*findParam("BarkTexture"))); }
void CMainWindow::chooseLeaf() { chooseTexture(*std::get<const TextInfo*>(*findParam("LeafTexture"))); }
void CMainWindow::closeWindow() { close(); }
void CMainWindow::undo() { m_document.history().undo(); }
void CMainWindow::redo() { m_document.history().redo(); }

void CMainWindow::throwDice() {
    const ParamRef seed = std::get<ParamRef>(*findParam("Seed"));
    m_document.setValue(seed, QRandomGenerator::global()->bounded(kMostSeed + 1), 0);
}

void CMainWindow::generate() {
    m_thread->request(m_document.params(), detailOf(m_only.value_or(Model::Full)), true);
    m_progressTimer.start();
}

void CMainWindow::showFullModel() {
    m_pause.stop();
    m_only.reset();
    m_thread->request(m_document.params(), detailOf(Model::Full));
    m_progressTimer.start();
}

void CMainWindow::toggleWired() { m_viewport->setWireframe(findChild<QAction*>(QStringLiteral("wired"))->isChecked()); }
void CMainWindow::recentre() { m_viewport->recentre(); }

void CMainWindow::showShortcuts() {
    QString text = tr("<p><b>In the picture</b><br>Left drag: turn<br>Right drag or wheel: nearer and farther<br>"
                      "Both buttons or middle drag: move<br>Space: see the whole tree again</p>"
                      "<p><b>In the parameters</b><br>The wheel changes an editor only after a click into "
                      "it.</p><p><b>Keys</b><table>");
    for (const Command& command : commandTable())
        if (*command.shortcut)
            text += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                        .arg(QLatin1String(command.shortcut),
                             tr2(command.text).remove(QLatin1Char('&')).remove(QChar(0x2026)));
    QMessageBox box(QMessageBox::NoIcon, tr("Mouse and keys"), text + QStringLiteral("</table></p>"),
                    QMessageBox::Close, this);
    box.exec();
}

void CMainWindow::showAbout() {
    QMessageBox::about(this, tr("About Stromar"),
                       tr("<p><b>Stromar %1</b></p><p>Grows trees by the model of Weber and Penn, "
                          "“Creation and Rendering of Realistic Trees”, SIGGRAPH ’95.</p>")
                           .arg(QApplication::applicationVersion()));
}

// Files

void CMainWindow::remember(const QString& path) {
    QSettings settings;
    QStringList files = settings.value(QLatin1String(kRecentKey)).toStringList();
    files.removeAll(path);
    files.prepend(path);
    settings.setValue(QLatin1String(kRecentKey), QStringList(files.mid(0, kMostRecent)));
    fillRecentMenu();
}

void CMainWindow::fillRecentMenu() {
    m_recentMenu->clear();
    const QStringList files = QSettings().value(QLatin1String(kRecentKey)).toStringList();
    for (const QString& file : files)
        m_recentMenu
            ->addAction(QFileInfo(file).fileName(), this,
                        [this, file] {
                            if (mayLoseChanges()) open(file);
                        })
            ->setStatusTip(file);
    m_recentMenu->setEnabled(!files.isEmpty());
}

bool CMainWindow::mayLoseChanges() {
    if (m_document.history().isClean()) return true;
    const auto answer =
        QMessageBox::question(this, tr("Unsaved changes"), tr("Save the changes of %1?").arg(m_document.displayName()),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) return saveOrChoose();
    return answer == QMessageBox::Discard;
}

void CMainWindow::closeEvent(QCloseEvent* event) {
    if (!mayLoseChanges()) return event->ignore();
    QSettings().setValue(QStringLiteral("geometry"), saveGeometry());
    event->accept();
}

} // namespace stromar
