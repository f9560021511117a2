#pragma once
#include <cstdint>
#include <glm/vec2.hpp>

namespace stromar {

/// Of a triangle's three, counter-clockwise.
constexpr std::uint32_t after(std::uint32_t corner) { return corner == 2 ? 0 : corner + 1; }
constexpr std::uint32_t before(std::uint32_t corner) { return corner == 0 ? 2 : corner - 1; }

/// Twice the area: positive when counter-clockwise.
inline double twiceArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

} // namespace stromar
