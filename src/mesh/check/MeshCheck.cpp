#include "stromar/mesh/check/MeshCheck.h"
#include "Groups.h"
#include "stem/TubeWalls.h"
#include "stromar/mesh/Weld.h"
#include "stromar/util/DisjointSets.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <optional>
#include <set>

namespace stromar {

namespace {
constexpr double kReach = 2; // of a collar's distance from its branch's base, along the parent, to what is nearest to it
constexpr MeshCheck kChecks[] = {
    {"bad numbers", &MeshFaults::badNumbers},    {"bad normals", &MeshFaults::badNormals},
    {"bad indices", &MeshFaults::badIndices},    {"unused vertices", &MeshFaults::unused},
    {"flat triangles", &MeshFaults::flat},       {"open surfaces", &MeshFaults::open},
    {"tangled surfaces", &MeshFaults::tangled},  {"tilted normals", &MeshFaults::tilted},
    {"floating collars", &MeshFaults::floating}, {"buried collars", &MeshFaults::buried},
};

/// A part of a mesh that is one surface.
struct Part {
    std::size_t firstVertex, vertexCount, firstIndex, indexCount;
};

bool isNumber(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void checkVertices(const CMesh& mesh, MeshFaults& faults) {
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        const glm::vec2 at = mesh.texCoords[v];
        const bool numbers =
            isNumber(mesh.positions[v]) && isNumber(mesh.normals[v]) && std::isfinite(at.x) && std::isfinite(at.y);
        if (!numbers) ++faults.badNumbers;
        if (numbers && std::abs(glm::length(glm::dvec3(mesh.normals[v])) - 1) > 1e-3) ++faults.badNormals;
    }
}

void checkTriangle(const CMesh& mesh, const std::uint32_t* corners, MeshFaults& faults) {
    const glm::dvec3 a(mesh.positions[corners[0]]), b(mesh.positions[corners[1]]), c(mesh.positions[corners[2]]);
    const glm::dvec3 face = glm::cross(b - a, c - a);
    if (!(glm::length(face) > 0)) {
        ++faults.flat;
        return;
    }
    const auto tilted = [&](int i) { return glm::dot(face, glm::dvec3(mesh.normals[corners[i]])) <= 0; };
    if (tilted(0) || tilted(1) || tilted(2)) ++faults.tilted;
}

/// False when an index lies outside.
bool checkTriangles(const CMesh& mesh, const Part& part, MeshFaults& faults) {
    std::vector<bool> used(part.vertexCount, false);
    const std::size_t bad = faults.badIndices;
    for (std::size_t i = part.firstIndex; i < part.firstIndex + part.indexCount; i += 3) {
        const std::uint32_t* corners = &mesh.indices[i];
        const auto inside = [&](int c) {
            return corners[c] >= part.firstVertex && corners[c] - part.firstVertex < part.vertexCount;
        };
        if (!inside(0) || !inside(1) || !inside(2)) {
            ++faults.badIndices;
            continue;
        }
        for (int c = 0; c < 3; ++c) used[corners[c] - part.firstVertex] = true;
        checkTriangle(mesh, corners, faults);
    }
    faults.unused += static_cast<std::size_t>(std::ranges::count(used, false));
    return faults.badIndices == bad;
}

/// Calls open(v) for each side of a triangle, from the vertex v of such a number, that no other triangle has the other way round, and
/// tangled(v) for each that another has too.
template <typename Open, typename Tangled>
void forEachBadEdge(std::span<const std::uint32_t> indices, const std::vector<std::uint32_t>& number, std::uint32_t firstVertex, Open&& open, Tangled&& tangled) {
    const auto at = [&](std::size_t i) { return number[indices[i] - firstVertex]; };
    const auto next = [&](std::size_t i) { return at(i % 3 == 2 ? i - 2 : i + 1); };
    CGroups<std::uint32_t> ends(number.empty() ? 0 : *std::ranges::max_element(number) + std::size_t{1}, indices.size(), at, next);
    for (std::size_t v = 0; v < ends.count(); ++v) std::ranges::sort(ends.of(v));
    for (std::uint32_t v = 0; v < ends.count(); ++v) {
        const std::span<const std::uint32_t> own = ends.of(v);
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (i > 0 && own[i] == own[i - 1]) tangled(v);
            if (!std::ranges::binary_search(ends.of(own[i]), v)) open(v);
        }
    }
}

void checkEdges(const CMesh& mesh, const Part& part, MeshFaults& faults) {
    const auto number = weld(std::span(mesh.positions).subspan(part.firstVertex, part.vertexCount), std::vector<std::uint32_t>(part.vertexCount));
    bool open = false, tangled = false;
    forEachBadEdge(
        std::span(mesh.indices).subspan(part.firstIndex, part.indexCount), number, static_cast<std::uint32_t>(part.firstVertex),
        [&](std::uint32_t) { open = true; }, [&](std::uint32_t) { tangled = true; });
    faults.open += open;
    faults.tangled += tangled;
}

/// Counts the surfaces, and those that are open or tangled, of vertices that are one where they have the same number.
void checkSurfaces(const CMesh& mesh, const std::vector<std::uint32_t>& number, MeshFaults& faults) {
    CDisjointSets surfaces(number.empty() ? 0 : *std::ranges::max_element(number) + 1);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t c = 1; c < 3; ++c) surfaces.join(number[mesh.indices[i]], number[mesh.indices[i + c]]);
    std::set<std::uint32_t> open, tangled;
    forEachBadEdge(
        mesh.indices, number, 0, [&](std::uint32_t v) { open.insert(surfaces.of(v)); }, [&](std::uint32_t v) { tangled.insert(surfaces.of(v)); });
    faults.surfaces = surfaces.count();
    faults.open = open.size();
    faults.tangled = tangled.size();
}

/// By generation, for each vertex: of which of all closed surfaces it is.
std::vector<std::vector<std::uint32_t>> closedSurfaces(std::span<const StemMesh> stems) {
    std::vector<std::vector<std::uint32_t>> all;
    std::uint32_t count = 0;
    for (const StemMesh& own : stems) {
        std::vector<std::uint32_t>& surfaces = all.emplace_back();
        for (const std::span<const Tube> tubes : surfacesOf(own.plan)) {
            surfaces.resize(tubes.back().firstVertex + tubes.back().vertexCount(), count);
            ++count;
        }
    }
    return all;
}

/// How far a point lies outside a surface, metres; negative inside.
double heightAbove(const CMesh& mesh, std::initializer_list<std::pair<std::size_t, std::size_t>> ranges, const glm::dvec3& p) {
    double best = std::numeric_limits<double>::infinity(), height = 0;
    const auto look = [&](std::size_t first) {
        const auto corner = [&](std::size_t c) { return glm::dvec3(mesh.positions[mesh.indices[first + c]]); };
        const glm::dvec3 a = corner(0), b = corner(1), c = corner(2), away = p - nearestOnTriangle(p, a, b, c);
        const double squared = glm::dot(away, away);
        if (squared >= best) return;
        best = squared;
        height = std::copysign(std::sqrt(squared), glm::dot(away, glm::cross(b - a, c - a)));
    };
    for (const auto& [begin, end] : ranges)
        for (std::size_t i = begin; i < end; i += 3) look(i);
    return height;
}

/// The walls of the tube that was asked for last: siblings follow each other.
class CWallsBelow {
public:
    const CTubeWalls& of(const CGeneration& generation, const MeshPlan& plan, const Tube& tube) {
        if (m_tube != &tube) m_walls.emplace(generation, plan, tube);
        m_tube = &tube;
        return *m_walls;
    }

private:
    std::optional<CTubeWalls> m_walls;
    const Tube* m_tube = nullptr;
};

void checkCollar(const CTree& tree, std::size_t generation, const StemMesh& stems, const Tube& tube, std::span<const StemMesh> all,
                 CWallsBelow& known, MeshFaults& faults) {
    const CStem& stem = tree.generation(generation).stems[tube.stem];
    if (tube.collarRings == 0) return;
    ++faults.attached;
    const std::size_t below = generation - tube.standsOn;
    const CStem& first = tree.ancestor(generation, stem, tube.standsOn - 1); // that sits on this wood
    const glm::dvec3 base = tree.generation(below + 1).segments[first.firstSegment].position;
    double reach = 0;
    for (std::uint32_t i = 0; i < tube.points; ++i)
        reach = std::max(reach, kReach * glm::distance(base, glm::dvec3(stems.mesh->positions[tube.firstVertex + i])));
    const StemMesh& bearers = all[below];
    const Tube& wood = bearers.plan.bearerOf(stems.plan, tube);
    const CTubeWalls& walls = known.of(tree.generation(below), bearers.plan, wood);
    const auto near = walls.between(first.offset - reach, first.offset + reach);
    const std::pair lids(walls.end(), wood.firstIndex + wood.indexCount());
    const std::pair whole(wood.firstIndex, wood.firstIndex + wood.indexCount());
    const glm::dvec3 at = glm::abs(glm::dvec3(stems.mesh->positions[tube.firstVertex]));
    const double rounding = 1e-6 * std::max({at.x, at.y, at.z});
    const auto floats = [&](double height) { return height > kMaxFloating * stem.radius + rounding; };
    const auto sinks = [&](double height) { return height < -kMaxBuried * stem.radius - rounding; };
    bool floating = false, buried = false;
    for (std::uint32_t i = 0; i < tube.points; ++i) {
        const glm::dvec3 point(stems.mesh->positions[tube.firstVertex + i]);
        double height = heightAbove(*bearers.mesh, {near, lids}, point);
        if (floats(height) || sinks(height)) height = heightAbove(*bearers.mesh, {whole}, point); // of wood that winds, other parts lie nearer
        floating = floating || floats(height);
        buried = buried || sinks(height);
    }
    faults.floating += floating;
    faults.buried += buried;
}
} // namespace

bool MeshFaults::sound() const {
    return std::ranges::all_of(kChecks, [&](const MeshCheck& check) { return this->*check.count == 0; });
}

std::span<const MeshCheck> meshChecks() { return kChecks; }

MeshFaults checkStems(const CTree& tree, int generation, const StemMesh& stems, std::span<const StemMesh> all) {
    MeshFaults faults{0, stems.mesh->vertexCount(), stems.mesh->triangleCount()};
    checkVertices(*stems.mesh, faults);
    CWallsBelow walls;
    for (const std::span<const Tube> tubes : surfacesOf(stems.plan)) {
        const Tube &first = tubes.front(), &last = tubes.back();
        const Part part{first.firstVertex, last.firstVertex + last.vertexCount() - first.firstVertex, first.firstIndex,
                        last.firstIndex + last.indexCount() - first.firstIndex};
        if (checkTriangles(*stems.mesh, part, faults)) checkEdges(*stems.mesh, part, faults);
        ++faults.surfaces;
    }
    if (!all.empty() && generation > 0)
        for (const Tube& tube : stems.plan.tubes) {
            faults.attached += tube.forked;
            checkCollar(tree, static_cast<std::size_t>(generation), stems, tube, all, walls, faults);
        }
    return faults;
}

MeshFaults checkSolid(const CMesh& solid) {
    MeshFaults faults{1, solid.vertexCount(), solid.triangleCount()};
    const Part whole{0, solid.vertexCount(), 0, solid.indices.size()};
    checkVertices(solid, faults);
    if (checkTriangles(solid, whole, faults)) checkEdges(solid, whole, faults);
    faults.tilted = 0;
    return faults;
}

MeshFaults checkJoined(const JoinedStems& joined, std::span<const StemMesh> stems) {
    CMesh all;
    std::vector<std::uint32_t> surfaces; // of the vertices: which closed surface they were part of
    const std::vector<std::vector<std::uint32_t>> closed = closedSurfaces(stems);
    for (std::size_t g = 0; g < joined.meshes.size(); ++g) {
        const CMesh& mesh = *joined.meshes[g];
        const auto first = static_cast<std::uint32_t>(all.vertexCount());
        const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
        append(all.positions, mesh.positions);
        append(all.normals, mesh.normals);
        append(all.texCoords, mesh.texCoords);
        for (const std::uint32_t v : mesh.indices) all.indices.push_back(first + v);
        for (const VertexSource& source : joined.sources[g]) surfaces.push_back(closed[source.generation][source.vertex]);
    }
    MeshFaults faults{0, all.vertexCount(), all.triangleCount()};
    checkVertices(all, faults);
    if (checkTriangles(all, {0, all.vertexCount(), 0, all.indices.size()}, faults))
        checkSurfaces(all, weld(all.positions, surfaces), faults);
    return faults;
}

MeshFaults checkLeaves(const CMesh& leaves) {
    MeshFaults faults{0, leaves.vertexCount(), leaves.triangleCount()};
    checkVertices(leaves, faults);
    checkTriangles(leaves, {0, leaves.vertexCount(), 0, leaves.indices.size()}, faults);
    return faults;
}

} // namespace stromar
