#pragma once
#include "document/Document.h"
#include "document/FileWatch.h"
#include "work/TreeCreatorThread.h"
#include "view/ViewController.h"
#include "stromar/app/ExportOptions.h"
#include "stromar/app/Pictures.h"
#include <QMainWindow>
#include <QPointer>
#include <QTimer>
#include <memory>

class QDockWidget;
class QLabel;
class QListWidget;
class QMenu;
class QProgressBar;

namespace stromar {

struct Command;
class CAutosave;
class CExportJob;
class CHelpWindow;
class CLightPanel;
class CMessageBar;
class CParamPanel;
class CPresetBrowser;
class CThumbnails;
class CVariants;

/// The window: viewport, parameters, docks, menus; brings document, worker and widgets together.
class CMainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// Without a document it starts a new one. A document that is handed over comes from another window.
    explicit CMainWindow(const SizeLimits& limits = {},
                         std::shared_ptr<CDocument> document = nullptr, QWidget* parent = nullptr);
    ~CMainWindow() override;

    /// False, with a message shown, when the file cannot be read; then nothing has changed.
    bool open(const QString& path);
    bool save(const QString& path);
    /// Puts the tree of a preset into the document, which can be undone. False, with a message, when it cannot be read.
    bool openPreset(const QString& path);
    /// Returns at once; exportEnded tells how it went.
    void exportTo(const QString& path, const ExportOptions& options = {});
    /// Which model follows a change; the default shows the simple one first, then the full one.
    void showOnly(Model model);
    /// Stores where everything stands, for the next window.
    void keepLayout() const;
    /// Offers what a crash has left.
    void offerRestore();

    CDocument& document() { return *m_document; }
    const std::shared_ptr<CDocument>& sharedDocument() const { return m_document; }
    CViewport& viewport() { return *m_viewport; }
    CViewController& view() { return *m_viewController; }
    CParamPanel& panel() { return *m_panel; }
    CPresetBrowser& presets() { return *m_presets; }
    CVariants& variants() { return *m_variants; }
    CMessageBar& bar() { return *m_bar; }
    CAutosave& autosave() { return *m_autosave; }
    /// Whether a tree grows or a thumbnail is still to come.
    bool busy() const;
    /// What the viewport shows; null before the first tree.
    const ViewModel* shown() const { return m_shown.get(); }

    // The commands of the table.
    void startNew(const ParamBlock& block = weberPennBlock());
    void chooseAndOpen();
    void saveAgain();
    void chooseAndSave();
    void savePreset();
    void chooseAndExport();
    void chooseTexture(const char* key);
    void findParameter();
    void showPreferences();
    void throwDice();
    void generate();
    void showFullModel();
    void stop();
    /// `other` is the switch that goes off.
    void setWireframe(Wireframe wireframe, const char* other);
    void resetLayout();
    void showManual();
    void showShortcuts();
    void showAbout();

signals:
    /// The viewport has a new model.
    void modelShown();
    void exportEnded(const QString& why, bool cancelled);
    /// Language or units are others now: this window should give way to a new one with the same document.
    void rebuildWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    static constexpr int kLayoutVersion = 2; ///< rises when docks come or go

    void makeCentre();
    void makeDocks();
    QDockWidget* addDock(const char* name, const QString& title, QWidget* widget, Qt::DockWidgetArea area);
    void makeActions();
    QAction* makeAction(const Command& command);
    void addMethods(QMenu& menu);
    void restoreSwitches();
    void makeStatusBar();
    void connectParts();
    void connectDocument();
    void restoreLayout();
    void fillRecentMenu();
    void remember(const QString& path);

    void onReplaced();
    void onChanged();
    void onCreated(const std::shared_ptr<const ViewModel>& view);
    void onFailed(const QString& why);
    void onSetting(const QString& key);
    void setMaxMemory(int gigabytes);
    void onFileChanged();
    void onContextLost();
    void request(Model model, bool anew = false);
    void requestFull();
    /// Whether the tree may grow; else asks what to do about its size.
    bool mayGrow();
    void offerSmaller(const Prediction& size);
    void updateTitle();
    void updateTextures();
    void openWorkshop(const ParamRef& text);
    void updateMessages();
    void updateProgress();
    void updateAutosave();
    void updateCounts(const TreeModel& model);
    void setTexture(const ParamRef& text, const QString& path);
    bool mayLoseChanges();
    void tellError(const QString& title, const QString& text);
    bool saveOrChoose();
    void takeTyped();
    /// For the tree as it is: none where the user let a large one grow.
    SizeLimits limits() const;
    void showPresets();

    std::shared_ptr<CDocument> m_document;
    CThumbnails* m_thumbnails;
    std::unique_ptr<CViewport> m_withoutPicture; ///< owns the viewport where there is no OpenGL
    CViewport* m_viewport;
    CParamPanel* m_panel;
    CPresetBrowser* m_presets;
    CVariants* m_variants;
    CMessageBar* m_bar;
    CLightPanel* m_light = nullptr;
    CViewController* m_viewController;
    QPointer<CHelpWindow> m_help;
    QMenu* m_recentMenu = nullptr;
    QDockWidget* m_messageDock = nullptr;
    QListWidget* m_messages = nullptr;
    QLabel* m_counts = nullptr;
    QLabel* m_notice = nullptr;
    QProgressBar* m_progress = nullptr;
    QTimer m_pause; ///< until the full model follows
    QTimer m_progressTimer;
    CFileWatch m_watch;
    std::shared_ptr<const ViewModel> m_shown;
    std::unique_ptr<CExportJob> m_export;
    std::unique_ptr<CAutosave> m_autosave;
    SurfaceTextures m_shownTextures;
    QByteArray m_firstLayout;
    std::optional<Model> m_only;
    SizeLimits m_limits;
    double m_givenMemory; ///< bytes; the limit where the user sets none
    CParams m_allowed; ///< may grow although they are large
    CParams m_fitting; ///< the last values that were not too large
    bool m_recentreNext = true;
    bool m_preferencesOpen = false, m_rebuildLater = false;
    bool m_started = false;                       ///< a tree was shown
    std::unique_ptr<CTreeCreatorThread> m_thread; ///< last: it stops before anything it reports to is gone
};

} // namespace stromar
