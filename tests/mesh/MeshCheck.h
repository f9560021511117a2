#pragma once
#include "stromar/mesh/MeshBuilder.h"
#include <string>
#include <vector>

namespace stromar::test {

// Each ...Fault says in words what is wrong first, or nothing.

/// Sizes of the arrays, numbers that are none, indices beyond the end, unused vertices, normals that are not unit.
std::string arrayFault(const CMesh& mesh);
/// Triangles with a corner twice or without an area.
std::string triangleFault(const CMesh& mesh);

/// Which part of a mesh of stems one tube takes.
struct TubeRange {
    std::size_t firstVertex = 0, vertexCount = 0, firstIndex = 0, indexCount = 0;
    bool operator==(const TubeRange&) const = default;
};

/// The parts in the order of the plan's tubes. The size of a tube is learnt by meshing such a tube alone.
std::vector<TubeRange> tubeRanges(const MeshPlan& plan);

/// Whether each edge is used exactly twice, in opposite directions, once equal positions count as one vertex.
std::string closednessFault(const CMesh& mesh, const TubeRange& tube);

/// What the triangles enclose; positive when they face outwards.
double signedVolume(const CMesh& mesh, std::size_t firstIndex, std::size_t indexCount);
inline double signedVolume(const CMesh& mesh) { return signedVolume(mesh, 0, mesh.indices.size()); }

/// How many triangles have a corner whose normal points to their back.
std::size_t countTiltedNormals(const CMesh& mesh);

/// Whether all bytes are equal.
bool sameBytes(const CMesh& a, const CMesh& b);

} // namespace stromar::test
