#pragma once
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace stromar {

class CThumbnails;

/// The trees that come with the program and the user's own, as pictures. A click or Enter chooses one; Enter
/// in the search the first that is found, Down goes to it. Empty until the first refresh().
class CPresetBrowser : public QWidget {
    Q_OBJECT
public:
    explicit CPresetBrowser(CThumbnails& thumbnails, QWidget* parent = nullptr);

    /// Where the user's own presets are; made when it is missing.
    static QString ownFolder();
    /// The picture that came with a preset of ours; empty when there is none.
    static QString shippedPicture(const QFileInfo& preset);
    /// Of the species in a preset, else of its file.
    static QString nameOf(const QString& path);
    QListWidget& list() { return *m_list; }
    QLineEdit& filter() { return *m_filter; }
    /// What stands in place of the list when it has nothing to show.
    QLabel& nothing() { return *m_nothing; }
    /// Reads the folders anew.
    void refresh();

signals:
    void chosen(const QString& path);
    /// The tree in the window should become a preset.
    void saveWanted();

private:
    void addFolder(const QString& folder, bool own);
    void showThumbnail(const QString& id, const QImage& image);
    void updateVisibility();
    void showMenu(const QPoint& at);
    void removePreset(QListWidgetItem* item);
    QListWidgetItem* itemOf(const QString& path) const;
    QListWidgetItem* firstShown() const;
    void choose(const QListWidgetItem* item);
    bool eventFilter(QObject* watched, QEvent* event) override;

    CThumbnails& m_thumbnails;
    QLineEdit* m_filter;
    QComboBox* m_folder;
    QLabel* m_nothing; ///< in place of the list
    QListWidget* m_list;
    QFileSystemWatcher m_watcher;
};

} // namespace stromar
