#include "stem/PointGenerator.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace stromar {

namespace {
constexpr double kTurn = 2 * std::numbers::pi;
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
    m_floor = m_surface.drawnFloor(stem, m_generation.segments[stem.firstSegment]);
    if (m_points != tube.points) {
        m_points = tube.points;
        m_circle.resize(m_points);
        for (std::uint32_t i = 0; i < m_points; ++i)
            m_circle[i] = {std::cos(kTurn * i / m_points), std::sin(kTurn * i / m_points)};
    }
    m_roots = tube.lobed ? m_surface.rootsOf(stem) : CRootFlare();
    m_bark = m_surface.barkOf(stem);
    m_line.start(stem, m_generation.paths[tube.path], tube.maxTurn);
    m_rings.clear();
    for (std::uint32_t i = 0; i < tube.ringCount; ++i)
        m_rings.push_back(shapeOf(tube, m_plan.rings[tube.firstRing + i]));
    setSlopes();
}

RingShape CPointGenerator::shapeOf(const Tube& tube, const Ring& ring) const {
    const CStem& stem = m_generation.stems[tube.stem];
    const CSegment& segment = m_generation.segments[ring.segment];
    RingShape shape{};
    static_cast<CCentreLine::Place&>(shape) = m_line.at(ring.segment, ring.t);
    shape.radius = std::max(m_floor, m_surface.woodRadius(stem, segment, ring.t));
    shape.along = segment.start + ring.t * segment.length;
    shape.lobes = tube.lobed ? m_surface.lobes() : 0;
    shape.lobeDepth = tube.lobed ? m_surface.lobeDepth(stem, shape.along) : 0;
    shape.skyVisibility = skyVisibilityAt(tube, shape.along);
    shape.points = ring.points;
    return shape;
}

/// Darker towards where the tube leaves its parent, a fork or the ground.
std::uint8_t CPointGenerator::skyVisibilityAt(const Tube& tube, double along) const {
    const CStem& stem = m_generation.stems[tube.stem];
    const CPath& path = m_generation.paths[tube.path];
    const double start = m_generation.segments[path.firstSegment].start;
    const double hidden = path.source >= 0 ? kHiddenInFork : stem.parent >= 0 ? kHiddenInCollar : kHiddenAtGround;
    const double radii = (along - start) / std::max(1e-9, stem.radius);
    return static_cast<std::uint8_t>(255 * (1 - hidden * std::exp(-std::max(0.0, radii) / kHiddenReach)) + 0.5);
}

void CPointGenerator::setSlopes() {
    for (std::size_t i = 0; i < m_rings.size(); ++i) {
        const RingShape& low = m_rings[i == 0 ? 0 : i - 1];
        const RingShape& high = m_rings[std::min(i + 1, m_rings.size() - 1)];
        m_rings[i].slope = (high.radius - low.radius) / std::max(1e-12, glm::distance(low.centre, high.centre));
    }
}

double CPointGenerator::radiusAt(const RingShape& ring, double angle) const {
    const double round = ring.lobes == 0
                             ? ring.radius
                             : std::max(m_floor, ring.radius * (1 + ring.lobeDepth * std::sin(ring.lobes * angle)));
    return m_roots.empty() ? round : round + trunkRadius() * m_roots.at(angle, ring.along / stem().length).out;
}

glm::dvec3 CPointGenerator::pointAt(const RingShape& ring, std::uint32_t i) const {
    const double radius = radiusAt(ring, kTurn * i / ring.points);
    const glm::dvec2 at = circle(ring, i);
    const glm::dvec3 offset = radius * (at.x * ring.frame[0] + at.y * ring.frame[1]);
    if (ring.stretch == 1) return ring.centre + offset;
    return ring.centre + offset + (ring.stretch - 1) * glm::dot(offset, ring.stretchAxis) * ring.stretchAxis;
}

/// The surface is centre + r(angle, s)·outwards + s·axis; the normal is the product of its two tangents.
glm::dvec3 CPointGenerator::normalAt(const RingShape& ring, double angle, glm::dvec2 direction) const {
    const glm::dvec3 outwards = direction.x * ring.frame[0] + direction.y * ring.frame[1];
    if (ring.lobes == 0 && m_roots.empty()) return glm::normalize(outwards - ring.slope * ring.frame[2]);
    const CRootFlare::Rise root = m_roots.at(angle, ring.along / stem().length);
    const double radius = radiusAt(ring, angle), round = radius - trunkRadius() * root.out;
    const double turned =
        ring.radius * ring.lobeDepth * ring.lobes * std::cos(ring.lobes * angle) + trunkRadius() * root.around;
    const double slope =
        ring.slope * (round / ring.radius) + trunkRadius() * root.up / std::max(1e-12, stem().length);
    const glm::dvec3 around = direction.x * ring.frame[1] - direction.y * ring.frame[0];
    return glm::normalize(outwards - turned / radius * around - slope * ring.frame[2]);
}

void CPointGenerator::addRing(std::size_t r, VertexSink& sink) const {
    const RingShape& ring = m_rings[r];
    for (std::uint32_t i = 0; i <= ring.points; ++i) {
        const std::uint32_t k = i == ring.points ? 0 : i;
        sink.add(pointAt(ring, k), normalAt(ring, kTurn * k / ring.points, circle(ring, k)), around(ring, i),
                 bark(ring.along), ring.skyVisibility);
    }
}

void CPointGenerator::addTip(VertexSink& sink) const {
    const RingShape &tip = m_rings.back(), &below = m_rings[m_rings.size() - 2];
    for (std::uint32_t i = 0; i < below.points; ++i) {
        const glm::dvec3 left = pointAt(below, i), right = pointAt(below, (i + 1) % below.points);
        const glm::dvec3 face = glm::cross(right - left, tip.centre - left);
        sink.add(tip.centre, glm::normalize(face), around(below, i + 0.5), bark(tip.along), tip.skyVisibility);
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
    const RingShape& own = m_rings.front();
    const glm::dvec3 normal = normalAt(own, kTurn * i / m_points, m_circle[i]);
    const glm::dvec3 lowNormal = creaseNormal(low.normal, normal);
    if (ring == 0) return {low.position, lowNormal};
    const glm::dvec3 high = pointAt(own, i);
    const glm::dvec3 corner = high - kFillet * glm::dot(high - low.position, own.frame[2]) * own.frame[2];
    const double t = double(ring) / m_tube->collarRings;
    return {(1 - t) * (1 - t) * low.position + 2 * t * (1 - t) * corner + t * t * high,
            glm::normalize((1 - t) * lowNormal + t * normal)};
}

void CPointGenerator::addCollarRing(std::uint32_t ring, VertexSink& sink) const {
    const RingShape& own = m_rings.front();
    const double share = double(ring) / m_tube->collarRings;
    const double hidden = 255 * (1 - kHiddenInCollar);
    const auto open = static_cast<std::uint8_t>(hidden + share * (own.skyVisibility - hidden) + 0.5);
    for (std::uint32_t i = 0; i <= m_points; ++i) {
        const std::uint32_t k = i == m_points ? 0 : i;
        const SurfacePoint point = collarPointAt(ring, k);
        const double below = m_bark.perMetre * glm::distance(point.position, pointAt(own, k));
        sink.add(point.position, point.normal, around(own, i), bark(own.along) - below, open);
    }
}

void CPointGenerator::addLid(bool base, VertexSink& sink) const {
    if (base && m_tube->collarRings > 0) return addCollarLid(sink);
    const RingShape& ring = base ? m_rings.front() : m_rings.back();
    const glm::dvec3 normal = base ? -ring.frame[2] : ring.frame[2];
    const auto add = [&](const glm::dvec3& point, glm::dvec2 at) {
        sink.add(point, normal, m_bark.around * (0.5 + at.x / 8), bark(ring.along) + m_bark.around * at.y / 8,
                 ring.skyVisibility);
    };
    if (m_tube->middleOfLid(base)) add(ring.centre, {0, 0});
    for (std::uint32_t i = 0; i < ring.points; ++i) add(pointAt(ring, i), circle(ring, i));
}

/// Closes a collar inside the parent: seen along the branch its points lie around the branch's middle in their order.
void CPointGenerator::addCollarLid(VertexSink& sink) const {
    const SurfacePoint* points = &m_plan.collarPoints[m_tube->firstCollarPoint];
    const RingShape& own = m_rings.front();
    const glm::dvec3 inwards = -own.frame[2];
    double depth = kLidDepth * own.radius;
    for (std::uint32_t i = 0; i < m_points; ++i) depth += glm::dot(points[i].position - own.centre, inwards) / m_points;
    const auto add = [&](const glm::dvec3& point, glm::dvec2 at) {
        sink.add(point, inwards, m_bark.around * (0.5 + at.x / 8), m_bark.around * at.y / 8, 0);
    };
    add(own.centre + depth * inwards, {0, 0});
    for (std::uint32_t i = 0; i < m_points; ++i) add(points[i].position, m_circle[i]);
}

} // namespace stromar
