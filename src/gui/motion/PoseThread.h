#pragma once
#include "stromar/model/ModelSway.h"
#include <QObject>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace stromar {

/// A tree in the wind at a moment.
struct SwayMoment {
    std::shared_ptr<const ModelSway> sway;
    Wind wind;
    double seconds = 0;

    std::shared_ptr<const WindPose> pose() const;
};

/// Works out poses away from the GUI thread, one at a time; the newest wish replaces the one that waits.
class CPoseThread : public QObject {
    Q_OBJECT
public:
    explicit CPoseThread(QObject* parent = nullptr);
    ~CPoseThread() override;

    void request(const SwayMoment& moment);

signals:
    /// Queued.
    void posed(const stromar::SwayMoment& moment, std::shared_ptr<const stromar::WindPose> pose);

private:
    void work(const std::stop_token& stop);

    std::mutex m_mutex; ///< guards the wish
    std::condition_variable_any m_wake;
    std::optional<SwayMoment> m_wanted;
    std::jthread m_thread; ///< last: it stops first
};

} // namespace stromar

Q_DECLARE_METATYPE(stromar::SwayMoment)
Q_DECLARE_METATYPE(std::shared_ptr<const stromar::WindPose>)
