#include "join/NearWood.h"
#include "stromar/mesh/Weld.h"
#include "stromar/util/DisjointSets.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace stromar {

namespace {
constexpr std::size_t kBlockTriangles = 64, kBlockGrain = 512;

/// Calls work(triangle, its bounds) for those that may touch anything in a tree.
template <typename Do> void forEachTriangleNear(const CBoundsTree& tree, std::span<const WoodBlock> blocks, const Wood& wood, Do&& work) {
    for (const WoodBlock& own : blocks) {
        if (!tree.touches(own.around)) continue;
        const CMesh& mesh = *wood.meshes[own.generation];
        for (std::size_t i = own.first; i < own.end; i += 3) {
            if (mesh.indices[i] == kGone) continue;
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

std::vector<std::uint32_t> chosenOf(const std::vector<CTubeLines>& lines, std::span<const WoodBlock> blocks, const Wood& wood, std::size_t most,
                                    const CProgress& progress) {
    std::vector<std::uint32_t> all(lines.size()), chosen;
    std::iota(all.begin(), all.end(), 0u);
    const CBoundsTree around = treeOf(lines, all);
    std::vector<std::size_t> near(lines.size());
    std::mutex mutex;
    parallelFor(
        blocks.size(), kBlockGrain,
        [&](std::size_t begin, std::size_t end) {
            CBoundsTree tree = around;
            std::vector<std::size_t> own(lines.size());
            forEachTriangleNear(tree, blocks.subspan(begin, end - begin), wood, [&](const WoodPlace::Source&, const Bounds& bounds) {
                tree.forEachTouching(bounds, [&](std::uint32_t t) { return ++own[t] <= most; });
            });
            const std::lock_guard lock(mutex);
            std::ranges::transform(near, own, near.begin(), std::plus());
        },
        progress);
    std::ranges::stable_sort(all, {}, [&](std::uint32_t t) { return near[t]; });
    std::size_t sum = 0;
    for (const std::uint32_t t : all)
        if ((sum += near[t]) <= most) chosen.push_back(t);
    std::ranges::sort(chosen);
    return chosen;
}

/// Triangles of some blocks that touch tubes.
struct Touching {
    struct Triangle {
        WoodPlace::Source source;
        std::size_t end; ///< of its tubes
    };
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> tubes; ///< of each triangle in turn
};

/// By block, in runs of kBlockGrain.
std::vector<Touching> touchingOf(const CBoundsTree& around, std::span<const WoodBlock> blocks, const Wood& wood, const CProgress& progress) {
    std::vector<Touching> all((blocks.size() + kBlockGrain - 1) / kBlockGrain);
    parallelFor(
        blocks.size(), kBlockGrain,
        [&](std::size_t begin, std::size_t end) {
            CBoundsTree tree = around;
            Touching& own = all[begin / kBlockGrain];
            forEachTriangleNear(tree, blocks.subspan(begin, end - begin), wood, [&](const WoodPlace::Source& triangle, const Bounds& bounds) {
                const std::size_t first = own.tubes.size();
                tree.forEachTouching(bounds, [&](std::uint32_t tube) {
                    own.tubes.push_back(tube);
                    return true;
                });
                if (own.tubes.size() > first) own.triangles.push_back({triangle, own.tubes.size()});
            });
        },
        progress);
    return all;
}

/// work(triangle, its tubes) for each.
template <typename Do> void forEachTouching(const std::vector<Touching>& all, Do&& work) {
    for (const Touching& own : all) {
        std::size_t first = 0;
        for (const auto& [source, end] : own.triangles) {
            work(source, std::span(own.tubes).subspan(first, end - first));
            first = end;
        }
    }
}
} // namespace

void CWoodBlocks::update(const Wood& wood, const CProgress& progress) {
    m_ends.resize(wood.meshes.size());
    std::vector<WoodBlock> added;
    for (std::uint32_t g = 0; g < wood.meshes.size(); ++g)
        for (const std::size_t count = wood.meshes[g]->indices.size(); m_ends[g] < count;) {
            const std::size_t end = std::min(m_ends[g] + 3 * kBlockTriangles, count);
            added.push_back({g, std::exchange(m_ends[g], end), end, kNowhere});
        }
    parallelFor(
        added.size(), kBlockGrain,
        [&](std::size_t begin, std::size_t end) {
            for (WoodBlock& own : std::span(added).subspan(begin, end - begin)) {
                const CMesh& mesh = *wood.meshes[own.generation];
                for (std::size_t i = own.first; i < own.end; ++i) include(own.around, mesh.positions[mesh.indices[i]]);
            }
        },
        progress);
    m_all.insert(m_all.end(), added.begin(), added.end());
    std::ranges::sort(m_all, {}, [](const WoodBlock& own) { return std::pair(own.generation, own.first); });
}

std::vector<WoodPlace> placesOf(const std::vector<CTubeLines>& lines, std::span<const WoodBlock> blocks, const Wood& wood, std::size_t most,
                                const CProgress& progress) {
    const std::vector<std::uint32_t> chosen = chosenOf(lines, blocks, wood, most, progress);
    const std::vector<Touching> touching = touchingOf(treeOf(lines, chosen), blocks, wood, progress);
    CDisjointSets together(chosen.size());
    forEachTouching(touching, [&](const WoodPlace::Source&, std::span<const std::uint32_t> tubes) {
        for (const std::uint32_t tube : tubes.subspan(1)) together.join(tubes[0], tube);
    });
    std::vector<WoodPlace> places(chosen.size());
    std::vector<std::size_t> within(chosen.size()); // its place's tubes: which it is
    for (std::uint32_t t = 0; t < chosen.size(); ++t) {
        WoodPlace& own = places[together.of(t)];
        within[t] = own.tubes.size();
        own.tubes.push_back(chosen[t]);
        own.near.emplace_back();
    }
    forEachTouching(touching, [&](const WoodPlace::Source& triangle, std::span<const std::uint32_t> tubes) {
        WoodPlace& place = places[together.of(tubes[0])];
        for (const std::uint32_t tube : tubes) place.near[within[tube]].push_back(static_cast<std::uint32_t>(place.triangles.size()));
        place.triangles.push_back(triangle);
    });
    std::erase_if(places, [](const WoodPlace& place) { return place.tubes.empty(); });
    return places;
}

std::uint32_t surfaceOf(std::span<const StemMesh> stems, const VertexSource& source) {
    const std::vector<Tube>& tubes = stems[source.generation].plan.tubes;
    auto own = std::ranges::upper_bound(tubes, source.vertex, {}, &Tube::firstVertex) - 1;
    while (own->joined) --own;
    return static_cast<std::uint32_t>(own - tubes.begin());
}

namespace {
/// Of each vertex: numbers from 0. Most follow others of their surface.
std::vector<std::uint32_t> surfacesOf(const std::vector<CWoodPatch::Vertex>& vertices, std::span<const StemMesh> stems) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
    std::vector<std::uint32_t> all;
    std::pair<std::uint32_t, std::uint32_t> last;
    for (const CWoodPatch::Vertex& vertex : vertices) {
        const std::pair name(vertex.value.source.generation, surfaceOf(stems, vertex.value.source));
        all.push_back(!all.empty() && name == last ? all.back() : known.try_emplace(name, static_cast<std::uint32_t>(known.size())).first->second);
        last = name;
    }
    return all;
}
} // namespace

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
    std::vector<glm::vec3> positions;
    for (const CWoodPatch::Vertex& vertex : vertices) positions.push_back(vertex.value.position);
    const std::vector<std::uint32_t> surface = surfacesOf(vertices, stems);
    return CWoodPatch(std::move(vertices), weld(positions, surface), std::move(triangles));
}

} // namespace stromar
