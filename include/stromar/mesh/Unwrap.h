#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/util/Progress.h"
#include <span>

namespace stromar {

/// A mesh with texture coordinates of which no two triangles share a place. A vertex whose triangles part has copies.
struct Unwrapped {
    std::vector<std::uint32_t> sources; ///< of each vertex: which of the mesh's it copies
    RawVector<std::uint32_t> indices;   ///< three per triangle, in the mesh's order
    RawVector<glm::vec2> texCoords;     ///< 0..1, of all meshes side by side
};

/// Unwraps meshes into one square, for light maps: their own texture coordinates, cut where they overlap, in pieces that are all as large as
/// the surface is (but long ones that do not fit in are pressed), with a gap around each: 1 of 512 parts of the square, less where there are
/// many pieces. Triangles without texture coordinates lie flat by themselves. About linear: a second for a million triangles. Throws CCancelled.
std::vector<Unwrapped> unwrap(std::span<const std::shared_ptr<const CMesh>> meshes, const CProgress& progress);

} // namespace stromar
