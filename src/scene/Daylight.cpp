#include "stromar/scene/Daylight.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <osg/Vec3d>

namespace stromar {

namespace {
using std::numbers::pi;
constexpr double kLatitude = 48 * pi / 180, kDeclination = 18 * pi / 180; // Central Europe, May or August

osg::Vec3 mixed(const osg::Vec3& a, const osg::Vec3& b, double t) {
    return a + (b - a) * static_cast<float>(std::clamp(t, 0.0, 1.0));
}

/// Unit, in a world with x to the east and −y to the south.
osg::Vec3 sunAt(double hour) {
    const double angle = (hour - 12) * pi / 12; // positive after noon
    const double up =
        std::sin(kLatitude) * std::sin(kDeclination) + std::cos(kLatitude) * std::cos(kDeclination) * std::cos(angle);
    const double west = std::cos(kDeclination) * std::sin(angle);
    const double south =
        std::sin(kLatitude) * std::cos(kDeclination) * std::cos(angle) - std::cos(kLatitude) * std::sin(kDeclination);
    return {static_cast<float>(-west), static_cast<float>(-south), static_cast<float>(up)};
}

/// What the air lets through: less blue than red, and less of all the longer the way.
osg::Vec3 throughAir(double up) {
    const double way = 1 / (std::max(up, 0.0) + 0.04);
    return {static_cast<float>(std::exp(-0.035 * way)), static_cast<float>(std::exp(-0.075 * way)),
            static_cast<float>(std::exp(-0.16 * way))};
}

/// A black body's colour beside that of another one (Planck), as bright as `strength` says.
osg::Vec3 tint(double kelvin, double neutral, double strength) {
    constexpr double kWavelengths[] = {610e-9, 550e-9, 465e-9}, kSecond = 1.4387769e-2; // metres; metre kelvins
    constexpr double kLuminance[] = {0.2126, 0.7152, 0.0722};
    osg::Vec3d colour;
    double bright = 0;
    for (int i = 0; i < 3; ++i) {
        colour[i] = std::expm1(kSecond / (kWavelengths[i] * neutral)) / std::expm1(kSecond / (kWavelengths[i] * kelvin));
        bright += kLuminance[i] * colour[i];
    }
    return osg::Vec3(colour * (strength / bright));
}
} // namespace

Daylight daylightAt(const Light& chosen) {
    Daylight light;
    const osg::Vec3 sun = sunAt(chosen.hour);
    const double a = chosen.sunTurn * pi / 180;
    const auto c = static_cast<float>(std::cos(a)), s = static_cast<float>(std::sin(a));
    light.sun = {c * sun.x() - s * sun.y(), s * sun.x() + c * sun.y(), sun.z()};
    const double up = sun.z(), day = std::clamp((up + 0.22) / 0.42, 0.0, 1.0),
                 low = std::clamp(1 - up / 0.35, 0.0, 1.0);
    light.sunlight = throughAir(up) * static_cast<float>(3.1 * std::clamp((up + 0.02) / 0.06, 0.0, 1.0));
    light.zenith = mixed({0.010f, 0.016f, 0.035f}, {0.11f, 0.30f, 0.74f}, day);
    light.haze = mixed(mixed({0.02f, 0.03f, 0.05f}, {0.62f, 0.75f, 0.89f}, day), {0.95f, 0.52f, 0.25f},
                       0.75 * low * std::clamp((up + 0.1) / 0.15, 0.0, 1.0));
    const osg::Vec3 sunTint = tint(chosen.sunTemperature, Light().sunTemperature, chosen.sunStrength);
    const osg::Vec3 skyTint = tint(chosen.skyTemperature, Light().skyTemperature, chosen.skyStrength);
    light.sunlight = osg::componentMultiply(light.sunlight, sunTint);
    light.zenith = osg::componentMultiply(light.zenith, skyTint);
    light.haze = osg::componentMultiply(light.haze, skyTint);
    const osg::Vec3 sky = (light.zenith + light.haze) * 0.5f;
    const osg::Vec3 received = sky + light.sunlight * std::max(0.0f, sun.z());
    const osg::Vec3 soil(0.11f, 0.12f, 0.07f);
    light.ground = {received.x() * soil.x(), received.y() * soil.y(), received.z() * soil.z()};
    return light;
}

} // namespace stromar
