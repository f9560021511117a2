#include "join/Union.h"
#include "join/TubeUnion.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <compare>
#include <unordered_map>

namespace stromar {

namespace {
constexpr double kReaches[]{6, 30}; // radii: most tubes come out soon
constexpr std::size_t kMostNear = 25'000; // triangles around all tubes that are looked at: some hundredths of a second

void leaveOutUnused(CMesh& mesh, std::vector<VertexSource>& sources) {
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

/// Writes what patches changed back to one generation's mesh.
void writeBack(std::uint32_t g, std::span<const CWoodPatch> patches, JoinedStems& joined) {
    const CMesh& before = *joined.meshes[g];
    std::vector<std::uint8_t> removed(before.triangleCount());
    bool changed = false;
    for (const CWoodPatch& patch : patches)
        for (const CWoodPatch::Triangle& triangle : patch.triangles())
            if (triangle.removed && !triangle.isNew && triangle.generation == g) removed[triangle.first / 3] = changed = true;
    if (!changed) return;
    auto mesh = std::make_shared<CMesh>(before);
    std::vector<VertexSource> sources = joined.sources[g];
    mesh->indices.clear();
    for (std::size_t i = 0; i < before.indices.size(); ++i)
        if (!removed[i / 3]) mesh->indices.push_back(before.indices[i]);
    for (const CWoodPatch& patch : patches) {
        std::unordered_map<Index, std::uint32_t> placeOf;
        for (const CWoodPatch::Triangle& triangle : patch.triangles()) {
            if (triangle.removed || !triangle.isNew || triangle.generation != g) continue;
            for (const Index v : triangle.vertices) {
                const CWoodPatch::Vertex& vertex = patch.vertices()[v];
                const auto [place, isNew] = placeOf.try_emplace(v, vertex.index != CWoodPatch::kNone ? vertex.index : static_cast<std::uint32_t>(sources.size()));
                mesh->indices.push_back(place->second);
                if (!isNew || vertex.index != CWoodPatch::kNone) continue;
                mesh->positions.push_back(vertex.value.position);
                mesh->normals.push_back(vertex.value.normal);
                mesh->texCoords.push_back(vertex.value.texCoord);
                mesh->looks.push_back(vertex.value.look);
                sources.push_back(vertex.value.source);
            }
        }
    }
    leaveOutUnused(*mesh, sources);
    joined.meshes[g] = std::move(mesh);
    joined.sources[g] = std::move(sources);
}

/// Whether to look at a tube, by place and tube: at those first with the fewest triangles around them.
std::vector<std::vector<bool>> choose(const std::vector<WoodPlace>& places) {
    struct Tube {
        std::size_t near, place, tube;
        auto operator<=>(const Tube&) const = default;
    };
    std::vector<Tube> all;
    std::vector<std::vector<bool>> chosen;
    for (const WoodPlace& place : places) {
        for (std::size_t i = 0; i < place.tubes.size(); ++i) all.push_back({place.near[i].size(), chosen.size(), i});
        chosen.emplace_back(place.tubes.size());
    }
    std::ranges::sort(all);
    std::size_t near = 0;
    for (const Tube& own : all) chosen[own.place][own.tube] = (near += own.near) <= kMostNear;
    return chosen;
}

/// Leaves those that stay apart.
United uniteWithin(double reach, const CTree& tree, std::span<const StemMesh> stems, std::vector<BranchTube>& apart, JoinedStems& joined,
                   const CProgress& progress) {
    std::vector<CTubeLines> lines;
    for (const BranchTube& own : apart) lines.emplace_back(tree, stems, own, reach);
    const std::vector<WoodPlace> places = placesOf(lines, joined, progress);
    const std::vector<std::vector<bool>> chosen = choose(places);
    std::vector<CWoodPatch> patches(places.size());
    std::vector<std::uint8_t> done(apart.size());
    parallelFor(
        places.size(), 1,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                if (std::ranges::count(chosen[p], true) == 0) continue;
                patches[p] = patchOf(places[p], stems, joined);
                for (std::size_t i = 0; i < places[p].tubes.size(); ++i) {
                    progress.poll();
                    if (!chosen[p][i]) continue;
                    patches[p].look(places[p].near[i]);
                    const std::uint32_t t = places[p].tubes[i];
                    done[t] = unite(tree, stems, apart[t], lines[t], patches[p]);
                }
            }
        },
        progress);
    for (std::uint32_t g = 0; g < stems.size(); ++g) writeBack(g, patches, joined);
    United united;
    for (std::size_t t = 0; t < apart.size(); ++t) (lines[t].tube.collarRings > 0 ? united.collars : united.others) += done[t];
    std::size_t next = 0;
    std::erase_if(apart, [&](const BranchTube&) { return done[next++] != 0; });
    return united;
}
} // namespace

United uniteWithWood(const CTree& tree, std::span<const StemMesh> stems, std::vector<BranchTube> apart, JoinedStems& joined,
                     const CProgress& progress) {
    United united;
    for (const double reach : kReaches) {
        if (apart.empty()) break;
        const United more = uniteWithin(reach, tree, stems, apart, joined, progress);
        united.collars += more.collars;
        united.others += more.others;
    }
    return united;
}

} // namespace stromar
