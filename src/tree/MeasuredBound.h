#pragma once
#include "stromar/tree/SizeBound.h"

namespace stromar {

// The bounds of a tree that was grown to know them.

/// Of all stems, or of those that are not in a set.
std::vector<GenerationBound> boundsOf(const CTree& tree, const StemSet& without = {});
/// Of the leaves only the counts are looked at. `leafLength` in metres.
TwigBound twigBoundOf(const CTree& tree, const COrgans& leaves, double leafLength);

} // namespace stromar
