#include "stem/Collar.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace stromar {

namespace {
constexpr double kFurthest = 0.9;     // of the branch's length: where its own rings have to start at the latest
constexpr double kHidden = 0.8;       // of its length: inside the wood so far a branch is not drawn
constexpr double kOfHelixTurn = 0.15; // of a helix's turn: how far a collar may rise while the branch turns away
constexpr int kStepsPerTurn = 12;     // along a helix, to find where it leaves the wood
constexpr double kMostSteps = 3;      // of them, ahead of where a line that bends leaves the wood
constexpr double kSteepest = 0.2;     // sine of the angle to the parent below which branches leave too slowly
constexpr int kEdgeHalvings = 8;          // to find the edge of the parent when a point misses it

/// Length of the drawn centre line.
double arcOf(const CSegment& segment) { return std::hypot(segment.length, 2 * std::numbers::pi * segment.turns * segment.helixRadius); }

/// Whether one of two loops has a side with all of the other beyond it, seen from where they look counter-clockwise.
bool isPartedBySideOf(const std::vector<glm::dvec3>& one, const std::vector<glm::dvec3>& other, const glm::dvec3& seenFrom) {
    for (std::size_t i = 0; i < one.size(); ++i) {
        const glm::dvec3 outwards = glm::cross(one[(i + 1) % one.size()] - one[i], seenFrom);
        if (std::ranges::all_of(other, [&](const glm::dvec3& point) { return glm::dot(point - one[i], outwards) > 0; })) return true;
    }
    return false;
}
} // namespace

double Collar::minGap() const {
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        gap = std::min(gap, glm::distance(points[i].position, points[(i + 1) % points.size()].position));
    return gap;
}

const Collar* CCollarMaker::make(const CStem& stem, const BranchBase& base, const CollarShape& shape, const ExitSearch& search) {
    m_base = base;
    m_shape = shape;
    m_search = search;
    const CStem* first = &stem; // that sits on the wood
    m_collar.standsOn = 1;
    m_leavesWood = false;
    for (std::size_t g = m_below.size(); g-- > 0; ++m_collar.standsOn) {
        standOn(g);
        if (const Collar* collar = makeOnAnyPath(*first)) return isApartFromCollarOf(*first) ? collar : nullptr;
        const CStem& parent = m_parents->stems[static_cast<std::size_t>(first->parent)];
        if (first->path > 0 || !isBelowItsWalls(parent, first->offset)) break;
        first = &parent;
    }
    return nullptr;
}

/// Whether the collar keeps off that of the stem below the branch, which sits on the same wood.
bool CCollarMaker::isApartFromCollarOf(const CStem& sitting) const {
    if (m_collar.standsOn == 1) return true;
    const StemMesh& bearing = *m_below[m_below.size() + 1 - m_collar.standsOn];
    const std::int32_t index = bearing.plan.tubeOfPath[sitting.firstPath];
    if (index < 0) return true;
    const Tube& tube = bearing.plan.tubes[static_cast<std::size_t>(index)];
    if (tube.collarRings == 0) return true;
    std::vector<glm::dvec3> own, other;
    glm::dvec3 outwards(0);
    for (const SurfacePoint& point : m_collar.points) {
        own.push_back(point.position);
        outwards += point.normal;
    }
    for (std::uint32_t i = 0; i < tube.points; ++i) other.emplace_back(bearing.mesh->positions[tube.firstVertex + i]);
    return isPartedBySideOf(own, other, outwards) || isPartedBySideOf(other, own, outwards);
}

bool CCollarMaker::hides(const CStem& stem, std::span<const CSegment> branch) {
    m_base.path = branch;
    const CStem* first = &stem; // that sits on the wood
    for (std::size_t g = m_below.size(); g-- > 0;) {
        standOn(g);
        if (surrounds(*first, m_tree.generation(g + 1).segments[first->firstSegment].position)) return true;
        const CStem& parent = m_parents->stems[static_cast<std::size_t>(first->parent)];
        if (first->path > 0 || !isBelowItsWalls(parent, first->offset)) break;
        first = &parent;
    }
    return false;
}

/// Whether the wood does on which a stem sits at a place. A hidden branch runs along it, so each of its segments lies inside the walls
/// as far up or down the wood.
bool CCollarMaker::surrounds(const CStem& sitting, const glm::dvec3& place) {
    const CStem& parent = m_parents->stems[static_cast<std::size_t>(sitting.parent)];
    const Frame& wood = m_parents->segmentAt(parent, sitting.path, sitting.position).frame;
    const double hidden = kHidden * m_base.path.back().end(), way = std::copysign(1.0, glm::dot(wood[2], m_base.path[0].tangent(0)));
    const double aside = 2 * sitting.parentRadius + glm::distance(m_base.path[0].position, place);
    return std::ranges::all_of(m_base.path, [&](const CSegment& segment) {
        if (segment.start >= hidden) return true;
        m_reach = m_reachAhead = segment.length + aside;
        collectAllTriangles(sitting, sitting.offset + way * segment.start);
        const double end = std::min(1.0, (hidden - segment.start) / segment.length);
        return isInside(segment.centre(end / 2), wood) && isInside(segment.centre(end), wood);
    });
}

/// Whether the walls lie around a place to all sides across the wood.
bool CCollarMaker::isInside(const glm::dvec3& place, const Frame& wood) const {
    if (place != glm::clamp(place, m_low, m_high)) return false;
    const std::array ways{wood[0], -wood[0], wood[1], -wood[1]};
    return std::ranges::all_of(ways, [&](const glm::dvec3& way) {
        int walls = 0; // left more often than entered
        for (const Triangle& triangle : m_triangles)
            if (const auto crossing = crossingOf(triangle, place, way, true)) walls += crossing->leaves ? 1 : -1;
        return walls > 0;
    });
}

void CCollarMaker::standOn(std::size_t generation) {
    m_parents = &m_tree.generation(generation);
    m_wood = m_below[generation];
}

/// Whether a stem is still inside the wood it grows on, or not drawn at all, so far along.
bool CCollarMaker::isBelowItsWalls(const CStem& parent, double offset) const {
    const std::int32_t index = m_wood->plan.tubeOfPath[parent.firstPath];
    return index < 0 || offset < placeOf(*m_wood->plan.ringsOf(m_wood->plan.tubes[static_cast<std::size_t>(index)]));
}

/// Of a ring, metres from its stem's base.
double CCollarMaker::placeOf(const Ring& ring) const {
    const CSegment& segment = m_parents->segments[ring.segment];
    return segment.start + ring.t * segment.length;
}

/// At a fork a branch may leave the wood through the wall of the limb beside its own.
const Collar* CCollarMaker::makeOnAnyPath(const CStem& stem) {
    const CStem& parent = m_parents->stems[static_cast<std::size_t>(stem.parent)];
    const std::uint32_t own = m_wood->plan.drawnPath(*m_parents, parent, stem.path);
    if (const Collar* collar = makeOn(own, stem)) return collar;
    for (std::uint32_t path = 0; path < parent.pathCount; ++path) {
        if (path == own || !partAt(stem, parent, path)) continue;
        if (const Collar* collar = makeOn(path, stem)) return collar;
    }
    return nullptr;
}

/// Likewise: the walls of all paths that a branch may be inside of.
void CCollarMaker::collectAllTriangles(const CStem& sitting, double offset) {
    const CStem& parent = m_parents->stems[static_cast<std::size_t>(sitting.parent)];
    const std::uint32_t own = m_wood->plan.drawnPath(*m_parents, parent, sitting.path);
    clearTriangles();
    for (std::uint32_t path = 0; path < parent.pathCount; ++path)
        if (path == own || partAt(sitting, parent, path)) addTriangles(parent.firstPath + path, offset);
}

/// Whether another path parts from a branch's own at a fork and still runs beside it where the branch sits.
bool CCollarMaker::partAt(const CStem& branch, const CStem& parent, std::uint32_t other) const {
    const CPath &own = m_parents->paths[parent.firstPath + branch.path], &beside = m_parents->paths[parent.firstPath + other];
    if (other == branch.path) return false;
    const bool isSource = own.source == static_cast<std::int32_t>(other), isClone = beside.source == static_cast<std::int32_t>(branch.path);
    if (!isSource && !isClone && (beside.source != own.source || beside.firstPosition != own.firstPosition)) return false;
    const std::uint32_t clone = isSource ? branch.path : other, node = m_parents->paths[parent.firstPath + clone].firstPosition;
    return branch.position + 1 >= node && (branch.position <= node || branch.offset <= endOfLimb(parent.firstPath + clone));
}

/// How far along its stem the rings of the fork reach that a path starts at, metres; 0 when it is drawn otherwise, without an end when another is drawn for it.
double CCollarMaker::endOfLimb(std::uint32_t path) const {
    const std::int32_t index = m_wood->plan.tubeOfPath[path];
    if (index < 0) return std::numeric_limits<double>::infinity();
    const Tube& tube = m_wood->plan.tubes[static_cast<std::size_t>(index)];
    if (!tube.startsAtFork()) return 0;
    const Fork& fork = m_wood->plan.forksOf(tube)[0];
    return placeOf(m_wood->plan.ringsOf(tube)[fork.ring + fork.rings - 1]);
}

/// `stem` is the branch, or, on wood further down, the one that sits there.
const Collar* CCollarMaker::makeOn(std::uint32_t path, const CStem& stem) {
    const CStem& parent = m_parents->stems[static_cast<std::size_t>(stem.parent)];
    const glm::dvec3 woodAxis = m_parents->segmentAt(parent, stem.path, stem.position).frame[2];
    setReach(stem, woodAxis);
    clearTriangles();
    addTriangles(parent.firstPath + path, stem.offset);
    if (m_triangles.empty()) return nullptr;
    const glm::dvec3 aside = asideOf(stem);
    const auto exit = findExit(aside);
    if (!exit) return nullptr;
    m_leavesWood = true;
    const std::optional<double> highest = pressOn(*exit, woodAxis);
    if (!highest) return nullptr;
    const double rise = *highest + m_shape.above * m_base.radius + glm::length(aside); // its own rings lie beside the collar
    if (exit->helixArc > 0 && rise > kOfHelixTurn * exit->helixArc) return nullptr;
    m_collar.clear = exit->along + rise * exit->rise;
    return m_collar.clear < kFurthest * m_base.path.back().end() ? &m_collar : nullptr;
}

/// Lays the points around where the branch leaves the wood; how far above that the highest lies, metres.
std::optional<double> CCollarMaker::pressOn(const Exit& exit, const glm::dvec3& woodAxis) {
    const glm::dvec3 axis = exit.frame[2], sideways = glm::cross(woodAxis, axis);
    const double sine = glm::length(sideways);
    const glm::dvec3 across = sine > 1e-6 ? sideways / sine : exit.frame[0];
    const glm::dvec3 along = glm::cross(axis, across);
    m_collar.points.clear();
    double highest = 0;
    for (std::uint32_t i = 0; i < m_base.points; ++i) {
        const double angle = 2 * std::numbers::pi * i / m_base.points;
        const glm::dvec3 out = std::cos(angle) * exit.frame[0] + std::sin(angle) * exit.frame[1];
        const auto hit = nearestExit(
            exit, m_shape.width * m_base.radius * (kAcross * glm::dot(out, across) * across + kAlong * glm::dot(out, along) * along));
        if (!hit) return {};
        highest = std::max(highest, glm::dot(hit->point.position - exit.centre, axis));
        m_collar.points.push_back(hit->point);
    }
    return highest;
}

/// Follows the branch's centre line, or one beside it, out of the wood.
std::optional<CCollarMaker::Exit> CCollarMaker::findExit(const glm::dvec3& aside) const {
    std::optional<Exit> last; // where it would be left on the way straight on
    for (const CSegment& segment : m_base.path) {
        const int steps = segment.helixRadius > 0 ? kStepsPerTurn : 1;
        for (int step = 0; step < steps; ++step) {
            const double t = double(step) / steps, arc = arcOf(segment), way = arc / steps;
            const double along = segment.start + t * segment.length;
            if (along > kFurthest * m_base.path.back().end()) return {};
            const glm::dvec3 centre = segment.centre(t) + aside, axis = segment.tangent(t);
            const auto hit = lastExit(centre, axis);
            if (!hit && last) return last; // the line bent out of the wood before
            if (!hit || hit->distance > kMostSteps * way) {
                last.reset();
                continue;
            }
            last = {centre, transported(segment.frame, axis), along, segment.length / arc, segment.helixRadius > 0 ? arc : 0};
            // The next step turns at most a little away from this one's direction.
            if (hit->distance <= 1.1 * way) return last;
        }
    }
    return {};
}

/// From the axis of the branch's parent, where it starts, to the middle of what is drawn there, if that is looked for; 0 when it is further
/// than the wood is thick.
glm::dvec3 CCollarMaker::asideOf(const CStem& stem) const {
    if (!m_search.aside || m_collar.standsOn > 1) return glm::dvec3(0);
    const glm::dvec3 way = m_walls->middleAt(*m_wood->mesh, stem.offset) - m_base.path[0].position;
    return glm::length(way) < stem.parentRadius + m_base.radius ? way : glm::dvec3(0);
}

void CCollarMaker::setReach(const CStem& stem, const glm::dvec3& woodAxis) {
    const double sine = std::max(kSteepest, glm::length(glm::cross(woodAxis, m_base.path[0].tangent(0))));
    const CSegment& sitting = m_tree.generation(m_below.size() + 1 - m_collar.standsOn).segments[stem.firstSegment];
    m_reach = (1.2 * stem.parentRadius + 2 * kAlong * m_base.radius) / sine + glm::distance(m_base.path[0].position, sitting.position);
    m_reachAhead = m_search.ahead * m_reach;
}

void CCollarMaker::clearTriangles() {
    m_triangles.clear();
    m_low = glm::dvec3(std::numeric_limits<double>::infinity());
    m_high = -m_low;
}

/// The walls of a path's tube that a branch at a place along the parent can meet; none of one that is not drawn.
void CCollarMaker::addTriangles(std::uint32_t path, double offset) {
    const std::int32_t tubeIndex = m_wood->plan.tubeOfPath[path];
    if (tubeIndex < 0) return;
    const Tube& tube = m_wood->plan.tubes[static_cast<std::size_t>(tubeIndex)];
    if (m_wallsOf != &tube) { // siblings follow each other
        m_walls.emplace(*m_parents, m_wood->plan, tube);
        m_wallsOf = &tube;
    }
    const CMesh& mesh = *m_wood->mesh;
    const auto [begin, end] = m_walls->between(offset - m_reach, offset + m_reachAhead);
    for (std::size_t i = begin; i < end; i += 3) {
        const std::uint32_t* v = &mesh.indices[i];
        const std::array corners{glm::dvec3(mesh.positions[v[0]]), glm::dvec3(mesh.positions[v[1]]), glm::dvec3(mesh.positions[v[2]])};
        m_triangles.push_back({corners[0], corners[1] - corners[0], corners[2] - corners[0], i});
        for (const glm::dvec3& corner : corners) {
            m_low = glm::min(m_low, corner);
            m_high = glm::max(m_high, corner);
        }
    }
}

/// Möller & Trumbore 1997. Of lines that leave the wood, or also of those that enter it.
std::optional<CCollarMaker::Crossing> CCollarMaker::crossingOf(const Triangle& triangle, const glm::dvec3& origin, const glm::dvec3& direction,
                                                               bool entering) {
    constexpr double kEdge = 1e-9; // neighbours share their edge, so nothing slips through between them
    const glm::dvec3 p = glm::cross(direction, triangle.edge2);
    const double determinant = glm::dot(triangle.edge1, p);
    if (entering ? determinant == 0 : determinant >= 0) return {};
    const glm::dvec3 toOrigin = origin - triangle.corner;
    const double u = glm::dot(toOrigin, p) / determinant;
    if (u < -kEdge || u > 1 + kEdge) return {};
    const glm::dvec3 q = glm::cross(toOrigin, triangle.edge1);
    const double v = glm::dot(direction, q) / determinant;
    if (v < -kEdge || u + v > 1 + kEdge) return {};
    const double distance = glm::dot(triangle.edge2, q) / determinant;
    if (distance <= 0) return {};
    return Crossing{distance, u, v, determinant < 0};
}

/// Where a line leaves the wood for the last time.
std::optional<CCollarMaker::Hit> CCollarMaker::lastExit(const glm::dvec3& origin, const glm::dvec3& direction) const {
    if (glm::distance(origin, glm::clamp(origin, m_low, m_high)) > m_reach + m_reachAhead) return {};
    const Triangle* left = nullptr;
    Crossing last{};
    for (const Triangle& triangle : m_triangles) {
        const auto crossing = crossingOf(triangle, origin, direction, false);
        if (!crossing || crossing->distance <= last.distance || crossing->distance > m_reach + m_reachAhead) continue;
        left = &triangle;
        last = *crossing;
    }
    if (!left) return {};
    return Hit{last.distance, surfaceAt(*left, last.u, last.v)};
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
    const auto normal = [&](std::size_t corner) { return glm::dvec3(m_wood->mesh->normals[m_wood->mesh->indices[triangle.firstIndex + corner]]); };
    return {triangle.corner + u * triangle.edge1 + v * triangle.edge2,
            glm::normalize((1 - u - v) * normal(0) + u * normal(1) + v * normal(2)), triangle.firstIndex};
}

} // namespace stromar
