#include "document/FileWatch.h"
#include <QCryptographicHash>
#include <QFile>
#include <utility>

namespace stromar {

namespace {
constexpr int kSettleMs = 300;

/// Empty when there is no such file.
QByteArray hashOf(const QString& path) {
    QFile file(path);
    if (path.isEmpty() || !file.open(QIODevice::ReadOnly)) return {};
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(&file);
    return hash.result();
}
} // namespace

CFileWatch::CFileWatch(QObject* parent) : QObject(parent) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    connect(&m_settle, &QTimer::timeout, this, &CFileWatch::check);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] { m_settle.start(); });
}

void CFileWatch::watch(const QString& path) {
    if (!m_watcher.files().isEmpty()) m_watcher.removePaths(m_watcher.files());
    m_settle.stop();
    m_path = path;
    m_known = hashOf(path);
    if (!path.isEmpty()) m_watcher.addPath(path);
}

void CFileWatch::check() {
    const QByteArray now = hashOf(m_path);
    if (!m_watcher.files().contains(m_path)) m_watcher.addPath(m_path); // a replaced file is no longer watched
    if (now.isEmpty() || now == std::exchange(m_known, now)) return;
    emit changed();
}

} // namespace stromar
