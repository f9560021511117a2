#pragma once
#include "stromar/mesh/MeshBuilder.h"

namespace stromar {

/// Where a vertex of joined wood comes from: a vertex of a generation's own mesh.
struct VertexSource {
    std::uint32_t generation, vertex;
};

/// The wood of a tree in which branches stand in holes of their parents' walls.
struct JoinedStems {
    Meshes meshes;                                  ///< by generation
    std::vector<std::vector<VertexSource>> sources; ///< of their vertices; what two generations share comes from one of them
    std::size_t joined = 0; ///< branches that are one surface with the wood they grow on: by a collar, or at a fork
    std::size_t apart = 0;  ///< others with a collar: closed by lids of their own inside the wood
    std::size_t withoutCollar = 0; ///< and those without, which start inside it, where none fits: clones too
};

/// Cuts the walls of stems open along the collars of their branches, and leaves out what lies inside, lids at forks too: with equal positions
/// taken as one vertex, all meshes together are one closed surface. An edge of a hole has the positions of the collar's
/// lowest ring; its normals and bark are the parent's. The wall around it keeps its vertices; copies are added where the seam of the
/// bark or a crease wants other values at the same place.
/// A branch whose collar crosses another one or the border between limbs of a fork, or that has none, is joined along the line where it comes out
/// of the wood; where it would fold there, or comes out as several limbs, it stays apart. New vertices on that line come from the nearest one of the wood.
/// `stems` are all generations with their plans' collars. Time n log n in the triangles of stems that bear branches;
/// same result for any number of threads. Throws CCancelled.
JoinedStems joinStems(const CTree& tree, std::span<const StemMesh> stems, const CProgress& progress);

} // namespace stromar
