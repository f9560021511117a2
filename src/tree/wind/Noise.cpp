#include "stromar/tree/Wind.h"
#include <algorithm>
#include <cmath>

namespace stromar {

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
    const auto valueAt = [&](double place) {
        const double wrapped = steps > 0 ? place - steps * std::floor(place / steps) : place;
        return windLattice(static_cast<std::uint32_t>(static_cast<std::int64_t>(wrapped)), seed);
    };
    const double low = valueAt(floor), high = valueAt(floor + 1);
    return low + (high - low) * f * f * f * (f * (6 * f - 15) + 10);
}

} // namespace stromar
