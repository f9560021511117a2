#pragma once
#include "Document.h"
#include "TreeCreatorThread.h"
#include "stromar/app/ExportOptions.h"
#include <QMainWindow>
#include <QTimer>
#include <memory>

class QDockWidget;
class QLabel;
class QListWidget;
class QMenu;
class QProgressBar;

namespace stromar {

class CExportJob;
class CParamPanel;
class CViewport;

/// The window: viewport, parameters, menus; brings document, worker and widgets together.
class CMainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit CMainWindow(double mostVertices = CTreeCreator::kMostVertices, QWidget* parent = nullptr);
    ~CMainWindow() override;

    /// False, with a message shown, when the file cannot be read; then nothing has changed.
    bool open(const QString& path);
    bool save(const QString& path);
    /// Returns at once; exportEnded tells how it went.
    void exportTo(const QString& path, const ExportOptions& options = {});
    /// Which model follows a change; the default shows the simple one first, then the full one.
    void showOnly(Model model);

    CDocument& document() { return m_document; }
    CViewport& viewport() { return *m_viewport; }
    CParamPanel& panel() { return *m_panel; }
    /// What the viewport shows; null before the first tree.
    const ViewModel* shown() const { return m_shown.get(); }

    // The commands of the table.
    void startNew();
    void chooseAndOpen();
    void saveAgain();
    void chooseAndSave();
    void chooseAndExport();
    void chooseBark();
    void chooseLeaf();
    void closeWindow();
    void undo();
    void redo();
    void throwDice();
    void generate();
    void showFullModel();
    void toggleWired();
    void recentre();
    void showShortcuts();
    void showAbout();

signals:
    /// The viewport has a new model.
    void modelShown();
    void exportEnded(const QString& why, bool cancelled);

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void makeActions();
    void makeDocks();
    void makeStatusBar();
    void connectParts();
    void fillRecentMenu();
    void remember(const QString& path);

    void onReplaced();
    void onChanged();
    void onCreated(const std::shared_ptr<const ViewModel>& view);
    void onFailed(const QString& why);
    void requestFull();
    void updateTitle();
    void updateTextures();
    void updateMessages();
    void updateProgress();
    void chooseTexture(const TextInfo& text);
    bool mayLoseChanges();
    void tellError(const QString& title, const QString& text);
    bool saveOrChoose();

    CDocument m_document;
    CViewport* m_viewport;
    CParamPanel* m_panel;
    QMenu* m_recentMenu = nullptr;
    QDockWidget* m_messageDock = nullptr;
    QListWidget* m_messages = nullptr;
    QLabel* m_counts = nullptr;
    QLabel* m_notice = nullptr;
    QProgressBar* m_progress = nullptr;
    QTimer m_pause; ///< until the full model follows
    QTimer m_progressTimer;
    std::shared_ptr<const ViewModel> m_shown;
    std::unique_ptr<CExportJob> m_export;
    QString m_shownBark, m_shownLeaf;
    std::optional<Model> m_only;
    double m_mostVertices;
    bool m_recentreNext = true;
    std::unique_ptr<CTreeCreatorThread> m_thread; ///< last: it stops before anything it reports to is gone
};

} // namespace stromar
