#pragma once
#include <cstdint>

namespace stromar {

/// Of a triangle's three, counter-clockwise.
constexpr std::uint32_t after(std::uint32_t corner) { return (corner + 1) % 3; }
constexpr std::uint32_t before(std::uint32_t corner) { return (corner + 2) % 3; }

} // namespace stromar
