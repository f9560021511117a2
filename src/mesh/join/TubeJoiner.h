#pragma once
#include "stromar/mesh/JoinedStems.h"
#include <glm/vec2.hpp>
#include <vector>

namespace stromar {

/// What becomes of the walls of one tube in which branches stand.
struct JoinedWalls {
    /// One that the tube has now: like a vertex of its own mesh, or of a branch's lowest ring.
    struct Vertex {
        VertexSource source;
        glm::vec3 position, normal;
        glm::vec2 texCoord;
        VertexLook look;
    };
    std::vector<std::size_t> replaced;    ///< triangles that are gone: the first of their indices, ascending
    std::vector<Vertex> vertices;         ///< new ones
    std::vector<std::uint32_t> triangles; ///< new ones, three indices each: of the mesh, and behind its end of `vertices`
    std::vector<std::uint32_t> joined;    ///< which of the branches stand in a hole
};

/// Cuts the collars of `branches`, tubes of the next generation, out of a tube. Throws CCancelled.
JoinedWalls joinWalls(const CTree& tree, std::size_t generation, const StemMesh& stems, const Tube& tube, const StemMesh& next,
                      const std::vector<std::uint32_t>& branches, const CProgress& progress);

} // namespace stromar
