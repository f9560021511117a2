#include "stromar/util/Parallel.h"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace stromar {
namespace {

struct Split {
    std::size_t count, grain;
    int threads;
};

std::vector<Split> runs() {
    std::vector<Split> all;
    for (const std::size_t count : {0u, 1u, 2u, 7u, 64u, 65u, 1000u})
        for (const std::size_t grain : {1u, 2u, 3u, 64u, 5000u})
            for (const int threads : {1, 2, 3, 8}) all.push_back({count, grain, threads});
    return all;
}

TEST(Parallel, CoversEachIndexExactlyOnce) {
    for (const Split& run : runs()) {
        std::vector<std::atomic<int>> visits(run.count);
        parallelFor(
            run.count, run.grain,
            [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) ++visits.at(i);
            },
            CProgress(run.threads));
        for (std::size_t i = 0; i < run.count; ++i)
            ASSERT_EQ(visits[i], 1) << i << " of " << run.count << ", grain " << run.grain << ", threads "
                                    << run.threads;
    }
}

TEST(Parallel, RangesDependOnTheGrainOnly) {
    for (const Split& run : runs()) {
        std::mutex mutex;
        std::set<std::pair<std::size_t, std::size_t>> ranges;
        parallelFor(
            run.count, run.grain,
            [&](std::size_t first, std::size_t last) {
                const std::lock_guard lock(mutex);
                ranges.emplace(first, last);
            },
            CProgress(run.threads));
        std::set<std::pair<std::size_t, std::size_t>> expected;
        for (std::size_t first = 0; first < run.count; first += run.grain)
            expected.emplace(first, std::min(run.count, first + run.grain));
        ASSERT_EQ(ranges, expected) << run.count << " by " << run.grain << " on " << run.threads;
    }
}

TEST(Parallel, TwoThreadsWorkAtTheSameTime) {
    std::latch bothAreIn(2);
    std::mutex mutex;
    std::set<std::thread::id> threads;
    parallelFor(
        2, 1,
        [&](std::size_t, std::size_t) {
            bothAreIn.arrive_and_wait(); // one thread alone would wait here for ever
            const std::lock_guard lock(mutex);
            threads.insert(std::this_thread::get_id());
        },
        CProgress(2));
    EXPECT_EQ(threads.size(), 2u);
    EXPECT_TRUE(threads.contains(std::this_thread::get_id())) << "the caller's thread has to work too";
}

TEST(Parallel, OneThreadIsTheCallers) {
    std::set<std::thread::id> threads;
    parallelFor(
        100, 1, [&](std::size_t, std::size_t) { threads.insert(std::this_thread::get_id()); }, CProgress(1));
    EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(Parallel, RethrowsAndStartsNoFurtherRange) {
    int started = 0;
    const auto body = [&](std::size_t first, std::size_t) {
        ++started;
        if (first == 3) throw std::runtime_error("third");
    };
    try {
        parallelFor(1000, 1, body, CProgress(1));
        FAIL() << "the exception is lost";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "third");
    }
    EXPECT_EQ(started, 4);
}

TEST(Parallel, AThrowOnAnyThreadStopsAll) {
    for (const int threads : {2, 4}) {
        std::atomic<int> started{0};
        const auto body = [&](std::size_t first, std::size_t) {
            ++started;
            if (first == 0) throw std::logic_error("first");
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        };
        EXPECT_THROW(parallelFor(10000, 1, body, CProgress(threads)), std::logic_error);
        EXPECT_LT(started, 5000);
    }
}

TEST(Parallel, RethrowsTheFirstException) {
    std::latch bothAreIn(2);
    const auto body = [&](std::size_t first, std::size_t) {
        bothAreIn.arrive_and_wait();
        if (first == 0) throw std::runtime_error("early");
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        throw std::runtime_error("late");
    };
    try {
        parallelFor(2, 1, body, CProgress(2));
        FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "early");
    }
}

TEST(Parallel, CancelStopsBeforeTheNextRange) {
    const CProgress progress(1);
    int started = 0;
    const auto body = [&](std::size_t, std::size_t) {
        if (++started == 5) progress.cancel();
    };
    EXPECT_THROW(parallelFor(1000, 1, body, progress), CCancelled);
    EXPECT_EQ(started, 5);
}

TEST(Parallel, CancelledBeforehandRunsNothing) {
    for (const int threads : {1, 2}) {
        const CProgress progress(threads);
        progress.cancel();
        std::atomic<int> started{0};
        EXPECT_THROW(parallelFor(
                         10, 1, [&](std::size_t, std::size_t) { ++started; }, progress),
                     CCancelled);
        EXPECT_EQ(started, 0);
    }
}

TEST(Progress, CopiesShareOneState) {
    const CProgress progress(3);
    const CProgress copy = progress;
    EXPECT_EQ(copy.threads(), 3);
    EXPECT_FALSE(copy.cancelled());
    EXPECT_NO_THROW(copy.poll());
    copy.report(0.25);
    EXPECT_EQ(progress.done(), 0.25);
    copy.cancel();
    EXPECT_TRUE(progress.cancelled());
    EXPECT_THROW(progress.poll(), CCancelled);
    EXPECT_FALSE(CProgress().cancelled());
    EXPECT_GE(CProgress().threads(), 1);
}

} // namespace
} // namespace stromar
