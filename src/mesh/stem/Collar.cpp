#include "stem/Collar.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace stromar {

namespace {
constexpr double kFurthest = 0.6;     // of the branch's length: where its own rings have to start at the latest
constexpr double kOfHelixTurn = 0.15; // of a helix's turn: how far a collar may rise while the branch turns away
constexpr int kStepsPerTurn = 12;     // along a helix, to find where it leaves the wood
constexpr double kSteepest = 0.2;     // sine of the angle to the parent below which branches leave too slowly
constexpr double kAboveSurface = 0.3; // radii between the collar's highest point and the first own ring
constexpr int kEdgeHalvings = 8;          // to find the edge of the parent when a point misses it

/// Length of the drawn centre line.
double arcOf(const CSegment& segment) { return std::hypot(segment.length, 2 * std::numbers::pi * segment.turns * segment.helixRadius); }
} // namespace

double Collar::minGap() const {
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        gap = std::min(gap, glm::distance(points[i].position, points[(i + 1) % points.size()].position));
    return gap;
}

/// At a fork a branch may leave the wood through the wall of the limb beside its own.
const Collar* CCollarMaker::make(const CStem& stem, std::span<const CSegment> branch, double radius,
                                 std::uint32_t points) {
    const CStem& parent = m_parents.stems[static_cast<std::size_t>(stem.parent)];
    if (const Collar* collar = makeOn(stem.path, stem, branch, radius, points)) return collar;
    for (std::uint32_t path = 0; path < parent.pathCount; ++path) {
        if (!partAt(stem, parent, path)) continue;
        if (const Collar* collar = makeOn(path, stem, branch, radius, points)) return collar;
    }
    return nullptr;
}

/// Whether another path parts from a branch's own at a fork where the segment begins or ends that it sits on.
bool CCollarMaker::partAt(const CStem& branch, const CStem& parent, std::uint32_t other) const {
    const CPath &own = m_parents.paths[parent.firstPath + branch.path], &beside = m_parents.paths[parent.firstPath + other];
    const auto isAt = [&](const CPath& clone) { return clone.firstPosition == branch.position || clone.firstPosition == branch.position + 1; };
    if (other == branch.path) return false;
    if (own.source == static_cast<std::int32_t>(other)) return isAt(own);
    const bool isClone = beside.source == static_cast<std::int32_t>(branch.path);
    return (isClone || (beside.source == own.source && beside.firstPosition == own.firstPosition)) && isAt(beside);
}

const Collar* CCollarMaker::makeOn(std::uint32_t path, const CStem& stem, std::span<const CSegment> branch, double radius, std::uint32_t points) {
    const CStem& parent = m_parents.stems[static_cast<std::size_t>(stem.parent)];
    const CSegment& wood = m_parents.segmentAt(parent, stem.path, stem.position);
    m_reach = reachOf(stem, wood.frame[2], branch[0].tangent(0), radius);
    if (!collectTriangles(parent.firstPath + path, stem.offset)) return nullptr;
    const auto exit = findExit(branch);
    if (!exit) return nullptr;

    const glm::dvec3 axis = exit->frame[2];
    const glm::dvec3 sideways = glm::cross(wood.frame[2], axis);
    const double sine = glm::length(sideways);
    const glm::dvec3 across = sine > 1e-6 ? sideways / sine : exit->frame[0];
    const glm::dvec3 along = glm::cross(axis, across);
    m_collar.points.clear();
    double highest = 0;
    for (std::uint32_t i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        const glm::dvec3 out = std::cos(angle) * exit->frame[0] + std::sin(angle) * exit->frame[1];
        const auto hit = nearestExit(
            *exit, radius * (kAcross * glm::dot(out, across) * across + kAlong * glm::dot(out, along) * along));
        if (!hit) return nullptr;
        highest = std::max(highest, glm::dot(hit->point.position - exit->centre, axis));
        m_collar.points.push_back(hit->point);
    }
    const double rise = highest + kAboveSurface * radius;
    if (exit->helixArc > 0 && rise > kOfHelixTurn * exit->helixArc) return nullptr;
    m_collar.clear = exit->along + rise * exit->rise;
    return m_collar.clear < kFurthest * branch.back().end() ? &m_collar : nullptr;
}

/// Follows the branch's centre line out of the wood.
std::optional<CCollarMaker::Exit> CCollarMaker::findExit(std::span<const CSegment> branch) const {
    for (const CSegment& segment : branch) {
        const int steps = segment.helixRadius > 0 ? kStepsPerTurn : 1;
        for (int step = 0; step < steps; ++step) {
            const double t = double(step) / steps;
            const double along = segment.start + t * segment.length;
            if (along > kFurthest * branch.back().end()) return {};
            const glm::dvec3 centre = segment.centre(t), axis = segment.tangent(t);
            const auto hit = lastExit(centre, axis);
            // The next step turns at most a little away from this one's direction.
            if (hit && hit->distance <= 1.1 * arcOf(segment) / steps)
                return Exit{centre, transported(segment.frame, axis), along, segment.length / arcOf(segment),
                            segment.helixRadius > 0 ? arcOf(segment) : 0};
        }
    }
    return {};
}

double CCollarMaker::reachOf(const CStem& stem, const glm::dvec3& parentAxis, const glm::dvec3& axis,
                             double radius) const {
    const double sine = std::max(kSteepest, glm::length(glm::cross(parentAxis, axis)));
    return (1.2 * stem.parentRadius + 2 * kAlong * radius) / sine;
}

/// The walls of a path's tube that a branch at a place along the parent can meet.
bool CCollarMaker::collectTriangles(std::uint32_t path, double offset) {
    m_triangles.clear();
    const std::int32_t tubeIndex = m_mesh.plan.tubeOfPath[path];
    if (tubeIndex < 0) return false;
    if (m_wallsOf != tubeIndex) { // siblings follow each other
        m_walls.emplace(m_parents, m_mesh.plan, m_mesh.plan.tubes[static_cast<std::size_t>(tubeIndex)]);
        m_wallsOf = tubeIndex;
    }
    const CMesh& mesh = *m_mesh.mesh;
    const auto [begin, end] = m_walls->between(offset - m_reach, offset + m_reach);
    for (std::size_t i = begin; i < end; i += 3) {
        const std::uint32_t* v = &mesh.indices[i];
        const glm::dvec3 corner(mesh.positions[v[0]]);
        m_triangles.push_back({corner,
                               glm::dvec3(mesh.positions[v[1]]) - corner,
                               glm::dvec3(mesh.positions[v[2]]) - corner,
                               i});
    }
    return !m_triangles.empty();
}

/// Where a line leaves the wood for the last time (Möller & Trumbore 1997).
std::optional<CCollarMaker::Hit> CCollarMaker::lastExit(const glm::dvec3& origin, const glm::dvec3& direction) const {
    constexpr double kEdge = 1e-9; // neighbours share their edge, so nothing slips through between them
    const Triangle* last = nullptr;
    double distance = 0, lastU = 0, lastV = 0;
    for (const Triangle& triangle : m_triangles) {
        const glm::dvec3 p = glm::cross(direction, triangle.edge2);
        const double determinant = glm::dot(triangle.edge1, p);
        if (determinant >= 0) continue; // seen from outside: the line enters here
        const glm::dvec3 toOrigin = origin - triangle.corner;
        const double u = glm::dot(toOrigin, p) / determinant;
        if (u < -kEdge || u > 1 + kEdge) continue;
        const glm::dvec3 q = glm::cross(toOrigin, triangle.edge1);
        const double v = glm::dot(direction, q) / determinant;
        if (v < -kEdge || u + v > 1 + kEdge) continue;
        const double here = glm::dot(triangle.edge2, q) / determinant;
        if (here <= distance || here > 2 * m_reach) continue;
        last = &triangle;
        distance = here;
        lastU = u;
        lastV = v;
    }
    if (!last) return {};
    return Hit{distance, surfaceAt(*last, lastU, lastV)};
}

/// The same for a point beside the centre line; one that misses the parent is drawn in until it meets its edge.
std::optional<CCollarMaker::Hit> CCollarMaker::nearestExit(const Exit& exit, const glm::dvec3& offset) const {
    const glm::dvec3 axis = exit.frame[2], origin = exit.centre - m_reach * axis; // also where the side is outside
    if (auto hit = lastExit(origin + offset, axis)) return hit;
    std::optional<Hit> best;
    double inside = 0, outside = 1;
    for (int i = 0; i < kEdgeHalvings; ++i) {
        const double half = (inside + outside) / 2;
        if (auto hit = lastExit(origin + half * offset, axis)) {
            best = hit;
            inside = half;
        } else
            outside = half;
    }
    return best;
}

SurfacePoint CCollarMaker::surfaceAt(const Triangle& triangle, double u, double v) const {
    const auto normal = [&](std::size_t corner) { return glm::dvec3(m_mesh.mesh->normals[m_mesh.mesh->indices[triangle.firstIndex + corner]]); };
    return {triangle.corner + u * triangle.edge1 + v * triangle.edge2,
            glm::normalize((1 - u - v) * normal(0) + u * normal(1) + v * normal(2)), triangle.firstIndex};
}

} // namespace stromar
