#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <memory>

namespace stromar {

constexpr std::size_t kMaxVoxelStems = 5000; ///< of a tree that is made into one solid
constexpr double kMaxVoxels = 2e9;           ///< of the box around it

/// All wood of a tree as one closed surface, for printing: what is inside any stem, in cubes of `size` metres, by marching
/// tetrahedra (Doi & Koide 1991). Wood thinner than a cube is drawn as thick as keeps it whole; trunks end flat. No organs.
/// Time: the voxels of the box; memory: two layers of it and the mesh. Throws CError when there are more stems or voxels
/// than above, saying what would do, and CCancelled.
std::shared_ptr<const CMesh> voxelMesh(const CTree& tree, const MeshParams& params, double size, const CProgress& progress);

} // namespace stromar
