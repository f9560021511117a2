#pragma once
#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace stromar {

/// Notices when another program changes a file.
class CFileWatch : public QObject {
    Q_OBJECT
public:
    explicit CFileWatch(QObject* parent = nullptr);

    /// From now on this file, as it is now; empty watches nothing.
    void watch(const QString& path);

signals:
    void changed();

private:
    void check();

    QFileSystemWatcher m_watcher;
    QTimer m_settle; ///< a file is often written in several steps, or replaced by another
    QString m_path;
    QByteArray m_known; ///< hash of the content
};

} // namespace stromar
