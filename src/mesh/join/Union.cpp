#include "join/Union.h"
#include "join/TubeUnion.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <functional>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace stromar {

namespace {
struct Pass {
    CTubeLines::Reach reach;
    UnionBy by;
    UnionEffort effort;
    std::size_t mostTubes;    ///< that may be apart: of most trees some dozens are, of those whose stems all run through each other thousands
    std::size_t mostNear;     ///< triangles around all tubes that are looked at: some hundredths of a second
    std::size_t mostWork = 0; ///< of one tube, see uniteSurfaces(): most need some hundreds
    std::size_t allWork = 0;  ///< of all tubes
};
constexpr Pass kUnionPasses[]{{{6}, UnionBy::Lines, UnionEffort::Smooth, 5'000, 25'000}, // most tubes come out soon
                              {{30}, UnionBy::Lines, UnionEffort::Smooth, 5'000, 25'000},
                              {{6, 4}, UnionBy::Surfaces, UnionEffort::Smooth, 100, 100'000, 4'000, 30'000},
                              {{30, 8}, UnionBy::Surfaces, UnionEffort::Smooth, 100, 100'000, 4'000, 30'000},
                              {{6}, UnionBy::Lines, UnionEffort::Usual, 5'000, 25'000},
                              {{30}, UnionBy::Lines, UnionEffort::Usual, 5'000, 25'000},
                              {{6, 4}, UnionBy::Surfaces, UnionEffort::Usual, 100, 100'000, 4'000, 30'000},
                              {{30, 8}, UnionBy::Surfaces, UnionEffort::Usual, 100, 100'000, 4'000, 30'000},
                              {{200, 60}, UnionBy::Surfaces, UnionEffort::Usual, 100, 100'000, 4'000, 30'000},
                              {{6, 4}, UnionBy::Surfaces, UnionEffort::All, 6, 100'000, 30'000, 30'000},
                              {{30, 8}, UnionBy::Surfaces, UnionEffort::All, 6, 100'000, 30'000, 30'000},
                              {{200, 60}, UnionBy::Surfaces, UnionEffort::All, 6, 100'000, 30'000, 30'000},
                              {{6, 4}, UnionBy::Surfaces, UnionEffort::All, 1, 100'000, 200'000, 200'000}, // for the last tube of a tree
                              {{30, 8}, UnionBy::Surfaces, UnionEffort::All, 1, 100'000, 200'000, 200'000}};

using Index = CWoodPatch::Index;

/// Triangles that were taken out, and vertices that none has any more.
void leaveOutUnused(CMesh& mesh, std::vector<VertexSource>& sources) {
    std::erase(mesh.indices, kGone);
    std::vector<std::uint32_t> placeOf(mesh.vertexCount());
    for (const std::uint32_t v : mesh.indices) placeOf[v] = 1;
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < placeOf.size(); ++v) {
        if (placeOf[v] == 0) continue;
        placeOf[v] = count;
        mesh.positions[count] = mesh.positions[v];
        mesh.normals[count] = mesh.normals[v];
        mesh.texCoords[count] = mesh.texCoords[v];
        mesh.looks[count] = mesh.looks[v];
        sources[count++] = sources[v];
    }
    mesh.positions.resize(count);
    mesh.normals.resize(count);
    mesh.texCoords.resize(count);
    mesh.looks.resize(count);
    sources.resize(count);
    for (std::uint32_t& v : mesh.indices) v = placeOf[v];
}

/// Little more than what patches may add: arrays that grow would be twice as large.
void reserveFor(std::span<const CWoodPatch> patches, std::uint32_t g, CMesh& mesh, std::vector<VertexSource>& sources) {
    std::size_t vertices = sources.size(), indices = mesh.indices.size();
    for (const CWoodPatch& patch : patches) {
        for (const CWoodPatch::Vertex& vertex : patch.vertices()) vertices += vertex.index == CWoodPatch::kNone && vertex.generation == g;
        for (const CWoodPatch::Triangle& triangle : patch.triangles()) indices += triangle.isNew && !triangle.removed && triangle.generation == g ? 3 : 0;
    }
    const auto reserve = [](auto& array, std::size_t count) {
        if (count > array.capacity()) array.reserve(count + count / kWoodSlack);
    };
    reserve(mesh.positions, vertices);
    reserve(mesh.normals, vertices);
    reserve(mesh.texCoords, vertices);
    reserve(mesh.looks, vertices);
    reserve(mesh.indices, indices);
    reserve(sources, vertices);
}

/// Writes a patch's new triangles of one generation.
void append(const CWoodPatch& patch, std::uint32_t g, CMesh& mesh, std::vector<VertexSource>& sources) {
    std::unordered_map<Index, std::uint32_t> placeOf;
    for (const CWoodPatch::Triangle& triangle : patch.triangles()) {
        if (triangle.removed || !triangle.isNew || triangle.generation != g) continue;
        for (const Index v : triangle.vertices) {
            const CWoodPatch::Vertex& vertex = patch.vertices()[v];
            const bool known = vertex.index != CWoodPatch::kNone;
            const auto [place, isNew] = placeOf.try_emplace(v, known ? vertex.index : static_cast<std::uint32_t>(sources.size()));
            mesh.indices.push_back(place->second);
            if (known || !isNew) continue;
            mesh.positions.push_back(vertex.value.position);
            mesh.normals.push_back(vertex.value.normal);
            mesh.texCoords.push_back(vertex.value.texCoord);
            mesh.looks.push_back(vertex.value.look);
            sources.push_back(vertex.value.source);
        }
    }
}

/// What patches changed of one generation; what no triangle has any more stays. False where they changed nothing.
bool writeBack(std::uint32_t g, std::span<const CWoodPatch> patches, Wood& wood) {
    CMesh& mesh = *wood.meshes[g];
    bool changed = false;
    for (const CWoodPatch& patch : patches)
        for (const CWoodPatch::Triangle& triangle : patch.triangles()) {
            if (!triangle.removed || triangle.isNew || triangle.generation != g) continue;
            std::fill_n(mesh.indices.begin() + static_cast<std::ptrdiff_t>(triangle.first), 3, kGone);
            changed = true;
        }
    if (!changed) return false;
    reserveFor(patches, g, mesh, wood.sources[g]);
    for (const CWoodPatch& patch : patches) append(patch, g, mesh, wood.sources[g]);
    return true;
}

/// work(index), on several threads.
template <typename Do> void forEachIndex(std::size_t count, const CProgress& progress, Do&& work) {
    parallelFor(
        count, 1,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) work(static_cast<std::uint32_t>(i));
        },
        progress);
}

/// Leaves those that stay apart, and marks generations that change.
United uniteWithin(const Pass& pass, const CTree& tree, std::span<const StemMesh> stems, std::vector<BranchTube>& apart, CWoodBlocks& blocks, Wood& wood,
                   std::vector<std::uint8_t>& changed, const CProgress& progress) {
    std::vector<CTubeLines> lines;
    for (const BranchTube& own : apart) lines.emplace_back(tree, stems, own, pass.reach);
    blocks.update(wood, progress);
    const std::vector<WoodPlace> places = placesOf(lines, blocks.all(), wood, pass.mostNear, progress);
    const std::size_t tubes = std::accumulate(places.begin(), places.end(), std::size_t{1}, [](std::size_t sum, const WoodPlace& own) { return sum + own.tubes.size(); });
    const UnionMethod method{pass.by, std::min(pass.mostWork, pass.allWork / tubes), pass.effort};
    std::vector<CWoodPatch> patches(places.size());
    std::vector<std::uint8_t> done(apart.size());
    std::vector<std::uint32_t> order(places.size()); // the largest first, so that no thread waits for it
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t p) { return places[p].triangles.size(); });
    forEachIndex(places.size(), progress, [&](std::uint32_t i) {
        const std::uint32_t p = order[i];
        patches[p] = patchOf(places[p], stems, wood);
        for (std::size_t k = 0; k < places[p].tubes.size(); ++k) {
            progress.poll();
            const std::uint32_t t = places[p].tubes[k];
            patches[p].select(places[p].near[k]);
            done[t] = unite(tree, stems, apart[t], method, lines[t], patches[p]);
        }
    });
    forEachIndex(stems.size(), progress, [&](std::uint32_t g) { changed[g] |= writeBack(g, patches, wood); });
    United united;
    for (std::size_t t = 0; t < apart.size(); ++t) (lines[t].tube.collarRings > 0 ? united.collars : united.others) += done[t];
    std::size_t next = 0;
    std::erase_if(apart, [&](const BranchTube&) { return done[next++] != 0; });
    return united;
}
} // namespace

United uniteWithWood(const CTree& tree, std::span<const StemMesh> stems, std::vector<BranchTube> apart, Wood& wood, const CProgress& progress) {
    apart.resize(std::min(apart.size(), kUnionPasses[0].mostTubes));
    United united;
    std::vector<std::uint8_t> changed(stems.size());
    CWoodBlocks blocks;
    bool idle = false; // the pass before joined none: one that reaches further will not either
    for (const Pass& pass : kUnionPasses) {
        if (apart.empty() || apart.size() > pass.mostTubes || (idle && pass.by == UnionBy::Surfaces && pass.effort != UnionEffort::All)) continue;
        const United more = uniteWithin(pass, tree, stems, apart, blocks, wood, changed, progress);
        united.collars += more.collars;
        united.others += more.others;
        idle = pass.by == UnionBy::Surfaces && more.collars + more.others == 0;
    }
    forEachIndex(stems.size(), progress, [&](std::uint32_t g) {
        if (changed[g]) leaveOutUnused(*wood.meshes[g], wood.sources[g]);
    });
    return united;
}

} // namespace stromar
