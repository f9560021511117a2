#include "document/Autosave.h"
#include "window/QtText.h"
#include "stromar/util/FileSet.h"
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>
#include <exception>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace stromar {

namespace {
QString withEnding(const QString& file, const char* ending) {
    return file.chopped(5) + QLatin1String(ending); // ".tree"
}
} // namespace

CFileLock::CFileLock(const QString& path)
    : m_file(::open(QFile::encodeName(path).constData(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)),
      m_held(m_file >= 0 && ::flock(m_file, LOCK_EX | LOCK_NB) == 0) {}

CFileLock::~CFileLock() {
    if (m_file >= 0) ::close(m_file);
}

QString CAutosave::standardFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/autosave");
}

CAutosave::CAutosave(const QString& folder, QObject* parent) : QObject(parent) {
    QDir().mkpath(folder);
    m_file = QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + QStringLiteral(".tree"));
    m_lock = std::make_unique<CFileLock>(withEnding(m_file, ".lock"));
    m_timer.setSingleShot(true);
    m_timer.setInterval(30000);
    connect(&m_timer, &QTimer::timeout, this, &CAutosave::write);
    m_thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

CAutosave::~CAutosave() {
    m_thread.request_stop();
    m_wake.notify_all();
    m_thread.join();
    if (std::uncaught_exceptions() > 0) return;
    removeFiles();
    QFile::remove(withEnding(m_file, ".lock"));
}

void CAutosave::setInterval(int seconds) {
    m_timer.stop();
    m_timer.setInterval(seconds * 1000);
    if (m_latest && seconds > 0) m_timer.start();
}

void CAutosave::keep(State state) {
    m_latest = std::move(state);
    if (!m_timer.isActive() && m_timer.interval() > 0) m_timer.start();
}

void CAutosave::clear() {
    m_timer.stop();
    m_latest.reset();
    {
        const std::lock_guard lock(m_mutex);
        m_task = std::optional<State>();
    }
    m_wake.notify_all();
}

void CAutosave::write() {
    if (!m_latest) return;
    {
        const std::lock_guard lock(m_mutex);
        m_task = std::move(m_latest);
    }
    m_latest.reset();
    m_wake.notify_all();
}

bool CAutosave::flush() {
    m_timer.stop();
    write();
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, [this] { return !m_task && !m_busy; });
    return m_fine;
}

void CAutosave::work(const std::stop_token& stop) {
    for (;;) {
        std::optional<State> state;
        {
            std::unique_lock lock(m_mutex);
            m_busy = false;
            m_wake.notify_all();
            m_wake.wait(lock, stop, [this] { return m_task.has_value(); });
            if (stop.stop_requested()) return;
            state = std::move(*m_task);
            m_task.reset();
            m_busy = true;
        }
        bool fine = false;
        try {
            if (state)
                writeFiles(*state);
            else
                removeFiles();
            fine = true;
            emit written();
        } catch (const std::exception& e) {
            emit failed(errorText(e));
        }
        const std::lock_guard lock(m_mutex);
        m_fine = fine;
    }
}

void CAutosave::writeFiles(const State& state) const {
    const QJsonObject about{{QStringLiteral("path"), state.path},
                            {QStringLiteral("time"), QDateTime::currentDateTime().toString(Qt::ISODate)}};
    writeFile(toPath(withEnding(m_file, ".json")), QJsonDocument(about).toJson().toStdString());
    writeFile(toPath(m_file), state.file->text(state.params)); // last: a leftover is what has values
}

void CAutosave::removeFiles() const {
    for (const char* ending : {".tree", ".json"}) QFile::remove(withEnding(m_file, ending));
}

std::vector<CAutosave::Leftover> CAutosave::leftovers(const QString& folder) {
    std::vector<Leftover> found;
    for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.tree")}, QDir::Files, QDir::Time)) {
        if (!CFileLock(withEnding(file.absoluteFilePath(), ".lock")).held()) continue; // its program lives
        QFile about(withEnding(file.absoluteFilePath(), ".json"));
        QJsonObject values;
        if (about.open(QIODevice::ReadOnly)) values = QJsonDocument::fromJson(about.readAll()).object();
        found.push_back(
            {file.absoluteFilePath(), values.value(QStringLiteral("path")).toString(), file.lastModified()});
    }
    return found;
}

void CAutosave::remove(const Leftover& leftover) {
    for (const char* ending : {".tree", ".json", ".lock"}) QFile::remove(withEnding(leftover.file, ending));
}

} // namespace stromar
