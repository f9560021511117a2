#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/util/Progress.h"
#include <vector>

namespace stromar {

/// Triangles of a mesh that lie in a plane without overlap.
struct Chart {
    std::vector<std::uint32_t> triangles;
    std::vector<glm::dvec2> corners; ///< three for each, metres, from 0 on
    glm::dvec2 size{0};
};

/// Cuts a mesh into them: triangles that share an edge and do not overlap in its texture coordinates.
std::vector<Chart> chartsOf(const CMesh& mesh, const CProgress& progress);

} // namespace stromar
