#include "stromar/mesh/Model.h"
#include <algorithm>
#include <cassert>
#include <iterator>

namespace stromar {

namespace {
using T = TextParams;
constexpr SurfaceInfo kSurfaceTable[] = {
    {"bark", {0.42f, 0.34f, 0.26f}, false, &T::barkTexture, "bark.png", nullptr},
    {"leaf", {0.30f, 0.45f, 0.18f}, true, &T::leafTexture, "leaf.png", nullptr},
    {"blossom", {0.95f, 0.88f, 0.90f}, true, &T::blossomTexture, "leaf:blossom", &GlobalParams::blossoms},
    {"fruit",
     {0.65f, 0.16f, 0.10f},
     false,
     &T::fruitTexture,
     "bark:smooth spots=0 light=#c8402c dark=#7c1c18",
     &GlobalParams::fruits},
    {"twig", {0.30f, 0.45f, 0.18f}, true, nullptr, "", nullptr},
};
static_assert(std::size(kSurfaceTable) == kSurfaces.size());

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

const SurfaceInfo& surfaceOf(Surface surface) { return kSurfaceTable[static_cast<std::size_t>(surface)]; }

bool hasSurface(const CParams& params, Surface surface) {
    const SurfaceInfo& info = surfaceOf(surface);
    return info.texture && (!info.number || params.global.*info.number > 0);
}

std::size_t ExportModel::lookIndex(const CMesh& mesh) const {
    const auto look = std::ranges::find(looks, mesh.surface, &SurfaceLook::surface);
    assert(look != looks.end());
    return static_cast<std::size_t>(look - looks.begin());
}

std::size_t ExportModel::vertexCount() const {
    return sum(*this, [](const CMesh& mesh) { return mesh.vertexCount(); });
}

std::size_t ExportModel::triangleCount() const {
    return sum(*this, [](const CMesh& mesh) { return mesh.triangleCount(); });
}

std::vector<MeshChunk> cutIntoChunks(const CMesh& mesh, std::size_t mostVertices, std::size_t mostTriangles) {
    std::vector<MeshChunk> chunks;
    std::vector<std::uint32_t> placeOf(mesh.vertexCount()), chunkOf(mesh.vertexCount(), 0); // chunks count from 1 here
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const bool full = chunks.empty() || chunks.back().vertices.size() + 3 > mostVertices ||
                          chunks.back().indices.size() / 3 == mostTriangles;
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
