#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/tree/SizeBound.h"

namespace stromar {

/// At most so much in the meshes of a tree within a bound.
struct MeshBound {
    double vertices = 0; ///< of what is shown
    double bytes = 0;    ///< of meshes and of plans for them, while they are made
};

/// `onCards`: cards stand for the last generation.
MeshBound meshBound(const SizeBound& tree, const MeshParams& params, const Detail& detail, bool onCards);

} // namespace stromar
