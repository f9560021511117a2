#pragma once
#include "stromar/model/Material.h"
#include <array>
#include <string>
#include <vector>

namespace stromar {

/// The least part of a screen's height that the tree fills when a level of detail is shown.
constexpr std::array<double, 4> kScreenCoverage{0.5, 0.25, 0.1, 0.01};

/// What a writer of model files gets.
struct ExportModel {
    std::string name;
    Meshes meshes;                  ///< none is empty
    std::vector<Meshes> coarser;    ///< levels of detail 1, 2, …, for formats that hold them
    std::vector<Material> materials; ///< of all surfaces of its meshes, perhaps of others

    /// Which of the materials a mesh has.
    std::size_t materialIndex(const CMesh& mesh) const;
    const Material& materialOf(const CMesh& mesh) const { return materials[materialIndex(mesh)]; }
    std::size_t vertexCount() const; ///< of all levels of detail
    std::size_t triangleCount() const;
};

/// A part of a mesh that keeps a file format's limits: own vertices, named by their place in the whole mesh.
struct MeshChunk {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> indices; ///< into `vertices`
};

/// Cuts a mesh, triangle by triangle in their order, into parts of at most so many vertices and triangles (3 at least).
std::vector<MeshChunk> cutIntoChunks(const CMesh& mesh, std::size_t maxVertices, std::size_t maxTriangles);

} // namespace stromar
