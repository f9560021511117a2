#include "stromar/params/methods/weberpenn/TreeParams.h"
#include "tree/Support.h"
#include <gtest/gtest.h>
#include <map>

namespace stromar {
namespace {

using namespace test;

/// Whether all segment ends of a stem lie inside, its size changed by `scale` about its base. The last bits of an end
/// may differ from those that were tested, so the test gets a hair of room.
bool inside(const CGeneration& generation, const CStem& stem, const CParams& params, double scaleTree, double scale) {
    const glm::dvec3 base = firstSegment(generation, stem).position;
    WeberPennParams roomy = weberPenn(params);
    roomy.pruneWidth *= 1 + 1e-9;
    for (std::uint32_t s = 0; s < stem.segmentCount; ++s) {
        const glm::dvec3 end = base + scale * (generation.segments[stem.firstSegment + s].axisPoint(1) - base);
        if (!insideEnvelope(end.x, end.y, end.z, roomy, scaleTree)) return false;
    }
    return true;
}

std::vector<CParams> prunedTrees() {
    std::vector<CParams> all{preset("weeping_willow"), with(richTree(), {{"PruneRatio", 1}, {"1Length", 0.8}})};
    for (unsigned seed = 0; seed < 20; ++seed)
        all.push_back(with(randomTree(seed), {{"PruneRatio", 1}, {"PruneWidth", 0.3}}));
    weberPenn(all[0]).level[3].branches = 20; // the same tree with fewer of its 50000 twigs
    return all;
}

TEST(Pruning, FullPruningLeavesNothingOutside) {
    std::size_t stems = 0;
    for (const CParams& params : prunedTrees()) {
        const auto tree = grow(params);
        for (std::size_t g = 1; g < tree->generationCount(); ++g)
            for (const CStem& stem : tree->generation(g).stems) {
                ++stems;
                ASSERT_TRUE(inside(tree->generation(g), stem, params, tree->height(), 1)) << "generation " << g;
            }
    }
    EXPECT_GT(stems, 3000u);
}

/// Level-1 branches by id.
std::map<std::uint64_t, CStem> branches(const CTree& tree) {
    std::map<std::uint64_t, CStem> all;
    for (const CStem& stem : tree.generation(1).stems) all.emplace(stem.id, stem);
    return all;
}

CParams wide() {
    return with({}, {{"Levels", 2},
                     {"1Branches", 80},
                     {"1Length", 0.6},
                     {"1LengthV", 0.3},
                     {"1CurveRes", 4},
                     {"1Curve", 40},
                     {"1DownAngle", 70},
                     {"PruneWidth", 0.3},
                     {"1SegSplits", 0.3},
                     {"1SplitAngle", 40}});
}

TEST(Pruning, LengthsShrinkByTenths) {
    const auto whole = branches(*grow(wide()));
    const auto tree = grow(with(wide(), {{"PruneRatio", 1}}));
    const auto fitted = branches(*tree);
    int shortened = 0;
    for (const auto& [id, stem] : fitted) {
        const double steps = std::log(stem.length / whole.at(id).length) / std::log(0.9);
        EXPECT_NEAR(steps, std::round(steps), 1e-6);
        EXPECT_GE(stem.length, 0.05 * whole.at(id).length);
        if (steps < 0.5) continue;
        ++shortened;
        EXPECT_FALSE(inside(tree->generation(1), stem, wide(), tree->height(), 1 / 0.9)) << "one step too short";
    }
    EXPECT_GT(shortened, 20);
    EXPECT_LT(shortened, 80);
}

TEST(Pruning, TheRatioBlends) {
    const auto whole = branches(*grow(wide())), fitted = branches(*grow(with(wide(), {{"PruneRatio", 1}})));
    for (const double ratio : {0.25, 0.5}) {
        const auto tree = grow(with(wide(), {{"PruneRatio", ratio}}));
        const auto blended = branches(*tree);
        EXPECT_EQ(blended.size(), whole.size()) << "only a full pruning drops stems";
        for (const auto& [id, stem] : blended) {
            const double least = fitted.contains(id) ? fitted.at(id).length : 0;
            EXPECT_NEAR(stem.length, whole.at(id).length * (1 - ratio) + least * ratio, 1e-9);
            const double inherited = 0.5 * stem.length / 10; // trunk 10 m long, ½ m thick
            EXPECT_NEAR(stem.radius, std::min(inherited, stem.parentRadius), 1e-12)
                << "radius from the pruned length";
        }
    }
}

TEST(Pruning, WhatCannotFitIsDropped) {
    const auto tree = grow(with(wide(), {{"PruneRatio", 1}, {"PruneWidth", 0}}));
    EXPECT_EQ(tree->generation(0).stems.size(), 1u) << "the trunk is never pruned";
    EXPECT_TRUE(tree->generation(1).stems.empty());
}

TEST(Pruning, TheTrunkStays) {
    const CParams params = with(richTree(), {{"0CurveV", 90}});
    const auto whole = grow(with(params, {{"PruneRatio", 0}})),
               pruned = grow(with(params, {{"PruneRatio", 1}, {"PruneWidth", 0.2}}));
    EXPECT_TRUE(same(whole->generation(0), pruned->generation(0)));
    EXPECT_FALSE(same(whole->generation(1), pruned->generation(1)));
}

TEST(Pruning, KeepsTheFormOfAStem) {
    const auto a = grow(wide()), b = grow(with(wide(), {{"PruneRatio", 1}}));
    const auto whole = branches(*a);
    for (const CStem& stem : b->generation(1).stems) {
        const CStem& old = whole.at(stem.id);
        ASSERT_EQ(stem.pathCount, old.pathCount);
        for (std::uint32_t s = 0; s < stem.segmentCount; ++s)
            EXPECT_TRUE(sameBits(b->generation(1).segments[stem.firstSegment + s].frame,
                                 a->generation(1).segments[old.firstSegment + s].frame));
    }
}

// Of the independent reference program: pruning shortens 402 stems of the willow and drops none.
TEST(Pruning, TheWillowsNeutralFigures) {
    const CParams params = with(preset("weeping_willow"), {{"AttractionAxis", 0}}); // the printed formula
    const auto tree = growNeutral(params);
    int shortened = 0;
    for (std::size_t g = 1; g < tree->generationCount(); ++g) {
        const CTreeParams seen(params, static_cast<int>(g), tree->height());
        for (const CStem& stem : tree->generation(g).stems) {
            const StemMeasures parent = grownOf(*tree, g - 1).measuresOf(static_cast<std::size_t>(stem.parent));
            const double lengthMax = scratchOf(tree->generation(g), stem).lengthMax;
            shortened += stem.length < 0.99 * seen.calc().length(lengthMax, parent, stem.offset);
        }
    }
    EXPECT_EQ(shortened, 402);
}

} // namespace
} // namespace stromar
