#include "join/SurfaceCutter.h"
#include "join/Corners.h"
#include "join/ShortestFill.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr double kFlatPart = 1e-13; // twice the area of a part of a triangle, over that of the triangle
constexpr double kAtEdge = 1e-12;   // likewise, of what a point at its edge would part off
constexpr std::size_t kMostAcross =
    200; // parts of a triangle that an edge crosses: filling takes their square in memory
} // namespace

CSurfaceCutter::CSurfaceCutter(const CCrossingCurves& curves, CWoodPatch& patch)
    : m_curves(curves), m_patch(patch), m_firstNew(patch.triangles().size()), m_listed(m_firstNew) {}

template <typename Do>
bool CSurfaceCutter::forEachNode(const std::set<Index>& curves, Do&& work) const {
    return std::ranges::all_of(curves, [&](Index c) { return std::ranges::all_of(m_curves.curves()[c].nodes, work); });
}

bool CSurfaceCutter::cut(const std::set<Index>& curves) {
    m_patch.undo();
    m_patch.keepWholes();
    m_parts.clear();
    m_listed = m_firstNew;
    addPoints(curves);
    return cutSurface(Surface::Wood, curves) && cutSurface(Surface::Branch, curves);
}

/// Both surfaces share them; they move as the wood does.
void CSurfaceCutter::addPoints(const std::set<Index>& curves) {
    m_pointOf.clear();
    m_nodeOf.clear();
    forEachNode(curves, [&](Index node) {
        const CCrossingCurves::Node& own = m_curves.nodes()[node];
        const std::array<Index, 3> near =
            own.edgeOf == Surface::Branch ? m_curves.cornersOf(own.triangle) : std::array{own.low, own.high, own.high};
        const Index nearest = *std::ranges::min_element(
            near, {}, [&](Index point) { return glm::distance(m_patch.place(point), own.place); });
        m_pointOf[node] = m_patch.addPoint(own.place, m_patch.sourceOf(nearest));
        m_nodeOf[m_pointOf[node]] = node;
        return true;
    });
}

bool CSurfaceCutter::cutSurface(Surface surface, const std::set<Index>& curves) {
    std::map<Edge, std::vector<Index>> edges;
    std::vector<Index> inside;
    forEachNode(curves, [&](Index node) {
        const CCrossingCurves::Node& own = m_curves.nodes()[node];
        (own.edgeOf == surface ? edges[{own.low, own.high}] : inside).push_back(node);
        return true;
    });
    m_fixed.clear();
    return std::ranges::all_of(edges, [&](const auto& own) { return splitEdge(own.second); }) &&
           std::ranges::all_of(inside, [&](Index node) { return splitFace(node); }) &&
           std::ranges::all_of(curves, [&](Index c) {
               return std::ranges::all_of(m_curves.curves()[c].segments, [&](Index segment) {
                   const CCrossingCurves::Segment& own = m_curves.segments()[segment];
                   return connect(own.in(surface), pointOf(own.nodes[0]), pointOf(own.nodes[1]));
               });
           });
}

glm::dvec2 CSurfaceCutter::at(Index point, Index whole) const {
    const auto& corners = m_curves.cornersOf(whole);
    const auto node = m_nodeOf.find(point);
    if (node == m_nodeOf.end()) return {corners[1] == point ? 1 : 0, corners[2] == point ? 1 : 0};
    return m_curves.flatOf(node->second, whole);
}

bool CSurfaceCutter::splitEdge(std::vector<Index> nodes) {
    std::ranges::sort(nodes, {}, [&](Index node) { return m_curves.nodes()[node].share; });
    Index low = m_curves.nodes()[nodes[0]].low;
    double before = 0;
    for (const Index node : nodes) {
        const CCrossingCurves::Node& own = m_curves.nodes()[node];
        if (!(own.share > before) || !(own.share < 1)) return false;
        if (!m_patch.splitEdge(low, own.high, (own.share - before) / (1 - before), pointOf(node))) return false;
        low = pointOf(node);
        before = own.share;
    }
    return true;
}

std::vector<CSurfaceCutter::Index> CSurfaceCutter::partsOf(Index whole) {
    const auto triangles = m_patch.triangles();
    if (!triangles[whole].removed) return {whole};
    for (; m_listed < triangles.size(); ++m_listed)
        m_parts[triangles[m_listed].whole].push_back(static_cast<Index>(m_listed));
    std::vector<Index>& parts = m_parts[whole];
    std::erase_if(parts, [&](Index t) { return triangles[t].removed; });
    return parts;
}

bool CSurfaceCutter::splitFace(Index node) {
    const Index whole = m_curves.nodes()[node].triangle;
    const glm::dvec2 place = m_curves.flatOf(node, whole);
    Index best = CWoodPatch::kNone;
    double most = -kAtEdge;
    glm::dvec3 areas(0);
    for (const Index part : partsOf(whole)) {
        const auto [a, b, c] = m_curves.cornersOf(part);
        const glm::dvec2 p = at(a, whole), q = at(b, whole), r = at(c, whole);
        const glm::dvec3 own(twiceArea(place, q, r), twiceArea(p, place, r), twiceArea(p, q, place));
        const double least = std::min({own.x, own.y, own.z});
        if (least <= most) continue;
        most = least;
        best = part;
        areas = own;
    }
    if (best == CWoodPatch::kNone) return false;
    if (most < kAtEdge) return splitEdgeAt(best, areas, node);
    m_patch.splitFace(best, areas / (areas.x + areas.y + areas.z), pointOf(node));
    return true;
}

/// Of a part that a node lies at the edge of, where that lies within the triangle.
bool CSurfaceCutter::splitEdgeAt(Index part, const glm::dvec3& areas, Index node) {
    const std::uint32_t third = areas.x <= areas.y && areas.x <= areas.z ? 0
                                : areas.y <= areas.z                     ? 1
                                                                         : 2,
                        corner = after(third);
    const Index other = m_patch.beyond({part, corner});
    const auto& triangles = m_patch.triangles();
    if (other == CWoodPatch::kNone || triangles[other].whole != triangles[part].whole) return false;
    const double low = areas[static_cast<int>(corner)], high = areas[static_cast<int>(after(corner))];
    if (!(low > kAtEdge) || !(high > kAtEdge)) return false;
    const auto points = m_curves.cornersOf(part);
    return m_patch.splitEdge(points[corner], points[after(corner)], high / (low + high), pointOf(node));
}

/// Makes an edge between two points of a triangle's parts: those that lie across are filled anew on either side of it.
bool CSurfaceCutter::connect(Index whole, Index from, Index to) {
    const std::vector<Index> parts = partsOf(whole);
    const glm::dvec2 start = at(from, whole), end = at(to, whole);
    const auto sideOf = [&](Index point) { return twiceArea(start, end, at(point, whole)); };
    const auto beyond = [&](Index a, Index b) { // the part with an edge from a to b, and its other point
        for (const Index t : parts)
            for (std::uint32_t c = 0; c < 3; ++c)
                if (const auto& own = m_curves.cornersOf(t); own[c] == a && own[after(c)] == b)
                    return std::pair(t, own[before(c)]);
        return std::pair(CWoodPatch::kNone, CWoodPatch::kNone);
    };
    m_fixed.insert(std::minmax(from, to));
    if (beyond(from, to).first != CWoodPatch::kNone || beyond(to, from).first != CWoodPatch::kNone) return true;
    std::vector<Index> crossed, right, left;
    for (const Index t : parts)
        for (std::uint32_t c = 0; c < 3; ++c)
            if (const auto& own = m_curves.cornersOf(t);
                own[c] == from && sideOf(own[after(c)]) < 0 && sideOf(own[before(c)]) > 0) {
                crossed = {t};
                right = {from, own[after(c)]};
                left = {from, own[before(c)]};
            }
    if (crossed.empty()) return false;
    for (Index last = CWoodPatch::kNone; last != to;) {
        if (crossed.size() > kMostAcross) return false;
        if (m_fixed.contains(std::minmax(left.back(), right.back()))) return false; // curves cross
        const auto [next, third] = beyond(left.back(), right.back());
        if (next == CWoodPatch::kNone) return false;
        crossed.push_back(next);
        last = third;
        if (third != to) (sideOf(third) > 0 ? left : right).push_back(third);
    }
    right.push_back(to);
    left.push_back(to);
    std::ranges::reverse(left);
    std::vector<std::array<Index, 3>> filled;
    if (!fill(whole, right, filled) || !fill(whole, left, filled)) return false;
    m_patch.replace(crossed, filled);
    return true;
}

bool CSurfaceCutter::fill(Index whole, const std::vector<Index>& edge,
                          std::vector<std::array<Index, 3>>& filled) const {
    const auto costOf = [&](std::size_t a, std::size_t b, std::size_t c) {
        if (twiceArea(at(edge[a], whole), at(edge[b], whole), at(edge[c], whole)) < kFlatPart)
            return std::numeric_limits<double>::infinity();
        return glm::distance(m_patch.place(edge[a]), m_patch.place(edge[c]));
    };
    return fillPolygon(edge.size(), costOf, [&](std::size_t a, std::size_t b, std::size_t c) {
        filled.push_back({edge[a], edge[b], edge[c]});
    });
}

} // namespace stromar
