#pragma once
#include "join/NearWood.h"

namespace stromar {

enum class UnionBy {
    Lines,    ///< along the tube's walls: a smooth foot
    Surfaces, ///< the walls as they cross: of any shape
};
enum class UnionEffort {
    Smooth, ///< not where the seam would be ragged
    Usual,
    All, ///< of surfaces: also with a part of the walls
};
struct UnionMethod {
    UnionBy by;
    std::size_t mostWork; ///< see uniteSurfaces()
    UnionEffort effort;
};

/// Joins a tube with the wood around it that it comes out of; false, and the patch as it was, where that cannot be. Time linear in the patch's
/// triangles, for each line of the tube.
bool unite(const CTree& tree, std::span<const StemMesh> stems, const BranchTube& tube, const UnionMethod& method, CTubeLines& lines, CWoodPatch& patch);

} // namespace stromar
