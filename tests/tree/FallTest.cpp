// A felled tree: the pendulum of the specification, where it comes to rest, what stands and what falls.
#include "stromar/tree/Fall.h"
#include "Support.h"
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace stromar::test {
namespace {

CFall felled(const TreePtr& tree, const Felling& felling) {
    return {std::make_shared<const CWindTable>(tree, *tree, 1, 1), felling};
}

/// A straight pole of even thickness.
TreePtr pole() {
    return growNeutral(with(CParams(), {{"Levels", 1},
                                        {"Scale", 10},
                                        {"0Taper", 0},
                                        {"Flare", 0},
                                        {"Ratio", 0.01},
                                        {"0CurveRes", 20},
                                        {"0SegSplits", 0}}));
}

/// Of a uniform rod of length L from 1° to an angle: ∫ dθ / √(3g/L·(cos 1° − cos θ)).
double rodSeconds(double length, double to) {
    const double from = std::numbers::pi / 180;
    double seconds = 0;
    const int steps = 2000000;
    for (int i = 0; i < steps; ++i) {
        const double angle = from + (to - from) * (i + 0.5) / steps;
        seconds += (to - from) / steps / std::sqrt(3 * 9.81 / length * (std::cos(from) - std::cos(angle)));
    }
    return seconds;
}

TEST(Fall, APoleFallsAsAUniformRod) {
    const TreePtr tree = pole();
    const CFall fall = felled(tree, {});
    double contact = 0;
    while (fall.angleAt(contact) < 1.5 && contact < 60) contact += 1.0 / 240;
    EXPECT_NEAR(contact, rodSeconds(tree->generation(0).stems[0].length, 1.5), 0.05);
    const CSegment& lowest = tree->generation(0).segments[tree->generation(0).segments.size() / 2 - 1]; // of the upper half
    EXPECT_NEAR(fall.angleAt(fall.seconds()), std::acos(lowest.radiusEnd / lowest.end()), 1e-3) << "it lies on its bark";
    EXPECT_EQ(fall.angleAt(0), 0);
}

TEST(Fall, BouncesOnceByFifteenPercentAndThenLies) {
    const CFall fall = felled(pole(), {});
    double before = 0, after = 0;
    int turns = 0;
    for (double t = 1.0 / 240; t < fall.seconds(); t += 1.0 / 240) {
        const double now = fall.speedAt(t);
        if (now < 0 && before > 0) {
            ++turns;
            after = now;
            EXPECT_NEAR(-after / before, 0.15, 0.02);
        }
        before = now;
    }
    EXPECT_EQ(turns, 1);
    EXPECT_EQ(fall.speedAt(fall.seconds()), 0);
}

class Felled : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Trees, Felled, ::testing::Values("quaking_aspen", "english_oak", "coconut_palm", "bamboo"));

TEST_P(Felled, StandsAtFirstAndLiesInItsDirection) {
    const TreePtr tree = grow(preset(GetParam()));
    const auto table = std::make_shared<const CWindTable>(tree, *tree, 1, 1);
    for (const double degrees : {0.0, 120.0}) {
        const CFall fall(table, {degrees, 0});
        WindPose first, last;
        fall.pose(0, first, CProgress(2));
        fall.pose(fall.seconds(), last, CProgress(2));
        const glm::dvec3 direction(std::cos(degrees * std::numbers::pi / 180),
                                   std::sin(degrees * std::numbers::pi / 180), 0);
        double along = 0, height = 0;
        for (std::size_t n = 0; n < table->nodeCount(); ++n) {
            ASSERT_EQ(glm::vec3(first.rows[2 * n]), table->still()[n]);
            along += glm::dot(glm::dvec3(last.rows[2 * n]), direction);
            height += last.rows[2 * n].z;
        }
        EXPECT_GT(along / double(table->nodeCount()), 0.4 * tree->height()) << degrees;
        EXPECT_LT(std::abs(height / double(table->nodeCount())), 0.35 * tree->height())
            << "arching stems keep their tips up";
        EXPECT_GT(fall.seconds(), 1);
        EXPECT_LT(fall.seconds(), 30);
    }
}

TEST_P(Felled, PiecesKeepTheirLengthsWhileItFallsAndBend) {
    const TreePtr tree = grow(preset(GetParam()));
    const auto table = std::make_shared<const CWindTable>(tree, *tree, 1, 1);
    const CFall fall(table, {40, 0.6});
    WindPose pose;
    for (const double part : {0.3, 0.8, 1.0}) {
        fall.pose(part * fall.seconds(), pose, CProgress(2));
        for (std::size_t g = 0; g < tree->generationCount(); ++g)
            for (std::uint32_t s = 0; s < tree->generation(g).segments.size(); ++s) {
                const std::uint32_t node = table->nodeOf(g, s);
                if (fall.falls(node) != fall.falls(node + 1)) continue; // the cut
                ASSERT_NEAR(glm::distance(glm::dvec3(pose.rows[2 * node]), glm::dvec3(pose.rows[2 * node + 2])),
                            tree->generation(g).segments[s].length, 2e-5);
            }
    }
}

TEST(Fall, AStumpStandsAndWhatItBears) {
    const TreePtr tree = grow(preset("quaking_aspen"));
    const auto table = std::make_shared<const CWindTable>(tree, *tree, 1, 1);
    const CFall fall(table, {0, 6});
    WindPose pose;
    fall.pose(fall.seconds(), pose, CProgress(2));
    std::size_t standing = 0, lying = 0;
    for (std::size_t n = 0; n < table->nodeCount(); ++n) {
        if (fall.falls(n)) {
            ++lying;
            continue;
        }
        ++standing;
        ASSERT_EQ(glm::vec3(pose.rows[2 * n]), table->still()[n]);
    }
    EXPECT_GT(standing, 10u);
    EXPECT_GT(lying, 100u);
    EXPECT_NEAR(fall.hinge().z, 6, 1e-6);
    EXPECT_GT(fall.angleAt(fall.seconds()), std::numbers::pi / 2) << "the tip goes below the hinge";
}

TEST(Fall, ACutAboveTheTreeFellsNothing) {
    const CFall fall = felled(grow(preset("apple")), {0, 100});
    EXPECT_FALSE(fall.anythingFalls());
    EXPECT_EQ(fall.seconds(), 0);
}

} // namespace
} // namespace stromar::test
