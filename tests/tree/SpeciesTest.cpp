#include "stromar/params/Season.h"
#include "stromar/params/methods/weberpenn/TreeParams.h"
#include "tree/Support.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace stromar {
namespace {

using namespace test;

/// A straight trunk with straight branches.
CParams whorled(int whorl) {
    return with(CParams(), {{"Levels", 2},
                            {"BaseSize", 0},
                            {"0CurveRes", 1},
                            {"1Branches", 24},
                            {"1Whorl", double(whorl)},
                            {"1BranchDistV", 0},
                            {"1RotateV", 0},
                            {"1DownAngle", 60}});
}

TEST(Whorl, BranchesOfOneStandAtOneHeightAndAtEqualAngles) {
    for (const int whorl : {1, 2, 3, 6}) {
        const auto tree = grow(whorled(whorl));
        std::map<double, std::vector<double>> byHeight;
        for (const CStem& stem : tree->generation(1).stems) {
            const CSegment& first = tree->generation(1).segments[stem.firstSegment];
            byHeight[std::round(first.position.z * 1e6)].push_back(std::atan2(first.frame[2].y, first.frame[2].x));
        }
        EXPECT_NEAR(double(byHeight.size()) * whorl, 24, whorl);
        for (const auto& [height, angles] : byHeight) {
            ASSERT_EQ(angles.size(), std::size_t(whorl)) << height;
            const double step = 2 * std::acos(-1.0) / whorl;
            for (std::size_t i = 1; i < angles.size(); ++i)
                EXPECT_NEAR(std::remainder(angles[i] - angles[0] - double(i) * step, 2 * std::acos(-1.0)), 0, 1e-9);
        }
    }
}

TEST(Whorl, OfLeavesStandsAtOnePlace) {
    for (const int whorl : {1, 2, 4}) {
        const auto tree = grow(with(whorled(1), {{"Leaves", 20}, {"LeafWhorl", double(whorl)}, {"2BranchDistV", 0}}));
        ASSERT_FALSE(tree->leaves().empty());
        ASSERT_EQ(tree->leaves().size() % std::size_t(whorl), 0u);
        for (std::size_t i = 0; i < tree->leaves().size(); ++i) {
            const CLeaf &leaf = tree->leaves()[i], &first = tree->leaves()[i / std::size_t(whorl) * std::size_t(whorl)];
            EXPECT_LT(glm::length(leaf.position - first.position), 1e-5f);
            if (&leaf != &first) {
                EXPECT_GT(glm::length(leaf.axis - first.axis), 0.1);
            }
        }
    }
}

TEST(Trunks, StandInsideTheirSpreadAndLeanOutwards) {
    const auto tree = grow(with(CParams(), {{"Trunks", 12}, {"TrunksSpread", 2}, {"TrunksLean", 30}, {"0CurveV", 0}}));
    const CGeneration& trunks = tree->generation(0);
    ASSERT_EQ(trunks.stems.size(), 12u);
    double outermost = 0;
    for (const CStem& stem : trunks.stems) {
        const CSegment& first = trunks.segments[stem.firstSegment];
        EXPECT_EQ(first.position.z, 0);
        const double out = std::hypot(first.position.x, first.position.y);
        EXPECT_LE(out, 2 + 1e-9);
        outermost = std::max(outermost, out);
        EXPECT_NEAR(declination(first.frame), out / 2 * 30 * kRadiansPerDegree, 1e-9);
        const glm::dvec2 away(first.position.x, first.position.y), lean(first.frame[2].x, first.frame[2].y);
        EXPECT_GT(glm::dot(away, lean), 0);
    }
    EXPECT_NEAR(outermost, 2, 1e-9);
    EXPECT_EQ(grow(CParams())->generation(0).segments[0].position, glm::dvec3(0))
        << "a single one stands in the middle";
}

TEST(Organs, BlossomsAndFruitsLeaveTheLeavesAlone) {
    const CParams bare = with(whorled(1), {{"Leaves", 9}});
    const CParams rich = with(bare, {{"Blossoms", 5}, {"Fruits", 3}, {"FruitScaleX", 0.5}});
    const auto before = grow(bare), after = grow(rich);
    EXPECT_TRUE(sameArrays(before->leaves(), after->leaves()));
    EXPECT_TRUE(before->grown(Organ::Blossom).empty());
    EXPECT_GT(after->grown(Organ::Blossom).size(), after->grown(Organ::Fruit).size());
    for (const CLeaf& fruit : after->grown(Organ::Fruit)) {
        EXPECT_LT(fruit.axis.z, -0.5) << "fruits hang";
        EXPECT_NEAR(fruit.width, 0.5 * fruit.length, 1e-12);
    }
}

TEST(Organs, BlossomsStandUprightOrHang) {
    const auto meanRise = [](double up) {
        const auto tree = grow(with(whorled(1), {{"Blossoms", 9}, {"BlossomUp", up}}));
        double sum = 0;
        for (const CLeaf& blossom : tree->grown(Organ::Blossom)) sum += blossom.axis.z;
        return sum / double(tree->grown(Organ::Blossom).size());
    };
    EXPECT_NEAR(meanRise(1), 1, 1e-9);
    EXPECT_NEAR(meanRise(-1), -1, 1e-9);
    EXPECT_GT(meanRise(0.5), meanRise(0) + 0.1);
    EXPECT_LT(meanRise(-0.5), meanRise(0) - 0.1);
}

TEST(Season, MakesAndTakesTheLeaves) {
    const auto at = [](double month, bool evergreen = false) {
        CommonParams g = CParams().common;
        g.season = month;
        g.evergreen = evergreen;
        return phenologyOf(g);
    };
    EXPECT_EQ(at(7).leaves, 1);
    EXPECT_EQ(at(7).leafSize, 1);
    EXPECT_EQ(at(1).leaves, 0);
    EXPECT_EQ(at(12).leaves, 0);
    EXPECT_GT(at(10.5).leaves, 0);
    EXPECT_LT(at(10.5).leaves, 1);
    EXPECT_LT(at(4.3).leafSize, 0.8);
    EXPECT_EQ(at(1, true).leaves, 1);
    EXPECT_EQ(at(4.5).blossoms, 1);
    EXPECT_EQ(at(7).blossoms, 0);
    EXPECT_EQ(at(9).fruitSize, 1);
    EXPECT_NEAR(at(8).fruitSize, 0.5, 1e-9);
    EXPECT_EQ(at(3).fruits, 0);
}

TEST(Season, OfBlossomGoesOverNewYear) {
    CommonParams g = CParams().common;
    g.blossomMonth = 0.2;
    g.season = 11.9;
    EXPECT_GT(phenologyOf(g).blossoms, 0.4);
}

} // namespace
} // namespace stromar
