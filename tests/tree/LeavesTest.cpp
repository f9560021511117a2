#include "tree/Support.h"
#include <gtest/gtest.h>
#include <map>

namespace stromar {
namespace {

using namespace test;

CParams leafy(Values values) {
    return with(
        with({},
             {{"Levels", 2}, {"1Branches", 40}, {"1CurveRes", 4}, {"1DownAngle", 70}, {"Leaves", 20}, {"LeafBend", 0}}),
        values);
}

constexpr double kSingle = 2e-6; // what single precision leaves of metres and unit vectors

std::map<std::uint32_t, std::vector<CLeaf>> byStem(const CTree& tree) {
    std::map<std::uint32_t, std::vector<CLeaf>> all;
    for (const CLeaf& leaf : tree.leaves()) all[leaf.stem].push_back(leaf);
    return all;
}

double numberOn(const CTree& tree, const CStem& stem, double leaves, double quality) {
    return leaves * (0.5 + 0.5 * stem.offset / tree.generation(0).stems[0].length) * quality;
}

TEST(Leaves, CountsAreTaperedAlongTheParent) {
    for (const double quality : {1.0, 0.25, 2.0})
        for (const bool varied : {true, false}) {
            const auto tree = grow(leafy({{"LeafQuality", quality}}), varied);
            const auto leaves = byStem(*tree);
            const auto& stems = tree->generation(1).stems;
            double sum = 0;
            for (std::uint32_t s = 0; s < stems.size(); ++s) {
                const double wanted = numberOn(*tree, stems[s], 20, quality);
                EXPECT_NEAR(double(leaves.contains(s) ? leaves.at(s).size() : 0), wanted, 1) << s;
                sum += wanted;
            }
            EXPECT_NEAR(double(tree->leaves().size()), sum, 3 * std::sqrt(40.0));
        }
}

TEST(Leaves, SizeKeepsTheLeafArea) {
    for (const double quality : {1.0, 0.25, 4.0}) {
        const auto tree = grow(leafy({{"LeafQuality", quality}, {"LeafScale", 0.3}, {"LeafScaleX", 0.4}}));
        ASSERT_FALSE(tree->leaves().empty());
        for (const CLeaf& leaf : tree->leaves()) {
            EXPECT_NEAR(leaf.length, 0.3 / std::sqrt(quality), 1e-7);
            EXPECT_NEAR(leaf.width, 0.3 * 0.4 / std::sqrt(quality), 1e-7);
        }
    }
}

TEST(Leaves, SitOnTheLastStems) {
    for (const int levels : {2, 3, 4}) {
        const auto tree = grow(with(richTree(), {{"Levels", double(levels)}}));
        const CGeneration& last = tree->generation(static_cast<std::size_t>(levels) - 1);
        ASSERT_FALSE(tree->leaves().empty());
        for (const CLeaf& leaf : tree->leaves()) {
            const CStem& stem = last.stems.at(leaf.stem);
            double nearest = 1e9;
            for (std::uint32_t s = 0; s < stem.segmentCount; ++s) {
                const CSegment& segment = last.segments[stem.firstSegment + s];
                const glm::dvec3 foot = leaf.position;
                const double t = glm::dot(foot - segment.position, segment.frame[2]) / segment.length;
                if (t > -1e-4 && t < 1 + 1e-4) nearest = std::min(nearest, glm::length(foot - segment.centre(t)));
            }
            ASSERT_LT(nearest, kSingle);
        }
    }
}

TEST(Leaves, TheNextLevelPlacesThem) {
    const auto tree = growNeutral(leafy({{"2DownAngle", 50}, {"2Rotate", 100}, {"1Curve", 0}}));
    for (const auto& [s, leaves] : byStem(*tree)) {
        const Frame& frame = firstSegment(tree->generation(1), tree->generation(1).stems[s]).frame;
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const Frame expected = rotatedX(rotatedZ(frame, glm::radians(100.0 * double(i + 1))), glm::radians(50.0));
            EXPECT_LT(glm::length(glm::dvec3(leaves[i].axis) - expected[2]), kSingle) << s << ", leaf " << i;
            EXPECT_LT(glm::length(glm::dvec3(leaves[i].normal) - expected[1]), kSingle) << "without LeafBend the frame stays";
        }
    }
}

TEST(Leaves, BranchDistDoesNotGatherThem) {
    EXPECT_EQ(difference(*growNeutral(leafy({{"2BranchDist", 0}})), *growNeutral(leafy({{"2BranchDist", 1}}))), "");
    EXPECT_NE(difference(*grow(leafy({{"2BranchDistV", 0}})), *grow(leafy({{"2BranchDistV", 1}}))), "");
}

TEST(Leaves, FullBendTurnsTheNormalsUp) {
    const auto tree = grow(with(richTree(), {{"LeafBend", 1}}));
    ASSERT_GT(tree->leaves().size(), 100u);
    for (const CLeaf& leaf : tree->leaves()) EXPECT_NEAR(leaf.normal.z, 1, kSingle);
}

// The first turn, about the vertical, takes the share of the way to the position's azimuth; the second, towards the
// sky, keeps the azimuth and takes the share of the way up.
TEST(Leaves, BendGoesAShareOfTheWay) {
    for (const double bend : {0.25, 0.6}) {
        const auto straight = grow(with(richTree(), {{"LeafBend", 0}})),
                   bent = grow(with(richTree(), {{"LeafBend", bend}}));
        ASSERT_EQ(straight->leaves().size(), bent->leaves().size());
        for (std::size_t i = 0; i < bent->leaves().size(); ++i) {
            const CLeaf &a = straight->leaves()[i], &b = bent->leaves()[i];
            const double up = angleBetween(a.normal, {0, 0, 1});
            ASSERT_NEAR(angleBetween(b.normal, {0, 0, 1}), (1 - bend) * up, 0.05);
            if (up < 0.1 || up > 179.9) continue; // no azimuth to speak of
            const double turn = bend * turnFrom(azimuthOf(a.normal), azimuthOf(a.position));
            ASSERT_NEAR(turnFrom(azimuthOf(a.normal) + turn, azimuthOf(b.normal)), 0, 0.05);
        }
    }
}

TEST(Leaves, AxesAndNormalsAreAtRightAngles) {
    for (const double bend : {0.0, 0.3, 1.0}) {
        const auto tree = grow(with(richTree(), {{"LeafBend", bend}}));
        ASSERT_FALSE(tree->leaves().empty());
        for (const CLeaf& leaf : tree->leaves()) {
            ASSERT_NEAR(glm::length(leaf.axis), 1, kSingle);
            ASSERT_NEAR(glm::length(leaf.normal), 1, kSingle);
            ASSERT_NEAR(glm::dot(leaf.axis, leaf.normal), 0, kSingle);
        }
    }
}

TEST(Leaves, AFanHasExactlyItsArc) {
    const auto tree = growNeutral(leafy({{"Leaves", -7}, {"2Rotate", 150}, {"2DownAngle", 0}}));
    const CGeneration& branches = tree->generation(1);
    const auto fans = byStem(*tree);
    ASSERT_EQ(fans.size(), branches.stems.size());
    for (const auto& [s, leaves] : fans) {
        const CStem& stem = branches.stems[s];
        ASSERT_EQ(leaves.size(), std::size_t(std::floor(numberOn(*tree, stem, 7, 1) + 0.5)));
        const CSegment& last = segmentOf(branches, stem, 0, curveRes(branches) - 1);
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const double turn = glm::radians(150 * (double(i) / double(leaves.size() - 1) - 0.5));
            EXPECT_LT(glm::length(glm::dvec3(leaves[i].position) - last.axisPoint(1)), kSingle);
            EXPECT_LT(glm::length(glm::dvec3(leaves[i].axis) - (std::cos(turn) * last.frame[2] + std::sin(turn) * last.frame[0])),
                      kSingle);
        }
        EXPECT_NEAR(angleBetween(leaves.front().axis, leaves.back().axis), 150, 1e-3);
    }
}

TEST(Leaves, FansStandAtTheTipsOfClonesToo) {
    const auto tree = growNeutral(
        leafy({{"Leaves", -12}, {"1CurveRes", 2}, {"1SegSplits", 1}, {"1SplitAngle", 90}, {"1DownAngle", 40}}));
    const CGeneration& branches = tree->generation(1);
    for (const auto& [s, leaves] : byStem(*tree)) {
        const CStem& stem = branches.stems[s];
        ASSERT_EQ(stem.pathCount, 2u);
        const auto share = std::size_t(std::floor(numberOn(*tree, stem, 12, 1) / 2 + 0.5)); // the density is halved
        ASSERT_EQ(leaves.size(), 2 * share);
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const CSegment& last = segmentOf(branches, stem, i < share ? 0 : 1, 1);
            EXPECT_LT(glm::length(glm::dvec3(leaves[i].position) - last.axisPoint(1)), kSingle);
        }
    }
}

TEST(Leaves, AFanOfOneStandsStraight) {
    const auto tree = growNeutral(leafy({{"Leaves", -1}, {"2Rotate", 150}, {"2DownAngle", 0}}));
    ASSERT_EQ(tree->leaves().size(), tree->generation(1).stems.size()); // ½ to 1 leaf, rounded
    for (const CLeaf& leaf : tree->leaves()) {
        const CStem& stem = tree->generation(1).stems[leaf.stem];
        const CSegment& last = segmentOf(tree->generation(1), stem, 0, curveRes(tree->generation(1)) - 1);
        EXPECT_LT(glm::length(glm::dvec3(leaf.axis) - last.frame[2]), kSingle);
    }
}

TEST(Leaves, NoneOnATrunkAlone) {
    for (const double leaves : {25.0, -25.0}) {
        const auto tree = grow(with({}, {{"Levels", 1}, {"Leaves", leaves}}));
        EXPECT_EQ(tree->generationCount(), 1u);
        EXPECT_TRUE(tree->leaves().empty());
    }
    EXPECT_TRUE(grow(leafy({{"Leaves", 0}}))->leaves().empty());
}

} // namespace
} // namespace stromar
