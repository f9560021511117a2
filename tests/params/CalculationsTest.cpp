#include "stromar/params/methods/weberpenn/Calculations.h"
#include "stromar/params/methods/weberpenn/TreeParams.h"
#include <cmath>
#include <gtest/gtest.h>

namespace stromar {
namespace {

constexpr double kTolerance = 1e-12;
const double kHalfRoot = std::sqrt(0.5);

struct ShapePoint {
    int shape;
    double ratio, value;
};

TEST(ShapeRatio, PointsByHand) {
    const ShapePoint points[] = {{0, 0, 0.2},      {0, 0.25, 0.4},
                                 {0, 1, 1}, // 0.2 + 0.8 r
                                 {1, 0, 0.2},      {1, 0.25, 0.2 + 0.8 * kHalfRoot},
                                 {1, 0.5, 1},      {1, 1, 0.2}, // 0.2 + 0.8 sin πr
                                 {2, 0, 0.2},      {2, 0.5, 0.2 + 0.8 * kHalfRoot},
                                 {2, 1. / 3, 0.6}, {2, 1, 1}, // 0.2 + 0.8 sin πr/2
                                 {3, 0, 1},        {3, 0.4, 1},
                                 {3, 1, 1}, //
                                 {4, 0, 0.5},      {4, 0.25, 0.625},
                                 {4, 1, 1}, // 0.5 + 0.5 r
                                 {5, 0, 0},        {5, 0.35, 0.5},
                                 {5, 0.7, 1},      {5, 0.85, 0.5},
                                 {5, 1, 0},        {6, 0, 1},
                                 {6, 0.25, 0.8},   {6, 1, 0.2}, // 1 − 0.8 r
                                 {7, 0, 0.5},      {7, 0.35, 0.75},
                                 {7, 0.7, 1},      {7, 0.85, 0.75},
                                 {7, 1, 0.5}};
    for (const auto& [shape, ratio, value] : points)
        EXPECT_NEAR(shapeRatio(shape, ratio, weberPenn(CParams())), value, kTolerance) << shape << " at " << ratio;
}

TEST(ShapeRatio, ClampsTheRatioExceptForTheEnvelope) {
    const WeberPennParams g = weberPenn(CParams());
    for (int shape = 0; shape < 8; ++shape)
        for (const double beyond : {0.001, 0.5, 100.0}) {
            EXPECT_EQ(shapeRatio(shape, -beyond, g), shapeRatio(shape, 0, g)) << shape;
            EXPECT_EQ(shapeRatio(shape, 1 + beyond, g), shapeRatio(shape, 1, g)) << shape;
        }
    EXPECT_EQ(shapeRatio(8, -0.001, g), 0);
    EXPECT_EQ(shapeRatio(8, 1.001, g), 0);
}

struct EnvelopePoint {
    double peak, low, high, ratio, value;
};

TEST(ShapeRatio, EnvelopeByHand) {
    const EnvelopePoint points[] = {{0.5, 0.5, 0.5, 0, 0},
                                    {0.5, 0.5, 0.5, 0.25, kHalfRoot},
                                    {0.5, 0.5, 0.5, 0.5, 1},
                                    {0.5, 0.5, 0.5, 0.75, kHalfRoot},
                                    {0.5, 0.5, 0.5, 1, 0},
                                    {0.2, 0.5, 2, 0.4, 0.25},      // above the peak: (0.4 / 0.8)²
                                    {0.2, 0.5, 2, 0.9, kHalfRoot}, // below it: (0.1 / 0.2)^½
                                    {0.2, 0.5, 2, 0.8, 1},
                                    {1, 0.5, 2, 0, 1},
                                    {1, 0.5, 2, 0.75, 0.5},
                                    {1, 0.5, 2, 1, 0}, // only the low part is left
                                    {0, 0.5, 2, 0.5, 0.25},
                                    {0, 0.5, 2, 0, 0},
                                    {0, 0.5, 2, 1, 1}, // only the high part
                                    {0.6, 0.001, 0.5, 0.1, 0.5},
                                    {0.6, 0.001, 0.5, 0.7, std::pow(0.5, 0.001)}};
    for (const auto& [peak, low, high, ratio, value] : points) {
        WeberPennParams g = weberPenn(CParams());
        g.pruneWidthPeak = peak;
        g.prunePowerLow = low;
        g.prunePowerHigh = high;
        EXPECT_NEAR(shapeRatio(8, ratio, g), value, 1e-9) << "peak " << peak << ", ratio " << ratio;
    }
}

/// The aspen's crown: bare up to 5.2 m of 13.
WeberPennParams aspen() {
    WeberPennParams g = weberPenn(CParams());
    g.baseSize = 0.4;
    g.shape = 7;
    g.ratioPower = 1.5;
    return g;
}

const StemMeasures kTrunk{.length = 13, .lengthMax = 1, .radius = 0.2};

TEST(Children, LengthsByHand) {
    const CTrunkCalc trunk(aspen(), 13);
    const C0BranchCalc first(aspen(), 13);
    const C1BranchCalc deeper(aspen(), 13);
    EXPECT_NEAR(trunk.length(0.8, {}, 0), 10.4, kTolerance);
    EXPECT_NEAR(trunk.bareLength(), 5.2, kTolerance);
    EXPECT_EQ(first.bareLength(), 0);
    EXPECT_EQ(deeper.bareLength(), 0);
    EXPECT_NEAR(first.length(0.3, kTrunk, 9.1), 13 * 0.3 * (0.5 + 0.5 * 0.5 / 0.7), kTolerance); // r = 3.9 / 7.8
    EXPECT_NEAR(first.length(0.3, kTrunk, 5.2), 13 * 0.3 * 0.5, kTolerance);                     // r = 1
    EXPECT_NEAR(first.length(0.3, kTrunk, 13), 13 * 0.3 * 0.5, kTolerance);                      // r = 0
    EXPECT_NEAR(deeper.length(0.6, {.length = 4}, 1), 0.6 * (4 - 0.6), kTolerance);
    EXPECT_NEAR(deeper.length(0.6, {.length = 4}, 4), 0.6 * 1.6, kTolerance);
}

TEST(Children, CountsByHand) {
    EXPECT_EQ(CTrunkCalc(aspen(), 13).childCount(50, kTrunk), 50);
    const C0BranchCalc first(aspen(), 13);
    EXPECT_NEAR(first.childCount(30, {.length = 3.9, .lengthMax = 0.3, .parentLength = 13}), 30, kTolerance);
    EXPECT_NEAR(first.childCount(30, {.length = 1.95, .lengthMax = 0.3, .parentLength = 13}), 30 * 0.6, kTolerance);
    const C1BranchCalc deeper(aspen(), 13);
    EXPECT_NEAR(deeper.childCount(10, {.length = 1, .offset = 0, .parentLength = 4}), 10, kTolerance);
    EXPECT_NEAR(deeper.childCount(10, {.length = 1, .offset = 2, .parentLength = 4}), 7.5, kTolerance);
    EXPECT_NEAR(deeper.childCount(10, {.length = 1, .offset = 4, .parentLength = 4}), 5, kTolerance);
}

TEST(Children, GradedDownAngles) {
    const CTrunkCalc trunk(aspen(), 13);
    EXPECT_NEAR(trunk.gradedDownAngle(60, -50, kTrunk, 5.2), 110, 1e-9); // the crown's bottom
    EXPECT_NEAR(trunk.gradedDownAngle(60, -50, kTrunk, 9.1), 70, 1e-9);
    EXPECT_NEAR(trunk.gradedDownAngle(60, -50, kTrunk, 13), 30, 1e-9); // its top
    const C0BranchCalc branch(aspen(), 13);
    EXPECT_NEAR(branch.gradedDownAngle(45, -40, {.length = 4}, 0), 85, 1e-9); // not bare: r = 1 at its base
    EXPECT_NEAR(branch.gradedDownAngle(45, -40, {.length = 4}, 1), 69, 1e-9); // r = ¾
}

TEST(Children, RadiusIsInheritedButFitsTheWood) {
    const C0BranchCalc calc(aspen(), 13);
    const StemMeasures parent{.length = 10, .radius = 0.2};
    EXPECT_NEAR(calc.childRadius(parent, 2.5, 1), 0.2 * 0.125, kTolerance); // (¼)^1.5
    EXPECT_NEAR(calc.childRadius(parent, 2.5, 0.02), 0.02, kTolerance);
    EXPECT_NEAR(calc.childRadius(parent, 20, 0.15), 0.15, kTolerance);
}

struct EnvelopeCase {
    double x, y, z;
    bool inside;
};

TEST(Envelope, PointsByHand) {
    WeberPennParams g = weberPenn(CParams());
    g.baseSize = 0.2; // from 2 m to 10 m, widest at 6 m: 5 m
    const EnvelopeCase cases[] = {{4.9, 0, 6, true},    {5.1, 0, 6, false}, {0, -4.9, 6, true},  {3.5, 3.5, 6, true},
                                  {3.6, 3.6, 6, false}, {3.53, 0, 8, true}, {3.54, 0, 8, false}, {0, 3.53, 4, true},
                                  {0, 3.54, 4, false},  {0, 0, 1.9, false}, {0, 0, 10.1, false}, {0, 0, 2.1, true},
                                  {0, 0, 9.9, true},    {0, 0, 10, false}};
    for (const auto& [x, y, z, inside] : cases)
        EXPECT_EQ(insideEnvelope(x, y, z, g, 10), inside) << x << ' ' << y << ' ' << z;
}

TEST(TreeParams, DeepGenerationsUseTheLastLevel) {
    CParams params;
    for (int level = 0; level < kParamLevels; ++level)
        weberPenn(params).level[static_cast<std::size_t>(level)].taper = 0.1 * level;
    for (int generation = 0; generation < 10; ++generation)
        EXPECT_EQ(CTreeParams(params, generation, 10).level().taper, 0.1 * std::min(generation, 3)) << generation;
}

TEST(TreeParams, AnglesAreDegreesUntilTheyAreAskedForRadians) {
    CParams params;
    LevelParams& level = weberPenn(params).level[1];
    level.length = 0.3;
    level.lengthV = 0.1;
    level.taper = 1.1;
    level.curve = 180;
    level.curveBack = -90;
    level.curveV = 45;
    level.segSplits = 0.4;
    level.splitAngle = 30;
    level.splitAngleV = 60;
    level.branchDist = 0.7;
    level.branchDistV = 0.2;
    level.downAngle = 120;
    level.downAngleV = -36;
    level.rotate = 140;
    level.rotateV = 18;
    level.curveRes = 5;
    level.branches = 40;
    const LevelParams seen = CTreeParams(params, 1, 10).level();
    const double pi = std::acos(-1.0);
    const std::pair<Degrees, double> angles[] = {
        {seen.curve, pi},           {seen.curveBack, -pi / 2},  {seen.curveV, pi / 4},
        {seen.splitAngle, pi / 6},  {seen.splitAngleV, pi / 3}, {seen.downAngle, pi * 2 / 3},
        {seen.downAngleV, -pi / 5}, {seen.rotate, pi * 7 / 9},  {seen.rotateV, pi / 10}};
    for (const auto& [got, expected] : angles) EXPECT_NEAR(got.radians(), expected, kTolerance);
    const std::pair<double, double> kept[] = {{seen.length, 0.3},    {seen.lengthV, 0.1},    {seen.taper, 1.1},
                                              {seen.segSplits, 0.4}, {seen.branchDist, 0.7}, {seen.branchDistV, 0.2},
                                              {seen.curveRes, 5},    {seen.branches, 40}};
    for (const auto& [got, expected] : kept) EXPECT_EQ(got, expected);
}

} // namespace
} // namespace stromar
