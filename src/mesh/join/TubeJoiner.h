#pragma once
#include "stromar/mesh/JoinedStems.h"
#include <glm/vec2.hpp>
#include <vector>

namespace stromar {

/// A tube of a generation that stands on the wood of an earlier one.
struct BranchTube {
    std::uint32_t generation, tube;

    bool operator==(const BranchTube&) const = default;
};

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
    std::vector<BranchTube> joined;       ///< which of the branches stand in a hole
};

/// Cuts the collars of `branches` out of a tube of a generation of `stems`; the first come first. Throws CCancelled.
JoinedWalls joinWalls(const CTree& tree, std::size_t generation, std::span<const StemMesh> stems, const Tube& tube,
                      const std::vector<BranchTube>& branches, const CProgress& progress);

} // namespace stromar
