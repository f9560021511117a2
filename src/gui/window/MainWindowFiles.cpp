#include "document/Autosave.h"
#include "work/ExportDialog.h"
#include "work/ExportJob.h"
#include "window/MainWindow.h"
#include "params/ParamPanel.h"
#include "library/PresetBrowser.h"
#include "window/QtText.h"
#include "library/TextureWorkshop.h"
#include "stromar/app/Prediction.h"
#include "stromar/texture/Draw.h"
#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageReader>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>

// What the window does with files: trees, presets, pictures, exports, and what a crash has left.

namespace stromar {

namespace {
constexpr int kMaxRecent = 10;
constexpr const char* kRecentKey = "recentFiles";

QString treeFilter() { return CMainWindow::tr("Trees (*.tree);;All files (*)"); }



bool isPicture(const QString& path) {
    return QImageReader::supportedImageFormats().contains(QFileInfo(path).suffix().toLower().toLatin1());
}

/// The one local file of a drag; empty when there is none we take.
QString droppedFile(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    if (urls.size() != 1 || !urls.front().isLocalFile()) return {};
    const QString path = urls.front().toLocalFile();
    return path.endsWith(QLatin1String(".tree"), Qt::CaseInsensitive) || isPicture(path) ? path : QString();
}
} // namespace

bool CMainWindow::open(const QString& path) {
    try {
        m_document->open(path);
    } catch (const std::exception& e) {
        tellError(tr("Cannot open the tree"), QString::fromUtf8(e.what()));
        return false;
    }
    remember(m_document->path());
    return true;
}

bool CMainWindow::openPreset(const QString& path) {
    if (!mayLoseChanges()) return false;
    try {
        m_document->loadPreset(path);
    } catch (const std::exception& e) {
        tellError(tr("Cannot open the preset"), QString::fromUtf8(e.what()));
        return false;
    }
    return true;
}

bool CMainWindow::save(const QString& path) {
    try {
        m_document->save(path);
    } catch (const std::exception& e) {
        tellError(tr("Cannot save the tree"), QString::fromUtf8(e.what()));
        return false;
    }
    m_watch.watch(m_document->path());
    remember(m_document->path());
    m_panel->showParams(m_document->params(), m_document->savedParams());
    updateAutosave();
    m_notice->setText(tr("Saved %1").arg(m_document->path()));
    return true;
}

void CMainWindow::startNew(const ParamBlock& block) {
    if (mayLoseChanges()) m_document->startNew(block);
}

void CMainWindow::chooseAndOpen() {
    if (!mayLoseChanges()) return;
    const QString start = m_document->path().isEmpty() ? fromPath(dataFolder() / "presets") : m_document->path();
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a tree"), start, treeFilter());
    if (!path.isEmpty()) open(path);
}

void CMainWindow::saveAgain() { saveOrChoose(); }

/// What is typed but not yet taken counts.
void CMainWindow::takeTyped() {
    if (QWidget* editor = focusWidget()) {
        editor->clearFocus();
        editor->setFocus();
    }
}

bool CMainWindow::saveOrChoose() {
    takeTyped();
    if (!m_document->path().isEmpty()) return save(m_document->path());
    chooseAndSave();
    return !m_document->isModified();
}

void CMainWindow::chooseAndSave() {
    takeTyped();
    const QString start = m_document->path().isEmpty() ? m_document->displayName() : m_document->path();
    QFileDialog dialog(this, tr("Save the tree"), start, treeFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("tree"));
    dialog.selectFile(start);
    if (dialog.exec() == QDialog::Accepted) save(dialog.selectedFiles().front());
}

void CMainWindow::savePreset() {
    takeTyped();
    const QString suggestion = toQString(m_document->params().text.species);
    bool wanted = false;
    const QString name = QInputDialog::getText(this, tr("Save as Preset"), tr("Name of the preset"), QLineEdit::Normal,
                                               suggestion, &wanted)
                             .trimmed();
    if (!wanted || name.isEmpty()) return;
    QString file = name;
    file.replace(QRegularExpression(QStringLiteral("[^\\w-]+"), QRegularExpression::UseUnicodePropertiesOption),
                 QStringLiteral("_"));
    const QString path = QDir(CPresetBrowser::ownFolder()).filePath(file + QStringLiteral(".tree"));
    if (QFileInfo::exists(path) &&
        QMessageBox::question(this, tr("Save as Preset"), tr("Replace the preset “%1”?").arg(name)) != QMessageBox::Yes)
        return;
    try {
        m_document->saveCopy(path, name);
        m_presets->refresh();
        m_notice->setText(tr("Saved %1").arg(path));
    } catch (const std::exception& e) {
        tellError(tr("Cannot save the preset"), QString::fromUtf8(e.what()));
    }
}

// Exports

void CMainWindow::chooseAndExport() {
    takeTyped();
    const bool full = m_shown && m_shown->model->detail == &detailOf(Model::Full);
    const double vertices = full ? double(m_shown->model->vertexCount())
                                 : predictSize(m_document->params(), detailOf(Model::Full)).vertices;
    CExportDialog dialog(QFileInfo(m_document->displayName()).completeBaseName(), vertices, this);
    if (dialog.exec() == QDialog::Accepted) exportTo(dialog.path(), dialog.options());
}

void CMainWindow::exportTo(const QString& path, const ExportOptions& options) {
    if (m_export) return;
    const bool ready = m_shown && m_shown->model->params == m_document->params();
    m_export =
        std::make_unique<CExportJob>(CExportJob::Task{m_document->params(), ready ? m_shown->model : nullptr, options,
                                                      m_document->folder(), toPath(path), limits()});
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

// Pictures on the tree

void CMainWindow::chooseTexture(const char* key) {
    const ParamRef text = *findParam(key, m_document->params().block());
    const QString start =
        m_document->folder().empty() ? fromPath(dataFolder() / "textures") : fromPath(m_document->folder());
    const QString path = QFileDialog::getOpenFileName(
        this, trText(text.info->label), start, tr("Pictures (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;All files (*)"));
    if (!path.isEmpty()) setTexture(text, path);
}

void CMainWindow::setTexture(const ParamRef& text, const QString& path) {
    const bool saved = !m_document->path().isEmpty();
    const std::string own = saved ? rebasedPath(QFileInfo(path).fileName().toStdString(),
                                                toPath(QFileInfo(path).absolutePath()), m_document->folder())
                                  : path.toStdString();
    m_document->setValue(text, own, 0);
}

/// With the recipe that the surface has, or with the first of the book.
void CMainWindow::openWorkshop(const ParamRef& text) {
    const std::string& own = text.text(m_document->params());
    std::string start = isRecipe(own) ? own : plainRecipes(text.info->recipes).front();
    try {
        CTextureWorkshop workshop{CRecipe(start), this};
        if (workshop.exec() == QDialog::Accepted)
            m_document->setValue(text, workshop.recipe().text(), 0);
    } catch (const CError& e) {
        onFailed(QString::fromUtf8(e.what()));
    }
}

void CMainWindow::updateTextures() {
    const CParams& params = m_document->params();
    const SurfaceTextures whole = texturesOf(params, m_document->folder());
    const auto isThere = [](const std::filesystem::path& file) {
        std::error_code problem;
        return std::filesystem::exists(file, problem);
    };
    for (const Surface surface : kSurfaces) {
        if (!hasSurface(params, surface)) continue;
        const auto i = static_cast<std::size_t>(surface);
        std::filesystem::path wanted = whole[i];
        const bool drawn = isRecipe(pictureOf(params, surface)); // then it comes after its tree, first in small
        if (drawn && !isThere(wanted)) wanted = textureOf(params, surface, {}, Drawn::Preview);
        if (wanted == m_shownTextures[i] || (drawn && !isThere(wanted))) continue;
        m_shownTextures[i] = wanted;
        if (const QString why = m_viewport->setTexture(surface, fromPath(wanted)); !why.isEmpty()) onFailed(why);
    }
}

void CMainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void CMainWindow::dropEvent(QDropEvent* event) {
    const QString path = droppedFile(*event->mimeData());
    if (path.isEmpty()) return;
    event->acceptProposedAction();
    if (!isPicture(path)) {
        if (mayLoseChanges()) open(path);
        return;
    }
    QMenu menu;
    menu.addAction(tr("As the &bark"), this, [this, path] { setTexture(*findParam("BarkTexture", m_document->params().block()), path); });
    menu.addAction(tr("As the &leaf"), this, [this, path] { setTexture(*findParam("LeafTexture", m_document->params().block()), path); });
    menu.exec(mapToGlobal(event->position().toPoint()));
}

// What must not be lost

void CMainWindow::updateAutosave() {
    if (m_document->isModified())
        m_autosave->keep(m_document->kept());
    else
        m_autosave->clear();
}

void CMainWindow::offerRestore() {
    for (const CAutosave::Leftover& leftover : CAutosave::leftovers(CAutosave::standardFolder())) {
        const QString name = leftover.path.isEmpty() ? tr("A tree that was never saved") : leftover.path;
        QMessageBox box(QMessageBox::Question, tr("Restore unsaved changes"),
                        tr("Stromar ended without saving these changes of %1:\n%2")
                            .arg(QLocale().toString(leftover.time, QLocale::ShortFormat), name),
                        QMessageBox::NoButton, this);
        const QPushButton* restore = box.addButton(tr("&Restore"), QMessageBox::AcceptRole);
        const QPushButton* discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
        box.addButton(tr("Ask &Later"), QMessageBox::RejectRole);
        box.exec();
        if (box.clickedButton() == discard) CAutosave::remove(leftover);
        if (box.clickedButton() != restore) continue;
        try {
            m_document->restore(leftover.path, CTreeFile::read(toPath(leftover.file)).params());
            updateAutosave();
            if (m_autosave->flush()) CAutosave::remove(leftover); // it is safe again
        } catch (const std::exception& e) {
            tellError(tr("Cannot restore"), QString::fromUtf8(e.what()));
        }
        return; // one document per window; the others are offered next time
    }
}

bool CMainWindow::mayLoseChanges() {
    takeTyped();
    if (!m_document->isModified()) return true;
    const auto answer =
        QMessageBox::question(this, tr("Unsaved changes"), tr("Save the changes of %1?").arg(m_document->displayName()),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) return saveOrChoose();
    return answer == QMessageBox::Discard;
}

void CMainWindow::closeEvent(QCloseEvent* event) {
    if (!mayLoseChanges()) return event->ignore();
    keepLayout();
    event->accept();
}

// Recent files

void CMainWindow::remember(const QString& path) {
    QSettings settings;
    QStringList files = settings.value(QLatin1String(kRecentKey)).toStringList();
    files.removeAll(path);
    files.prepend(path);
    settings.setValue(QLatin1String(kRecentKey), QStringList(files.mid(0, kMaxRecent)));
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

} // namespace stromar
