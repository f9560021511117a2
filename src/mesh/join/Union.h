#pragma once
#include "join/NearWood.h"

namespace stromar {

/// How many tubes were joined.
struct United {
    std::size_t collars = 0, others = 0; ///< those with a collar, and those without
};

/// Joins tubes that start inside the wood and stand in no hole of it, `apart`, wherever their walls come out: of a fork, of a branch beside
/// them, of the wood that their parent grows on. There the wood is cut along a loop around each and stitched to its walls. Those that would
/// fold stay as they are; so do the last of thousands, and those with the most triangles around them, once that would take long. Vertices along
/// the loop move like the nearest one of the wood. Time n log n in the triangles of all meshes. Throws CCancelled.
United uniteWithWood(const CTree& tree, std::span<const StemMesh> stems, std::vector<BranchTube> apart, Wood& wood, const CProgress& progress);

} // namespace stromar
