#pragma once
#include "stromar/util/Error.h"
#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

namespace stromar {

/// What a long computation is told from outside (how many threads, to stop) and tells back (how far it is).
/// A handle: copies share one state; every member may be called from any thread.
class CProgress {
public:
    /// `threads` 0 takes one per processor.
    explicit CProgress(int threads = 0)
        : m_state(std::make_shared<State>()),
          m_threads(threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

    int threads() const { return m_threads; }
    void cancel() const { m_state->cancelled = true; }
    bool cancelled() const { return m_state->cancelled.load(std::memory_order_relaxed); }
    /// Throws CCancelled when someone asked to stop.
    void poll() const {
        if (cancelled()) throw CCancelled();
    }
    /// Share of the work that is done, 0..1.
    void report(double done) const { m_state->done.store(done, std::memory_order_relaxed); }
    double done() const { return m_state->done.load(std::memory_order_relaxed); }

private:
    struct State {
        std::atomic<bool> cancelled{false};
        std::atomic<double> done{0};
    };
    std::shared_ptr<State> m_state;
    int m_threads;
};

} // namespace stromar
