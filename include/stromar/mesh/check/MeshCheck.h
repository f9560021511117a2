#pragma once
#include "stromar/mesh/JoinedStems.h"
#include <span>
#include <string_view>

namespace stromar {

/// What was found in one mesh. The first four say what there is, all others have to be 0.
struct MeshFaults {
    std::size_t surfaces = 0, vertices = 0, triangles = 0;
    std::size_t attached = 0;   ///< surfaces that start on their parent's, by a collar or at a fork; others start inside it
    std::size_t badNumbers = 0; ///< vertices with a position, normal or texture coordinate that is no number
    std::size_t badNormals = 0; ///< vertices whose normal is not unit
    std::size_t badIndices = 0; ///< triangles beyond their surface's vertices
    std::size_t unused = 0;     ///< vertices of no triangle
    std::size_t flat = 0;       ///< triangles without an area
    std::size_t open = 0;       ///< surfaces with an edge of one triangle only, equal positions counting as one vertex
    std::size_t tangled = 0;    ///< surfaces with an edge of several triangles, or of two that face opposite ways
    std::size_t tilted = 0;     ///< triangles with a corner whose normal points to their back
    std::size_t floating = 0;   ///< branches whose collar starts above their parent's surface
    std::size_t buried = 0;     ///< branches whose collar starts more than kMaxBuried radii below it

    bool sound() const;
};

/// One row of the table of what is checked.
struct MeshCheck {
    std::string_view name;
    std::size_t MeshFaults::*count;
};
std::span<const MeshCheck> meshChecks();

constexpr double kMaxFloating = 0.001, kMaxBuried = 0.01; ///< radii of the branch: rounding

/// Checks the closed surfaces of a generation's stems; their collars against the triangles of the generations before, if given.
MeshFaults checkStems(const CTree& tree, int generation, const StemMesh& stems, std::span<const StemMesh> all);
/// Checks joined wood as one mesh: equal positions count as one vertex on a stem, and where a branch stands in it. Surfaces are
/// counted as they hang together. `stems` are those that were joined.
MeshFaults checkJoined(const JoinedStems& joined, std::span<const StemMesh> stems);
/// Checks a mesh that is one closed surface, but for normals that look to the back: where voxels meet by a point, none fits all
/// triangles.
MeshFaults checkSolid(const CMesh& solid);
/// Checks a mesh of leaves: flat pieces that may be open.
MeshFaults checkLeaves(const CMesh& leaves);

} // namespace stromar
