#include "join/WoodPatch.h"
#include "join/Corners.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace stromar {

namespace {
constexpr int kMaxCuts = 200;      // of edges, on the way between two points
constexpr double kLeastStep = 1e-12; // metres
constexpr double kDetour = 15;      // the longest way between two points, over their distance
constexpr double kLeastFold = 0.5; // cosine of the turn of a triangle whose corner is moved
constexpr double kRounded = 1e-6;  // of what a place is from the origin
constexpr double kBulge = 2.5;     // how far from its middle what a loop bounds may reach, over the loop itself

std::uint32_t cornerAt(const CWoodPatch::Triangle& triangle, CWoodPatch::Index point) {
    return static_cast<std::uint32_t>(std::ranges::find(triangle.points, point) - triangle.points.begin());
}

JoinedWalls::Vertex mixed(const JoinedWalls::Vertex& a, const JoinedWalls::Vertex& b, const JoinedWalls::Vertex& c, const glm::dvec3& shares) {
    const glm::vec3 s(shares);
    JoinedWalls::Vertex own = shares.x >= shares.y && shares.x >= shares.z ? a : shares.y >= shares.z ? b : c;
    const glm::vec3 normal = s.x * a.normal + s.y * b.normal + s.z * c.normal;
    if (glm::length(normal) > 0) own.normal = glm::normalize(normal);
    own.texCoord = s.x * a.texCoord + s.y * b.texCoord + s.z * c.texCoord;
    return own;
}
} // namespace

CWoodPatch::CWoodPatch(std::vector<Vertex> vertices, std::vector<Index> pointOf, std::vector<Triangle> triangles)
    : m_vertices(std::move(vertices)), m_pointOf(std::move(pointOf)), m_triangles(std::move(triangles)) {
    const std::size_t points = m_pointOf.empty() ? 0 : *std::ranges::max_element(m_pointOf) + std::size_t{1};
    m_places.resize(points);
    m_sources.resize(points);
    m_around.resize(points);
    for (std::size_t v = m_vertices.size(); v-- > 0;) {
        m_places[m_pointOf[v]] = m_vertices[v].value.position;
        m_sources[m_pointOf[v]] = m_vertices[v].value.source;
    }
    for (Index t = 0; t < m_triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) {
            m_triangles[t].points[c] = m_pointOf[m_triangles[t].vertices[c]];
            m_around[m_triangles[t].points[c]].push_back(t);
        }
    m_oldCount = m_triangles.size();
    mark();
}

glm::dvec3 CWoodPatch::faceOf(const Triangle& triangle) const {
    const glm::dvec3 a = place(triangle.points[0]);
    return glm::cross(place(triangle.points[1]) - a, place(triangle.points[2]) - a);
}

glm::dvec3 CWoodPatch::normalAt(Index point) const {
    glm::dvec3 sum(0);
    forEachAround(point, [&](Index t) { sum += faceOf(m_triangles[t]); });
    return sum;
}

CWoodPatch::Index CWoodPatch::beyond(const Side& side) const {
    const Triangle& own = m_triangles[side.triangle];
    const Index from = own.points[side.corner], to = own.points[after(side.corner)];
    Index other = kNone;
    forEachAround(to, [&](Index t) {
        for (std::uint32_t c = 0; c < 3; ++c)
            if (m_triangles[t].points[c] == to && m_triangles[t].points[after(c)] == from) other = t;
    });
    return other;
}

void CWoodPatch::select(std::span<const Index> near) {
    ++m_selection;
    m_selected.clear();
    const auto add = [&](Index t) {
        if (m_triangles[t].removed) return;
        m_triangles[t].selection = m_selection;
        m_selected.push_back(t);
    };
    std::ranges::for_each(near, add);
    for (std::size_t t = m_oldCount; t < m_triangles.size(); ++t) add(static_cast<Index>(t));
}

void CWoodPatch::flood(std::span<const Index> seeds) {
    ++m_flood;
    std::vector<Index> open(seeds.begin(), seeds.end());
    while (!open.empty()) {
        const Index t = open.back();
        open.pop_back();
        if (isMarked(t) || m_triangles[t].removed || m_triangles[t].selection != m_selection) continue;
        m_triangles[t].flooded = m_flood;
        for (std::uint32_t c = 0; c < 3; ++c)
            if (const Index next = beyond({t, c}); next != kNone) open.push_back(next);
    }
}

void CWoodPatch::markOnly(std::span<const Index> triangles) {
    ++m_flood;
    for (const Index t : triangles) m_triangles[t].flooded = m_flood;
}

std::vector<CWoodPatch::Index> CWoodPatch::near(const Capsule& capsule) const {
    std::vector<Index> found;
    const glm::dvec3 way = capsule.to - capsule.from;
    const double squared = glm::dot(way, way);
    for (const Index t : m_selected) {
        if (!isMarked(t) || m_triangles[t].removed) continue;
        const auto& points = m_triangles[t].points;
        const glm::dvec3 a = place(points[0]), b = place(points[1]), c = place(points[2]), middle = (a + b + c) / 3.0;
        const double share = squared > 0 ? glm::clamp(glm::dot(middle - capsule.from, way) / squared, 0.0, 1.0) : 0;
        const double around = std::sqrt(std::max({glm::dot(a - middle, a - middle), glm::dot(b - middle, b - middle), glm::dot(c - middle, c - middle)}));
        if (glm::distance(middle, capsule.from + share * way) <= capsule.radius + around) found.push_back(t);
    }
    return found;
}

std::vector<CWoodPatch::Crossing> CWoodPatch::crossings(const glm::dvec3& from, const glm::dvec3& to, std::span<const Index> among) const {
    std::vector<Crossing> all;
    const glm::dvec3 way = to - from;
    const glm::vec3 rounding(kRounded * glm::max(glm::abs(from), glm::abs(to)));
    const glm::vec3 low = glm::vec3(glm::min(from, to)) - rounding, high = glm::vec3(glm::max(from, to)) + rounding;
    const auto isBeside = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) { // most are: meetTriangle() takes longer
        for (int i = 0; i < 3; ++i)
            if ((a[i] < low[i] && b[i] < low[i] && c[i] < low[i]) || (a[i] > high[i] && b[i] > high[i] && c[i] > high[i])) return true;
        return false;
    };
    for (const Index t : among) {
        const Triangle& own = m_triangles[t];
        if (isBeside(m_places[own.points[0]], m_places[own.points[1]], m_places[own.points[2]])) continue;
        const auto share = meetTriangle(from, way, place(own.points[0]), place(own.points[1]), place(own.points[2]));
        if (share && *share >= 0 && *share <= 1) all.push_back({*share, t, from + *share * way, glm::dot(faceOf(own), way) > 0});
    }
    std::ranges::sort(all, {}, &Crossing::share);
    return all;
}

CWoodPatch::Index CWoodPatch::addPoint(const glm::dvec3& at, const VertexSource& source) {
    m_places.emplace_back(at);
    m_sources.push_back(source);
    m_around.emplace_back();
    return static_cast<Index>(m_places.size() - 1);
}

CWoodPatch::Index CWoodPatch::addVertex(const Vertex& vertex, Index point) {
    Vertex own = vertex;
    own.value.position = m_places[point];
    own.value.source = m_sources[point];
    own.index = kNone;
    m_vertices.push_back(own);
    m_pointOf.push_back(point);
    return static_cast<Index>(m_vertices.size() - 1);
}

CWoodPatch::Index CWoodPatch::addMixed(const Triangle& of, const glm::dvec3& shares, Index point) {
    const auto corner = [&](std::size_t c) { return m_vertices[of.vertices[c]].value; };
    return addVertex({mixed(corner(0), corner(1), corner(2), shares), of.generation, kNone}, point);
}

CWoodPatch::Index CWoodPatch::add(Triangle triangle) {
    triangle.isNew = true;
    triangle.removed = false;
    for (std::size_t c = 0; c < 3; ++c) triangle.points[c] = m_pointOf[triangle.vertices[c]];
    const auto t = static_cast<Index>(m_triangles.size());
    m_triangles.push_back(triangle);
    m_selected.push_back(t);
    for (const Index point : triangle.points) m_around[point].push_back(t);
    return t;
}

void CWoodPatch::addTriangle(const std::array<Index, 3>& vertices, std::uint32_t generation) {
    add({.vertices = vertices, .points = {}, .generation = generation, .first = 0, .selection = m_selection, .flooded = m_flood});
}

void CWoodPatch::remove(Index triangle) {
    m_triangles[triangle].removed = true;
    m_removed.push_back(triangle);
}

void CWoodPatch::keepWholes() {
    for (const Index t : m_selected) m_triangles[t].whole = t;
}

void CWoodPatch::splitFace(Index triangle, const glm::dvec3& shares, Index point) {
    const Triangle own = m_triangles[triangle];
    const Index middle = addMixed(own, shares, point);
    remove(triangle);
    for (std::uint32_t c = 0; c < 3; ++c) {
        Triangle part = own;
        part.vertices = {own.vertices[c], own.vertices[after(c)], middle};
        add(part);
    }
}

std::vector<CWoodPatch::Side> CWoodPatch::sidesOf(Index one, Index other) const {
    std::vector<Side> sides;
    forEachAround(one, [&](Index t) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            const Index from = m_triangles[t].points[c], to = m_triangles[t].points[after(c)];
            if ((from == one && to == other) || (from == other && to == one)) sides.push_back({t, c});
        }
    });
    return sides;
}

/// Whether only the two triangles of an edge have corners at both ends and at the same third point (the link condition).
bool CWoodPatch::isEdgeAlone(Index from, Index to) const {
    const auto neighbours = [&](Index point) {
        std::set<Index> all;
        forEachAround(point, [&](Index t) { all.insert(m_triangles[t].points.begin(), m_triangles[t].points.end()); });
        return all;
    };
    const std::set<Index> one = neighbours(from), other = neighbours(to);
    return std::ranges::count_if(one, [&](Index point) { return other.contains(point); }) == 4; // both ends and two more
}

bool CWoodPatch::collapse(Index from, Index to) {
    std::vector<Triangle> moved;
    std::map<Index, Index> vertexFor; // at `from`: that at `to`
    for (const Side& side : sidesOf(from, to)) {
        const Triangle& own = m_triangles[side.triangle];
        const std::uint32_t end = own.points[side.corner] == to ? side.corner : after(side.corner);
        vertexFor[own.vertices[end == side.corner ? after(side.corner) : side.corner]] = own.vertices[end];
    }
    if (!isEdgeAlone(from, to)) return false;
    bool folds = false;
    std::vector<Index> around;
    forEachAround(from, [&](Index t) {
        around.push_back(t);
        Triangle own = m_triangles[t];
        if (std::ranges::count(own.points, to) > 0) return;
        const std::uint32_t corner = cornerAt(own, from);
        const auto vertex = vertexFor.find(own.vertices[corner]);
        const glm::dvec3 before = faceOf(own);
        own.points[corner] = to;
        const glm::dvec3 face = faceOf(own);
        folds = folds || vertex == vertexFor.end() || !(glm::dot(before, face) > kLeastFold * glm::length(before) * glm::length(face));
        if (folds) return;
        own.vertices[corner] = vertex->second;
        moved.push_back(own);
    });
    if (folds) return false;
    for (const Index t : around) remove(t);
    for (const Triangle& own : moved) add(own);
    return true;
}

bool CWoodPatch::splitEdge(Index one, Index other, double share, Index point) {
    const std::vector<Side> sides = sidesOf(one, other);
    if (sides.size() != 2) return false;
    std::array<Index, 2> known{kNone, kNone}; // the ends of the edge, as vertices
    Index middle = kNone;
    for (const Side& side : sides) {
        const Triangle own = m_triangles[side.triangle];
        const std::uint32_t a = side.corner, b = after(a), c = before(a);
        const bool turned = own.points[a] == other;
        const std::array<Index, 2> ends{own.vertices[turned ? b : a], own.vertices[turned ? a : b]};
        if (ends != known) {
            glm::dvec3 shares(0);
            shares[static_cast<int>(a)] = turned ? share : 1 - share;
            shares[static_cast<int>(b)] = turned ? 1 - share : share;
            middle = addMixed(own, shares, point);
            known = ends;
        }
        remove(side.triangle);
        Triangle part = own;
        part.vertices = {own.vertices[a], middle, own.vertices[c]};
        add(part);
        part.vertices = {middle, own.vertices[b], own.vertices[c]};
        add(part);
    }
    return true;
}

CWoodPatch::Index CWoodPatch::pointInside(Index triangle, const glm::dvec3& shares) {
    const auto points = m_triangles[triangle].points;
    const std::size_t nearest = shares.x >= shares.y && shares.x >= shares.z ? 0 : shares.y >= shares.z ? 1 : 2;
    const Index point = addPoint(shares.x * place(points[0]) + shares.y * place(points[1]) + shares.z * place(points[2]), m_sources[points[nearest]]);
    splitFace(triangle, shares, point);
    return point;
}

/// A new point on the edge between two. kNone where it cannot be parted.
CWoodPatch::Index CWoodPatch::pointOn(Index one, Index other, double share) {
    if (sidesOf(one, other).size() != 2) return kNone;
    const Index point = addPoint(glm::mix(place(one), place(other), share), m_sources[share < 0.5 ? one : other]);
    splitEdge(one, other, share, point);
    return point;
}

void CWoodPatch::replace(std::span<const Index> parts, std::span<const std::array<Index, 3>> points) {
    std::unordered_map<Index, Index> vertexAt;
    for (const Index t : parts)
        for (const Index v : m_triangles[t].vertices) vertexAt[m_pointOf[v]] = v;
    Triangle own = m_triangles[parts[0]];
    for (const Index t : parts) remove(t);
    for (const auto& corners : points) {
        for (std::size_t c = 0; c < 3; ++c) own.vertices[c] = vertexAt.at(corners[c]);
        add(own);
    }
}

CWoodPatch::Index CWoodPatch::pointAt(Index triangle, const glm::dvec3& at, double apart) {
    const Triangle own = m_triangles[triangle];
    const glm::dvec3 face = faceOf(own);
    const double twice = glm::dot(face, face);
    if (!(twice > 0)) return kNone;
    for (const Index point : own.points)
        if (glm::distance(place(point), at) < apart) return point;
    const glm::dvec3 shares = barycentricOf(at, place(own.points[0]), place(own.points[1]), place(own.points[2]));
    std::uint32_t nearest = 0; // edge
    double height = std::numeric_limits<double>::infinity();
    for (std::uint32_t c = 0; c < 3; ++c) {
        const double length = glm::distance(place(own.points[c]), place(own.points[after(c)]));
        const double above = shares[static_cast<int>(before(c))] * std::sqrt(twice) / length;
        if (above < height) height = above, nearest = c;
    }
    if (height < apart) {
        const double low = shares[static_cast<int>(nearest)], high = shares[static_cast<int>(after(nearest))];
        return pointOn(own.points[nearest], own.points[after(nearest)], high / (low + high));
    }
    return pointInside(triangle, shares);
}

CWoodPatch::Index CWoodPatch::pointNear(const glm::dvec3& at, double apart) {
    Index nearest = kNone;
    double least = std::numeric_limits<double>::infinity();
    glm::dvec3 there(0);
    for (const Index t : m_selected) {
        const Triangle& triangle = m_triangles[t];
        if (!isMarked(t) || triangle.removed) continue;
        const glm::dvec3 own = nearestOnTriangle(at, place(triangle.points[0]), place(triangle.points[1]), place(triangle.points[2]));
        if (!(glm::distance(at, own) < least)) continue;
        least = glm::distance(at, own);
        nearest = t;
        there = own;
    }
    return nearest == kNone ? kNone : pointAt(nearest, there, apart);
}

CWoodPatch::Index CWoodPatch::vertexAt(Index point) const {
    Index found = kNone;
    forEachAround(point, [&](Index t) { found = m_triangles[t].vertices[cornerAt(m_triangles[t], point)]; });
    return found;
}

CWoodPatch::Index CWoodPatch::vertexAt(Index from, Index to, bool end) const {
    Index found = kNone;
    forEachAround(from, [&](Index t) {
        const std::uint32_t corner = cornerAt(m_triangles[t], from);
        if (m_triangles[t].points[after(corner)] == to) found = m_triangles[t].vertices[end ? after(corner) : corner];
    });
    return found;
}

CWoodPatch::Index CWoodPatch::addBetween(Index one, Index other, double share, double below, Index point) {
    const Vertex &a = m_vertices[one], &b = m_vertices[other];
    Vertex own{mixed(a.value, b.value, b.value, {1 - share, share, 0}), a.generation, kNone};
    own.value.texCoord.y -= static_cast<float>(below);
    return addVertex(own, point);
}

bool CWoodPatch::areConnected(Index one, Index other) const {
    bool found = false;
    forEachAround(one, [&](Index t) { found = found || std::ranges::count(m_triangles[t].points, other) > 0; });
    return found;
}

/// Over the triangles at a point, along a plane: straight on, as nearly as they let.
CWoodPatch::Step CWoodPatch::stepFrom(Index current, Index previous, const glm::dvec3& ahead, const Plane& plane) const {
    Step best;
    double bestAlong = previous == kNone ? 0 : -std::numeric_limits<double>::infinity();
    const auto height = [&](Index point) { return glm::dot(plane.normal, place(point) - plane.place); };
    const auto consider = [&](const glm::dvec3& at, const Step& step) {
        const glm::dvec3 way = at - place(current);
        const double along = glm::dot(way, ahead) / std::max(glm::length(way), kLeastStep);
        if (along > bestAlong) bestAlong = along, best = step;
    };
    forEachAround(current, [&](Index t) {
        const Triangle& own = m_triangles[t];
        if (!isMarked(t) || std::ranges::count(own.points, previous) > 0) return;
        const std::uint32_t corner = cornerAt(own, current);
        const Index a = own.points[after(corner)], b = own.points[before(corner)];
        const double low = height(a), high = height(b);
        if (std::abs(low) < plane.apart) return consider(place(a), {a});
        if (std::abs(high) < plane.apart) return consider(place(b), {b});
        if ((low < 0) == (high < 0)) return;
        const double share = low / (low - high);
        consider(glm::mix(place(a), place(b), share), {a, b, share});
    });
    return best;
}

bool CWoodPatch::cut(Index from, Index to, const glm::dvec3& across, double apart, std::span<const Index> closed, std::vector<Index>& way) {
    const auto isClosed = [&](Index point) { return std::ranges::count(closed, point) > 0 || std::ranges::count(way, point) > 0; };
    const Plane plane{place(from), across, apart};
    double left = kDetour * glm::distance(place(from), place(to));
    Index current = from, previous = kNone;
    for (int cuts = 0; cuts < kMaxCuts && left > 0; ++cuts) {
        if (areConnected(current, to)) {
            way.push_back(to);
            return true;
        }
        const Step step = stepFrom(current, previous, previous == kNone ? place(to) - place(from) : place(current) - place(previous), plane);
        if (step.one == kNone || (isClosed(step.one) && (step.other == kNone || isClosed(step.other)))) return false; // that may be an edge of the loop
        const Index next = step.other == kNone ? step.one : pointOn(step.one, step.other, step.share);
        if (next == kNone) return false;
        left -= glm::distance(place(current), place(next));
        way.push_back(next);
        previous = std::exchange(current, next);
    }
    return false;
}

/// The triangle at each edge; fewer where edges are missing.
std::vector<CWoodPatch::Index> CWoodPatch::leftOf(std::span<const Index> loop) const {
    std::vector<Index> found;
    for (std::size_t i = 0; i < loop.size(); ++i)
        forEachAround(loop[i], [&](Index t) {
            const auto& points = m_triangles[t].points;
            if (points[after(cornerAt(m_triangles[t], loop[i]))] == loop[(i + 1) % loop.size()]) found.push_back(t);
        });
    return found;
}

bool CWoodPatch::removeLeftOf(std::span<const Index> loop, std::uint32_t generation, bool near) {
    const auto isOnLoop = [&](Index from, Index to) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Index a = loop[i], b = loop[(i + 1) % loop.size()];
            if ((a == from && b == to) || (a == to && b == from)) return true;
        }
        return false;
    };
    glm::dvec3 middle(0);
    for (const Index point : loop) middle += place(point) / double(loop.size());
    double reach = near ? 0 : std::numeric_limits<double>::infinity();
    for (const Index point : loop) reach = std::max(reach, kBulge * glm::distance(middle, place(point)));
    std::vector<Index> open = leftOf(loop), inside;
    if (open.size() != loop.size()) return false;
    std::unordered_set<Index> seen;
    while (!open.empty()) {
        const Index t = open.back();
        open.pop_back();
        if (!seen.insert(t).second) continue;
        const Triangle& own = m_triangles[t];
        if (!isMarked(t) || own.generation > generation) return false;
        if (std::ranges::any_of(own.points, [&](Index point) { return glm::distance(middle, place(point)) > reach; })) return false;
        inside.push_back(t);
        for (std::uint32_t c = 0; c < 3; ++c) {
            if (isOnLoop(own.points[c], own.points[after(c)])) continue;
            open.push_back(beyond({t, c}));
            if (open.back() == kNone) return false;
        }
    }
    for (const Index t : inside) remove(t);
    return true;
}

/// Whether an edge has one triangle on either side, or is of the patch's border.
bool CWoodPatch::isSewn(Index from, Index to) const {
    int there = 0, back = 0;
    bool hadBack = false;
    for (const Index t : m_around[from])
        for (std::uint32_t c = 0; c < 3; ++c) {
            const Index a = m_triangles[t].points[c], b = m_triangles[t].points[after(c)];
            const bool isBack = a == to && b == from;
            hadBack = hadBack || isBack;
            if (m_triangles[t].removed) continue;
            there += a == from && b == to;
            back += isBack;
        }
    const bool isBorder = !hadBack && from < m_pointMark && to < m_pointMark;
    return there == 1 && (back == 1 || isBorder);
}

/// Whether no new point is at exactly the place of another, as far as there are triangles at both.
bool CWoodPatch::areApart() const {
    const auto inOrder = [](const glm::vec3& a, const glm::vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    const auto isUsed = [&](Index point) { return std::ranges::any_of(m_around[point], [&](Index t) { return !m_triangles[t].removed; }); };
    std::vector<glm::vec3> added;
    for (auto point = static_cast<Index>(m_pointMark); point < m_places.size(); ++point)
        if (isUsed(point)) added.push_back(m_places[point]);
    std::ranges::sort(added, inOrder);
    if (std::ranges::adjacent_find(added) != added.end()) return false;
    for (Index point = 0; point < m_pointMark; ++point)
        if (std::ranges::binary_search(added, m_places[point], inOrder) && isUsed(point)) return false;
    return true;
}

bool CWoodPatch::finish() {
    if (!areApart()) return false;
    std::unordered_map<Index, std::vector<Index>> turnedOf; // vertices that took the place of one
    for (std::size_t t = m_triangleMark; t < m_triangles.size(); ++t) {
        if (m_triangles[t].removed) continue;
        const glm::dvec3 face = faceOf(m_triangles[t]);
        if (!(glm::length(face) > 0)) return false;
        for (std::uint32_t c = 0; c < 3; ++c) {
            if (!isSewn(m_triangles[t].points[c], m_triangles[t].points[after(c)])) return false;
            const Vertex vertex = m_vertices[m_triangles[t].vertices[c]];
            if (glm::dot(face, glm::dvec3(vertex.value.normal)) > 0) continue;
            std::vector<Index>& turned = turnedOf[m_triangles[t].vertices[c]];
            auto fitting = std::ranges::find_if(turned, [&](Index v) { return glm::dot(face, glm::dvec3(m_vertices[v].value.normal)) > 0; });
            if (fitting == turned.end()) {
                Vertex own = vertex;
                own.value.normal = glm::vec3(glm::normalize(face));
                fitting = turned.insert(turned.end(), addVertex(own, m_triangles[t].points[c]));
            }
            m_triangles[t].vertices[c] = *fitting;
        }
    }
    return true;
}

void CWoodPatch::mark() {
    m_removed.clear();
    m_vertexMark = m_vertices.size();
    m_triangleMark = m_triangles.size();
    m_pointMark = m_places.size();
}

void CWoodPatch::undo() {
    for (const Index t : m_removed) m_triangles[t].removed = false;
    for (std::size_t t = m_triangles.size(); t-- > m_triangleMark;)
        for (const Index point : m_triangles[t].points) m_around[point].pop_back();
    std::erase_if(m_selected, [&](Index t) { return t >= m_triangleMark; });
    m_triangles.resize(m_triangleMark, m_triangles.empty() ? Triangle{} : m_triangles[0]);
    m_vertices.resize(m_vertexMark, m_vertices.empty() ? Vertex{} : m_vertices[0]);
    m_pointOf.resize(m_vertexMark);
    m_places.resize(m_pointMark);
    m_sources.resize(m_pointMark);
    m_around.resize(m_pointMark);
    mark();
}

} // namespace stromar
