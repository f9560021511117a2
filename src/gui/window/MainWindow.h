#pragma once
#include "document/Document.h"
#include "view/SideBySide.h"
#include "view/ViewController.h"
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
class CComparison;
class CDockFolder;
class CExportController;
class CFileController;
class CGrowthController;
class CHelpWindow;
class CLightPanel;
class CMessageBar;
class CSavedCameras;
class CParamPanel;
class CPresetBrowser;
class CThumbnails;
class CFallController;
class CRandomiser;
class CRecorder;
class CTimeline;
class CVariants;
class CWindController;
class CWindPanel;

/// The window: viewport, parameters, docks, menus; brings document, controllers and widgets together.
class CMainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// Without a document it starts a new one. A document that is handed over comes from another window.
    explicit CMainWindow(const SizeLimits& limits = {},
                         std::shared_ptr<CDocument> document = nullptr, QWidget* parent = nullptr);
    ~CMainWindow() override;

    /// Stores where everything stands, for the next window.
    void keepLayout() const;

    CDocument& document() { return *m_document; }
    const std::shared_ptr<CDocument>& sharedDocument() const { return m_document; }
    CViewport& viewport() { return *m_viewport; }
    CViewController& view() { return *m_viewController; }
    CParamPanel& panel() { return *m_panel; }
    CPresetBrowser& presets() { return *m_presets; }
    CVariants& variants() { return *m_variants; }
    CMessageBar& bar() { return *m_bar; }
    CGrowthController& growth() { return *m_growth; }
    CFileController& files() { return *m_files; }
    CExportController& exporter() { return *m_exporter; }
    CRecorder& recorder() { return *m_recorder; }
    CFallController& fall() { return *m_fall; }
    CTimeline& timeline() { return *m_timeline; }
    CWindPanel& wind() { return *m_wind; }
    CComparison& comparison() { return *m_comparison; }
    CSideBySide& sideBySide() { return *m_sideBySide; }
    /// Whether a tree grows or a thumbnail is still to come.
    bool busy() const;
    /// What the viewport shows; null before the first tree.
    const ViewModel* shown() const { return m_shown.get(); }

    /// For a program that starts without a file: a tree to look at and, the first times, the ways to begin.
    void showStart();

    // The commands of the table.
    void chooseTexture(const char* key);
    void chooseBackdrop();
    void setReference(bool on);
    void saveCamera();
    void setRow(CSideBySide::Row row);
    void findParameter();
    void showPreferences();
    void throwDice();
    void stop();
    /// `other` is the switch that goes off.
    /// Asks what, how and where to, and records growth, wind or fall.
    void record();
    /// Asks where to and how, and fells the tree; or lets it stand again.
    void setFelled(bool felled);
    void setWireframe(Wireframe wireframe, const char* other);
    void resetLayout();
    void showManual();
    void showShortcuts();
    void showAbout();
    void showWelcome();

signals:
    /// The viewport has a new model.
    void modelShown();
    /// Language or units are others now: this window should give way to a new one with the same document.
    void rebuildWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    static constexpr int kLayoutVersion = 4; ///< rises when docks come or go

    void makeCentre();
    void makeDocks();
    QDockWidget* addDock(const char* name, const QString& title, QWidget* widget, Qt::DockWidgetArea area);
    void makeActions();
    QAction* makeAction(const Command& command);
    void addMethods(QMenu& menu);
    void restoreSwitches();
    void makeStatusBar();
    void connectParts();
    void connectMotion();
    void connectDocument();
    void restoreLayout();

    void onReplaced();
    void onChanged();
    void onCreated(const std::shared_ptr<const ViewModel>& view);
    void showNow();
    bool showsSimple() const;
    std::vector<ViewPart> standInParts() const;
    void showNothing();
    void onRefused();
    void onFailed(const QString& why);
    std::shared_ptr<const TreeModel> shownModel() const;
    void onSurfaceRead(Surface surface, const std::shared_ptr<const SurfaceMaps>& maps);
    void connectControllers();
    void onSetting(const QString& key);
    void onContextLost();
    void updateTitle();
    void updateMessages();
    void updateProgress();
    void updateCounts(const TreeModel& model);
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
    CTimeline* m_timeline;
    CWindPanel* m_wind;
    CRecorder* m_recorder;
    CRandomiser* m_randomiser;
    CComparison* m_comparison;
    CSavedCameras* m_cameras;
    CSideBySide* m_sideBySide;
    CViewController* m_viewController;
    QPointer<CHelpWindow> m_help;
    QMenu* m_recentMenu = nullptr;
    CDockFolder* m_folder = nullptr;
    QDockWidget* m_messageDock = nullptr;
    QListWidget* m_messages = nullptr;
    QLabel* m_counts = nullptr;
    QLabel* m_notice = nullptr;
    QProgressBar* m_progress = nullptr;
    QTimer m_progressTimer;
    std::shared_ptr<const ViewModel> m_shown;
    std::shared_ptr<const ViewModel> m_simple; ///< the last one
    QByteArray m_firstLayout;
    CParams m_replacedBy; ///< what the document was when it was opened
    bool m_recentreNext = true;
    bool m_preferencesOpen = false, m_rebuildLater = false;
    bool m_started = false; ///< a tree was shown
    CFileController* m_files;
    CExportController* m_exporter;
    CWindController* m_windController = nullptr;
    CFallController* m_fall = nullptr;
    std::unique_ptr<CGrowthController> m_growth; ///< last: it stops before anything it reports to is gone
};

} // namespace stromar
