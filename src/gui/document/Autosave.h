#pragma once
#include "stromar/params/TreeFile.h"
#include <QDateTime>
#include <QObject>
#include <QTimer>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace stromar {

/// A lock that the system releases when its program ends, however that happens.
class CFileLock {
public:
    /// Creates the file when it is missing; try held().
    explicit CFileLock(const QString& path);
    ~CFileLock();
    CFileLock(const CFileLock&) = delete;
    CFileLock& operator=(const CFileLock&) = delete;
    bool held() const { return m_held; }

private:
    int m_file;
    bool m_held;
};

/// Keeps unsaved changes aside, so that a crash loses at most one interval. Each window has a name of its own in the
/// folder: `name.tree` the values, `name.json` what they belong to, `name.lock` held while the program lives. Files are
/// written on a thread of their own.
class CAutosave : public QObject {
    Q_OBJECT
public:
    /// What is to be kept. The file gives comments and order; it is shared, not copied.
    struct State {
        std::shared_ptr<const CTreeFile> file;
        CParams params;
        QString path; ///< of the document; empty for one that was never saved
    };
    /// What a program that ended without a word has left.
    struct Leftover {
        QString file, path; ///< of the kept values; of the document, may be empty
        QDateTime time;
    };

    explicit CAutosave(const QString& folder, QObject* parent = nullptr);
    /// Nothing is left behind, except when an error ends the program: closing a window has asked about unsaved changes.
    ~CAutosave() override;

    static QString standardFolder();
    /// Seconds; 0 never.
    void setInterval(int seconds);
    /// Unsaved changes; written when the interval since the first of them is over.
    void keep(State state);
    /// There are no unsaved changes any more.
    void clear();
    /// Whatever waits is written now; returns when it is, and whether the last writing went well.
    bool flush();
    /// The file it keeps the values in.
    const QString& file() const { return m_file; }

    static std::vector<Leftover> leftovers(const QString& folder);
    static void remove(const Leftover& leftover);

signals:
    void written();
    void failed(const QString& why);

private:
    void write();
    void work(const std::stop_token& stop);
    void writeFiles(const State& state) const;
    void removeFiles() const;

    QString m_file;
    std::unique_ptr<CFileLock> m_lock;
    QTimer m_timer;
    std::optional<State> m_latest; ///< not yet handed to the thread
    std::mutex m_mutex;            ///< guards the next three
    std::condition_variable_any m_wake;
    std::optional<std::optional<State>> m_task; ///< what to write; an empty state: remove the files
    bool m_busy = false;
    bool m_fine = true;    ///< the last writing
    std::jthread m_thread; ///< last: it stops first
};

} // namespace stromar
