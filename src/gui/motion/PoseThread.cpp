#include "motion/PoseThread.h"
#include <utility>

namespace stromar {

std::shared_ptr<const WindPose> SwayMoment::pose() const {
    auto rows = std::make_shared<WindPose>();
    sway->table->pose(wind, seconds, *rows, CProgress());
    return rows;
}

CPoseThread::CPoseThread(QObject* parent) : QObject(parent) {
    qRegisterMetaType<SwayMoment>();
    qRegisterMetaType<std::shared_ptr<const WindPose>>();
    m_thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

CPoseThread::~CPoseThread() {
    m_thread.request_stop();
    m_wake.notify_all();
    m_thread.join();
}

void CPoseThread::request(const SwayMoment& moment) {
    {
        const std::lock_guard lock(m_mutex);
        m_wanted = moment;
    }
    m_wake.notify_one();
}

void CPoseThread::work(const std::stop_token& stop) {
    for (;;) {
        SwayMoment moment;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, stop, [this] { return m_wanted.has_value(); });
            if (stop.stop_requested()) return;
            moment = *std::exchange(m_wanted, {});
        }
        emit posed(moment, moment.pose());
    }
}

} // namespace stromar
