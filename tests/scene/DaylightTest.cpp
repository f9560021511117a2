#include "stromar/scene/Daylight.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

TEST(Daylight, TheSunRisesInTheEastAndStandsInTheSouthAtNoon) {
    EXPECT_GT(daylightAt({.hour = 7, .sunTurn = 0}).sun.x(), 0.8);
    EXPECT_LT(daylightAt({.hour = 17, .sunTurn = 0}).sun.x(), -0.8);
    const Daylight noon = daylightAt({.hour = 12, .sunTurn = 0});
    EXPECT_NEAR(noon.sun.x(), 0, 1e-6);
    EXPECT_LT(noon.sun.y(), 0) << "before the front";
    for (double hour = 0; hour <= 24; hour += 0.5) {
        EXPECT_NEAR(daylightAt({.hour = hour, .sunTurn = 33}).sun.length(), 1, 1e-5);
        EXPECT_LE(daylightAt({.hour = hour, .sunTurn = 0}).sun.z(), noon.sun.z());
        EXPECT_EQ(daylightAt({.hour = hour, .sunTurn = 0}).sun.z(), daylightAt({.hour = hour, .sunTurn = 120}).sun.z());
    }
}

TEST(Daylight, ItsTurnGoesAboutTheTree) {
    const osg::Vec3 before = daylightAt({.hour = 12, .sunTurn = 0}).sun, after = daylightAt({.hour = 12, .sunTurn = 90}).sun;
    EXPECT_NEAR(after.x(), -before.y(), 1e-6);
    EXPECT_NEAR(after.y(), before.x(), 1e-6);
}

TEST(Daylight, LowSunsAreRedAndWeakAndThereIsNoneAtNight) {
    const osg::Vec3 noon = daylightAt({.hour = 12, .sunTurn = 0}).sunlight, evening = daylightAt({.hour = 18.8, .sunTurn = 0}).sunlight;
    EXPECT_GT(evening.x() / evening.z(), 2 * noon.x() / noon.z());
    EXPECT_LT(evening.x(), noon.x());
    EXPECT_EQ(daylightAt({.hour = 0, .sunTurn = 0}).sunlight.length(), 0);
    EXPECT_GT(daylightAt({.hour = 0, .sunTurn = 0}).zenith.length(), 0) << "but it is not pitch-dark";
}

TEST(Daylight, StrengthAndTemperatureOfSunAndSkyAreTheirOwn) {
    const Daylight usual = daylightAt({}), warm = daylightAt({.sunTemperature = 3000}),
                   blue = daylightAt({.skyTemperature = 12000}), strong = daylightAt({.sunStrength = 2});
    const auto redness = [](const osg::Vec3& c) { return c.x() / c.z(); };
    EXPECT_GT(redness(warm.sunlight), 1.5 * redness(usual.sunlight));
    EXPECT_EQ(warm.zenith, usual.zenith);
    EXPECT_LT(redness(blue.haze), redness(usual.haze));
    EXPECT_EQ(blue.sunlight, usual.sunlight);
    EXPECT_NEAR(strong.sunlight.x(), 2 * usual.sunlight.x(), 1e-5);
    const osg::Vec3 luminance(0.2126f, 0.7152f, 0.0722f);
    EXPECT_NEAR(warm.sunlight * luminance, usual.sunlight * luminance, 0.35 * (usual.sunlight * luminance));
    EXPECT_EQ(daylightAt({.sunStrength = 0}).sunlight.length(), 0);
}

} // namespace
} // namespace stromar
