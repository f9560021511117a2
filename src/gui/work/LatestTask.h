#pragma once
#include "stromar/util/Progress.h"
#include <QObject>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace stromar {

/// Works for the window on a thread of its own, one task at a time. One slot: of those that wait only the newest counts.
/// Called from the thread of the window.
class CLatestTask {
public:
    /// What the window does with the result.
    using Then = std::function<void()>;
    /// Runs on the thread of its own. May throw CCancelled, nothing else; what it returns runs in the window's.
    using Work = std::function<Then(const CProgress&)>;

    /// `receiver` must outlive it.
    explicit CLatestTask(QObject& receiver);
    ~CLatestTask();

    void run(Work work);
    /// Gives up what runs and what waits.
    void cancel();

private:
    void work(const std::stop_token& stop);

    QObject& m_receiver;
    std::mutex m_mutex; ///< guards the slot and the task that runs
    std::condition_variable_any m_wake;
    std::optional<Work> m_wanted;
    std::optional<CProgress> m_running;
    std::jthread m_thread; ///< last: it stops first
};

} // namespace stromar
