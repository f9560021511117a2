#include "stromar/model/ExportModel.h"
#include <algorithm>
#include <cassert>

namespace stromar {

namespace {
/// Sums over the meshes of all levels of detail.
template <typename Count>
std::size_t sum(const ExportModel& model, Count&& count) {
    std::size_t all = 0;
    for (const auto& mesh : model.meshes) all += count(*mesh);
    for (const Meshes& lod : model.coarser)
        for (const auto& mesh : lod) all += count(*mesh);
    return all;
}
} // namespace

std::size_t ExportModel::materialIndex(const CMesh& mesh) const {
    if (!meshMaterials.empty())
        return meshMaterials[static_cast<std::size_t>(std::ranges::find(meshes, &mesh, [](const auto& own) { return own.get(); }) - meshes.begin())];
    auto own = std::ranges::find(materials, mesh.surface, &Material::surface);
    for (Surface surface = mesh.surface; own == materials.end() && standIn(surface) != surface;)
        own = std::ranges::find(materials, surface = standIn(surface), &Material::surface);
    assert(own != materials.end());
    return static_cast<std::size_t>(own - materials.begin());
}

std::size_t ExportModel::vertexCount() const {
    return sum(*this, [](const CMesh& mesh) { return mesh.vertexCount(); });
}

std::size_t ExportModel::triangleCount() const {
    return sum(*this, [](const CMesh& mesh) { return mesh.triangleCount(); });
}

std::vector<MeshChunk> cutIntoChunks(const CMesh& mesh, std::size_t maxVertices, std::size_t maxTriangles) {
    std::vector<MeshChunk> chunks;
    std::vector<std::uint32_t> placeOf(mesh.vertexCount()), chunkOf(mesh.vertexCount(), 0); // chunks count from 1 here
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const bool full = chunks.empty() || chunks.back().vertices.size() + 3 > maxVertices ||
                          chunks.back().indices.size() / 3 == maxTriangles;
        if (full) chunks.emplace_back();
        MeshChunk& chunk = chunks.back();
        for (std::size_t corner = t; corner < t + 3; ++corner) {
            const std::uint32_t vertex = mesh.indices[corner];
            if (chunkOf[vertex] != chunks.size()) {
                chunkOf[vertex] = static_cast<std::uint32_t>(chunks.size());
                placeOf[vertex] = static_cast<std::uint32_t>(chunk.vertices.size());
                chunk.vertices.push_back(vertex);
            }
            chunk.indices.push_back(placeOf[vertex]);
        }
    }
    return chunks;
}

} // namespace stromar
