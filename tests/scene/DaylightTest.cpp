#include "stromar/scene/Daylight.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

TEST(Daylight, TheSunRisesInTheEastAndStandsInTheSouthAtNoon) {
    EXPECT_GT(daylightAt(7, 0).sun.x(), 0.8);
    EXPECT_LT(daylightAt(17, 0).sun.x(), -0.8);
    const Daylight noon = daylightAt(12, 0);
    EXPECT_NEAR(noon.sun.x(), 0, 1e-6);
    EXPECT_LT(noon.sun.y(), 0) << "before the front";
    for (double hour = 0; hour <= 24; hour += 0.5) {
        EXPECT_NEAR(daylightAt(hour, 33).sun.length(), 1, 1e-5);
        EXPECT_LE(daylightAt(hour, 0).sun.z(), noon.sun.z());
        EXPECT_EQ(daylightAt(hour, 0).sun.z(), daylightAt(hour, 120).sun.z());
    }
}

TEST(Daylight, ItsTurnGoesAboutTheTree) {
    const osg::Vec3 before = daylightAt(12, 0).sun, after = daylightAt(12, 90).sun;
    EXPECT_NEAR(after.x(), -before.y(), 1e-6);
    EXPECT_NEAR(after.y(), before.x(), 1e-6);
}

TEST(Daylight, LowSunsAreRedAndWeakAndThereIsNoneAtNight) {
    const osg::Vec3 noon = daylightAt(12, 0).sunlight, evening = daylightAt(18.8, 0).sunlight;
    EXPECT_GT(evening.x() / evening.z(), 2 * noon.x() / noon.z());
    EXPECT_LT(evening.x(), noon.x());
    EXPECT_EQ(daylightAt(0, 0).sunlight.length(), 0);
    EXPECT_GT(daylightAt(0, 0).zenith.length(), 0) << "but it is not pitch-dark";
}

} // namespace
} // namespace stromar
