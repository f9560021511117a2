#pragma once
#include <cstdint>

namespace stromar {

/// What a random number of the strand model is for. The values are part of what a seed means: never reuse or renumber one.
enum StrandDraw : std::uint32_t {
    kDrawFirstPlane = 1,
    kDrawSplitAngle = 2,
    kDrawPlaneTurn = 3,
    kDrawStrandOrgan = 4, ///< and the two that follow, by Organ
};

} // namespace stromar
