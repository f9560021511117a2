#include "stromar/util/Lazy.h"
#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <vector>

namespace stromar {
namespace {

TEST(Lazy, IsMadeOnceWhenItIsAskedForByAnyThread) {
    int made = 0;
    const CLazy<int> lazy([&](const CProgress&) { return ++made; });
    EXPECT_EQ(made, 0);
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] { EXPECT_EQ(lazy.get(CProgress()), 1); });
    threads.clear();
    EXPECT_EQ(made, 1);
}

TEST(Lazy, IsTriedAgainAfterItWasCancelled) {
    const CLazy<int> lazy([](const CProgress& progress) {
        progress.poll();
        return 3;
    });
    const CProgress stopped;
    stopped.cancel();
    EXPECT_THROW(lazy.get(stopped), CCancelled);
    EXPECT_EQ(lazy.get(CProgress()), 3);
}

TEST(Lazy, LetsGoOfWhatItWasMadeFrom) {
    const auto source = std::make_shared<int>(5);
    const CLazy<int> lazy([source](const CProgress&) { return *source; });
    EXPECT_EQ(source.use_count(), 2);
    EXPECT_EQ(lazy.get(CProgress()), 5);
    EXPECT_EQ(source.use_count(), 1);
}

} // namespace
} // namespace stromar
