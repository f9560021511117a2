#include "stromar/tree/Wind.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

glm::dvec3 windDirection(double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return {std::cos(a), std::sin(a), 0};
}

Rhythm::Rhythm(double hertz, double loop) : frequency(hertz), steps(0) {
    if (loop <= 0) return;
    steps = static_cast<std::uint32_t>(std::max(1.0, std::round(hertz * loop)));
    frequency = steps / loop;
}

double windLattice(std::uint32_t at, std::uint32_t seed) {
    std::uint32_t h = (at * 0x9e3779b1u) ^ seed;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return double(h ^ (h >> 16)) / 0x1p31 - 1;
}

double windNoise(double at, std::uint32_t seed, std::uint32_t steps) {
    const double floor = std::floor(at), f = at - floor;
    auto below = static_cast<std::int64_t>(floor), above = below + 1;
    if (steps > 0) {
        const auto wrapped = [&](std::int64_t place) { return (place % steps + steps) % steps; };
        below = wrapped(below);
        above = wrapped(above);
    }
    const double low = windLattice(static_cast<std::uint32_t>(below), seed),
                 high = windLattice(static_cast<std::uint32_t>(above), seed);
    return low + (high - low) * f * f * f * (f * (6 * f - 15) + 10);
}

} // namespace stromar
