#include "stromar/params/Season.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr double kYear = 12;
// Months of a deciduous tree of temperate regions.
constexpr double kBudBreak = 3.7, kInLeaf = 5.2, kLeafFall = 9.9, kBare = 11.3;
constexpr double kBudSize = 0.25;
constexpr double kBlossomTime = 0.8;                  // months before and after full blossom
constexpr double kFruitGrowth = 2, kFruitHangs = 0.7; // months

double rise(double from, double to, double x) { return std::clamp((x - from) / (to - from), 0.0, 1.0); }
/// Into −6..6: December is near January.
double monthsFrom(double month, double now) { return std::remainder(now - month, kYear); }
} // namespace

Phenology phenologyOf(const CommonParams& g) {
    Phenology now{1, 1, 1, 1, 1};
    if (g.evergreen == 0) {
        now.leaves = std::min(rise(kBudBreak, kBudBreak + 0.4, g.season), 1 - rise(kLeafFall, kBare, g.season));
        now.leafSize = kBudSize + (1 - kBudSize) * rise(kBudBreak, kInLeaf, g.season);
    }
    const double sinceBlossom = std::abs(monthsFrom(g.blossomMonth, g.season));
    now.blossoms = 1 - rise(0.3 * kBlossomTime, kBlossomTime, sinceBlossom);
    const double sinceRipe = monthsFrom(g.fruitMonth, g.season);
    now.fruitSize = rise(-kFruitGrowth, 0, sinceRipe);
    now.fruits = now.fruitSize > 0 ? 1 - rise(kFruitHangs, 1.7 * kFruitHangs, sinceRipe) : 0;
    return now;
}

} // namespace stromar
