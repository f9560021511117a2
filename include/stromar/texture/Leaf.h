#pragma once
#include "stromar/texture/Recipe.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Progress.h"

namespace stromar {

/// How the pieces of a leaf are put together.
enum class LeafPlan { Simple, Lobed, Pinnate, Palmate, Fan, Needles, NeedleTwig, Scales, Flower, Flowers, Candle };
constexpr auto kLastLeafPlan = LeafPlan::Candle;

/// What a leaf, a needle twig or a blossom looks like. A plain value; what each means stands in the table.
struct LeafParams {
    int kind = 0;
    LeafPlan plan = LeafPlan::Simple; ///< by kind
    int seed = 1, teeth = 0, veins = 8, lobes = 0, leaflets = 0;
    double width = 0.6, stalk = 0.06, peak = 0.45, base = 0.6, tip = 0.9, heart = 0;
    double tooth = 0.04, lobe = 0.3, slant = 0.35, spread = 60;
    double spots = 0.15, gloss = 0.4, season = 7;
    Colour green{70, 104, 40}, vein{150, 170, 96}, autumn{206, 160, 44};

    bool operator==(const LeafParams&) const = default;
};

/// How far the highest place lies above the deepest, in heights of the picture.
constexpr double kLeafRelief = 0.02;

/// Months between which leaves are simply green: younger ones are lighter, older ones turn.
constexpr double kGreenFrom = 5.8, kGreenUntil = 8.7;

/// oval, oak, maple … needles, blossom.
const RecipeBook<LeafParams>& leafBook();

/// Draws a leaf that fills a card: its stalk begins in the middle of the lower edge, its tip lies at the upper one; a
/// card `width` times as wide as long shows it undistorted. Colours go on under the transparent part. The same values
/// give the same bytes for any number of threads. Cost: 0.2 to 1 s for 512 pixels.
TextureMaps makeLeaf(const LeafParams& leaf, int size, const CProgress& progress);

} // namespace stromar
