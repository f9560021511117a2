#pragma once
#include "document/Autosave.h"
#include "document/Document.h"
#include "document/FileWatch.h"
#include <QObject>
#include <QPointer>
#include <memory>

class QDropEvent;
class QMenu;
class QMimeData;
class QWidget;

namespace stromar {

class CMessageBar;
class CTextureWorkshop;

/// What a window does with files: trees, presets, pictures on the tree, and what a crash has left. Asks and tells by
/// dialogs of the window.
class CFileController : public QObject {
    Q_OBJECT
public:
    CFileController(CDocument& document, CMessageBar& bar, QWidget* window);
    ~CFileController() override;

    /// False, with a message shown, when the file cannot be read; then nothing has changed.
    /// Of another program. False when it cannot be read, which was told.
    bool import(const QString& path);
    void chooseAndImport();
    bool open(const QString& path);
    bool save(const QString& path);
    /// Puts the tree of a preset into the document, which can be undone. False, with a message, when it cannot be read.
    bool openPreset(const QString& path);
    /// As a document of its own, without a word where it cannot be read.
    void startWith(const QString& path);
    void startNew(const ParamBlock& block);
    void chooseAndOpen();
    /// To the document's file, or to one that is asked for. False when nothing was saved.
    bool saveOrChoose();
    void chooseAndSave();
    void savePreset();
    void chooseFile(const ParamRef& text);
    void openWorkshop(const ParamRef& text);
    /// Asks whether changes are to be saved; false: the user wants to go on with them.
    bool mayLoseChanges();
    /// Offers what a crash has left.
    void offerRestore();
    void fillRecentMenu(QMenu& menu);
    /// The one local file of a drag; empty when there is none that can be taken.
    static QString droppedFile(const QMimeData& data);
    void drop(const QString& path, const QPoint& at);

    /// After a change of the document.
    void keepAside();
    /// After the document was replaced.
    void watchFile();
    CAutosave& autosave() { return m_autosave; }

signals:
    void notice(const QString& text);
    void failed(const QString& why);
    void saved();
    void presetSaved();
    void recentChanged();

private:
    double aspectOf(const ParamRef& text) const;
    void setFile(const ParamRef& text, const QString& path);
    void onFileChanged();
    void remember(const QString& path);
    void tellError(const QString& title, const QString& text);

    CDocument& m_document;
    QPointer<CTextureWorkshop> m_workshop;
    CMessageBar& m_bar;
    QWidget* m_window;
    CFileWatch m_watch;
    CAutosave m_autosave;
    bool m_changesBehind = false; ///< that only the history has: a preset was opened over them
};

/// What is typed into a window but not yet taken counts.
void takeTyped(QWidget& window);

} // namespace stromar
