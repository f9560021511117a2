#pragma once
#include <cmath>
#include <cstdint>

namespace stromar {

/// What a random number is for. The values are part of what a seed means: never reuse or renumber one.
enum Draw : std::uint32_t {
    kDrawTreeScale = 1,
    kDrawTrunkScale = 2,
    kDrawLength = 3,
    kDrawCurveAngle = 4,
    kDrawCurveAxis = 5,
    kDrawSplitAngle = 6,
    kDrawSpreadSize = 7,
    kDrawSpreadSign = 8,
    kDrawBaseSpread = 9,
    kDrawPlace = 10,
    kDrawDownAngle = 11,
    kDrawRotation = 12,
    kDrawCountPhase = 13,
    kDrawLeafId = 14,
    kDrawBlossomId = 15,
    kDrawFruitId = 16,
};

/// Into −½..½, whole numbers apart.
inline double centred(double x) { return x + 0.5 - std::floor(x + 0.5) - 0.5; }
inline double fraction(double x) { return x - std::floor(x); }

} // namespace stromar
