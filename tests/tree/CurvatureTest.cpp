#include "tree/Support.h"
#include <gtest/gtest.h>
#include <set>

namespace stromar {
namespace {

using namespace test;

/// Declinations of the trunk's segments, degrees; negative beyond the vertical (towards +Y).
std::vector<double> leans(const CParams& params, bool varied = false) {
    std::vector<double> all;
    const auto tree = grow(with(params, {{"Levels", 1}}), varied);
    for (const CSegment& segment : tree->generation(0).segments) {
        const glm::dvec3 z = segment.frame[2];
        all.push_back(degrees(std::atan2(-z.y, z.z)));
        EXPECT_NEAR(z.x, 0, varied ? 1 : 1e-12);
    }
    return all;
}

void expectLeans(Values values, const std::vector<double>& expected) {
    const std::vector<double> got = leans(with({}, values));
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t k = 0; k < got.size(); ++k) EXPECT_NEAR(got[k], expected[k], 1e-9) << "segment " << k;
}

TEST(Curvature, TheFirstSegmentIsNotBent) {
    expectLeans({{"0CurveRes", 6}, {"0Curve", 60}}, {0, 10, 20, 30, 40, 50}); // (N−1)/N of the whole
    expectLeans({{"0CurveRes", 4}, {"0Curve", -40}}, {0, -10, -20, -30});
    expectLeans({{"0CurveRes", 1}, {"0Curve", 90}}, {0});
}

TEST(Curvature, CurveBackTakesTheUpperHalf) {
    expectLeans({{"0CurveRes", 4}, {"0Curve", 40}, {"0CurveBack", -40}}, {0, 20, 0, -20});
    expectLeans({{"0CurveRes", 5}, {"0Curve", 40}, {"0CurveBack", -40}}, {0, 16, 32, 16, 0});
    expectLeans({{"0CurveRes", 4}, {"0Curve", 0}, {"0CurveBack", 30}}, {0, 0, 15, 30});
}

TEST(Curvature, SegmentsShareTheLength) {
    const auto tree = growNeutral(with({}, {{"Levels", 1}, {"Scale", 12}, {"0Length", 0.5}, {"0CurveRes", 4}}));
    const CGeneration& trunk = tree->generation(0);
    ASSERT_EQ(trunk.segments.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_DOUBLE_EQ(trunk.segments[k].length, 1.5);
        EXPECT_NEAR(trunk.segments[k].position.z, 1.5 * double(k), 1e-12);
    }
    EXPECT_TRUE(sameBits(trunk.segments[0].frame, Frame(1.0))) << "the trunk starts upright, without a spin";
    EXPECT_TRUE(trunk.segments[0].position == glm::dvec3(0));
}

TEST(Curvature, VariationIsShared) {
    const int n = 10;
    double most = 0, sum = 0;
    std::set<int> quadrants;
    for (int seed = 0; seed < 200; ++seed) {
        const auto tree = grow(with({}, {{"Levels", 1}, {"0CurveRes", n}, {"0CurveV", 90}, {"Seed", seed}}));
        const auto& segments = tree->generation(0).segments;
        for (std::size_t k = 1; k < segments.size(); ++k) {
            const double bend = angleBetween(segments[k - 1].frame[2], segments[k].frame[2]);
            ASSERT_LE(bend, 9 + 1e-9);
            most = std::max(most, bend);
            sum += bend;
        }
        const glm::dvec3 tip = segments.back().axisPoint(1);
        quadrants.insert((tip.x > 0) + 2 * (tip.y > 0));
    }
    EXPECT_GT(most, 8.9);
    EXPECT_NEAR(sum / (200 * (n - 1)), 4.5, 0.35); // |uniform in ±9| has the mean 4.5
    EXPECT_EQ(quadrants.size(), 4u) << "trunks bend in one plane only";
}

CParams helixTree() {
    return with(
        {},
        {{"Levels", 2}, {"0CurveRes", 4}, {"0CurveV", -30}, {"1Branches", 20}, {"1Length", 0.2}, {"BaseSize", 0.1}});
}

TEST(Helix, TheTangentHasExactlyTheAngle) {
    const auto tree = grow(helixTree());
    for (const CSegment& segment : tree->generation(0).segments) {
        EXPECT_NEAR(segment.helixRadius, segment.length * std::tan(glm::radians(30.0)) / (2 * std::numbers::pi),
                    1e-12);
        for (int i = 0; i <= 20; ++i) {
            const double t = i / 20.0, h = 1e-6;
            const glm::dvec3 numeric = glm::normalize(segment.centre(t + h) - segment.centre(t - h));
            EXPECT_NEAR(angleBetween(segment.tangent(t), segment.frame[2]), 30, 1e-9);
            EXPECT_NEAR(angleBetween(segment.tangent(t), numeric), 0, 1e-3);
        }
    }
}

TEST(Helix, TheCentreLineFollowsTheFormula) {
    const auto tree = growNeutral(helixTree());
    const CSegment& s = tree->generation(0).segments[1];
    const double r = s.helixRadius;
    const std::pair<double, glm::dvec3> points[] = {
        {0, {0, 0, 0}}, {0.25, {-r, r, 0}}, {0.5, {-2 * r, 0, 0}}, {0.75, {-r, -r, 0}}, {1, {0, 0, 0}}};
    for (const auto& [t, aside] : points)
        EXPECT_LT(glm::length(s.centre(t) - (s.position + s.frame * aside + t * s.length * s.frame[2])), 1e-12) << t;
}

TEST(Helix, ChildrenStartOnTheDrawnLine) {
    const auto tree = grow(helixTree());
    const CGeneration &trunk = tree->generation(0), &branches = tree->generation(1);
    ASSERT_GT(branches.stems.size(), 10u);
    double aside = 0;
    for (const CStem& stem : branches.stems) {
        const CSegment& parent = segmentOf(trunk, trunk.stems[0], stem.path, stem.position);
        const double w = stem.offset / parent.length - stem.position;
        const glm::dvec3 base = firstSegment(branches, stem).position;
        EXPECT_LT(glm::length(base - parent.centre(w)), 1e-9);
        aside = std::max(aside, glm::length(base - parent.axisPoint(w)));
    }
    EXPECT_GT(aside, trunk.segments[0].helixRadius) << "no child stands off the axis";
}

TEST(Helix, OnlyForNegativeValues) {
    const auto tree = grow(with(helixTree(), {{"0CurveV", 30}}));
    for (const CSegment& segment : tree->generation(0).segments) {
        EXPECT_EQ(segment.helixRadius, 0);
        EXPECT_TRUE(segment.centre(0.3) == segment.axisPoint(0.3));
        EXPECT_TRUE(segment.tangent(0.3) == segment.frame[2]);
    }
}

TEST(Helix, TheAxisKeepsCurving) { expectLeans({{"0CurveRes", 4}, {"0Curve", 40}, {"0CurveV", -30}}, {0, 10, 20, 30}); }

/// Level-2 branches that start level, with Y to the sky (down 90) or to the ground (down −90).
CParams levelTwigs(double down, double attraction) {
    return with({}, {{"Levels", 3},
                     {"1Branches", 4},
                     {"1DownAngle", 0},
                     {"2Branches", 4},
                     {"2DownAngle", down},
                     {"2CurveRes", 2},
                     {"AttractionUp", attraction}});
}

TEST(AttractionUp, RaisesAndLowersByTheFormula) {
    const std::tuple<double, double, double> cases[] = {{90, 0, 90},  {90, 1, 45},    {90, -1, 135},
                                                        {-90, 1, 45}, {-90, -1, 135}, {90, 0.5, 67.5}};
    for (const auto& [down, attraction, expected] : cases) {
        const auto tree = growNeutral(levelTwigs(down, attraction)); // up = attraction · 90 · (±1) / 2 segments
        const CGeneration& twigs = tree->generation(2);
        ASSERT_GT(twigs.stems.size(), 4u);
        for (const CStem& stem : twigs.stems) {
            EXPECT_NEAR(declinationOf(segmentOf(twigs, stem, 0, 0)), 90, 1e-9);
            EXPECT_NEAR(declinationOf(segmentOf(twigs, stem, 0, 1)), expected, 1e-9) << down << ", " << attraction;
        }
    }
}

/// d' = d − A·d·|sin d|/N, whatever way a branch has rolled; never beyond the vertical.
TEST(AttractionUp, AboutTheHorizontalAllBranchesFollow) {
    for (const double attraction : {0.7, -0.7, 9.0, -9.0})
        for (const double roll : {0.0, 40.0, 90.0}) {
            const auto tree = growNeutral(with(levelTwigs(70, attraction), {{"2Rotate", roll},
                                                                           {"1DownAngle", 50},
                                                                           {"2CurveRes", 5},
                                                                           {"AttractionAxis", 1}}));
            const CGeneration& twigs = tree->generation(2);
            ASSERT_GT(twigs.stems.size(), 4u);
            for (const CStem& stem : twigs.stems)
                for (std::uint32_t k = 0; k + 1 < 5; ++k) {
                    const double before = declinationOf(segmentOf(twigs, stem, 0, k)) * kRadiansPerDegree;
                    const double expected = before - attraction * before * std::sin(before) / 5;
                    EXPECT_NEAR(declinationOf(segmentOf(twigs, stem, 0, k + 1)) * kRadiansPerDegree,
                                std::clamp(expected, 0.0, std::numbers::pi), 1e-6)
                        << attraction << ", " << roll;
                }
        }
}

TEST(AttractionUp, MovesNeitherTrunkNorFirstBranches) {
    const auto plain = grow(with(richTree(), {{"AttractionUp", 0}, {"PruneRatio", 0}}));
    for (const double attraction : {-5.0, 3.0}) {
        const auto pulled = grow(with(richTree(), {{"AttractionUp", attraction}, {"PruneRatio", 0}}));
        for (const std::size_t g : {0u, 1u}) EXPECT_TRUE(same(plain->generation(g), pulled->generation(g)));
        EXPECT_FALSE(same(plain->generation(2), pulled->generation(2)));
    }
}

TEST(AttractionUp, TipsOfAllTwigsFollowTheSign) {
    const CParams params = with(preset("quaking_aspen"), {{"2CurveV", 0}, {"2Curve", 0}});
    const auto tips = [&](double attraction) {
        const auto tree = grow(with(params, {{"AttractionUp", attraction}}));
        std::vector<double> heights;
        for (const CStem& stem : tree->generation(2).stems)
            heights.push_back(segmentOf(tree->generation(2), stem, 0, curveRes(tree->generation(2)) - 1).axisPoint(1).z);
        return heights;
    };
    const auto low = tips(-1), plain = tips(0), high = tips(1);
    ASSERT_EQ(low.size(), plain.size());
    ASSERT_EQ(high.size(), plain.size());
    double raised = 0, lowered = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_GE(high[i], plain[i] - 1e-9) << i;
        ASSERT_LE(low[i], plain[i] + 1e-9) << i;
        raised += high[i] - plain[i];
        lowered += plain[i] - low[i];
    }
    EXPECT_GT(raised, 0.01 * double(plain.size()));
    EXPECT_GT(lowered, 0.01 * double(plain.size()));
}

} // namespace
} // namespace stromar
