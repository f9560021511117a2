#pragma once
#include "stromar/app/Randomise.h"
#include <QObject>
#include <atomic>
#include <thread>
#include <vector>

namespace stromar {

/// Looks for random values that are still a tree, on a thread of its own.
class CRandomiser : public QObject {
    Q_OBJECT
public:
    struct Task {
        CParams params;
        std::vector<ParamRef> refs;
        double amount;
        std::uint64_t seed;
        SizeLimits limits;
    };

    using QObject::QObject;
    /// Cancels and waits.
    ~CRandomiser() override;

    /// Gives up what it was looking for before.
    void start(Task task);
    bool busy() const { return m_busy; }

signals:
    /// Values for the tree it was started with; none where no throw is a tree.
    void found(const stromar::CParams& from, const stromar::ParamValues& values);

private:
    void look(const Task& task, quint64 number);
    void cancel();

    CProgress m_progress;
    quint64 m_number = 0; ///< of the task
    bool m_busy = false;
    std::jthread m_thread;
};

} // namespace stromar
