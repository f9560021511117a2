#pragma once
#include <compare>
#include <numbers>

namespace stromar {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

/// An angle as files and the window have it. Everything else counts in radians, as plain numbers.
struct Degrees {
    double value = 0;

    constexpr Degrees() = default;
    constexpr Degrees(double degrees) : value(degrees) {}
    constexpr double radians() const { return value * kRadiansPerDegree; }
    constexpr auto operator<=>(const Degrees&) const = default;
};

} // namespace stromar
