#pragma once
#include "join/NearWood.h"

namespace stromar {

/// Joins a tube with the wood around it that it comes out of; false, and the patch as it was, where that cannot be. Time linear in the patch's
/// triangles, for each line of the tube.
bool unite(const CTree& tree, std::span<const StemMesh> stems, const BranchTube& tube, CTubeLines& lines, CWoodPatch& patch);

} // namespace stromar
