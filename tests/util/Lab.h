#pragma once
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace stromar::test {

/// Light of an sRGB byte, 0..1.
inline double linear(std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// CIE L*a*b* of linear sRGB, D65: distances are ΔE of 1976.
inline glm::dvec3 labOf(const glm::dvec3& rgb) {
    const auto curve = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = curve((0.4124 * rgb.x + 0.3576 * rgb.y + 0.1805 * rgb.z) / 0.95047), y = curve(0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z),
                 z = curve((0.0193 * rgb.x + 0.1192 * rgb.y + 0.9505 * rgb.z) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

} // namespace stromar::test
