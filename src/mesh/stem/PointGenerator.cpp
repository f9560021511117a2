#include "stem/PointGenerator.h"
#include "stem/Fork.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace stromar {

namespace {
constexpr double kCrease = 0.3;     // least cosine between a coarse collar's lowest normals and the branch's
constexpr std::uint32_t kRound = 8; // points from which a ring is not coarse
constexpr double kLidDepth = 0.1;   // radii
constexpr double kFillet = 0.6;     // part of the collar's height along which it follows the branch

// How much of the sky is hidden where a surface starts, and how far that reaches, in radii.
constexpr double kHiddenInCollar = 0.55, kHiddenInFork = 0.35, kHiddenAtGround = 0.4, kHiddenReach = 2;
} // namespace

void CPointGenerator::startTube(const Tube& tube) {
    m_tube = &tube;
    const CStem& stem = m_generation.stems[tube.stem];
    if (m_points != tube.points) {
        m_points = tube.points;
        m_circle.resize(m_points);
        for (std::uint32_t i = 0; i < m_points; ++i)
            m_circle[i] = {std::cos(kTurn * i / m_points), std::sin(kTurn * i / m_points)};
    }
    startPath(stem, tube);
    m_rings.clear();
    for (std::uint32_t i = 0; i < tube.ringCount; ++i)
        m_rings.push_back(shapeOf(tube, m_plan.rings[tube.firstRing + i]));
    averageBaseOcclusion(tube);
    lookAtForks(tube);
    setSlopes();
    measureButtresses();
    drawLowest();
}

/// As far as the last ring.
void CPointGenerator::startPath(const CStem& stem, const Tube& tube) {
    const CPath& path = m_generation.paths[tube.path];
    const std::uint32_t last = m_plan.rings[tube.firstRing + tube.ringCount - 1].segment;
    m_path.start(stem, path, tube.maxTurn, tube.lobed, last < path.firstSegment ? 0 : last + 1 - path.firstSegment);
    if (tube.forked)
        m_bark.start(m_generation, stem, path, &m_plan.barkJoints[tube.barkJoint]);
    else
        m_bark.start(m_generation, stem, path, nullptr, m_generation.segments[last].end());
}

/// A collar's rings all lead to this one.
void CPointGenerator::drawLowest() {
    m_lowest.clear();
    for (std::uint32_t i = 0; i < (m_tube->collarRings > 0 ? m_points : 0); ++i) m_lowest.push_back({pointAt(m_rings.front(), i), normalAt(m_rings.front(), i)});
}

void CPointGenerator::lookAtForks(const Tube& tube) {
    for (const Fork& fork : m_plan.forksOf(tube)) {
        const std::size_t end = fork.ring + fork.rings;
        const ForkPoint* given = &m_plan.forkPoints[fork.firstPoint];
        for (std::size_t r = fork.ring; r < std::min(end, m_rings.size()); ++r) {
            m_rings[r].given = given;
            m_rings[r].onParent = tube.forked && fork.ring == 0;
            given += m_rings[r].points + 1;
        }
        if (end < m_rings.size()) m_rings[end].seam = fork.seam;
    }
}

/// Where a tube leaves its parent, a fork or the ground less of the sky is seen.
struct CPointGenerator::BaseOcclusion {
    double start, radius; ///< metres
    double hidden;        ///< of the sky

    /// In units of the reach.
    double above(double along) const { return std::max(0.0, along - start) / (kHiddenReach * std::max(1e-9, radius)); }
    std::uint8_t skyVisibility(double share) const { return static_cast<std::uint8_t>(255 * (1 - hidden * share) + 0.5); }
};

CPointGenerator::BaseOcclusion CPointGenerator::baseOcclusionOf(const Tube& tube) const {
    const CStem& stem = m_generation.stems[tube.stem];
    const CPath& path = m_generation.paths[tube.path];
    const bool inside = path.source >= 0 && !tube.joined; // where it starts
    return {inside ? m_generation.segments[path.firstSegment].start : 0, stem.radius,
            tube.forked ? 0 : inside ? kHiddenInFork : stem.parent >= 0 ? kHiddenInCollar : kHiddenAtGround};
}

CPointGenerator::DrawnRing CPointGenerator::shapeOf(const Tube& tube, const Ring& ring) const {
    DrawnRing shape{m_path.shapeAt(ring.segment, ring.t), {}, ring.points};
    const BaseOcclusion base = baseOcclusionOf(tube);
    shape.look = {base.skyVisibility(std::exp(-base.above(shape.along))), m_surface.thinness(shape.radius)};
    return shape;
}

/// Without a collar the second ring may be far: the lowest one gets the value with which the wall between them has the mean of many rings.
void CPointGenerator::averageBaseOcclusion(const Tube& tube) {
    if (tube.collarRings > 0 || tube.forked || m_rings.size() < 2) return;
    const BaseOcclusion base = baseOcclusionOf(tube);
    const double low = base.above(m_rings[0].along), wall = base.above(m_rings[1].along) - low;
    if (wall < 1e-3) return;
    const double end = std::exp(-wall), mean = (1 - end) / wall;
    m_rings[0].look.skyVisibility = base.skyVisibility(std::exp(-low) * (2 * mean - end));
}

VertexLook CPointGenerator::lookAt(const DrawnRing& ring, double skyVisibility) const {
    return {static_cast<std::uint8_t>(skyVisibility + 0.5), ring.look.thinness};
}

void CPointGenerator::setSlopes() {
    for (std::size_t i = 0; i < m_rings.size(); ++i) {
        const DrawnRing& low = m_rings[i == 0 ? 0 : i - 1];
        const DrawnRing& high = m_rings[std::min(i + 1, m_rings.size() - 1)];
        m_rings[i].slope = (high.radius - low.radius) / std::max(1e-12, glm::distance(low.centre, high.centre));
    }
}

/// On the way up a root the surface is longer than the trunk: its bark hangs from where the roots end.
void CPointGenerator::measureButtresses() {
    m_buttresses.clear();
    if (!m_tube->lobed || m_surface.roots() == 0) return;
    std::size_t count = 0;
    while (count + 1 < m_rings.size() && !m_rings[count].given && m_path.hasRootsAt(m_rings[count].along)) ++count;
    m_buttresses.resize(count);
    for (std::size_t r = count; r-- > 0;) {
        const DrawnRing &ring = m_rings[r], &above = m_rings[r + 1];
        const double up = above.along - ring.along;
        for (std::uint32_t i = 0; i < ring.points; ++i) {
            const double angle = angleOf(ring, i), out = m_path.radiusAt(ring, angle) - m_path.radiusAt(above, angle);
            const double more = std::hypot(up, out) - up;
            m_buttresses[r].push_back(more + (r + 1 < count ? m_buttresses[r + 1][i * above.points / ring.points] : 0));
        }
    }
}

/// Repeats at a point of a ring on roots.
double CPointGenerator::hangingBark(std::size_t r, std::uint32_t i) const {
    return m_bark.at(m_rings[r].along) - m_bark.perMetre() * m_buttresses[r][i];
}

double CPointGenerator::angleOf(const DrawnRing& ring, std::uint32_t i) const { return kTurn * i / ring.points; }

void CPointGenerator::addRing(std::size_t r, VertexSink& sink) const {
    const DrawnRing& ring = m_rings[r];
    if (ring.given) return addGivenRing(ring, sink);
    const auto points = static_cast<std::int32_t>(ring.points);
    const bool hangs = r < m_buttresses.size(), isLowest = r == 0 && !m_lowest.empty();
    const double bark = m_bark.at(ring.along);
    for (std::int32_t i = ring.seam; i < ring.seam + points; ++i) {
        const auto k = static_cast<std::uint32_t>((i % points + points) % points);
        const SurfacePoint own = isLowest ? m_lowest[k] : SurfacePoint{pointAt(ring, k), normalAt(ring, k)};
        sink.add(own.position, own.normal, around(ring, i), hangs ? hangingBark(r, k) : bark, ring.look);
    }
    const auto first = static_cast<std::uint32_t>((ring.seam % points + points) % points);
    sink.addAgain(ring.points, around(ring, ring.seam + points), hangs ? hangingBark(r, first) : bark);
}

void CPointGenerator::addGivenRing(const DrawnRing& ring, VertexSink& sink) const {
    for (const ForkPoint& point : std::span(ring.given, ring.points + 1)) {
        const double open = ring.look.skyVisibility * (1 - kHiddenInFork * double(point.depth));
        const double turn = double(point.turn), along = double(point.along);
        const glm::dvec2 bark = ring.onParent ? m_bark.onLimb(turn, along - stem().offset) : glm::dvec2(m_bark.around(turn), m_bark.at(along));
        sink.add(point.position, point.normal, bark.x, bark.y, lookAt(ring, open));
    }
}

void CPointGenerator::addTip(VertexSink& sink) const {
    const DrawnRing &tip = m_rings.back(), &below = m_rings[m_rings.size() - 2];
    for (std::uint32_t i = 0; i < below.points; ++i) {
        const glm::dvec3 left = pointAt(below, i), right = pointAt(below, (i + 1) % below.points);
        const glm::dvec3 face = glm::cross(right - left, tip.centre - left);
        sink.add(tip.centre, glm::normalize(face), around(below, i + 0.5), m_bark.at(tip.along), tip.look);
    }
}

/// The parent's normal; on coarse rings turned towards the branch's where the two meet in a crease.
glm::dvec3 CPointGenerator::creaseNormal(const glm::dvec3& parent, const glm::dvec3& own) const {
    const double cosine = glm::dot(parent, own);
    if (m_points >= kRound || cosine >= kCrease) return parent;
    const double share = (kCrease - cosine) / (1 - cosine);
    return glm::normalize((1 - share) * parent + share * own);
}

/// From the parent's surface to the first own ring on a parabola that leaves along the branch: a fillet.
SurfacePoint CPointGenerator::collarPointAt(std::uint32_t ring, std::uint32_t i) const {
    const SurfacePoint& low = m_plan.collarPoints[m_tube->firstCollarPoint + i];
    const glm::dvec3 &high = m_lowest[i].position, &normal = m_lowest[i].normal;
    const glm::dvec3 lowNormal = creaseNormal(low.normal, normal);
    if (ring == 0) return {low.position, lowNormal};
    const glm::dvec3 along = m_rings.front().frame[2], corner = high - kFillet * glm::dot(high - low.position, along) * along;
    const double t = double(ring) / m_tube->collarRings;
    return {(1 - t) * (1 - t) * low.position + 2 * t * (1 - t) * corner + t * t * high,
            glm::normalize((1 - t) * lowNormal + t * normal)};
}

void CPointGenerator::addCollarRing(std::uint32_t ring, VertexSink& sink) const {
    const DrawnRing& own = m_rings.front();
    const double share = double(ring) / m_tube->collarRings;
    const double hidden = 255 * (1 - kHiddenInCollar);
    const VertexLook look = lookAt(own, hidden + share * (own.look.skyVisibility - hidden));
    const double bark = m_bark.at(own.along);
    double first = 0;
    for (std::uint32_t i = 0; i < m_points; ++i) {
        const SurfacePoint point = collarPointAt(ring, i);
        const double at = bark - m_bark.perMetre() * glm::distance(point.position, m_lowest[i].position);
        if (i == 0) first = at;
        sink.add(point.position, point.normal, around(own, i), at, look);
    }
    sink.addAgain(m_points, around(own, m_points), first);
}

void CPointGenerator::addLid(bool base, VertexSink& sink) const {
    if (base && m_tube->collarRings > 0) return addCollarLid(sink);
    if (base && m_tube->forked) return addForkLid(true, m_plan.limbOf(*m_tube), m_rings[0].given, sink);
    const DrawnRing& ring = base ? m_rings.front() : m_rings.back();
    const glm::dvec3 normal = base ? -ring.frame[2] : ring.frame[2];
    const auto add = [&](const glm::dvec3& point, glm::dvec2 at) {
        sink.add(point, normal, m_bark.around() * (0.5 + at.x / 8), m_bark.at(ring.along) + m_bark.around() * at.y / 8,
                 ring.look);
    };
    if (m_tube->middleOfLid(base)) add(ring.centre, {0, 0});
    for (std::uint32_t i = 0; i < ring.points; ++i) add(pointAt(ring, i), circle(ring, i));
}

void CPointGenerator::addBranchLid(const ForkedBranch& branch, VertexSink& sink) const {
    addForkLid(false, branch.limb, &m_plan.branchPoints[branch.firstPoint], sink);
}

/// Inside the wood, at the base of a limb or over the hole that it leaves in its parent.
void CPointGenerator::addForkLid(bool base, const LimbLayout& limb, const ForkPoint* given, VertexSink& sink) const {
    const std::vector<std::uint32_t> boundary = limb.boundary();
    std::vector<glm::dvec3> line;
    for (const std::uint32_t i : boundary) line.emplace_back(given[i].position);
    const LidShape lid = lidOf(line);
    const glm::dvec3 normal = base ? -lid.normal : lid.normal;
    const DrawnRing& ring = m_rings.front();
    sink.add(lid.middle, normal, m_bark.around() * 0.5, m_bark.at(ring.along), ring.look);
    for (std::size_t i = 0; i < line.size(); ++i)
        sink.add(line[i], normal, m_bark.around() * double(given[boundary[i]].turn), m_bark.at(ring.along), ring.look);
}

/// Closes a collar inside the parent: seen along the branch its points lie around their middle in their order.
void CPointGenerator::addCollarLid(VertexSink& sink) const {
    const SurfacePoint* points = &m_plan.collarPoints[m_tube->firstCollarPoint];
    const DrawnRing& own = m_rings.front();
    const glm::dvec3 inwards = -own.frame[2];
    glm::dvec3 middle = kLidDepth * own.radius * inwards;
    for (std::uint32_t i = 0; i < m_points; ++i) middle += points[i].position / double(m_points);
    const auto add = [&](const glm::dvec3& point, glm::dvec2 at) {
        sink.add(point, inwards, m_bark.around() * (0.5 + at.x / 8), m_bark.around() * at.y / 8, lookAt(own, 0));
    };
    add(middle, {0, 0});
    for (std::uint32_t i = 0; i < m_points; ++i) add(points[i].position, m_circle[i]);
}

} // namespace stromar
