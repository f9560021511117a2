#pragma once
#include "stromar/mesh/MeshParams.h"
#include "stromar/params/Params.h"

namespace stromar {

/// The mesh that LeafMesh or Leaf2Mesh … names: a built-in one or a file, whose path starts at the tree's folder. A file is read again
/// when it has changed. Null where the tree has none. Any thread. Throws CError, which says what is wrong.
std::shared_ptr<const LeafBlade> leafMeshOf(const CParams& params, std::size_t kind = 0);

/// meshParamsOf() with those meshes. Likewise.
MeshParams meshParamsWithLeaf(const CParams& params);

} // namespace stromar
