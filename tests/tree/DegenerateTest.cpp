#include "tree/Support.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

using namespace test;

void expectFinite(const CTree& tree, const std::string& what) {
    for (const auto& generation : tree.generations()) {
        for (const CStem& stem : generation->stems)
            ASSERT_TRUE(std::isfinite(stem.length) && std::isfinite(stem.radius)) << what;
        for (const CSegment& segment : generation->segments) {
            const glm::dvec3 end = segment.centre(1);
            ASSERT_TRUE(std::isfinite(end.x) && std::isfinite(end.y) && std::isfinite(end.z)) << what;
            ASSERT_TRUE(segment.radiusBase >= 0 && segment.radiusEnd >= 0) << what; // not a number fails too
        }
    }
    for (const CLeaf& leaf : tree.leaves())
        ASSERT_TRUE(std::isfinite(leaf.position.z) && std::isfinite(leaf.axis.z) && std::isfinite(leaf.normal.z))
            << what;
}

TEST(Levels, OneToNineAreBuilt) {
    for (int levels = 1; levels <= 9; ++levels) {
        const auto tree = grow(with({}, {{"Levels", double(levels)},
                                         {"1Branches", 4},
                                         {"2Branches", 2},
                                         {"3Branches", 2},
                                         {"3Length", 0.9},
                                         {"3CurveRes", 3},
                                         {"3Taper", 0.4},
                                         {"2CurveRes", 2},
                                         {"Leaves", 3}}));
        ASSERT_EQ(tree->generationCount(), std::size_t(levels));
        for (std::size_t g = 0; g < tree->generationCount(); ++g) {
            ASSERT_FALSE(tree->generation(g).stems.empty()) << levels << ", generation " << g;
            for (const CStem& stem : tree->generation(g).stems) {
                EXPECT_EQ(stem.segmentCount, g == 0 ? 3u : g == 1 ? 3u : g == 2 ? 2u : 3u);
                const CSegment& last = tree->generation(g).segments[stem.firstSegment + stem.segmentCount - 1];
                EXPECT_NEAR(last.radiusEnd, g < 3 ? 0 : 0.6 * stem.radius, 1e-12)
                    << "level " << g << " uses the values of level 3";
            }
        }
        EXPECT_EQ(tree->leaves().empty(), levels == 1);
        expectFinite(*tree, std::to_string(levels) + " levels");
    }
}

TEST(Levels, StemCountSumsUp) {
    const auto tree = grow(richTree());
    std::size_t sum = 0;
    for (const auto& generation : tree->generations()) sum += generation->stems.size();
    EXPECT_EQ(tree->stemCount(), sum);
}

TEST(ScaleOfTree, VariesAroundTheHeight) {
    double least = 100, most = 0, sum = 0;
    const int seeds = 2000;
    for (int seed = 0; seed < seeds; ++seed) {
        const CParams params = with({}, {{"Scale", 13}, {"ScaleV", 3}, {"Seed", double(seed)}});
        const double scale = scaleOfTree(params, true);
        EXPECT_EQ(scaleOfTree(params, false), 13);
        least = std::min(least, scale);
        most = std::max(most, scale);
        sum += scale;
    }
    EXPECT_GE(least, 10);
    EXPECT_LT(least, 10.1);
    EXPECT_LE(most, 16);
    EXPECT_GT(most, 15.9);
    EXPECT_NEAR(sum / seeds, 13, 5 * 6 / std::sqrt(12.0 * seeds));
}

TEST(ScaleOfTree, IsNeverLessThanATenth) {
    double least = 100;
    for (int seed = 0; seed < 500; ++seed) // the black oak's 10 ± 10 m
        least = std::min(least, scaleOfTree(with({}, {{"Scale", 10}, {"ScaleV", 10}, {"Seed", double(seed)}}), true));
    EXPECT_EQ(least, 1);
}

TEST(ScaleOfTree, IsTheTreesHeight) {
    const CParams params = with(richTree(), {{"0Length", 0.8}, {"0LengthV", 0}, {"0Scale", 2}, {"0ScaleV", 0}});
    const auto tree = grow(params);
    EXPECT_EQ(tree->height(), scaleOfTree(params, true));
    const CStem& trunk = tree->generation(0).stems.at(0);
    EXPECT_DOUBLE_EQ(trunk.length, 0.8 * tree->height());
    EXPECT_DOUBLE_EQ(trunk.radius, trunk.length * 0.03 * 2) << "0Scale counts once";
}

TEST(Degenerate, NoRoomNoBranches) {
    const Values cases[] = {{{"BaseSize", 1}},
                            {{"0Length", 0.25}, {"BaseSize", 0.25}},
                            {{"0Length", 0.1}, {"BaseSize", 0.5}},
                            {{"1Branches", 0}},
                            {{"1Length", 0}},
                            {{"1Length", 1e-7}}};
    for (const Values& values : cases) {
        const auto tree = grow(with(with({}, {{"Leaves", 20}}), values));
        EXPECT_EQ(tree->generation(0).stems.size(), 1u);
        EXPECT_TRUE(tree->generation(1).stems.empty()) << values.begin()->first;
        EXPECT_TRUE(tree->generation(2).stems.empty());
        EXPECT_TRUE(tree->leaves().empty());
        expectFinite(*tree, std::string(values.begin()->first));
    }
}

TEST(Degenerate, NoTrunkNoTree) {
    const auto tree = grow(with({}, {{"0Length", 0}, {"Leaves", 20}}));
    ASSERT_EQ(tree->generationCount(), 3u);
    EXPECT_EQ(tree->stemCount(), 0u);
    EXPECT_TRUE(tree->leaves().empty());
}

TEST(Degenerate, StemsOfTenMicrometresAreLeftOut) {
    const auto tree = grow(with({}, {{"Levels", 2}, {"1Branches", 100}, {"1Length", 0}, {"1LengthV", 0.001}}));
    ASSERT_GT(tree->generation(1).stems.size(), 30u) << "about half of the lengths are positive";
    ASSERT_LT(tree->generation(1).stems.size(), 70u);
    for (const CStem& stem : tree->generation(1).stems) EXPECT_GT(stem.length, 1e-5);
}

TEST(Degenerate, VariationMakesNoNegativeRadius) {
    for (int seed = 0; seed < 50; ++seed) {
        const auto tree = grow(with({}, {{"0Scale", 0.1}, {"0ScaleV", 0.5}, {"Seed", double(seed)}}));
        ASSERT_GE(tree->generation(0).stems.at(0).radius, 0) << "seed " << seed;
        expectFinite(*tree, "seed " + std::to_string(seed));
        ASSERT_FALSE(HasFatalFailure());
    }
}

/// Every value at the ends of what files may hold, the others moderate.
TEST(Degenerate, BoundsOfEveryValueStayFinite) {
    const CParams base =
        with(richTree(), {{"1Branches", 5}, {"2Branches", 3}, {"3Branches", 2}, {"0BaseSplits", 1}, {"0CurveRes", 4}});
    for (const ParamRef& ref : numberParams())
        for (const double bound : {ref.info->range.min, ref.info->range.max}) {
            // what only makes the tree big is capped; splits grow with the power of the segments
            const bool count = ref.info->integer() || ref.info->key == "SegSplits" || ref.info->key == "LeafQuality";
            const double value = count && ref.info->key != "Seed"
                                     ? std::clamp(bound, -200.0, ref.info->key == "SegSplits" ? 3.0 : 60.0)
                                     : bound;
            const CParams params =
                with(base, {{ref.key(), value}, {"Levels", ref.info->key == "Levels" ? std::min(value, 6.0) : 3}});
            expectFinite(*grow(params), ref.key() + " = " + std::to_string(value));
            ASSERT_FALSE(HasFatalFailure());
        }
}

} // namespace
} // namespace stromar
