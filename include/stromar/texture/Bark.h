#pragma once
#include "stromar/texture/Recipe.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Progress.h"

namespace stromar {

/// What a bark looks like. A plain value; what each means stands in the table.
struct BarkParams {
    int kind = 0, seed = 1, ridges = 8, rings = 0, spots = 0;
    double stretch = 4, crack = 0.35, depth = 1, grain = 0.5, warp = 0.5;
    Colour light{150, 138, 122}, dark{62, 52, 44};

    bool operator==(const BarkParams&) const = default;
};

/// How far the highest place lies above the deepest, in widths of the picture: at a depth of 1, and of a bark.
constexpr double kBarkRelief = 0.02;
inline double reliefOf(const BarkParams& bark) { return bark.depth * kBarkRelief; }

/// furrowed, plated, smooth …
const RecipeBook<BarkParams>& barkBook();

/// Draws a square picture that can be laid side by side in both directions. The same values give the same bytes for any
/// number of threads; another size shows the same bark. Cost: about two microseconds per pixel and thread.
TextureMaps makeBark(const BarkParams& bark, int size, const CProgress& progress);

} // namespace stromar
