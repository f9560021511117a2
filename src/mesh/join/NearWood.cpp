#include "join/NearWood.h"
#include "stromar/mesh/Weld.h"
#include "stromar/util/DisjointSets.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

namespace stromar {

namespace {
constexpr std::size_t kBlockTriangles = 64, kBlockGrain = 512;

/// Triangles that follow one another in a mesh, most of them of one stem.
struct Block {
    std::uint32_t generation;
    std::size_t first, end; ///< indices
    Bounds around;
};

std::vector<Block> blocksOf(const Wood& wood, const CProgress& progress) {
    std::vector<Block> blocks;
    for (std::uint32_t g = 0; g < wood.meshes.size(); ++g)
        for (std::size_t first = 0, end = 0; first < wood.meshes[g]->indices.size(); first = end) {
            end = std::min(first + 3 * kBlockTriangles, wood.meshes[g]->indices.size());
            blocks.push_back({g, first, end, kNowhere});
        }
    parallelFor(
        blocks.size(), kBlockGrain,
        [&](std::size_t begin, std::size_t end) {
            for (Block& own : std::span(blocks).subspan(begin, end - begin)) {
                const CMesh& mesh = *wood.meshes[own.generation];
                for (std::size_t i = own.first; i < own.end; ++i) include(own.around, mesh.positions[mesh.indices[i]]);
            }
        },
        progress);
    return blocks;
}

/// Calls work(triangle, its bounds) for those that may touch anything in a tree.
template <typename Do> void forEachTriangleNear(const CBoundsTree& tree, const std::vector<Block>& blocks, const Wood& wood, const CProgress& progress, Do&& work) {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (b % kBlockGrain == 0) progress.poll();
        const Block& own = blocks[b];
        if (!tree.touches(own.around)) continue;
        const CMesh& mesh = *wood.meshes[own.generation];
        for (std::size_t i = own.first; i < own.end; i += 3) {
            Bounds bounds = kNowhere;
            for (std::size_t c = 0; c < 3; ++c) include(bounds, mesh.positions[mesh.indices[i + c]]);
            work(WoodPlace::Source{own.generation, i}, bounds);
        }
    }
}

CBoundsTree treeOf(const std::vector<CTubeLines>& lines, const std::vector<std::uint32_t>& tubes) {
    std::vector<Bounds> bounds;
    for (const std::uint32_t t : tubes) bounds.push_back(lines[t].bounds());
    return CBoundsTree(std::move(bounds));
}

std::vector<std::uint32_t> chosenOf(const std::vector<CTubeLines>& lines, const std::vector<Block>& blocks, const Wood& wood, std::size_t most,
                                    const CProgress& progress) {
    std::vector<std::uint32_t> all(lines.size()), chosen;
    std::iota(all.begin(), all.end(), 0u);
    CBoundsTree tree = treeOf(lines, all);
    std::vector<std::size_t> near(lines.size());
    forEachTriangleNear(tree, blocks, wood, progress, [&](const WoodPlace::Source&, const Bounds& bounds) {
        tree.forEachTouching(bounds, [&](std::uint32_t t) { return ++near[t] <= most; });
    });
    std::ranges::stable_sort(all, {}, [&](std::uint32_t t) { return near[t]; });
    std::size_t sum = 0;
    for (const std::uint32_t t : all)
        if ((sum += near[t]) <= most) chosen.push_back(t);
    std::ranges::sort(chosen);
    return chosen;
}
} // namespace

std::vector<WoodPlace> placesOf(const std::vector<CTubeLines>& lines, const Wood& wood, std::size_t most, const CProgress& progress) {
    const std::vector<Block> blocks = blocksOf(wood, progress);
    const std::vector<std::uint32_t> chosen = chosenOf(lines, blocks, wood, most, progress);
    CBoundsTree tree = treeOf(lines, chosen);
    CDisjointSets together(chosen.size());
    struct Near {
        WoodPlace::Source triangle;
        std::size_t first, end; // in `tubes`
    };
    std::vector<Near> near;
    std::vector<std::uint32_t> tubes;
    forEachTriangleNear(tree, blocks, wood, progress, [&](const WoodPlace::Source& triangle, const Bounds& bounds) {
        const std::size_t first = tubes.size();
        tree.forEachTouching(bounds, [&](std::uint32_t tube) {
            tubes.push_back(tube);
            return true;
        });
        if (tubes.size() == first) return;
        near.push_back({triangle, first, tubes.size()});
        for (std::size_t k = first + 1; k < tubes.size(); ++k) together.join(tubes[first], tubes[k]);
    });
    std::vector<WoodPlace> places(chosen.size());
    std::vector<std::size_t> within(chosen.size()); // its place's tubes: which it is
    for (std::uint32_t t = 0; t < chosen.size(); ++t) {
        WoodPlace& own = places[together.of(t)];
        within[t] = own.tubes.size();
        own.tubes.push_back(chosen[t]);
        own.near.emplace_back();
    }
    for (const Near& own : near) {
        WoodPlace& place = places[together.of(tubes[own.first])];
        for (std::size_t k = own.first; k < own.end; ++k) place.near[within[tubes[k]]].push_back(static_cast<std::uint32_t>(place.triangles.size()));
        place.triangles.push_back(own.triangle);
    }
    std::erase_if(places, [](const WoodPlace& place) { return place.tubes.empty(); });
    return places;
}

std::uint32_t surfaceOf(std::span<const StemMesh> stems, const VertexSource& source) {
    const std::vector<Tube>& tubes = stems[source.generation].plan.tubes;
    auto own = std::ranges::upper_bound(tubes, source.vertex, {}, &Tube::firstVertex) - 1;
    while (own->joined) --own;
    return static_cast<std::uint32_t>(own - tubes.begin());
}

CWoodPatch patchOf(const WoodPlace& place, std::span<const StemMesh> stems, const Wood& wood) {
    std::vector<CWoodPatch::Vertex> vertices;
    std::vector<CWoodPatch::Triangle> triangles;
    std::vector<std::unordered_map<std::uint32_t, CWoodPatch::Index>> known(wood.meshes.size());
    for (const auto& [g, first] : place.triangles) {
        const CMesh& mesh = *wood.meshes[g];
        CWoodPatch::Triangle& own = triangles.emplace_back();
        own.generation = g;
        own.first = first;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = mesh.indices[first + c];
            const auto [at, isNew] = known[g].try_emplace(v, static_cast<CWoodPatch::Index>(vertices.size()));
            if (isNew)
                vertices.push_back({{wood.sources[g][v], mesh.positions[v], mesh.normals[v], mesh.texCoords[v], mesh.looks[v]}, g, v});
            own.vertices[c] = at->second;
        }
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> surfaces;
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> surface;
    for (const CWoodPatch::Vertex& vertex : vertices) {
        positions.push_back(vertex.value.position);
        const std::pair name(vertex.value.source.generation, surfaceOf(stems, vertex.value.source));
        surface.push_back(surfaces.try_emplace(name, static_cast<std::uint32_t>(surfaces.size())).first->second);
    }
    return CWoodPatch(std::move(vertices), weld(positions, surface), std::move(triangles));
}

} // namespace stromar
