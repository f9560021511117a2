#pragma once
#include "stromar/mesh/Mesh.h"
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace stromar {

/// The ellipsoid that a tree's meshes fill, for how dark its inside is.
struct Crown {
    glm::vec3 centre, radii;
};

constexpr float kInTheMiddle = 0.45f; ///< of the light outside
constexpr glm::dvec3 kLeafTint(0.97, 0.99, 0.9); ///< what the picture of leaves is multiplied by, in the mean of all leaves

/// Of all leaves, or of all meshes where there are none.
Crown crownOf(const Meshes& meshes);

/// Ambient occlusion of a vertex, 0 dark … 255 open: what its own stem leaves open (CMesh::skyVisibility), less towards the
/// middle of the crown. A closed form, no rays: cost of one square root.
std::uint8_t ambientAt(const Crown& crown, const CMesh& mesh, std::size_t vertex);

/// What the picture of leaves is multiplied by besides kLeafTint and what makes each another, as kTreeFragmentShader does. `lit`: 0 in the middle
/// of the crown … 1 in the open; `sunAndShade`: LeafSunShade, 0..1.
glm::dvec3 sunAndShadeAt(double lit, double sunAndShade);

/// Per vertex the unit direction of rising u, square to the normal, and the sign of the direction of rising v against
/// normal × tangent: for normal maps. Mean of the triangles (Lengyel 2001).
std::vector<glm::vec4> tangentsOf(const CMesh& mesh);

} // namespace stromar
