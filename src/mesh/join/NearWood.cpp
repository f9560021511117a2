#include "join/NearWood.h"
#include "stromar/mesh/Weld.h"
#include "stromar/util/DisjointSets.h"
#include <map>
#include <unordered_map>

namespace stromar {

std::vector<WoodPlace> placesOf(const std::vector<CTubeLines>& lines, const JoinedStems& joined, const CProgress& progress) {
    std::vector<Box> boxes;
    for (const CTubeLines& own : lines) boxes.push_back(own.box());
    const CBoxTree all(std::move(boxes));
    CDisjointSets together(lines.size());
    struct Near {
        WoodPlace::Source triangle;
        std::size_t first, end; // in `tubes`
    };
    std::vector<Near> near;
    std::vector<std::uint32_t> tubes;
    for (std::uint32_t g = 0; g < joined.meshes.size(); ++g) {
        progress.poll();
        const CMesh& mesh = *joined.meshes[g];
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            Box box;
            for (std::size_t c = 0; c < 3; ++c) box.add(glm::dvec3(mesh.positions[mesh.indices[i + c]]));
            const std::size_t first = tubes.size();
            all.forEachTouching(box, [&](std::uint32_t tube) { tubes.push_back(tube); });
            if (tubes.size() == first) continue;
            near.push_back({{g, i}, first, tubes.size()});
            for (std::size_t k = first + 1; k < tubes.size(); ++k) together.join(tubes[first], tubes[k]);
        }
    }
    std::vector<WoodPlace> places(lines.size());
    std::vector<std::uint32_t> within(lines.size()); // its place's tubes: which it is
    for (std::uint32_t t = 0; t < lines.size(); ++t) {
        WoodPlace& own = places[together.of(t)];
        within[t] = static_cast<std::uint32_t>(own.tubes.size());
        own.tubes.push_back(t);
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

CWoodPatch patchOf(const WoodPlace& place, std::span<const StemMesh> stems, const JoinedStems& joined) {
    std::vector<CWoodPatch::Vertex> vertices;
    std::vector<CWoodPatch::Triangle> triangles;
    std::vector<std::unordered_map<std::uint32_t, CWoodPatch::Index>> known(joined.meshes.size());
    for (const auto& [g, first] : place.triangles) {
        const CMesh& mesh = *joined.meshes[g];
        CWoodPatch::Triangle& own = triangles.emplace_back();
        own.generation = g;
        own.first = first;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = mesh.indices[first + c];
            const auto [at, isNew] = known[g].try_emplace(v, static_cast<CWoodPatch::Index>(vertices.size()));
            if (isNew)
                vertices.push_back({{joined.sources[g][v], mesh.positions[v], mesh.normals[v], mesh.texCoords[v], mesh.looks[v]}, g, v});
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
