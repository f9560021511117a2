#pragma once
#include "stromar/mesh/OrganMesh.h"
#include <filesystem>

namespace stromar {

/// All triangles of a model file as one mesh in the file's axes; v of its texture coordinates counts upwards, as bottom-left
/// pictures have it. Of .obj and .glb; other files that it refers to are not opened. At most kMaxLeafPoints: what would take
/// much more memory is refused before it is read. Throws CError, which names the file.
LeafBlade readLeafMesh(const std::filesystem::path& file);

constexpr std::size_t kMaxLeafPoints = 20'000;

} // namespace stromar
