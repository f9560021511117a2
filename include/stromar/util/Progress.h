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
        : m_cancelled(std::make_shared<std::atomic<bool>>(false)), m_done(std::make_shared<std::atomic<double>>(0)),
          m_threads(threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

    int threads() const { return m_threads; }
    /// For one of many pieces of the work: it stops with the whole, and tells nobody how far it is.
    CProgress piece(int threads) const {
        CProgress own(threads);
        own.m_cancelled = m_cancelled;
        return own;
    }

    void cancel() const { *m_cancelled = true; }
    bool cancelled() const { return m_cancelled->load(std::memory_order_relaxed); }
    /// Throws CCancelled when someone asked to stop.
    void poll() const {
        if (cancelled()) throw CCancelled();
    }
    /// Share of the work that is done, 0..1.
    void report(double done) const { m_done->store(done, std::memory_order_relaxed); }
    double done() const { return m_done->load(std::memory_order_relaxed); }

private:
    std::shared_ptr<std::atomic<bool>> m_cancelled;
    std::shared_ptr<std::atomic<double>> m_done;
    int m_threads;
};

} // namespace stromar
