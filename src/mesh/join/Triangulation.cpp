#include "join/Triangulation.h"
#include "join/Corners.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

namespace stromar {

namespace {
constexpr double kTooFlat = 1e-8;   // twice the area of a triangle that is too flat, over its longest side squared
constexpr double kOnEdge = 1e-6; // share of a triangle below which a point lies on its edge
constexpr int kMaxSteps = 400;  // to a point, along an edge, or flips for one: more is a fault of rounding
constexpr int kPasses = 4;
constexpr double kAboutHalf = 0.3;   // turns
constexpr std::size_t kMaxUnsure = 4; // ways of a loop of which either side may be meant

/// The side of a line from a to b on which c lies: 1 on its left, −1 on its right, 0 nearly on it.
int sideOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const auto squared = [](const glm::dvec2& way) { return glm::dot(way, way); };
    const double twice = twiceArea(a, b, c), flat = kTooFlat * std::max({squared(b - a), squared(c - b), squared(a - c)});
    return twice > flat ? 1 : twice < -flat ? -1 : 0;
}
} // namespace

CTriangulation::CTriangulation(std::vector<Triangle> triangles, Index vertexCount)
    : m_triangles(std::move(triangles)), m_touching(vertexCount, kNone) {
    findNeighbours();
    for (Index t = 0; t < m_triangles.size(); ++t) touch(t);
}

void CTriangulation::findNeighbours() {
    struct Side {
        Index high, triangle;
        std::uint32_t corner;
    };
    const auto lowOf = [](const Triangle& own, std::uint32_t c) { return std::min(own.vertices[c], own.vertices[after(c)]); };
    std::vector<std::size_t> ends(m_touching.size() + 1); // of the sides of each vertex that is their lower one
    for (const Triangle& own : m_triangles)
        for (std::uint32_t c = 0; c < 3; ++c) ++ends[lowOf(own, c) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Side> sides(3 * m_triangles.size());
    for (Index t = 0; t < m_triangles.size(); ++t)
        for (std::uint32_t c = 0; c < 3; ++c)
            sides[ends[lowOf(m_triangles[t], c)]++] = {std::max(m_triangles[t].vertices[c], m_triangles[t].vertices[after(c)]), t, c};
    std::size_t start = 0;
    for (std::size_t low = 0; low < m_touching.size(); ++low) {
        const std::span<Side> own(sides.data() + start, ends[low] - start);
        std::ranges::sort(own, {}, [](const Side& side) { return std::tuple(side.high, side.triangle); });
        for (std::size_t i = 0; i + 1 < own.size(); ++i) {
            const Side &one = own[i], &other = own[i + 1];
            if (one.high != other.high || m_triangles[one.triangle].vertices[one.corner] == m_triangles[other.triangle].vertices[other.corner])
                continue;
            m_triangles[one.triangle].next[one.corner] = other.triangle;
            m_triangles[other.triangle].next[other.corner] = one.triangle;
        }
        start = ends[low];
    }
}

void CTriangulation::touch(Index triangle) {
    for (const Index vertex : m_triangles[triangle].vertices) m_touching[vertex] = triangle;
}

void CTriangulation::link(Index triangle, Index old, Index now) {
    if (triangle == kNone) return;
    Triangle& own = m_triangles[triangle];
    for (std::uint32_t c = 0; c < 3; ++c)
        if (own.next[c] == old) {
            own.next[c] = now;
            own.settled[c] = false;
            return;
        }
}

/// The same edge of the triangle beyond.
CTriangulation::Edge CTriangulation::twin(const Edge& edge) const {
    const Triangle& own = m_triangles[edge.triangle];
    const Index other = own.next[edge.corner];
    const auto& vertices = m_triangles[other].vertices;
    for (std::uint32_t c = 0; c < 3; ++c)
        if (vertices[c] == own.vertices[after(edge.corner)] && vertices[after(c)] == own.vertices[edge.corner]) return {other, c};
    return {kNone, 0};
}

/// What has to be added to places of the triangle beyond.
glm::dvec2 CTriangulation::shiftTo(const Edge& edge, const Edge& twin) const {
    const double turns = m_triangles[edge.triangle].at[edge.corner].x - m_triangles[twin.triangle].at[after(twin.corner)].x;
    return {std::abs(turns) < 0.5 ? 0 : std::round(turns), 0}; // as nearly all are: rounding takes long
}

/// The corners of two neighbours, counter-clockwise, from the edge's start by the far one and its end to the near one.
std::array<glm::dvec2, 4> CTriangulation::quad(const Edge& edge, const Edge& twin) const {
    const Triangle& own = m_triangles[edge.triangle];
    const glm::dvec2 far = m_triangles[twin.triangle].at[before(twin.corner)] + shiftTo(edge, twin);
    return {own.at[edge.corner], far, own.at[after(edge.corner)], own.at[before(edge.corner)]};
}

bool CTriangulation::isConvex(const Edge& edge, const Edge& twin) const {
    const auto [a, far, b, near] = quad(edge, twin);
    return sideOf(a, far, near) > 0 && sideOf(far, b, near) > 0;
}

void CTriangulation::flip(const Edge& edge) {
    const Edge other = twin(edge);
    const glm::dvec2 shift = shiftTo(edge, other);
    const auto [a, far, b, near] = quad(edge, other);
    const Index t = edge.triangle, n = other.triangle;
    const Triangle own = m_triangles[t], beyond = m_triangles[n];
    const std::uint32_t i = edge.corner, j = other.corner;
    const auto vertex = [&](std::uint32_t corner) { return own.vertices[corner]; };
    const Index d = beyond.vertices[before(j)];
    m_triangles[t] = {{vertex(i), d, vertex(before(i))},
                      {a, far, near},
                      {beyond.next[after(j)], n, own.next[before(i)]},
                      {beyond.fixed[after(j)], false, own.fixed[before(i)]},
                      {},
                      own.turns,
                      true,
                      false};
    m_triangles[n] = {{d, vertex(after(i)), vertex(before(i))},
                      {far, b, near},
                      {beyond.next[before(j)], own.next[after(i)], t},
                      {beyond.fixed[before(j)], own.fixed[after(i)], false},
                      {},
                      beyond.turns + shift.x,
                      true,
                      false};
    link(beyond.next[after(j)], n, t);
    link(own.next[after(i)], t, n);
    link(beyond.next[before(j)], n, n);
    link(own.next[before(i)], t, t);
    touch(t);
    touch(n);
}

/// Into three about a point inside.
void CTriangulation::split(Index triangle, Index vertex, const glm::dvec2& at) {
    const Triangle own = m_triangles[triangle];
    const auto second = static_cast<Index>(m_triangles.size()), third = second + 1;
    const std::array parts{triangle, second, third};
    m_triangles.resize(m_triangles.size() + 2);
    for (std::uint32_t c = 0; c < 3; ++c) {
        m_triangles[parts[c]] = {{own.vertices[c], own.vertices[after(c)], vertex},
                                 {own.at[c], own.at[after(c)], at},
                                 {own.next[c], parts[after(c)], parts[before(c)]},
                                 {own.fixed[c], false, false},
                                 {},
                                 own.turns,
                                 true,
                                 false};
        link(own.next[c], triangle, parts[c]);
        touch(parts[c]);
    }
}

bool CTriangulation::insert(const LoopPoint& point) {
    Index t = point.triangle;
    glm::dvec2 at = point.at + glm::dvec2(m_triangles[t].turns, 0);
    for (std::uint32_t step = 0; step < kMaxSteps; ++step) {
        const Triangle& here = m_triangles[t];
        std::uint32_t out = 3, near = 3;
        int nearCount = 0;
        const double whole = twiceArea(here.at[0], here.at[1], here.at[2]);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t c = (k + step) % 3;
            const double share = twiceArea(here.at[c], here.at[after(c)], at) / whole;
            if (share < -kOnEdge) out = c;
            if (std::abs(share) <= kOnEdge) near = c, ++nearCount;
        }
        if (out < 3) {
            const Index next = here.next[out];
            if (next == kNone) return false;
            at -= shiftTo({t, out}, twin({t, out}));
            t = next;
            continue;
        }
        if (here.removed || nearCount > 1 || (nearCount == 1 && (here.fixed[near] || here.next[near] == kNone))) return false;
        if (nearCount == 1 && m_triangles[here.next[near]].removed) return false;
        const auto vertex = static_cast<Index>(m_touching.size());
        m_touching.push_back(t);
        const std::uint32_t edge = near;
        split(t, vertex, at);
        if (nearCount == 1) flip({edge == 0 ? t : static_cast<Index>(m_triangles.size()) - 3 + edge, 0});
        return true;
    }
    return false;
}

/// The edges that leave a vertex, of the triangles about it, until this is asked again; none at the surface's border.
std::span<const CTriangulation::Edge> CTriangulation::around(Index vertex) {
    m_around.clear();
    const auto cornerOf = [&](Index t) {
        return static_cast<std::uint32_t>(std::ranges::find(m_triangles[t].vertices, vertex) - m_triangles[t].vertices.begin());
    };
    const Index start = m_touching[vertex];
    Index t = start;
    do {
        const std::uint32_t corner = cornerOf(t);
        if (corner == 3 || m_around.size() > kMaxSteps) return {};
        m_around.push_back({t, corner});
        t = m_triangles[t].next[before(corner)];
        if (t == kNone) return {};
    } while (t != start);
    return m_around;
}

std::optional<CTriangulation::Edge> CTriangulation::edgeBetween(Index from, Index to, const glm::dvec2& way) {
    for (const Edge& edge : around(from)) {
        const Triangle& here = m_triangles[edge.triangle];
        const glm::dvec2 own = here.at[after(edge.corner)] - here.at[edge.corner];
        if (here.vertices[after(edge.corner)] == to && std::abs(own.x - way.x) < 0.25) return edge;
    }
    return {};
}

/// On a thin stem there may be an edge on either side.
bool CTriangulation::areConnected(Index one, Index other) {
    return std::ranges::any_of(around(one), [&](const Edge& edge) {
        return m_triangles[edge.triangle].vertices[after(edge.corner)] == other;
    });
}

/// The first edge on the way from a vertex; nothing where a vertex stands on the way.
std::optional<CTriangulation::Edge> CTriangulation::crossedFrom(Index from, const glm::dvec2& way) {
    for (const Edge& edge : around(from)) {
        const Triangle& here = m_triangles[edge.triangle];
        const glm::dvec2 start = here.at[edge.corner], end = start + way;
        const glm::dvec2 right = here.at[after(edge.corner)], left = here.at[before(edge.corner)];
        if (sideOf(start, end, right) < 0 && sideOf(start, end, left) > 0) return Edge{edge.triangle, after(edge.corner)};
    }
    return {};
}

/// Flips one of the edges on a way that crosses `crossed` first: the nearest for which it is of use. False when there is none.
bool CTriangulation::flipTowards(Edge crossed, const glm::dvec2& way) {
    std::optional<Edge> convex;
    glm::dvec2 start = m_triangles[crossed.triangle].at[before(crossed.corner)];
    for (int step = 0; step < kMaxSteps; ++step) {
        const Triangle& own = m_triangles[crossed.triangle];
        const Index next = own.next[crossed.corner];
        if (own.fixed[crossed.corner] || next == kNone || own.removed || m_triangles[next].removed) return false;
        const Edge other = twin(crossed);
        const auto [right, far, left, near] = quad(crossed, other);
        const int side = sideOf(start, start + way, far);
        if (side == 0 && glm::distance(far, start + way) > kOnEdge * glm::length(way)) return false; // a vertex stands on the way
        if (isConvex(crossed, other)) {
            if (step == 0 || side == 0 || side == sideOf(start, start + way, near)) {
                flip(crossed);
                return true;
            }
            if (!convex) convex = crossed;
        }
        if (side == 0) break;
        start -= shiftTo(crossed, other);
        crossed = {other.triangle, side > 0 ? after(other.corner) : before(other.corner)};
    }
    if (convex) flip(*convex);
    return convex.has_value();
}

bool CTriangulation::makeEdge(Index from, Index to, const glm::dvec2& way) {
    for (int flips = 0; flips < kMaxSteps; ++flips) {
        if (edgeBetween(from, to, way)) return true;
        const auto crossed = crossedFrom(from, way);
        if (!crossed || !flipTowards(*crossed, way)) return false;
    }
    return false;
}

bool CTriangulation::fix(Index from, Index to, const glm::dvec2& way, bool fixed) {
    const auto edge = edgeBetween(from, to, way);
    if (!edge) return false;
    const Edge other = twin(*edge);
    m_triangles[edge->triangle].fixed[edge->corner] = fixed;
    m_triangles[other.triangle].fixed[other.corner] = fixed;
    return true;
}

/// From the left of a loop's first edge to the loop, whose vertices start at `first`.
bool CTriangulation::removeInside(Index first, Index second, const glm::dvec2& way) {
    const auto start = edgeBetween(first, second, way);
    if (!start || m_triangles[start->triangle].removed) return false;
    std::vector<Index> inside;
    const auto take = [&](Index t) {
        m_triangles[t].removed = true;
        inside.push_back(t);
    };
    const auto isBorder = [&](const Triangle& here, std::uint32_t c) {
        return here.fixed[c] && here.vertices[c] >= first && here.vertices[after(c)] >= first;
    };
    bool sound = true;
    take(start->triangle);
    for (std::size_t i = 0; sound && i < inside.size(); ++i)
        for (std::uint32_t c = 0; c < 3; ++c) {
            const Triangle& here = m_triangles[inside[i]];
            if (isBorder(here, c)) continue;
            const Index next = here.next[c];
            const bool known = next != kNone && m_triangles[next].removed;
            if (known && std::ranges::find(inside, next) != inside.end()) continue;
            sound = sound && !here.fixed[c] && next != kNone && !known;
            if (sound) take(next);
        }
    if (!sound)
        for (const Index t : inside) m_triangles[t].removed = false;
    return sound;
}

namespace {
/// Whether ways lead counter-clockwise back to where they start.
bool isLoop(const std::vector<glm::dvec2>& ways) {
    glm::dvec2 sum(0);
    double twice = 0;
    for (const glm::dvec2& way : ways) {
        twice += sum.x * way.y - sum.y * way.x;
        sum += way;
    }
    return std::abs(sum.x) < 0.5 && twice > 0;
}

/// From each point of a loop to the next: the shorter way around, or, where both are about half a turn, the one that makes a loop.
std::optional<std::vector<glm::dvec2>> waysAlong(std::span<const CTriangulation::LoopPoint> loop) {
    std::vector<glm::dvec2> ways;
    ways.reserve(loop.size());
    std::vector<std::size_t> unsure;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        glm::dvec2 way = loop[(i + 1) % loop.size()].at - loop[i].at;
        way.x -= std::round(way.x);
        if (std::abs(way.x) > kAboutHalf && unsure.size() < kMaxUnsure) unsure.push_back(i);
        ways.push_back(way);
    }
    if (unsure.empty()) return isLoop(ways) ? std::optional(std::move(ways)) : std::nullopt;
    for (std::size_t choice = 0; choice < std::size_t{1} << unsure.size(); ++choice) {
        std::vector<glm::dvec2> chosen = ways;
        for (std::size_t bit = 0; bit < unsure.size(); ++bit)
            if (choice >> bit & 1) chosen[unsure[bit]].x -= std::copysign(1.0, ways[unsure[bit]].x);
        if (isLoop(chosen)) return chosen;
    }
    return {};
}
} // namespace

bool CTriangulation::cutOut(std::span<const LoopPoint> loop) {
    const Index first = vertexCount();
    const auto count = static_cast<Index>(loop.size());
    const auto found = waysAlong(loop);
    if (!found) return false;
    const std::vector<glm::dvec2>& ways = *found;
    for (const LoopPoint& point : loop)
        if (!insert(point)) return false;
    Index made = 0;
    const auto end = [&](Index i) { return first + (i + 1) % count; };
    for (; made < count; ++made)
        if (!makeEdge(first + made, end(made), ways[made]) || !fix(first + made, end(made), ways[made], true)) break;
    if (made == count && removeInside(first, end(0), ways[0])) return true;
    for (Index i = 0; i < made; ++i) fix(first + i, end(i), ways[i], false);
    return false;
}

/// Whether the edge is better as it is, seen from either side.
bool CTriangulation::isSettled(const Edge& edge, const BetterFlipped& better) {
    Triangle& own = m_triangles[edge.triangle];
    const Edge other = twin(edge);
    Triangle& beyond = m_triangles[other.triangle];
    const std::uint32_t c = edge.corner;
    const bool flips = isConvex(edge, other) && better({own.vertices[c], own.vertices[after(c)], own.vertices[before(c)],
                                                        beyond.vertices[before(other.corner)]},
                                                       {edge.triangle, other.triangle});
    own.settled[c] = beyond.settled[other.corner] = !flips;
    return !flips;
}

void CTriangulation::improve(const BetterFlipped& better) {
    for (int pass = 0; pass < kPasses; ++pass) {
        bool flipped = false;
        for (Index t = 0; t < m_triangles.size(); ++t) {
            if (!m_triangles[t].changed || m_triangles[t].removed) continue;
            for (std::uint32_t c = 0; c < 3; ++c) {
                const Triangle& own = m_triangles[t];
                const Index next = own.next[c];
                if (own.settled[c] || own.fixed[c] || next == kNone || m_triangles[next].removed || isSettled({t, c}, better)) continue;
                const Edge other = twin({t, c});
                if (areConnected(own.vertices[before(c)], m_triangles[next].vertices[before(other.corner)])) continue;
                flip({t, c});
                flipped = true;
            }
        }
        if (!flipped) return;
    }
}

bool CTriangulation::turnAway(Index triangle, Index from, Index to) {
    const Triangle& own = m_triangles[triangle];
    for (std::uint32_t c = 0; c < 3; ++c) {
        if (own.vertices[c] != from || own.vertices[after(c)] != to) continue;
        const Index next = own.next[c];
        if (own.removed || own.fixed[c] || next == kNone || m_triangles[next].removed) return false;
        const Edge other = twin({triangle, c});
        if (!isConvex({triangle, c}, other)) return false;
        if (areConnected(own.vertices[before(c)], m_triangles[next].vertices[before(other.corner)])) return false;
        flip({triangle, c});
        return true;
    }
    return false;
}

} // namespace stromar
