#include "stromar/util/Random.h"
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace stromar {
namespace {

constexpr int kDraws = 20000;

/// Five standard errors of the mean of kDraws uniform numbers: chance alone exceeds it once in two million runs.
const double kMeanTolerance = 5 / std::sqrt(12.0 * kDraws);
const double kCorrelationTolerance = 5 / std::sqrt(double(kDraws));

using Series = std::function<double(std::uint64_t)>;

struct NamedSeries {
    const char* name;
    Series draw;
};

/// One argument of the function runs while the others stand still.
std::vector<NamedSeries> series() {
    return {{"seed", [](std::uint64_t i) { return CRandom(i, true).uniform(7, 3, 5); }},
            {"id", [](std::uint64_t i) { return CRandom(1, true).uniform(i, 3, 5); }},
            {"purpose", [](std::uint64_t i) { return CRandom(1, true).uniform(7, static_cast<std::uint32_t>(i), 5); }},
            {"place", [](std::uint64_t i) { return CRandom(1, true).uniform(7, 3, i); }},
            {"phase of id", [](std::uint64_t i) { return CRandom(1, true).phase(i, 3); }}};
}

double correlation(const Series& a, const Series& b) {
    double sum = 0;
    for (std::uint64_t i = 0; i < kDraws; ++i) sum += (a(i) - 0.5) * (b(i) - 0.5);
    return 12 * sum / kDraws;
}

TEST(Random, IsAPureFunction) {
    const CRandom random(42, true), same(42, true);
    const double first = random.uniform(1, 2, 3);
    for (std::uint64_t i = 0; i < 100; ++i) (void)random.uniform(i, 9, i);
    EXPECT_EQ(random.uniform(1, 2, 3), first);
    EXPECT_EQ(same.uniform(1, 2, 3), first);
}

TEST(Random, EveryArgumentMatters) {
    std::set<double> values;
    for (std::uint64_t seed = 0; seed < 5; ++seed)
        for (std::uint64_t id = 0; id < 5; ++id)
            for (std::uint32_t purpose = 0; purpose < 5; ++purpose)
                for (std::uint64_t place = 0; place < 5; ++place)
                    values.insert(CRandom(seed, true).uniform(id, purpose, place));
    EXPECT_EQ(values.size(), 625u);
}

TEST(Random, IsUniformInEveryArgument) {
    for (const auto& [name, draw] : series()) {
        double sum = 0;
        std::array<int, 20> bins{};
        for (std::uint64_t i = 0; i < kDraws; ++i) {
            const double u = draw(i);
            ASSERT_GE(u, 0) << name;
            ASSERT_LT(u, 1) << name;
            sum += u;
            ++bins[static_cast<std::size_t>(u * 20)];
        }
        EXPECT_NEAR(sum / kDraws, 0.5, kMeanTolerance) << name;
        double chiSquare = 0;
        for (const int bin : bins) chiSquare += std::pow(bin - kDraws / 20.0, 2) / (kDraws / 20.0);
        EXPECT_LT(chiSquare, 19 + 6 * std::sqrt(2 * 19.0)) << name;
    }
}

TEST(Random, NeighboursAreIndependent) {
    for (const NamedSeries& one : series())
        for (const std::uint64_t lag : {1u, 2u, 64u})
            EXPECT_NEAR(correlation(one.draw, [&](std::uint64_t i) { return one.draw(i + lag); }), 0,
                        kCorrelationTolerance)
                << one.name << " and the next " << lag;
}

TEST(Random, PurposesPlacesIdsAndSeedsAreIndependent) {
    const Series base = [](std::uint64_t i) { return CRandom(1, true).uniform(i, 3, 5); };
    const std::vector<NamedSeries> others{
        {"purpose", [](std::uint64_t i) { return CRandom(1, true).uniform(i, 4, 5); }},
        {"place", [](std::uint64_t i) { return CRandom(1, true).uniform(i, 3, 6); }},
        {"seed", [](std::uint64_t i) { return CRandom(2, true).uniform(i, 3, 5); }},
        {"id and place exchanged", [](std::uint64_t i) { return CRandom(1, true).uniform(5, 3, i); }}};
    for (const auto& [name, other] : others) EXPECT_NEAR(correlation(base, other), 0, kCorrelationTolerance) << name;
}

TEST(Random, VaryIsSymmetricAndScaled) {
    const CRandom random(1, true);
    double sum = 0, most = 0;
    for (std::uint64_t i = 0; i < kDraws; ++i) {
        const double v = random.vary(20, i, 3);
        ASSERT_GE(v, -20);
        ASSERT_LT(v, 20);
        ASSERT_DOUBLE_EQ(v, 20 * (2 * random.uniform(i, 3) - 1));
        sum += v;
        most = std::max(most, std::abs(v));
    }
    EXPECT_NEAR(sum / kDraws, 0, 40 * kMeanTolerance);
    EXPECT_GT(most, 19.9);
    EXPECT_EQ(random.vary(0, 1, 2, 3), 0);
}

TEST(Random, TheNeutralSourceHasNoChance) {
    for (std::uint64_t i = 0; i < 50; ++i) {
        const CRandom neutral(i, false);
        EXPECT_EQ(neutral.uniform(i, 3, 5), 0.5);
        EXPECT_EQ(neutral.vary(20, i, 3, 5), 0);
        EXPECT_EQ(neutral.phase(i, 3), 0);
    }
}

TEST(Random, HashSpreadsEveryBit) {
    for (int bit = 0; bit < 64; ++bit) {
        int viaWord = 0, viaHash = 0;
        for (std::uint64_t i = 0; i < 256; ++i) {
            const std::uint64_t hash = hashCombine(i, 77), flip = std::uint64_t{1} << bit;
            viaHash += std::popcount(hash ^ hashCombine(i ^ flip, 77));
            viaWord += std::popcount(hashCombine(77, i) ^ hashCombine(77, i ^ flip));
        }
        EXPECT_NEAR(viaHash / 256.0, 32, 2) << "bit " << bit;
        EXPECT_NEAR(viaWord / 256.0, 32, 2) << "bit " << bit;
    }
    EXPECT_NE(hashCombine(1, 2), hashCombine(2, 1));
}

} // namespace
} // namespace stromar
