// The wind pose: lengths keep, joints hold, loops close, crowns lean with the wind, still air moves nothing.
#include "Checkout.h"
#include "stromar/tree/Wind.h"
#include "Support.h"
#include "stromar/params/TreeFile.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

std::shared_ptr<const CTree> preset(const std::string& name, double age = 1) {
    const CParams params = CTreeFile::read(inSource("presets/") + name + ".tree").params();
    return growTree(CWeberPennBuilder(), params, CProgress(), age);
}

CWindTable tableOf(const std::shared_ptr<const CTree>& tree, double flexibility = 1, int seed = 1) {
    return {tree, *tree, flexibility, seed};
}

WindPose poseOf(const CWindTable& table, const Wind& wind, double seconds, int threads = 2) {
    WindPose pose;
    table.pose(wind, seconds, pose, CProgress(threads));
    return pose;
}

glm::dvec3 nodeAt(const WindPose& pose, std::size_t node) { return glm::dvec3(pose.rows[2 * node]); }

class WindTest : public ::testing::TestWithParam<const char*> {};

TEST_P(WindTest, LengthsOfAllPiecesKeep) {
    const auto tree = preset(GetParam());
    const CWindTable table = tableOf(tree, 2);
    const WindPose pose = poseOf(table, {.strength = 2, .gusts = 1}, 3.7);
    for (std::size_t g = 0; g < tree->generationCount(); ++g) {
        const CGeneration& all = tree->generation(g);
        for (std::uint32_t s = 0; s < all.segments.size(); ++s) {
            const std::uint32_t node = table.nodeOf(g, s);
            ASSERT_NEAR(glm::distance(nodeAt(pose, node), nodeAt(pose, node + 1)), all.segments[s].length, 1e-5);
        }
    }
}

TEST_P(WindTest, BranchesStayWhereTheySitOnTheirParents) {
    const auto tree = preset(GetParam());
    const CWindTable table = tableOf(tree);
    const WindPose pose = poseOf(table, {.strength = 1, .gusts = 1}, 12.3);
    std::size_t branches = 0;
    for (const WindStem& stem : table.stems()) {
        if (stem.parent < 0) {
            ASSERT_EQ(nodeAt(pose, stem.firstNode), glm::dvec3(glm::vec3(stem.base)));
            continue;
        }
        const Swayed parent(table.still(), pose, stem.on);
        ASSERT_LT(glm::distance(glm::dvec3(parent.point(glm::vec3(stem.base))), nodeAt(pose, stem.firstNode)), 1e-5);
        ++branches;
    }
    EXPECT_GT(branches, 10u);
}

TEST_P(WindTest, ClonesStartWhereTheirStemForks) {
    const auto tree = preset(GetParam());
    const CWindTable table = tableOf(tree);
    const WindPose pose = poseOf(table, {.strength = 1}, 5);
    for (std::size_t g = 0; g < tree->generationCount(); ++g) {
        const CGeneration& all = tree->generation(g);
        for (const CStem& stem : all.stems)
            for (std::uint32_t p = 1; p < stem.pathCount; ++p) {
                const CPath& path = all.paths[stem.firstPath + p];
                const CSegment* below = all.segmentBelow(stem, path);
                const auto end = table.nodeOf(g, static_cast<std::uint32_t>(below - all.segments.data())) + 1;
                ASSERT_EQ(nodeAt(pose, end), nodeAt(pose, table.nodeOf(g, path.firstSegment)));
            }
    }
}

TEST_P(WindTest, TheCrownLeansWithTheWindFromAnySide) {
    const auto tree = preset(GetParam());
    const CWindTable table = tableOf(tree);
    for (const glm::dvec3 direction :
         {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::normalize(glm::dvec3(-1, 1, 0))}) {
        double along = 0, across = 0;
        for (int second = 0; second < 60; second += 3) {
            const WindPose pose = poseOf(table, {.direction = direction, .strength = 0.6, .gusts = 0.5}, second);
            for (std::size_t n = 0; n < table.nodeCount(); ++n) {
                const glm::dvec3 moved = nodeAt(pose, n) - glm::dvec3(table.still()[n]);
                along += glm::dot(moved, direction);
                across += glm::dot(moved, glm::cross(direction, glm::dvec3(0, 0, 1)));
            }
        }
        EXPECT_GT(along, 0);
        EXPECT_LT(std::abs(across), 0.5 * along);
    }
}

TEST_P(WindTest, LoopsClose) {
    const CWindTable table = tableOf(preset(GetParam()));
    for (const double loop : {0.7, 2.0, 5.0}) {
        const Wind wind{.strength = 1, .gusts = 1, .loop = loop};
        const WindPose first = poseOf(table, wind, 0), last = poseOf(table, wind, loop),
                       half = poseOf(table, wind, loop / 2);
        double moved = 0;
        for (std::size_t i = 0; i < first.rows.size(); ++i) {
            ASSERT_LT(glm::distance(first.rows[i], last.rows[i]), 1e-5f);
            moved = std::max(moved, double(glm::distance(first.rows[i], half.rows[i])));
        }
        EXPECT_GT(moved, 0.01); // it is a motion
    }
}

TEST_P(WindTest, TheSameForAnyNumberOfThreads) {
    const CWindTable table = tableOf(preset(GetParam()));
    const Wind wind{.strength = 1, .gusts = 1};
    EXPECT_EQ(poseOf(table, wind, 4, 1).rows, poseOf(table, wind, 4, 7).rows);
}

TEST_P(WindTest, NothingJumps) {
    const auto tree = preset(GetParam());
    const CWindTable table = tableOf(tree);
    const Wind wind{.strength = 1, .gusts = 1};
    WindPose before = poseOf(table, wind, 0);
    for (int frame = 1; frame <= 30; ++frame) { // at 250 pictures a second
        const WindPose now = poseOf(table, wind, frame / 250.0);
        for (std::size_t n = 0; n < table.nodeCount(); ++n)
            ASSERT_LT(glm::distance(nodeAt(before, n), nodeAt(now, n)), 0.02 * tree->height());
        before = now;
    }
}

INSTANTIATE_TEST_SUITE_P(Trees, WindTest,
                         ::testing::Values("quaking_aspen", "english_oak", "weeping_willow", "coconut_palm",
                                           "norway_spruce"));

TEST(Wind, StillAirIsTheStillTree) {
    const CWindTable table = tableOf(preset("quaking_aspen"));
    const WindPose pose = poseOf(table, {.strength = 0, .gusts = 1}, 17);
    for (std::size_t n = 0; n < table.nodeCount(); ++n) {
        ASSERT_EQ(pose.rows[2 * n + 1], glm::vec4(0, 0, 0, 1)); // no turn at all
        ASSERT_LT(glm::distance(glm::vec3(pose.rows[2 * n]), table.still()[n]), 1e-5f);
    }
}

TEST(Wind, NoStemTurnsFurtherThanToTheWindOrSixtyDegrees) {
    const CWindTable table = tableOf(preset("weeping_willow"), 2);
    const Wind wind{.strength = kMaxWindStrength, .gusts = 1};
    for (const WindStem& stem : table.stems()) ASSERT_LE(glm::length(table.pushOn(stem, wind, 8).turn), 1.0472);
    WindStem along = table.stems().front(); // a stem that lies in the wind only trembles
    along.axis = wind.direction;
    EXPECT_LE(glm::length(table.pushOn(along, {.strength = 1, .gusts = 0}, 8).turn), 2 * 0.05 * std::sqrt(2.0) + 1e-9);
}

TEST(Wind, FlexibilityAndStrengthBend) {
    const auto tree = preset("quaking_aspen");
    const auto tipOf = [&](double flexibility, double strength) {
        const CWindTable table = tableOf(tree, flexibility);
        const WindPose pose = poseOf(table, {.strength = strength, .gusts = 0}, 1);
        const CGeneration& trunk = tree->generation(0);
        return nodeAt(pose, table.nodeOf(0, trunk.paths[0].segmentCount - 1) + 1).x;
    };
    EXPECT_LT(tipOf(1, 0), tipOf(1, 0.3));
    EXPECT_LT(tipOf(1, 0.3), tipOf(1, 0.8));
    EXPECT_LT(tipOf(0.5, 0.5), tipOf(1.5, 0.5));
    EXPECT_EQ(tipOf(0, 1), tipOf(1, 0));
}

TEST(Wind, YoungStemsAreAsStiffAsTheyWillBe) {
    const CParams params = CTreeFile::read(inSource("presets/quaking_aspen.tree")).params();
    const auto grown = growTree(CWeberPennBuilder(), params, CProgress()),
               young = growTree(CWeberPennBuilder(), params, CProgress(), 0.6);
    const CWindTable now(young, *grown, 1, 1), then(grown, *grown, 1, 1);
    EXPECT_LT(young->generation(0).stems[0].length, grown->generation(0).stems[0].length);
    EXPECT_EQ(now.stems()[0].length, then.stems()[0].length);
    EXPECT_EQ(now.stems()[0].diameter, then.stems()[0].diameter);
}

TEST(Wind, NoiseIsSmoothAndBoundedAndRepeats) {
    double before = windNoise(-10, 5, 0);
    for (double at = -10; at < 10; at += 0.01) {
        const double now = windNoise(at, 5, 0);
        ASSERT_LE(std::abs(now), 1);
        ASSERT_LT(std::abs(now - before), 0.04);
        before = now;
        ASSERT_NEAR(windNoise(at, 5, 4), windNoise(at + 4, 5, 4), 1e-9) << at;
    }
    EXPECT_NE(windNoise(0.5, 5, 0), windNoise(0.5, 6, 0));
}

} // namespace
} // namespace stromar::test
