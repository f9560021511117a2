#include "stromar/mesh/JoinedStems.h"
#include "join/TubeJoiner.h"
#include "join/Union.h"
#include "stem/FrontNormals.h"
#include "stem/TubeLids.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>
#include <unordered_map>

namespace stromar {

namespace {
constexpr std::size_t kTubeGrain = 4;

/// The tubes of one generation that bear branches with collars, and these.
struct Bearers {
    std::vector<std::uint32_t> tubes;
    std::vector<std::vector<BranchTube>> branches; ///< of each, from the next generation on
};

Bearers bearersOf(std::span<const StemMesh> stems, std::size_t g) {
    const MeshPlan& plan = stems[g].plan;
    std::vector<std::vector<BranchTube>> branches(plan.tubes.size());
    for (std::size_t above = g + 1; above < stems.size(); ++above) {
        const MeshPlan& later = stems[above].plan;
        for (std::uint32_t t = 0; t < later.tubes.size(); ++t) {
            const Tube& tube = later.tubes[t];
            if (tube.collarRings == 0 || tube.standsOn != above - g) continue;
            branches[static_cast<std::size_t>(&plan.bearerOf(later, tube) - plan.tubes.data())].push_back({static_cast<std::uint32_t>(above), t});
        }
    }
    Bearers bearers;
    for (std::uint32_t t = 0; t < branches.size(); ++t)
        if (!branches[t].empty()) {
            bearers.tubes.push_back(t);
            bearers.branches.push_back(std::move(branches[t]));
        }
    return bearers;
}

/// The walls of one generation's tubes in which branches stand.
struct OpenWalls {
    std::vector<std::uint32_t> tubes; ///< ascending
    std::vector<JoinedWalls> walls;   ///< of each
};

/// The mesh of one generation, open where branches stand, without the lids of tubes that stand in holes or at forks.
class CWoodWriter {
public:
    CWoodWriter(std::uint32_t generation, std::span<const StemMesh> stems, const OpenWalls& open, const std::vector<bool>& standsInHole)
        : m_generation(generation), m_mesh(*stems[generation].mesh), m_plan(stems[generation].plan), m_open(open), m_dropped(m_mesh.triangleCount()) {
        for (std::size_t t = 0; t < m_plan.tubes.size(); ++t)
            if (standsInHole[t] || m_plan.tubes[t].forked) dropLid(m_plan.tubes[t]);
        for (const JoinedWalls& own : open.walls)
            for (const std::size_t index : own.replaced) m_dropped[index / 3] = true;
        if (generation + 1 < stems.size()) dropBranchLids(stems[generation + 1].plan);
        if (generation > 0) findCommon(stems[generation - 1].plan);
    }

    void write(Wood& wood, const CProgress& progress) {
        countUsed();
        std::size_t vertices = m_kept, indices = 3 * static_cast<std::size_t>(std::ranges::count(m_dropped, false));
        for (const JoinedWalls& own : m_open.walls) {
            vertices += own.vertices.size();
            indices += own.triangles.size();
        }
        m_out = allocateMesh(m_mesh.name, m_mesh.surface, 0, 0);
        reserve(vertices + vertices / kWoodSlack, indices + indices / kWoodSlack);
        m_out->indices.resize(indices);
        copyKept();
        for (const JoinedWalls& own : m_open.walls) append(own);
        turnNormals(progress);
        wood.meshes[m_generation] = m_out;
        wood.sources[m_generation] = std::move(m_sources);
    }

private:
    /// The lowest lid is a tube's last, a fan about a middle of its own.
    void dropLid(const Tube& tube) {
        const std::uint32_t triangles = m_plan.baseLidPoints(tube);
        drop(tube.firstIndex + tube.indexCount() - 3 * std::size_t{triangles}, triangles);
    }

    void drop(std::size_t firstIndex, std::uint32_t triangles) { std::fill_n(m_dropped.begin() + static_cast<std::ptrdiff_t>(firstIndex / 3), triangles, true); }

    /// Those over holes in which a branch stands that starts at the fork.
    void dropBranchLids(const MeshPlan& above) {
        std::vector<bool> starts(m_plan.branches.size());
        for (const Tube& tube : above.tubes)
            if (tube.forked) starts[static_cast<std::size_t>(m_plan.branch(tube.stem) - m_plan.branches.data())] = true;
        for (const Tube& tube : m_plan.tubes) {
            if (tube.branchCount == 0) continue;
            const std::vector<LidPlace> lids = branchLidsOf(m_plan, tube);
            for (std::size_t b = 0; b < lids.size(); ++b)
                if (starts[tube.firstBranch + b]) drop(lids[b].index, lids[b].points);
        }
    }

    /// What bounds a branch at a fork comes from the lid that its parent has there: both move alike.
    void findCommon(const MeshPlan& below) {
        if (below.branches.empty()) return;
        std::vector<std::uint32_t> lids(below.branches.size()); // their first points
        for (const Tube& tube : below.tubes) {
            if (tube.branchCount == 0) continue;
            std::size_t next = tube.firstBranch;
            for (const LidPlace& lid : branchLidsOf(below, tube)) lids[next++] = lid.vertex + 1;
        }
        for (const Tube& tube : m_plan.tubes) {
            if (!tube.forked) continue;
            const ForkedBranch& branch = *below.branch(tube.stem);
            const std::uint32_t lid = lids[static_cast<std::size_t>(&branch - below.branches.data())];
            const std::vector<std::uint32_t> boundary = branch.limb.boundary();
            for (std::uint32_t i = 0; i < boundary.size(); ++i) m_common.emplace(tube.firstVertex + boundary[i], lid + i);
            m_common.emplace(tube.firstVertex + branch.limb.pointCount() - 1, lid); // the saddle
        }
    }

    VertexSource sourceOf(std::uint32_t v) const {
        if (m_common.empty()) return {m_generation, v};
        const auto common = m_common.find(v);
        return common == m_common.end() ? VertexSource{m_generation, v} : VertexSource{m_generation - 1, common->second};
    }

    void countUsed() {
        std::vector<std::uint8_t> used(m_mesh.vertexCount());
        for (std::size_t i = 0; i < m_mesh.indices.size(); ++i)
            if (!m_dropped[i / 3]) used[m_mesh.indices[i]] = true;
        for (const JoinedWalls& own : m_open.walls)
            for (const std::uint32_t v : own.triangles)
                if (v < used.size()) used[v] = true;
        m_place.assign(m_mesh.vertexCount(), kNone);
        for (std::size_t v = 0; v < used.size(); ++v)
            if (used[v]) m_place[v] = m_kept++;
    }

    void reserve(std::size_t vertices, std::size_t indices) {
        m_out->indices.reserve(indices);
        m_out->positions.reserve(vertices);
        m_out->normals.reserve(vertices);
        m_out->texCoords.reserve(vertices);
        m_out->looks.reserve(vertices);
        m_sources.reserve(vertices);
    }

    void copyKept() {
        const auto isKept = [](std::uint32_t place) { return place != kNone; };
        for (auto end = m_place.begin(), first = std::find_if(end, m_place.end(), isKept); first != m_place.end();
             first = std::find_if(end, m_place.end(), isKept)) {
            end = std::find(first, m_place.end(), kNone);
            copyVertices(first - m_place.begin(), end - m_place.begin());
        }
        copyTriangles();
    }

    void copyVertices(std::ptrdiff_t first, std::ptrdiff_t end) {
        const auto copy = [&](const auto& from, auto& to) { to.insert(to.end(), from.begin() + first, from.begin() + end); };
        copy(m_mesh.positions, m_out->positions);
        copy(m_mesh.normals, m_out->normals);
        copy(m_mesh.texCoords, m_out->texCoords);
        copy(m_mesh.looks, m_out->looks);
        for (auto v = static_cast<std::uint32_t>(first); v < static_cast<std::uint32_t>(end); ++v) m_sources.push_back(sourceOf(v));
    }

    void copyTriangles() {
        std::size_t i = 0;
        const auto copyTo = [&](std::size_t end) {
            for (; i < end; i += 3) {
                if (m_dropped[i / 3]) continue;
                for (std::size_t c = 0; c < 3; ++c) m_out->indices[m_nextIndex++] = m_place[m_mesh.indices[i + c]];
            }
        };
        for (const std::uint32_t tube : m_open.tubes) {
            copyTo(m_plan.tubes[tube].firstIndex);
            const std::size_t first = m_nextIndex;
            copyTo(m_plan.tubes[tube].firstIndex + m_plan.tubes[tube].indexCount());
            m_keptIndices.push_back({first, m_nextIndex});
        }
        copyTo(m_mesh.indices.size());
    }

    void append(const JoinedWalls& walls) {
        const auto first = static_cast<std::uint32_t>(m_sources.size());
        const std::size_t firstIndex = m_nextIndex;
        for (JoinedWalls::Vertex vertex : walls.vertices) {
            if (vertex.source.generation == m_generation) vertex.source = sourceOf(vertex.source.vertex);
            add(vertex);
        }
        for (const std::uint32_t v : walls.triangles)
            m_out->indices[m_nextIndex++] = v < m_place.size() ? m_place[v] : first + (v - static_cast<std::uint32_t>(m_place.size()));
        m_newIndices.push_back({firstIndex, m_nextIndex});
    }

    void add(const JoinedWalls::Vertex& vertex) {
        m_out->positions.push_back(vertex.position);
        m_out->normals.push_back(vertex.normal);
        m_out->texCoords.push_back(vertex.texCoord);
        m_out->looks.push_back(vertex.look);
        m_sources.push_back(vertex.source);
    }

    /// Tubes have no vertex in common.
    void turnNormals(const CProgress& progress) {
        std::vector<std::uint8_t> touched(m_out->vertexCount());
        std::vector<std::vector<std::size_t>> creases(m_open.tubes.size());
        parallelFor(
            creases.size(), kTubeGrain,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    const std::vector<std::size_t> changed = changedTriangles(i, touched);
                    turnNormalsToFront(*m_out, changed);
                    creases[i] = creasesAt(changed); // of slivers rounding may say something else
                }
            },
            progress);
        std::vector<std::size_t> all;
        for (const std::vector<std::size_t>& own : creases) all.insert(all.end(), own.begin(), own.end());
        std::ranges::sort(all);
        splitCreases(all);
    }

    /// The new triangles of an open tube, and those that share a vertex with them: by their first indices.
    std::vector<std::size_t> changedTriangles(std::size_t tube, std::vector<std::uint8_t>& touched) const {
        const auto [keptFirst, keptEnd] = m_keptIndices[tube];
        const auto [newFirst, newEnd] = m_newIndices[tube];
        const auto& indices = m_out->indices;
        for (std::size_t i = newFirst; i < newEnd; ++i) touched[indices[i]] = true;
        std::vector<std::size_t> changed;
        for (std::size_t t = keptFirst; t < keptEnd; t += 3)
            if (touched[indices[t]] || touched[indices[t + 1]] || touched[indices[t + 2]]) changed.push_back(t);
        for (std::size_t t = newFirst; t < newEnd; t += 3) changed.push_back(t);
        return changed;
    }

    glm::dvec3 faceAt(std::size_t t) const {
        const auto at = [&](std::size_t c) { return glm::dvec3(m_out->positions[m_out->indices[t + c]]); };
        return glm::cross(at(1) - at(0), at(2) - at(0));
    }

    /// The corners that no normal of their vertices fits: beside collars of thin stems. By their indices.
    std::vector<std::size_t> creasesAt(const std::vector<std::size_t>& triangles) const {
        std::vector<std::size_t> creases;
        for (const std::size_t t : triangles) {
            const glm::dvec3 face = faceAt(t);
            if (!(glm::length(face) > 0)) continue;
            for (std::size_t i = t; i < t + 3; ++i)
                if (glm::dot(face, glm::dvec3(m_out->normals[m_out->indices[i]])) <= 0) creases.push_back(i);
        }
        return creases;
    }

    /// Such a corner has its triangle's own normal.
    void splitCreases(const std::vector<std::size_t>& creases) {
        if (creases.empty()) return;
        std::vector<std::uint32_t> uses(m_sources.size());
        for (const std::uint32_t v : m_out->indices) ++uses[v];
        for (const std::size_t i : creases) giveNormal(i, glm::normalize(faceAt(i - i % 3)), uses);
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

    /// Of indices of the new mesh.
    struct IndexRange {
        std::size_t first, end;
    };
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::uint32_t m_generation;
    const CMesh& m_mesh;
    const MeshPlan& m_plan;
    const OpenWalls& m_open;
    std::vector<std::uint8_t> m_dropped; ///< by triangle; bytes, which are faster than bits
    std::vector<std::uint32_t> m_place; ///< where vertices go
    std::uint32_t m_kept = 0;
    std::size_t m_nextIndex = 0;
    std::vector<IndexRange> m_keptIndices, m_newIndices; ///< of the open tubes
    std::shared_ptr<CMesh> m_out;
    std::unordered_map<std::uint32_t, std::uint32_t> m_common; ///< vertices that are also the generation's before
    std::vector<VertexSource> m_sources;
};

/// By generation.
std::vector<OpenWalls> openWallsOf(const CTree& tree, std::span<const StemMesh> stems, const CProgress& progress) {
    std::vector<Bearers> bearers;
    std::vector<OpenWalls> open;
    std::vector<std::array<std::size_t, 2>> all; // generation and which of its bearers
    for (std::size_t g = 0; g < stems.size(); ++g) {
        bearers.push_back(bearersOf(stems, g));
        open.push_back({bearers[g].tubes, std::vector<JoinedWalls>(bearers[g].tubes.size())});
        for (std::size_t i = 0; i < bearers[g].tubes.size(); ++i) all.push_back({g, i});
    }
    parallelFor(
        all.size(), kTubeGrain,
        [&](std::size_t begin, std::size_t end) {
            for (const auto& [g, i] : std::span(all).subspan(begin, end - begin))
                open[g].walls[i] = joinWalls(tree, g, stems, stems[g].plan.tubes[bearers[g].tubes[i]], bearers[g].branches[i], progress);
        },
        progress);
    return open;
}

/// By generation and tube.
std::vector<std::vector<bool>> standingInHoles(std::span<const StemMesh> stems, std::span<const OpenWalls> open) {
    std::vector<std::vector<bool>> stands;
    for (const StemMesh& own : stems) stands.emplace_back(own.plan.tubes.size());
    for (const OpenWalls& generation : open)
        for (const JoinedWalls& own : generation.walls)
            for (const BranchTube& branch : own.joined) stands[branch.generation][branch.tube] = true;
    return stands;
}

/// Whether a tube starts inside the wood as it is, not on its surface or at a fork.
bool startsInside(const CTree& tree, std::size_t g, const Tube& tube) {
    return tube.collarRings == 0 && !tube.startsAtFork() && (g > 0 || tree.generation(g).paths[tube.path].source >= 0);
}

void count(const CTree& tree, std::span<const StemMesh> stems, std::span<const OpenWalls> open, JoinedStems& joined) {
    for (std::size_t g = 0; g < stems.size(); ++g) {
        for (const Tube& tube : stems[g].plan.tubes) {
            joined.joined += tube.forked;
            joined.apart += tube.collarRings > 0;
            joined.withoutCollar += startsInside(tree, g, tube);
        }
        for (const JoinedWalls& own : open[g].walls) {
            joined.joined += own.joined.size();
            joined.apart -= own.joined.size();
        }
    }
}

/// The tubes that are no part of the wood they start in, where levels of detail join any.
std::vector<BranchTube> apartOf(const CTree& tree, std::span<const StemMesh> stems, const std::vector<std::vector<bool>>& standsInHole) {
    std::vector<BranchTube> apart;
    for (std::uint32_t g = 0; g < stems.size(); ++g) {
        const MeshPlan& plan = stems[g].plan;
        if (plan.detail->collarRings == 0) continue;
        for (std::uint32_t t = 0; t < plan.tubes.size(); ++t) {
            const Tube& tube = plan.tubes[t];
            if ((tube.collarRings > 0 && !standsInHole[g][t]) || startsInside(tree, g, tube)) apart.push_back({g, t});
        }
    }
    return apart;
}
} // namespace

JoinedStems joinStems(const CTree& tree, std::span<const StemMesh> stems, const CProgress& progress) {
    Wood wood{std::vector<std::shared_ptr<CMesh>>(stems.size()), std::vector<std::vector<VertexSource>>(stems.size())};
    const std::vector<OpenWalls> open = openWallsOf(tree, stems, progress);
    const auto standsInHole = standingInHoles(stems, open);
    parallelFor(
        stems.size(), 1,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t g = begin; g < end; ++g) CWoodWriter(static_cast<std::uint32_t>(g), stems, open[g], standsInHole[g]).write(wood, progress);
        },
        progress);
    JoinedStems joined;
    count(tree, stems, open, joined);
    const United united = uniteWithWood(tree, stems, apartOf(tree, stems, standsInHole), wood, progress);
    joined.meshes.assign(wood.meshes.begin(), wood.meshes.end());
    joined.sources = std::move(wood.sources);
    joined.joined += united.collars + united.others;
    joined.apart -= united.collars;
    joined.withoutCollar -= united.others;
    return joined;
}

} // namespace stromar
