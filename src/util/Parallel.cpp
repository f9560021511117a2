#include "stromar/util/Parallel.h"
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace stromar {

namespace {
class CRangeQueue {
public:
    CRangeQueue(std::size_t count, std::size_t grain, const CProgress& progress)
        : m_count(count), m_grain(std::max<std::size_t>(grain, 1)), m_progress(progress) {}

    std::size_t ranges() const { return (m_count + m_grain - 1) / m_grain; }

    void work(const std::function<void(std::size_t, std::size_t)>& body) noexcept {
        try {
            for (;;) {
                const std::size_t range = m_next.fetch_add(1, std::memory_order_relaxed);
                if (range >= ranges()) return;
                m_progress.poll();
                body(range * m_grain, std::min(m_count, (range + 1) * m_grain));
            }
        } catch (...) {
            const std::lock_guard lock(m_mutex);
            if (!m_error) m_error = std::current_exception();
            m_next.store(ranges(), std::memory_order_relaxed);
        }
    }

    void rethrow() const {
        if (m_error) std::rethrow_exception(m_error);
    }

private:
    std::size_t m_count, m_grain;
    const CProgress& m_progress;
    std::atomic<std::size_t> m_next{0};
    std::mutex m_mutex;
    std::exception_ptr m_error;
};
} // namespace

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body,
                 const CProgress& progress) {
    CRangeQueue queue(count, grain, progress);
    const std::size_t helpers = std::min<std::size_t>(static_cast<std::size_t>(progress.threads()), queue.ranges());
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 1; i < helpers; ++i) threads.emplace_back([&] { queue.work(body); });
        queue.work(body);
    }
    queue.rethrow();
}

} // namespace stromar
