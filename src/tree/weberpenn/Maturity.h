#pragma once
#include <algorithm>
#include <cmath>

namespace stromar {

// How stems of Weber and Penn's trees grow with the age of the tree, 0..1: fast at first, slower towards the end.

/// The part of its length and thickness that a stem has which was born at `birth`.
inline double maturity(double age, double birth) {
    if (!(age > birth)) return 0;
    const double left = (1 - age) / (1 - birth);
    return 1 - left * left * left;
}

/// When the tip of a stem passes a place, 0..1 of its grown length; near its end a little early, for nothing is to grow
/// up in no time at all.
inline double passedAt(double birth, double place) {
    constexpr double kLast = 0.99;
    return 1 - (1 - birth) * std::cbrt(1 - std::min(place, kLast));
}

/// 0..1, smooth at both ends.
inline double smoothstep(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace stromar
