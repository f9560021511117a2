#include "stromar/params/methods/weberpenn/TreeParams.h"
#include "tree/Support.h"
#include <gtest/gtest.h>
#include <map>

namespace stromar {
namespace {

using namespace test;

/// A straight trunk with level branches.
CParams levelBranches(Values values) {
    return with(
        with(
            {},
            {{"Levels", 2}, {"Scale", 10}, {"BaseSize", 0.2}, {"0CurveRes", 5}, {"1Branches", 12}, {"1DownAngle", 90}}),
        values);
}

/// Azimuths of the branches of path 0, in order.
std::vector<double> azimuths(const CTree& tree) {
    std::vector<double> all;
    for (const CStem& stem : tree.generation(1).stems)
        if (stem.path == 0) all.push_back(azimuthOf(firstSegment(tree.generation(1), stem).frame[2]));
    return all;
}

TEST(Placement, ALevelBranchHasItsYToTheSky) {
    const auto tree = grow(levelBranches({{"1RotateV", 90}}));
    ASSERT_GT(tree->generation(1).stems.size(), 8u);
    for (const CStem& stem : tree->generation(1).stems) {
        const Frame& frame = firstSegment(tree->generation(1), stem).frame;
        EXPECT_NEAR(frame[2].z, 0, 1e-12);
        EXPECT_NEAR(frame[1].z, 1, 1e-12);
        EXPECT_NEAR(frame[0].z, 0, 1e-12);
    }
}

// rotz(ρ) turns Y to azimuth 90 + ρ and rotx(90) sends Z to −Y: azimuth ρ − 90.
TEST(Placement, TheRotationRuns) {
    for (const double rotate : {0.0, 90.0, 140.0, 222.0}) {
        const auto got = azimuths(*growNeutral(levelBranches({{"1Rotate", rotate}})));
        ASSERT_GE(got.size(), 10u);
        for (std::size_t i = 0; i < got.size(); ++i)
            EXPECT_NEAR(turnFrom(rotate * double(i + 1) - 90, got[i]), 0, 1e-9) << rotate << ", branch " << i;
    }
}

TEST(Placement, NegativeRotationAlternates) {
    for (const double rotate : {-120.0, -180.0, -10.0, -270.0}) {
        const auto got = azimuths(*growNeutral(levelBranches({{"1Rotate", rotate}})));
        ASSERT_GE(got.size(), 10u);
        for (std::size_t i = 0; i < got.size(); ++i)
            EXPECT_NEAR(turnFrom((i % 2 ? -1 : 1) * (180 + rotate) - 90, got[i]), 0, 1e-9)
                << rotate << ", branch " << i;
    }
}

TEST(Placement, EveryPathHasItsPhase) {
    const auto tree = growNeutral(levelBranches({{"0BaseSplits", 2}, {"1Rotate", 50}, {"1Branches", 30}}));
    const CGeneration &trunk = tree->generation(0), &branches = tree->generation(1);
    std::map<std::uint32_t, int> first;
    for (const CStem& stem : branches.stems) {
        if (++first[stem.path] > 1) continue;
        // the clone's own frame is spread by 120° a path, and its phase is as much again
        const double expected = 120.0 * stem.path + 120.0 * stem.path + 50 - 90;
        EXPECT_NEAR(turnFrom(expected, azimuthOf(firstSegment(branches, stem).frame[2])), 0, 1e-9)
            << "path " << stem.path;
    }
    EXPECT_EQ(first.size(), 3u);
    EXPECT_EQ(trunk.paths.size(), 3u);
}

TEST(Placement, DownAnglesVaryOrAreGraded) {
    const auto down = [](const CTree& tree) {
        std::vector<double> all;
        for (const CStem& stem : tree.generation(1).stems)
            all.push_back(declinationOf(firstSegment(tree.generation(1), stem)));
        return all;
    };
    double least = 180, most = 0;
    for (const double angle :
         down(*grow(levelBranches({{"1DownAngle", 60}, {"1DownAngleV", 20}, {"1Branches", 400}})))) {
        least = std::min(least, angle);
        most = std::max(most, angle);
    }
    EXPECT_GE(least, 40 - 1e-9);
    EXPECT_LT(least, 42);
    EXPECT_LE(most, 80 + 1e-9);
    EXPECT_GT(most, 78);
    const auto tree = grow(levelBranches({{"1DownAngle", 60}, {"1DownAngleV", -50}, {"1Branches", 400}}));
    const auto graded = down(*tree);
    EXPECT_NEAR(graded.front(), 110, 1); // the crown's bottom
    EXPECT_NEAR(graded.back(), 30, 1);   // its top
    for (std::size_t i = 0; i < graded.size(); ++i) {
        const double r = (10 - tree->generation(1).stems[i].offset) / 8;
        EXPECT_NEAR(graded[i], 60 - 50 * (1 - 2 * (0.2 + 0.8 * r)), 1e-9);
    }
}

TEST(Placement, BranchesStandEvenlyAboveTheBarePart) {
    const auto tree = growNeutral(levelBranches({{"1Branches", 16}})); // 8 m for 16, four a segment
    const auto& stems = tree->generation(1).stems;
    ASSERT_EQ(stems.size(), 16u);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(stems[i].offset, 2 + 0.25 + 0.5 * double(i), 1e-9) << i;
}

TEST(Placement, TheBareSegmentIsFilledFromItsBarePlace) {
    const auto tree = growNeutral(levelBranches({{"BaseSize", 0.25}, {"1Branches", 15}})); // 7.5 m, half a metre each
    std::map<std::uint32_t, int> perSegment;
    for (const CStem& stem : tree->generation(1).stems) {
        ++perSegment[stem.position];
        EXPECT_GE(stem.offset, 2.5);
    }
    EXPECT_EQ(perSegment, (std::map<std::uint32_t, int>{{1, 3}, {2, 4}, {3, 4}, {4, 4}}));
}

TEST(Placement, BranchDistGathersAtTheSegmentsBase) {
    const std::pair<double, double> spacings[] = {{1, 0.5}, {0.5, 0.25}, {0, 0}};
    for (const auto& [dist, spacing] : spacings) {
        const auto tree = growNeutral(levelBranches({{"1Branches", 16}, {"1BranchDist", dist}}));
        const auto& stems = tree->generation(1).stems;
        ASSERT_EQ(stems.size(), 16u);
        for (std::size_t i = 0; i < 16; ++i)
            EXPECT_NEAR(stems[i].offset, 2 + 2 * double(i / 4) + spacing * (0.5 + double(i % 4)), 1e-9)
                << dist << ", " << i;
    }
}

TEST(Placement, TheJitterIsAPartOfTheSpacing) {
    double most = 0;
    for (int seed = 0; seed < 30; ++seed) {
        const CParams params = levelBranches({{"1Branches", 16}, {"1BranchDistV", 0.4}, {"Seed", seed}});
        const auto tree = grow(params), still = grow(with(params, {{"1BranchDistV", 0}}));
        ASSERT_EQ(tree->generation(1).stems.size(), still->generation(1).stems.size());
        for (std::size_t i = 0; i < tree->generation(1).stems.size(); ++i) {
            const CStem &moved = tree->generation(1).stems[i], &even = still->generation(1).stems[i];
            ASSERT_EQ(moved.id, even.id);
            ASSERT_EQ(moved.position, even.position) << "kept inside the segment";
            int siblings = 0;
            for (const CStem& other : still->generation(1).stems) siblings += other.position == even.position;
            const double shift = (moved.offset - even.offset) / (2.0 / siblings);
            EXPECT_LE(std::abs(shift), 0.4 + 1e-9);
            most = std::max(most, std::abs(shift));
        }
    }
    EXPECT_GT(most, 0.38);
}

/// Children counted, each stem by itself, against the number by the formula: the rounding is less than one.
void expectCounts(const CParams& params, std::size_t generation, bool varied) {
    const auto tree = grow(params, varied);
    const CTreeParams seen(params, static_cast<int>(generation), tree->height());
    const CGeneration& parents = tree->generation(generation);
    std::vector<double> children(parents.stems.size());
    for (const CStem& child : tree->generation(generation + 1).stems)
        children[static_cast<std::size_t>(child.parent)] += 1;
    double sum = 0, wanted = 0;
    for (std::size_t s = 0; s < parents.stems.size(); ++s) {
        const StemMeasures m = grownOf(*tree, generation).measuresOf(s);
        const double most = weberPenn(params).level[std::min<std::size_t>(generation + 1, 3)].branches;
        const double number = generation == 0   ? most
                              : generation == 1 ? most * (0.2 + 0.8 * m.length / m.parentLength / m.lengthMax)
                                                : most * (1 - 0.5 * m.offset / m.parentLength);
        EXPECT_NEAR(children[s], number, 1) << "stem " << s << " of generation " << generation;
        sum += children[s];
        wanted += number;
    }
    EXPECT_NEAR(sum, wanted, 3 * std::sqrt(double(parents.stems.size())) + 1) << "generation " << generation;
}

TEST(Placement, CountsFollowTheFormulas) {
    const CParams params = with(
        {},
        {{"Levels", 4}, {"1Branches", 60}, {"2Branches", 7}, {"3Branches", 4}, {"1LengthV", 0.1}, {"Ratio", 0.001}});
    for (const bool varied : {false, true})
        for (const std::size_t generation : {0u, 1u, 2u}) expectCounts(params, generation, varied);
}

TEST(Placement, ClonesShareTheChildren) {
    const CParams params =
        with({}, {{"Levels", 2}, {"0CurveRes", 6}, {"0BaseSplits", 3}, {"0SegSplits", 0.4}, {"1Branches", 200}});
    expectCounts(params, 0, true);
}

TEST(Placement, NoChildStartsInsideTheParent) {
    const auto tree = grow(with({}, {{"Levels", 3},
                                     {"Ratio", 0.08},
                                     {"RatioPower", 0.5},
                                     {"2Branches", 30},
                                     {"1CurveRes", 4},
                                     {"2DownAngle", 80}}));
    const CGeneration &branches = tree->generation(1), &twigs = tree->generation(2);
    ASSERT_GT(twigs.stems.size(), 100u);
    int near = 0;
    for (const CStem& stem : twigs.stems) {
        const CStem& parent = branches.stems[static_cast<std::size_t>(stem.parent)];
        const double segment = parent.length / curveRes(branches);
        EXPECT_GE(stem.offset, std::min(segment, parent.parentRadius) - 1e-9);
        near += stem.position == 0;
    }
    EXPECT_GT(near, 5);
}

TEST(Placement, LengthsVaryPerChild) {
    const auto tree = grow(levelBranches({{"1Branches", 500}, {"1Length", 0.5}, {"1LengthV", 0.2}, {"Shape", 3}}));
    double least = 1, most = 0;
    for (const CStem& stem : tree->generation(1).stems) {
        const double lengthMax = scratchOf(tree->generation(1), stem).lengthMax;
        EXPECT_DOUBLE_EQ(stem.length, 10 * lengthMax);
        least = std::min(least, lengthMax);
        most = std::max(most, lengthMax);
    }
    EXPECT_GE(least, 0.3 - 1e-12);
    EXPECT_LT(least, 0.31);
    EXPECT_LE(most, 0.7 + 1e-12);
    EXPECT_GT(most, 0.69);
}

} // namespace
} // namespace stromar
