#include "join/CrossingCurves.h"
#include "join/BoundsTree.h"
#include "join/Corners.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace stromar {

namespace {
constexpr double kClear = 1e-9;                // metres from a plane, of what certainly does not meet it
constexpr std::size_t kMostPairs = 5'000'000;  // triangles whose bounds touch: some hundredths of a second
constexpr std::size_t kMostMeetings = 500'000; // edges and triangles that may cross, some tens of bytes each
constexpr double kSmallBase = 0.25;            // of its size, where it is moved

/// Six times the volume of four points, not 0, and of the very same size whatever their order is.
template <typename Corner> double volume(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    std::array<const Corner*, 4> corners{&a, &b, &c, &d};
    double sign = 1;
    for (std::size_t i = 1; i < 4; ++i)
        for (std::size_t k = i; k > 0 && corners[k]->point < corners[k - 1]->point; --k)
            std::swap(corners[k], corners[k - 1]), sign = -sign;
    const glm::dvec3& start = corners[0]->place;
    const double own =
        glm::dot(glm::cross(corners[1]->place - start, corners[2]->place - start), corners[3]->place - start);
    return sign * (own == 0 ? std::numeric_limits<double>::min() : own);
}
} // namespace

bool CCrossingCurves::Segment::meets(const Segment& own) const {
    return std::ranges::any_of(nodes, [&](Index node) { return std::ranges::count(own.nodes, node) > 0; });
}

CCrossingCurves::CCrossingCurves(const CrossingSurfaces& surfaces, const CWoodPatch& patch)
    : m_surfaces(surfaces), m_patch(patch) {
    for (const Index t : surfaces.own)
        for (const Index point : cornersOf(t))
            if (const glm::dvec3 normal = patch.normalAt(point); glm::length(normal) > 0)
                move(point, patch.place(point) - surfaces.inset * glm::normalize(normal));
    if (surfaces.start) moveBase(*surfaces.start);
}

void CCrossingCurves::move(Index point, const glm::dvec3& place) {
    if (point >= m_movedOf.size()) m_movedOf.resize(point + std::size_t{1}, CWoodPatch::kNone);
    if (m_movedOf[point] == CWoodPatch::kNone) {
        m_movedOf[point] = static_cast<Index>(m_moved.size());
        m_moved.push_back(place);
    } else
        m_moved[m_movedOf[point]] = place;
}

void CCrossingCurves::moveBase(const glm::dvec3& start) {
    glm::dvec3 sum(0);
    std::set<Index> points;
    for (const Index t : m_surfaces.base) points.insert(cornersOf(t).begin(), cornersOf(t).end());
    for (const Index point : points) sum += m_patch.place(point);
    const glm::dvec3 middle = sum / double(points.size());
    for (const Index point : points) move(point, start + kSmallBase * (m_patch.place(point) - middle));
}

CCrossingCurves::Facet CCrossingCurves::facetOf(Index triangle) const {
    Facet own{triangle, {}, glm::dvec3(0), boundsOf(triangle), glm::dvec3(0), 0};
    for (std::size_t c = 0; c < 3; ++c) own.corners[c] = placeOf(cornersOf(triangle)[c]);
    const glm::dvec3 face = glm::cross(own.corners[1] - own.corners[0], own.corners[2] - own.corners[0]);
    if (glm::length(face) > 0) own.normal = glm::normalize(face);
    own.middle = (own.corners[0] + own.corners[1] + own.corners[2]) / 3.0;
    for (const glm::dvec3& corner : own.corners) own.radius = std::max(own.radius, glm::distance(own.middle, corner));
    return own;
}

bool CCrossingCurves::Facet::isBeside(const Facet& plane) const {
    glm::dvec3 heights(0);
    for (int c = 0; c < 3; ++c)
        heights[c] = glm::dot(plane.normal, corners[static_cast<std::size_t>(c)] - plane.corners[0]);
    return std::min({heights.x, heights.y, heights.z}) > kClear ||
           std::max({heights.x, heights.y, heights.z}) < -kClear;
}

glm::dvec2 CCrossingCurves::flatOf(Index node, Index triangle) const {
    const Node& own = m_nodes[node];
    const auto corners = cornersOf(triangle);
    const auto within = [&](Index point) {
        return glm::dvec2(corners[1] == point ? 1 : 0, corners[2] == point ? 1 : 0);
    };
    if (own.triangle != triangle) return glm::mix(within(own.low), within(own.high), own.share);
    const glm::dvec3 shares = barycentricOf(own.place, placeOf(corners[0]), placeOf(corners[1]), placeOf(corners[2]));
    return {shares.y, shares.z};
}

/// Of the edge from one of a triangle's corners to the next, with a triangle of the other surface; kNone where they do not cross.
CCrossingCurves::Index CCrossingCurves::nodeOf(const Facet& edgeOf, std::uint32_t first, const Facet& facet,
                                               Surface surface) {
    Corner low = corner(edgeOf, first), high = corner(edgeOf, after(first));
    if (high.point < low.point) std::swap(low, high);
    const auto [known, isNew] = m_nodeOf.at({low.point, high.point, facet.triangle});
    if (!isNew) return known;
    const Corner a = corner(facet, 0), b = corner(facet, 1), c = corner(facet, 2);
    const double below = volume(a, b, c, low), above = volume(a, b, c, high);
    if ((below > 0) == (above > 0)) return CWoodPatch::kNone;
    const bool left = volume(low, high, a, b) > 0;
    if ((volume(low, high, b, c) > 0) != left || (volume(low, high, c, a) > 0) != left) return CWoodPatch::kNone;
    const double share = below / (below - above);
    m_nodes.push_back(
        {low.point, high.point, facet.triangle, surface, share, glm::mix(low.place, high.place, share)});
    return known = static_cast<Index>(m_nodes.size() - 1);
}

/// Adds the segment that two triangles have in common. False where that cannot be told.
bool CCrossingCurves::addSegment(const Facet& wood, const Facet& branch) {
    if (++m_pairs > kMostPairs) return false;
    if (wood.isBeside(branch) || branch.isBeside(wood)) return true;
    if (m_nodeOf.size() > kMostMeetings) return false;
    std::array<Index, 6> nodes{};
    std::size_t count = 0;
    const auto add = [&](Index node) {
        if (node != CWoodPatch::kNone) nodes[count++] = node;
    };
    for (std::uint32_t c = 0; c < 3; ++c) {
        add(nodeOf(wood, c, branch, Surface::Wood));
        add(nodeOf(branch, c, wood, Surface::Branch));
    }
    if (count != 2) return count == 0;
    for (const Index node : {nodes[0], nodes[1]}) m_nodes[node].segments.push_back(static_cast<Index>(m_segments.size()));
    m_segments.push_back(
        {{nodes[0], nodes[1]}, {wood.triangle, branch.triangle}, glm::cross(branch.normal, wood.normal)});
    return true;
}

/// Around the branch, both as it is and as it was moved.
Bounds CCrossingCurves::reachOfBranch() const {
    Bounds reach = kNowhere;
    for (const Index t : m_surfaces.branch)
        for (const Index point : cornersOf(t)) include(reach, glm::vec3(placeOf(point))), include(reach, glm::vec3(m_patch.place(point)));
    return reach;
}

Bounds CCrossingCurves::boundsOf(Index triangle) const {
    Bounds own = kNowhere;
    for (const Index point : cornersOf(triangle)) include(own, glm::vec3(placeOf(point)));
    return own;
}

std::vector<CCrossingCurves::Facet> CCrossingCurves::allOfWood() const {
    std::vector<Facet> all;
    for (const Index t : m_surfaces.wood) all.push_back(facetOf(t));
    return all;
}

bool CCrossingCurves::findSegments() {
    std::vector<Facet>& wood = m_facets[0];
    std::vector<Facet>& branch = m_facets[1];
    const Bounds reach = reachOfBranch();
    for (const Index t : m_surfaces.wood)
        if (touch(boundsOf(t), reach)) wood.push_back(facetOf(t));
    for (const Index t : m_surfaces.branch) branch.push_back(facetOf(t));
    std::vector<Bounds> bounds;
    for (const Facet& own : branch) bounds.push_back(own.bounds);
    CBoundsTree tree(std::move(bounds));
    bool clear = true;
    for (const Facet& own : wood)
        tree.forEachTouching(own.bounds, [&](std::uint32_t b) { return clear = clear && addSegment(own, branch[b]); });
    return clear;
}

bool CCrossingCurves::findCurves() {
    for (Index first = 0; first < m_segments.size(); ++first) {
        if (m_segments[first].used) continue;
        Curve curve;
        Index segment = first, node = m_segments[first].nodes[0];
        while (segment != CWoodPatch::kNone && !m_segments[segment].used) {
            m_segments[segment].used = true;
            curve.nodes.push_back(node);
            curve.segments.push_back(segment);
            node = m_segments[segment].other(node);
            const std::vector<Index>& both = m_nodes[node].segments;
            if (both.size() > 2) return false;
            segment = both.size() < 2 ? CWoodPatch::kNone : both[both[0] == segment ? 1 : 0];
        }
        if (segment != first) continue; // it ends at the patch's border, or starts there
        orient(curve);
        m_curves.push_back(std::move(curve));
    }
    return true;
}

void CCrossingCurves::orient(Curve& curve) const {
    double along = 0;
    for (std::size_t i = 0; i < curve.nodes.size(); ++i) {
        const Segment& own = m_segments[curve.segments[i]];
        const glm::dvec3 way = m_nodes[own.other(curve.nodes[i])].place - m_nodes[curve.nodes[i]].place;
        along += glm::dot(way, own.along);
    }
    if (along > 0) return;
    std::ranges::reverse(curve.nodes);
    std::reverse(curve.segments.begin(), curve.segments.end() - 1);
}

void CCrossingCurves::findConflicts() {
    struct Part {
        Index curve, segment;
        std::array<glm::dvec2, 2> ends;
    };
    std::map<Index, std::vector<Part>> parts; // by triangle
    for (Index c = 0; c < m_curves.size(); ++c)
        for (const Index segment : m_curves[c].segments) {
            const Segment& own = m_segments[segment];
            for (const Index t : own.triangles)
                parts[t].push_back({c, segment, {flatOf(own.nodes[0], t), flatOf(own.nodes[1], t)}});
        }
    const auto parted = [](const Part& own, const Part& by) {
        return (twiceArea(by.ends[0], by.ends[1], own.ends[0]) > 0) !=
               (twiceArea(by.ends[0], by.ends[1], own.ends[1]) > 0);
    };
    for (const auto& [triangle, all] : parts)
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (!m_segments[all[i].segment].meets(m_segments[all[k].segment]) && parted(all[i], all[k]) &&
                    parted(all[k], all[i]))
                    m_conflicts.insert(std::minmax(all[i].curve, all[k].curve));
}

bool CCrossingCurves::find() {
    if (!findSegments() || !findCurves()) return false;
    findConflicts();
    return true;
}

} // namespace stromar
