#pragma once
#include "stromar/mesh/check/MeshCheck.h"
#include <array>
#include <map>
#include <string>

namespace stromar::test {

/// The faults in words, or nothing.
std::string inWords(const MeshFaults& faults);

/// What the triangles enclose; positive when they face outwards.
double signedVolume(const CMesh& mesh, std::size_t firstIndex, std::size_t indexCount);
/// Closed surfaces that are inside out.
std::size_t invertedSurfaces(const MeshPlan& plan, const CMesh& mesh);
inline double signedVolume(const CMesh& mesh) { return signedVolume(mesh, 0, mesh.indices.size()); }
/// Of meshes that are closed only together.
double signedVolume(const std::vector<std::shared_ptr<const CMesh>>& meshes);

/// How many edges of meshes together have not just as many triangles on one side as on the other; positions within 0.01 mm are
/// the same.
std::size_t openEdges(const std::vector<const CMesh*>& meshes);

/// From a place to another, counter-clockwise in a triangle.
using MeshEdge = std::array<std::array<float, 3>, 2>;
/// With the first of the triangle's indices.
std::map<MeshEdge, std::size_t> trianglesByEdge(const CMesh& mesh);

/// Whether all bytes are equal.
bool sameBytes(const CMesh& a, const CMesh& b);

} // namespace stromar::test
