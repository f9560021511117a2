#include "work/LatestTask.h"
#include <utility>

namespace stromar {

CLatestTask::CLatestTask(QObject& receiver)
    : m_receiver(receiver), m_thread([this](const std::stop_token& stop) { work(stop); }) {}

CLatestTask::~CLatestTask() {
    m_thread.request_stop();
    cancel();
}

void CLatestTask::run(Work work) {
    {
        const std::lock_guard lock(m_mutex);
        m_wanted = std::move(work);
    }
    m_wake.notify_one();
}

void CLatestTask::cancel() {
    const std::lock_guard lock(m_mutex);
    m_wanted.reset();
    if (m_running) m_running->cancel();
}

void CLatestTask::work(const std::stop_token& stop) {
    for (;;) {
        Work task;
        CProgress progress(1); // the tree in the window comes first
        {
            std::unique_lock lock(m_mutex);
            m_running.reset();
            if (!m_wake.wait(lock, stop, [this] { return m_wanted.has_value(); }) || stop.stop_requested()) return;
            task = *std::exchange(m_wanted, std::nullopt);
            m_running = progress;
        }
        try {
            QMetaObject::invokeMethod(
                &m_receiver,
                [then = task(progress), progress] {
                    if (!progress.cancelled()) then();
                },
                Qt::QueuedConnection);
        } catch (const CCancelled&) { // a newer one waits, or nobody
        }
    }
}

} // namespace stromar
