#include "stromar/mesh/JoinedStems.h"
#include "join/TubeJoiner.h"
#include "stem/FrontNormals.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

namespace stromar {

namespace {
constexpr std::size_t kTubeGrain = 16;

/// The tubes of one generation that bear branches with collars, and these.
struct Bearers {
    std::vector<std::uint32_t> tubes;
    std::vector<std::vector<std::uint32_t>> branches; ///< of each
};

Bearers bearersOf(const CTree& tree, std::size_t generation, const MeshPlan& plan, const MeshPlan& next) {
    std::vector<std::vector<std::uint32_t>> branches(plan.tubes.size());
    for (std::uint32_t t = 0; t < next.tubes.size(); ++t) {
        if (next.tubes[t].collarRings == 0) continue;
        const CStem& stem = tree.generation(generation + 1).stems[next.tubes[t].stem];
        const CStem& parent = tree.generation(generation).stems[static_cast<std::size_t>(stem.parent)];
        if (const std::int32_t bearer = plan.tubeOfPath[parent.firstPath + stem.path]; bearer >= 0)
            branches[static_cast<std::size_t>(bearer)].push_back(t);
    }
    Bearers bearers;
    for (std::uint32_t t = 0; t < branches.size(); ++t)
        if (!branches[t].empty()) {
            bearers.tubes.push_back(t);
            bearers.branches.push_back(std::move(branches[t]));
        }
    return bearers;
}

/// The mesh of one generation, open where branches stand, without the lids of tubes that stand in holes.
class CWoodWriter {
public:
    CWoodWriter(std::uint32_t generation, const StemMesh& stems, const std::vector<bool>& standsInHole)
        : m_generation(generation), m_mesh(*stems.mesh), m_dropped(m_mesh.triangleCount()) {
        for (std::size_t t = 0; t < stems.plan.tubes.size(); ++t)
            if (standsInHole[t]) dropLid(stems.plan.tubes[t]);
    }

    void write(const std::vector<JoinedWalls>& walls, JoinedStems& joined) {
        for (const JoinedWalls& own : walls)
            for (const std::size_t index : own.replaced) m_dropped[index / 3] = true;
        countUsed(walls);
        std::size_t vertices = m_kept, indices = 3 * static_cast<std::size_t>(std::ranges::count(m_dropped, false));
        for (const JoinedWalls& own : walls) {
            vertices += own.vertices.size();
            indices += own.triangles.size();
        }
        m_out = allocateMesh(m_mesh.name, m_mesh.surface, vertices, indices);
        m_sources.reserve(vertices);
        copyKept();
        m_firstNewIndex = m_nextIndex;
        for (const JoinedWalls& own : walls) append(own);
        const std::vector<std::size_t> changed = changedTriangles();
        turnNormalsToFront(*m_out, changed);
        splitCreases(changed); // of slivers rounding may say something else
        joined.meshes.push_back(m_out);
        joined.sources.push_back(std::move(m_sources));
    }

private:
    /// The lowest lid is a tube's last, a fan about a middle of its own.
    void dropLid(const Tube& tube) {
        const std::size_t end = (tube.firstIndex + tube.indexCount()) / 3;
        std::fill(m_dropped.begin() + static_cast<std::ptrdiff_t>(end - tube.points), m_dropped.begin() + static_cast<std::ptrdiff_t>(end), true);
    }

    void countUsed(const std::vector<JoinedWalls>& walls) {
        std::vector<std::uint8_t> used(m_mesh.vertexCount());
        for (std::size_t i = 0; i < m_mesh.indices.size(); ++i)
            if (!m_dropped[i / 3]) used[m_mesh.indices[i]] = true;
        for (const JoinedWalls& own : walls)
            for (const std::uint32_t v : own.triangles)
                if (v < used.size()) used[v] = true;
        m_place.assign(m_mesh.vertexCount(), kNone);
        for (std::size_t v = 0; v < used.size(); ++v)
            if (used[v]) m_place[v] = m_kept++;
    }

    void copyKept() {
        for (std::uint32_t v = 0; v < m_mesh.vertexCount(); ++v)
            if (m_place[v] != kNone)
                add({{m_generation, v}, m_mesh.positions[v], m_mesh.normals[v], m_mesh.texCoords[v], m_mesh.looks[v]});
        for (std::size_t i = 0; i < m_mesh.indices.size(); ++i)
            if (!m_dropped[i / 3]) m_out->indices[m_nextIndex++] = m_place[m_mesh.indices[i]];
    }

    void append(const JoinedWalls& walls) {
        const auto first = static_cast<std::uint32_t>(m_sources.size());
        for (const JoinedWalls::Vertex& vertex : walls.vertices) add(vertex);
        for (const std::uint32_t v : walls.triangles)
            m_out->indices[m_nextIndex++] = v < m_place.size() ? m_place[v] : first + (v - static_cast<std::uint32_t>(m_place.size()));
    }

    void add(const JoinedWalls::Vertex& vertex) {
        const std::size_t v = m_sources.size();
        m_out->positions[v] = vertex.position;
        m_out->normals[v] = vertex.normal;
        m_out->texCoords[v] = vertex.texCoord;
        m_out->looks[v] = vertex.look;
        m_sources.push_back(vertex.source);
    }

    /// The new triangles, and those that share a vertex with them: by their first indices.
    std::vector<std::size_t> changedTriangles() const {
        std::vector<std::uint8_t> touched(m_out->vertexCount());
        for (std::size_t i = m_firstNewIndex; i < m_out->indices.size(); ++i) touched[m_out->indices[i]] = true;
        std::vector<std::size_t> changed;
        for (std::size_t t = 0; t < m_out->indices.size(); t += 3)
            if (touched[m_out->indices[t]] || touched[m_out->indices[t + 1]] || touched[m_out->indices[t + 2]]) changed.push_back(t);
        return changed;
    }

    /// A corner that no normal of its vertex fits has the triangle's own: beside collars of thin stems.
    void splitCreases(const std::vector<std::size_t>& triangles) {
        std::vector<std::uint32_t> uses(m_sources.size());
        for (const std::uint32_t v : m_out->indices) ++uses[v];
        for (const std::size_t t : triangles) {
            const auto at = [&](std::size_t c) { return glm::dvec3(m_out->positions[m_out->indices[t + c]]); };
            const glm::dvec3 face = glm::cross(at(1) - at(0), at(2) - at(0));
            if (!(glm::length(face) > 0)) continue;
            for (std::size_t i = t; i < t + 3; ++i)
                if (glm::dot(face, glm::dvec3(m_out->normals[m_out->indices[i]])) <= 0) giveNormal(i, glm::normalize(face), uses);
        }
    }

    /// A normal of its own to a corner, by its index.
    void giveNormal(std::size_t i, const glm::vec3& normal, std::vector<std::uint32_t>& uses) {
        const std::uint32_t v = m_out->indices[i];
        if (uses[v] == 1) {
            m_out->normals[v] = normal;
            return;
        }
        --uses[v];
        uses.push_back(1);
        m_out->indices[i] = static_cast<std::uint32_t>(m_sources.size());
        m_out->positions.push_back(m_out->positions[v]);
        m_out->normals.push_back(normal);
        m_out->texCoords.push_back(m_out->texCoords[v]);
        m_out->looks.push_back(m_out->looks[v]);
        m_sources.push_back(m_sources[v]);
    }

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::uint32_t m_generation;
    const CMesh& m_mesh;
    std::vector<std::uint8_t> m_dropped; ///< by triangle; bytes, which are faster than bits
    std::vector<std::uint32_t> m_place; ///< where vertices go
    std::uint32_t m_kept = 0;
    std::size_t m_nextIndex = 0, m_firstNewIndex = 0;
    std::shared_ptr<CMesh> m_out;
    std::vector<VertexSource> m_sources;
};

std::vector<JoinedWalls> joinGeneration(const CTree& tree, std::size_t g, std::span<const StemMesh> stems, const CProgress& progress) {
    if (g + 1 >= stems.size()) return {};
    const Bearers bearers = bearersOf(tree, g, stems[g].plan, stems[g + 1].plan);
    std::vector<JoinedWalls> walls(bearers.tubes.size());
    parallelFor(
        walls.size(), kTubeGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                walls[i] = joinWalls(tree, g, stems[g], stems[g].plan.tubes[bearers.tubes[i]], stems[g + 1], bearers.branches[i], progress);
        },
        progress);
    return walls;
}
} // namespace

JoinedStems joinStems(const CTree& tree, std::span<const StemMesh> stems, const CProgress& progress) {
    JoinedStems joined;
    std::size_t collars = 0;
    std::vector<bool> standsInHole(stems.empty() ? 0 : stems.front().plan.tubes.size());
    for (std::size_t g = 0; g < stems.size(); ++g) {
        const std::vector<JoinedWalls> walls = joinGeneration(tree, g, stems, progress);
        CWoodWriter(static_cast<std::uint32_t>(g), stems[g], standsInHole).write(walls, joined);
        if (g + 1 < stems.size()) {
            standsInHole.assign(stems[g + 1].plan.tubes.size(), false);
            collars += static_cast<std::size_t>(std::ranges::count_if(stems[g + 1].plan.tubes, [](const Tube& tube) { return tube.collarRings > 0; }));
        }
        for (const JoinedWalls& own : walls) {
            joined.joined += own.joined.size();
            for (const std::uint32_t tube : own.joined) standsInHole[tube] = true;
        }
    }
    joined.apart = collars - joined.joined;
    return joined;
}

} // namespace stromar
