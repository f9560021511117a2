// The laws of thickness: Weber & Penn §4.4, taper 0..3, flare and lobes.
#include "weberpenn/Grown.h"
#include <cmath>
#include <gtest/gtest.h>

namespace stromar {
namespace {

constexpr double kTolerance = 1e-12;

struct TaperPoint {
    double taper, length, radius, z, expected;
};

TEST(Taper, PointsByHand) {
    const double root34 = std::sqrt(0.75);
    const TaperPoint points[] = {{0, 10, 1, 0, 1},           {0, 10, 1, 0.5, 1},
                                 {0, 10, 1, 1, 1}, // a cylinder
                                 {0.5, 10, 1, 0, 1},         {0.5, 10, 1, 0.5, 0.75},
                                 {0.5, 10, 1, 1, 0.5}, //
                                 {1, 10, 1, 0, 1},           {1, 10, 1, 0.5, 0.5},
                                 {1, 10, 1, 0.75, 0.25},     {1, 10, 1, 1, 0}, // a cone
                                 {1, 1, 2, 0.5, root34}, // thicker than long: τ = 1, ½ m to the tip
                                 {1.5, 10, 1, 0.5, 0.75},    {1.5, 10, 1, 0.95, std::sqrt(0.275)},
                                 {1.5, 10, 1, 1, 0}, // rounded tip
                                 {2, 10, 1, 0.5, 1},         {2, 10, 1, 0.6, 1},
                                 {2, 10, 1, 0.95, root34},   {2, 10, 1, 1, 0}, // half a sphere
                                 {2.5, 10, 1, 0.5, 1},       {2.5, 10, 1, 0.6, 0.5},
                                 {2.5, 10, 1, 0.95, root34}, {2.5, 10, 1, 1, 0}, // dents
                                 {3, 10, 1, 0.5, 1},         {3, 10, 1, 0.6, 0},
                                 {3, 10, 1, 0.55, root34},   {3, 10, 1, 1, 0}}; // spheres
    for (const auto& [taper, length, radius, z, expected] : points) {
        EXPECT_NEAR(taperProfile(taper).radiusAt(z * length, length, radius), expected, 1e-7) << "taper " << taper << " at " << z;
    }
}

TEST(Taper, NothingIsLeftOfNothing) {
    for (const double taper : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0})
        for (const double z : {0.0, 0.3, 1.0})
            EXPECT_EQ(taperProfile(taper).radiusAt(2 * z, 2, 0), 0) << taper;
}

TEST(Flare, WidensTheGroundOnly) {
    BaseForm base{.flare = 0.6};
    EXPECT_NEAR(base.flareAt(0), 1 + 0.99 * 0.6, kTolerance);
    EXPECT_NEAR(base.flareAt(1.0 / 16), 1 + 0.6 * 9 / 100, kTolerance);
    for (const double z : {0.125, 0.2, 0.5, 1.0}) EXPECT_EQ(base.flareAt(z), 1) << z;
    EXPECT_EQ(BaseForm().flareAt(0), 1);
    base.flare = -1;
    EXPECT_NEAR(base.flareAt(0), 0.01, kTolerance);
    EXPECT_NEAR(BaseForm::falloff(0), 100, kTolerance);
    EXPECT_NEAR(BaseForm::falloff(1.0 / 16), 10, kTolerance);
    EXPECT_EQ(BaseForm::falloff(0.5), 1);
}

TEST(Lobes, FadeAboveTheGroundByLobeFade) {
    const BaseForm faded{.lobes = 5, .lobeDepth = 0.2, .lobeFade = 1}, kept{.lobes = 5, .lobeDepth = 0.2, .lobeFade = 0};
    EXPECT_NEAR(faded.lobeDepthAt(0), 0.2, kTolerance);
    EXPECT_NEAR(faded.lobeDepthAt(0.5), 0, kTolerance);
    EXPECT_NEAR(kept.lobeDepthAt(0.5), 0.2, kTolerance);
    EXPECT_EQ((BaseForm{.lobes = 5}).lobeCount(), 0) << "lobes without a depth are none";
}

} // namespace
} // namespace stromar
