#pragma once
#include "join/TubeJoiner.h"

namespace stromar {

/// Joins tubes that start inside the wood and stand in no hole of it, `apart`, wherever their walls come out: of a fork, of a branch beside
/// them, of the wood that their parent grows on. There the wood is cut along a loop around each and sewn to its walls. Those that would
/// fold stay as they are. Returns how many are joined of those with a collar, and of those without. Vertices along the loop move
/// like the nearest one of the wood. Time n log n in the triangles of all meshes, if few are apart. Throws CCancelled.
struct United {
    std::size_t collars = 0, others = 0;
};
United uniteWithWood(const CTree& tree, std::span<const StemMesh> stems, std::vector<BranchTube> apart, JoinedStems& joined,
                     const CProgress& progress);

} // namespace stromar
