#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "tree/Support.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

using namespace test;

std::size_t trunkPaths(Values values, int seed) {
    CParams params = with({}, values);
    params.common.seed = seed;
    weberPenn(params).levels = 1;
    return grow(params)->generation(0).paths.size();
}

// A stem of N segments has N − 1 joints at which every live path splits (never behind the last segment), and a path
// that a joint opens is looked at from the next joint on. With c clones each time that makes (c + 1)^(N − 1) stems: the
// paper's 4 = 2² (3 segments, 1 clone) and 81 = 3⁴ (5 segments, 2 clones).
TEST(Splits, ThePapersFourAndEightyOneStems) {
    for (int seed = 0; seed < 20; ++seed) {
        EXPECT_EQ(trunkPaths({{"0CurveRes", 3}, {"0SegSplits", 1}, {"CloneHalving", 0}}, seed), 4u);
        EXPECT_EQ(trunkPaths({{"0CurveRes", 5}, {"0SegSplits", 2}, {"CloneHalving", 0}}, seed), 81u);
    }
}

// Figure 1: two base splits make three stems, at the next joint each of them splits once. Base splits do not halve the
// tendency, so it holds with halving as well.
TEST(Splits, TheSixStemsOfFigureOne) {
    for (int seed = 0; seed < 20; ++seed)
        for (const int halving : {0, 1})
            EXPECT_EQ(
                trunkPaths({{"0CurveRes", 3}, {"0BaseSplits", 2}, {"0SegSplits", 1}, {"CloneHalving", double(halving)}},
                           seed),
                6u);
}

// One split, then both halves split with the tendency ½: one of them does.
TEST(Splits, HalvingHalvesOnce) {
    for (int seed = 0; seed < 20; ++seed) {
        EXPECT_EQ(trunkPaths({{"0CurveRes", 3}, {"0SegSplits", 1}}, seed), 3u);
        // from then on ½ each, never ¼: 1, 2, 3, then 3/2 more or fewer by the rounding
        const std::size_t after = trunkPaths({{"0CurveRes", 4}, {"0SegSplits", 1}}, seed);
        EXPECT_TRUE(after == 4 || after == 5) << after;
    }
}

TEST(Splits, NeverBehindTheLastSegment) {
    EXPECT_EQ(trunkPaths({{"0CurveRes", 1}, {"0SegSplits", 3}, {"0BaseSplits", 3}}, 1), 1u);
    EXPECT_EQ(trunkPaths({{"0CurveRes", 2}, {"0SegSplits", 3}}, 1), 4u);
    EXPECT_EQ(trunkPaths({{"0CurveRes", 2}, {"0BaseSplits", 5}}, 1), 6u);
}

TEST(Splits, BaseSplitsAreTheTrunksOnly) {
    const auto tree = grow(with({}, {{"Levels", 2}, {"0BaseSplits", 2}, {"1CurveRes", 4}, {"1Branches", 20}}));
    EXPECT_EQ(tree->generation(0).cloneCount(), 2u);
    EXPECT_EQ(tree->generation(1).cloneCount(), 0u);
}

TEST(Splits, FractionsHoldInTheMean) {
    for (const double wanted : {0.1, 0.5, 0.75, 1.2, 2.9})
        for (const bool varied : {false, true}) {
            const auto tree = grow(
                with({},
                     {{"Levels", 2}, {"1Branches", 3000}, {"1CurveRes", 2}, {"1SegSplits", wanted}, {"Ratio", 0.0001}}),
                varied);
            const CGeneration& branches = tree->generation(1);
            for (const CStem& stem : branches.stems) {
                ASSERT_GE(stem.pathCount - 1, std::floor(wanted));
                ASSERT_LE(stem.pathCount - 1, std::ceil(wanted));
            }
            const double stems = double(branches.stems.size()), mean = double(branches.cloneCount()) / stems;
            ASSERT_GT(stems, 2900);
            EXPECT_NEAR(mean, wanted, varied ? 5 * 0.5 / std::sqrt(stems) : 0.01) << "varied " << varied;
        }
}

TEST(Splits, TheErrorIsCarriedAlongAStem) {
    for (const double wanted : {0.3, 0.7, 1.2}) {
        const auto tree = grow(with(
            {}, {{"Levels", 2}, {"1Branches", 100}, {"1CurveRes", 5}, {"1SegSplits", wanted}, {"CloneHalving", 0}}));
        const CGeneration& branches = tree->generation(1);
        for (const CStem& stem : branches.stems) {
            double visits = 0; // joints times live paths
            for (std::uint32_t p = 0; p < stem.pathCount; ++p)
                visits += 4 - branches.paths[stem.firstPath + p].firstPosition;
            EXPECT_NEAR(stem.pathCount - 1, wanted * visits, 1 + 1e-9);
        }
    }
}

/// A trunk that splits at its base only.
CParams baseSplit(double clones, double angle) {
    return with({}, {{"Levels", 1}, {"0CurveRes", 5}, {"0BaseSplits", clones}, {"0SplitAngle", angle}});
}

TEST(Splits, TheWholeAngleIsReturned) {
    const auto tree = grow(baseSplit(3, 30));
    const CGeneration& trunk = tree->generation(0);
    ASSERT_EQ(trunk.paths.size(), 4u);
    for (std::uint32_t p = 0; p < 4; ++p)
        for (std::uint32_t k = 1; k < 5; ++k) // a quarter of 30° is taken back by each of the four
            EXPECT_NEAR(declinationOf(segmentOf(trunk, trunk.stems[0], p, k)), 30 - 7.5 * k, 1e-6) << p << ", " << k;
}

TEST(Splits, BaseSplitsSpreadEvenly) {
    for (const int clones : {1, 2, 3, 6}) {
        const auto tree = grow(baseSplit(clones, 30));
        const CGeneration& trunk = tree->generation(0);
        ASSERT_EQ(trunk.paths.size(), std::size_t(clones) + 1);
        for (std::uint32_t j = 0; j < trunk.paths.size(); ++j) {
            const double around = 360.0 * j / (clones + 1);
            const double azimuth = azimuthOf(segmentOf(trunk, trunk.stems[0], j, 1).frame[2]);
            EXPECT_NEAR(turnFrom(-90 + around, azimuth), 0, 1e-9) << j; // path 0 leans towards −Y
            EXPECT_NEAR(grownOf(*tree, 0).rotationPhase[j], glm::radians(around), 1e-12);
        }
    }
}

TEST(Splits, ClonesBelongToTheStem) {
    const auto tree = grow(baseSplit(2, 30));
    const CGeneration& trunk = tree->generation(0);
    ASSERT_EQ(trunk.stems.size(), 1u);
    EXPECT_EQ(trunk.stems[0].segmentCount, 5u + 4 + 4);
    const glm::dvec3 fork = segmentOf(trunk, trunk.stems[0], 0, 0).axisPoint(1);
    for (std::uint32_t p = 0; p < 3; ++p) {
        const CPath& path = trunk.paths[p];
        EXPECT_EQ(path.source, p == 0 ? -1 : 0);
        EXPECT_EQ(path.firstPosition, p == 0 ? 0u : 1u);
        EXPECT_EQ(path.segmentCount, p == 0 ? 5u : 4u);
        EXPECT_LT(glm::length(segmentOf(trunk, trunk.stems[0], p, 1).position - fork), 1e-12);
        for (std::uint32_t k = path.firstPosition; k < 5; ++k) {
            const CSegment& segment = segmentOf(trunk, trunk.stems[0], p, k);
            EXPECT_NEAR(grownOf(*tree, 0).density[path.firstSegment + k - path.firstPosition], k == 0 ? 1 : 1.0 / 3, 1e-12);
            EXPECT_EQ(segment.forks, k == 0);
            EXPECT_DOUBLE_EQ(segment.length, 2);
        }
    }
}

// A level-free check by hand: bends and splits lie in one plane. Joint 0 leans the path by 50 and gives 25 back per
// segment, so segment 1 leans 50 + 20 − 25 = 45. Joint 1 adds 50 − 45 = 5 and takes it back at once: 45 + 5 + 20 − 30
// = 40.
TEST(Splits, TheAngleIsFromTheVertical) {
    const auto tree = growNeutral(with({}, {{"Levels", 1},
                                            {"0CurveRes", 3},
                                            {"0Curve", 60},
                                            {"0SegSplits", 1},
                                            {"0SplitAngle", 50},
                                            {"CloneHalving", 0}}));
    const CGeneration& trunk = tree->generation(0);
    const double expected[] = {0, 45, 40};
    for (std::uint32_t k = 0; k < 3; ++k)
        EXPECT_NEAR(declinationOf(segmentOf(trunk, trunk.stems[0], 0, k)), expected[k], 1e-6) << k;
}

TEST(Splits, ALeaningStemIsNotBentBack) {
    const auto tree = growNeutral(with({}, {{"Levels", 2},
                                            {"1Branches", 5},
                                            {"1DownAngle", 90},
                                            {"1CurveRes", 2},
                                            {"1SegSplits", 1},
                                            {"1SplitAngle", 30}}));
    const CGeneration& branches = tree->generation(1);
    for (const CStem& stem : branches.stems) {
        ASSERT_EQ(stem.pathCount, 2u);
        const CSegment &below = segmentOf(branches, stem, 0, 0), &own = segmentOf(branches, stem, 0, 1),
                       &clone = segmentOf(branches, stem, 1, 1);
        EXPECT_NEAR(angleBetween(below.frame[2], own.frame[2]), 0, 1e-9);
        // level: 20 + ¾·30·¼
        EXPECT_NEAR(turnFrom(azimuthOf(own.frame[2]), azimuthOf(clone.frame[2])), 25.625, 1e-9);
    }
}

double spreadOf(const CGeneration& trunk, std::uint32_t path) {
    const auto x = [&](std::uint32_t p) { return azimuthOf(segmentOf(trunk, trunk.stems[0], p, 1).frame[0]); };
    return turnFrom(x(0), x(path));
}

TEST(Splits, OneCloneSpreadsByTheFormula) {
    const CParams params = with({}, {{"Levels", 1}, {"0CurveRes", 2}, {"0SegSplits", 1}, {"0SplitAngle", 30}});
    EXPECT_NEAR(spreadOf(growNeutral(params)->generation(0), 1), 42.5, 1e-9); // 20 + ¾·(30 + 90)·¼, sign +
    double least = 180, most = 0, positive = 0, sum = 0;
    const int seeds = 1000;
    for (int seed = 0; seed < seeds; ++seed) {
        const double spread = spreadOf(grow(with(params, {{"Seed", seed}}))->generation(0), 1);
        least = std::min(least, std::abs(spread));
        most = std::max(most, std::abs(spread));
        sum += std::abs(spread);
        positive += spread > 0;
    }
    EXPECT_GE(least, 20 - 1e-9);
    EXPECT_LT(least, 20.1);
    EXPECT_LE(most, 110);
    EXPECT_GT(most, 109);
    EXPECT_NEAR(sum / seeds, 20 + 90 / 3.0, 5 * 27 / std::sqrt(seeds)); // the mean of u² is ⅓
    EXPECT_NEAR(positive / seeds, 0.5, 5 * 0.5 / std::sqrt(seeds));
}

TEST(Splits, SeveralClonesSpreadEvenly) {
    const auto tree = grow(with({}, {{"Levels", 1}, {"0CurveRes", 2}, {"0SegSplits", 3}, {"0SplitAngle", 30}}));
    for (std::uint32_t j = 1; j <= 3; ++j) EXPECT_NEAR(turnFrom(90.0 * j, spreadOf(tree->generation(0), j)), 0, 1e-9);
}

TEST(Splits, OneVariationPerEvent) {
    double least = 90, most = 0, uneven = 0;
    for (int seed = 0; seed < 100; ++seed) {
        const auto tree = grow(with(baseSplit(2, 40), {{"0SplitAngleV", 20}, {"Seed", seed}}));
        const CGeneration& trunk = tree->generation(0);
        const double lean = declinationOf(segmentOf(trunk, trunk.stems[0], 0, 1)) / 0.75;
        for (std::uint32_t p = 1; p < 3; ++p) {
            EXPECT_NEAR(declinationOf(segmentOf(trunk, trunk.stems[0], p, 1)) / 0.75, lean, 1e-6)
                << "its paths share one draw";
            const double turn = turnFrom(120.0 * p, spreadOf(trunk, p));
            EXPECT_LE(std::abs(turn), 20 + 1e-9);
            uneven = std::max(uneven, std::abs(turn));
        }
        least = std::min(least, lean);
        most = std::max(most, lean);
    }
    EXPECT_GE(least, 20 - 1e-6);
    EXPECT_LT(least, 24);
    EXPECT_LE(most, 60 + 1e-6);
    EXPECT_GT(most, 56);
    EXPECT_GT(uneven, 16);
}

} // namespace
} // namespace stromar
