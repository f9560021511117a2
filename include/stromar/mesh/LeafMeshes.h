#pragma once
#include "stromar/mesh/OrganMesh.h"
#include <span>
#include <string_view>

namespace stromar {

/// A form of leaf that comes with the program, beside cards and outlines. It shows the whole leaf texture.
struct BuiltInLeaf {
    std::string_view name;  ///< in files, after "mesh:"
    std::string_view label; ///< marked for translation
    LeafBlade (*make)(bool far); ///< as the last level of detail has it, or as all others
};
std::span<const BuiltInLeaf> builtInLeaves();
/// By a name as "mesh:curved"; null for a file's. Throws CError where there is none of such a name.
const BuiltInLeaf* builtInLeaf(std::string_view name);

/// A mesh that stands somehow, as a blade of length 1: from its foot, which is the origin, it grows where its box reaches
/// farthest, and what it is thinnest across, it faces. It keeps its proportions: of a blade that is drawn `aspect` times as
/// wide as long. Throws CError when it has no length or width. Points as in LeafBlade, in any axes and unit.
LeafBlade bladeOf(LeafBlade mesh, double aspect);

} // namespace stromar
