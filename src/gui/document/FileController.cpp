#include "document/FileController.h"
#include "document/Gesture.h"
#include "library/PresetBrowser.h"
#include "library/TextureWorkshop.h"
#include "window/MessageBar.h"
#include "window/QtText.h"
#include "stromar/app/Import.h"
#include "stromar/app/Pictures.h"
#include "stromar/texture/Draw.h"
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageReader>
#include <QInputDialog>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>

namespace stromar {

namespace {
constexpr int kMaxRecent = 10;
constexpr int kWorkshopEdge = 8; // pixels to the window's
constexpr const char* kRecentKey = "recentFiles";
constexpr const char* kAboutFile = "file";

QString treeFilter() { return CFileController::tr("Trees (*.tree);;All files (*)"); }


bool isPicture(const QString& path) {
    return QImageReader::supportedImageFormats().contains(QFileInfo(path).suffix().toLower().toLatin1());
}
} // namespace

CFileController::CFileController(CDocument& document, CMessageBar& bar, QWidget* window)
    : QObject(window), m_document(document), m_bar(bar), m_window(window), m_autosave(CAutosave::standardFolder()) {
    connect(&m_watch, &CFileWatch::changed, this, &CFileController::onFileChanged);
    connect(&m_autosave, &CAutosave::failed, this, [this](const QString& why) { emit failed(tr("Autosave: %1").arg(why)); });
}

CFileController::~CFileController() = default;

QString CFileController::droppedFile(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    if (urls.size() != 1 || !urls.front().isLocalFile()) return {};
    const QString path = urls.front().toLocalFile();
    return path.endsWith(QLatin1String(".tree"), Qt::CaseInsensitive) || isPicture(path) || mayImport(toPath(path)) ? path : QString();
}

void CFileController::tellError(const QString& title, const QString& text) {
    QMessageBox::critical(m_window, title, text);
}

bool CFileController::import(const QString& path) {
    try {
        m_document.import(path);
        m_changesBehind = false;
        return true;
    } catch (const std::exception& e) {
        tellError(tr("Cannot import the tree"), errorText(e));
        return false;
    }
}

void CFileController::chooseAndImport() {
    if (!mayLoseChanges()) return;
    QStringList kinds, all;
    for (const ImportFormat& format : importTable()) {
        const QStringList endings = toQString(format.endings).split(QLatin1Char(' '));
        QStringList patterns;
        for (const QString& ending : endings) patterns << QLatin1Char('*') + ending;
        all << patterns;
        kinds << QStringLiteral("%1 (%2)").arg(trText(format.name), patterns.join(QLatin1Char(' ')));
    }
    all.removeDuplicates();
    kinds.prepend(QStringLiteral("%1 (%2)").arg(tr("Trees of other programs"), all.join(QLatin1Char(' '))));
    const QString path = QFileDialog::getOpenFileName(m_window, tr("Import a tree"), {}, kinds.join(QStringLiteral(";;")));
    if (!path.isEmpty()) import(path);
}

bool CFileController::open(const QString& path) {
    try {
        m_document.open(path);
        m_changesBehind = false;
    } catch (const std::exception& e) {
        tellError(tr("Cannot open the tree"), errorText(e));
        return false;
    }
    remember(m_document.path());
    return true;
}

bool CFileController::openPreset(const QString& path) {
    takeTyped(*m_window);
    const bool changed = m_document.isModified();
    try {
        m_document.loadPreset(path);
        m_changesBehind |= changed;
    } catch (const std::exception& e) {
        tellError(tr("Cannot open the preset"), errorText(e));
        return false;
    }
    return true;
}

void CFileController::startWith(const QString& path) {
    try {
        m_document.startWith(path);
    } catch (const CError&) {
        // A new tree stays.
    }
}

bool CFileController::save(const QString& path) {
    try {
        m_document.save(path);
        m_changesBehind = false;
    } catch (const std::exception& e) {
        tellError(tr("Cannot save the tree"), errorText(e));
        return false;
    }
    m_watch.watch(m_document.path());
    remember(m_document.path());
    emit saved();
    keepAside();
    emit notice(tr("Saved %1").arg(m_document.path()));
    return true;
}

void CFileController::startNew(const ParamBlock& block) {
    if (!mayLoseChanges()) return;
    m_document.startNew(block);
    m_changesBehind = false;
}

void CFileController::chooseAndOpen() {
    if (!mayLoseChanges()) return;
    const QString start = m_document.path().isEmpty() ? fromPath(dataFolder() / "presets") : m_document.path();
    const QString path = QFileDialog::getOpenFileName(m_window, tr("Open a tree"), start, treeFilter());
    if (!path.isEmpty()) open(path);
}

void takeTyped(QWidget& window) {
    if (QWidget* editor = window.focusWidget()) {
        editor->clearFocus();
        editor->setFocus();
    }
}

bool CFileController::saveOrChoose() {
    takeTyped(*m_window);
    if (!m_document.path().isEmpty()) return save(m_document.path());
    chooseAndSave();
    return !m_document.isModified();
}

void CFileController::chooseAndSave() {
    takeTyped(*m_window);
    const QString start = m_document.path().isEmpty() ? m_document.displayName() : m_document.path();
    QFileDialog dialog(m_window, tr("Save the tree"), start, treeFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("tree"));
    dialog.selectFile(start);
    if (dialog.exec() == QDialog::Accepted) save(dialog.selectedFiles().front());
}

void CFileController::savePreset() {
    takeTyped(*m_window);
    const QString suggestion = toQString(m_document.params().text.species);
    bool wanted = false;
    const QString name = QInputDialog::getText(m_window, tr("Save as Preset"), tr("Name of the preset"), QLineEdit::Normal,
                                               suggestion, &wanted)
                             .trimmed();
    if (!wanted || name.isEmpty()) return;
    QString file = name;
    file.replace(QRegularExpression(QStringLiteral("[^\\w-]+"), QRegularExpression::UseUnicodePropertiesOption),
                 QStringLiteral("_"));
    const QString path = QDir(CPresetBrowser::ownFolder()).filePath(file + QStringLiteral(".tree"));
    if (QFileInfo::exists(path) &&
        QMessageBox::question(m_window, tr("Save as Preset"), tr("Replace the preset “%1”?").arg(name)) != QMessageBox::Yes)
        return;
    try {
        m_document.saveCopy(path, name);
        emit presetSaved();
        emit notice(tr("Saved %1").arg(path));
    } catch (const std::exception& e) {
        tellError(tr("Cannot save the preset"), errorText(e));
    }
}

// Pictures on the tree, and meshes of its leaves

void CFileController::chooseFile(const ParamRef& text) {
    const QString start =
        m_document.folder().empty() ? fromPath(dataFolder() / "textures") : fromPath(m_document.folder());
    const QString path = QFileDialog::getOpenFileName(
        m_window, trText(text.info->label), start,
        text.info->picture() ? tr("Pictures (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;All files (*)")
                             : tr("Meshes (*.obj *.glb);;All files (*)"));
    if (!path.isEmpty()) setFile(text, path);
}

void CFileController::setFile(const ParamRef& text, const QString& path) {
    const bool saved = !m_document.path().isEmpty();
    const std::string own = saved ? rebasedPath(QFileInfo(path).fileName().toStdString(),
                                                toPath(QFileInfo(path).absolutePath()), m_document.folder())
                                  : path.toStdString();
    m_document.setValue(text, own, 0);
}

/// With the recipe that the surface has, or with the first of the book. The tree wears it at once, as one step.
void CFileController::openWorkshop(const ParamRef& text) {
    const std::string own = text.text(m_document.params());
    const std::string start = isRecipe(own) ? own : plainRecipes(text.info->recipes).front();
    if (m_workshop) m_workshop->accept(); // what was made there stays
    try {
        m_workshop = new CTextureWorkshop(CRecipe(start), aspectOf(text), m_window);
    } catch (const CError& e) {
        return tellError(tr("Cannot open the workshop"), errorText(e));
    }
    m_workshop->setAttribute(Qt::WA_DeleteOnClose);
    const auto wear = [this, text, gesture = nextGesture()](const std::string& value) { m_document.setValue(text, value, gesture); };
    const auto wearRecipe = [workshop = m_workshop.data(), wear] { wear(workshop->recipe().text()); };
    connect(m_workshop, &CTextureWorkshop::changed, this, wearRecipe);
    connect(m_workshop, &QDialog::accepted, this, wearRecipe);
    connect(m_workshop, &QDialog::rejected, this, [wear, own] { wear(own); });
    connect(&m_document, &CDocument::replaced, m_workshop, [workshop = m_workshop.data(), this] {
        workshop->disconnect(this);
        workshop->close();
    });
    m_workshop->adjustSize(); // beside the tree that wears it
    m_workshop->move(m_window->mapToGlobal(QPoint(m_window->width() - m_workshop->width() - kWorkshopEdge, m_window->height() / 3)));
    m_workshop->show();
}

/// Of a leaf, as the tree has it.
double CFileController::aspectOf(const ParamRef& text) const {
    const auto width = findParam("LeafScaleX", m_document.params().block());
    const bool leaf = text.info->recipes == "leaf";
    return leaf && width ? std::max(0.05, width->get(m_document.params())) : 1;
}

void CFileController::drop(const QString& path, const QPoint& at) {
    if (!isPicture(path)) {
        if (mayLoseChanges()) mayImport(toPath(path)) ? import(path) : open(path);
        return;
    }
    QMenu menu;
    const auto offer = [&](const QString& text, const char* key) {
        menu.addAction(text, this, [this, path, key] { setFile(*findParam(key, m_document.params().block()), path); });
    };
    offer(tr("As the &bark"), "BarkTexture");
    offer(tr("As the &leaf"), "LeafTexture");
    menu.exec(at);
}

// What must not be lost

void CFileController::watchFile() {
    m_watch.watch(m_document.path());
    m_bar.dismiss(QLatin1String(kAboutFile));
}

void CFileController::onFileChanged() {
    const QString path = m_document.path();
    const QString text = m_document.isModified()
                             ? tr("Another program has changed %1. Opening it again loses your changes.")
                             : tr("Another program has changed %1.");
    m_bar.ask(QLatin1String(kAboutFile), text.arg(m_document.displayName()),
              {{tr("Open it again"), [this, path] { open(path); }}, {tr("Keep mine"), [this] {
                                                                         m_document.keepAgainstFile();
                                                                         keepAside();
                                                                     }}});
}

void CFileController::keepAside() {
    if (m_document.isModified())
        m_autosave.keep(m_document.kept());
    else
        m_autosave.clear();
}

void CFileController::offerRestore() {
    for (const CAutosave::Leftover& leftover : CAutosave::leftovers(CAutosave::standardFolder())) {
        const QString name = leftover.path.isEmpty() ? tr("A tree that was never saved") : leftover.path;
        QMessageBox box(QMessageBox::Question, tr("Restore unsaved changes"),
                        tr("Stromar ended without saving these changes of %1:\n%2")
                            .arg(QLocale().toString(leftover.time, QLocale::ShortFormat), name),
                        QMessageBox::NoButton, m_window);
        const QPushButton* restore = box.addButton(tr("&Restore"), QMessageBox::AcceptRole);
        const QPushButton* discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
        box.addButton(tr("Ask &Later"), QMessageBox::RejectRole);
        box.exec();
        if (box.clickedButton() == discard) CAutosave::remove(leftover);
        if (box.clickedButton() != restore) continue;
        try {
            m_document.restore(leftover.path, CTreeFile::read(toPath(leftover.file)).params());
            keepAside();
            if (m_autosave.flush()) CAutosave::remove(leftover); // it is safe again
        } catch (const std::exception& e) {
            tellError(tr("Cannot restore"), errorText(e));
        }
        return; // one document per window; the others are offered next time
    }
}

bool CFileController::mayLoseChanges() {
    takeTyped(*m_window);
    if (!m_document.isModified() && m_changesBehind)
        return QMessageBox::question(m_window, tr("Unsaved changes"),
                                     tr("Changes from before a preset was opened are not saved; Undo brings them back. Go on without them?"),
                                     QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel) == QMessageBox::Discard;
    if (!m_document.isModified()) return true;
    const auto answer =
        QMessageBox::question(m_window, tr("Unsaved changes"), tr("Save the changes of %1?").arg(m_document.displayName()),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) return saveOrChoose();
    return answer == QMessageBox::Discard;
}

// Recent files

void CFileController::remember(const QString& path) {
    QSettings settings;
    QStringList files = settings.value(QLatin1String(kRecentKey)).toStringList();
    files.removeAll(path);
    files.prepend(path);
    settings.setValue(QLatin1String(kRecentKey), QStringList(files.mid(0, kMaxRecent)));
    emit recentChanged();
}

void CFileController::fillRecentMenu(QMenu& menu) {
    menu.clear();
    const QStringList files = QSettings().value(QLatin1String(kRecentKey)).toStringList();
    for (const QString& file : files)
        menu.addAction(QFileInfo(file).fileName(), this,
                       [this, file] {
                           if (mayLoseChanges()) open(file);
                       })
            ->setStatusTip(file);
    menu.setEnabled(!files.isEmpty());
}

} // namespace stromar
