#include "PointGenerator.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace stromar {

namespace {
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kCrease = 0.3;   // least cosine between a collar's lowest normals and the branch's
constexpr double kLidDepth = 0.1; // radii
constexpr double kFillet = 0.6;   // part of the collar's height along which it follows the branch

/// A frame half way between two that differ by a bend.
Frame between(const Frame& a, const Frame& b) { return transported(a, glm::normalize(a[2] + b[2])); }
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
    m_rings.clear();
    for (std::uint32_t i = 0; i < tube.ringCount; ++i)
        m_rings.push_back(shapeOf(tube, m_plan.rings[tube.firstRing + i], i));
    setSlopes();
}

RingShape CPointGenerator::shapeOf(const Tube& tube, const Ring& ring, std::uint32_t index) const {
    const CStem& stem = m_generation.stems[tube.stem];
    const CPath& path = m_generation.paths[tube.path];
    const CSegment& segment = m_generation.segments[ring.segment];
    const std::uint32_t position = path.firstPosition + ring.segment - path.firstSegment;
    RingShape shape{};
    shape.centre = segment.centre(ring.t);
    shape.frame = frameOf(tube, ring, index);
    shape.radius = std::max(m_floor, m_surface.woodRadius(stem, segment, position, ring.t));
    shape.along = CStemSurface::along(stem, position, ring.t);
    shape.lobes = tube.lobed ? m_surface.lobes() : 0;
    shape.lobeDepth = tube.lobed ? m_surface.lobeDepth(shape.along) : 0;
    return shape;
}

Frame CPointGenerator::frameOf(const Tube& tube, const Ring& ring, std::uint32_t index) const {
    const CPath& path = m_generation.paths[tube.path];
    const CSegment& segment = m_generation.segments[ring.segment];
    if (segment.helixRadius > 0) return transported(segment.frame, segment.tangent(ring.t));
    if (ring.t > 0) return segment.frame;
    if (index > 0) {
        const CSegment& below = m_generation.segments[ring.segment - 1];
        // Where clones leave, the ring stays square to the part below, so that all paths start from the same circle.
        return below.forks ? transported(segment.frame, below.frame[2]) : between(segment.frame, below.frame);
    }
    if (path.source < 0) return segment.frame;
    const CPath& source =
        m_generation.paths[m_generation.stems[tube.stem].firstPath + static_cast<std::uint32_t>(path.source)];
    const CSegment& fork = m_generation.segments[source.firstSegment + path.firstPosition - 1 - source.firstPosition];
    return transported(segment.frame, fork.frame[2]);
}

void CPointGenerator::setSlopes() {
    for (std::size_t i = 0; i < m_rings.size(); ++i) {
        const RingShape& low = m_rings[i == 0 ? 0 : i - 1];
        const RingShape& high = m_rings[std::min(i + 1, m_rings.size() - 1)];
        m_rings[i].slope = (high.radius - low.radius) / std::max(1e-12, glm::distance(low.centre, high.centre));
    }
}

double CPointGenerator::radiusAt(const RingShape& ring, double angle) const {
    if (ring.lobes == 0) return ring.radius;
    return std::max(m_floor, ring.radius * (1 + ring.lobeDepth * std::sin(ring.lobes * angle)));
}

glm::dvec3 CPointGenerator::pointAt(const RingShape& ring, std::uint32_t i) const {
    const double radius = radiusAt(ring, kTurn * i / m_points);
    return ring.centre + radius * (m_circle[i].x * ring.frame[0] + m_circle[i].y * ring.frame[1]);
}

/// The surface is centre + r(angle, s)·outwards + s·axis; the normal is the product of its two tangents.
glm::dvec3 CPointGenerator::normalAt(const RingShape& ring, double angle, glm::dvec2 direction) const {
    const glm::dvec3 outwards = direction.x * ring.frame[0] + direction.y * ring.frame[1];
    if (ring.lobes == 0) return glm::normalize(outwards - ring.slope * ring.frame[2]);
    const double radius = radiusAt(ring, angle);
    const double turned = ring.radius * ring.lobeDepth * ring.lobes * std::cos(ring.lobes * angle) / radius;
    const glm::dvec3 around = direction.x * ring.frame[1] - direction.y * ring.frame[0];
    return glm::normalize(outwards - turned * around - ring.slope * (radius / ring.radius) * ring.frame[2]);
}

void CPointGenerator::addRing(std::size_t r, VertexSink& sink) const {
    const RingShape& ring = m_rings[r];
    for (std::uint32_t i = 0; i <= m_points; ++i) {
        const std::uint32_t k = i == m_points ? 0 : i;
        sink.add(pointAt(ring, k), normalAt(ring, kTurn * k / m_points, m_circle[k]), m_wrap.x * i / m_points,
                 m_wrap.y * ring.along);
    }
}

void CPointGenerator::addTip(VertexSink& sink) const {
    const RingShape& tip = m_rings.back();
    RingShape below = m_rings[m_rings.size() - 2];
    below.slope = -below.radius / glm::distance(below.centre, tip.centre);
    below.lobes = 0;
    for (std::uint32_t i = 0; i < m_points; ++i) {
        const double middle = kTurn * (i + 0.5) / m_points;
        sink.add(tip.centre, normalAt(below, middle, {std::cos(middle), std::sin(middle)}),
                 m_wrap.x * (i + 0.5) / m_points, m_wrap.y * tip.along);
    }
}

/// The parent's normal, turned towards the branch's where the two meet in a crease.
glm::dvec3 CPointGenerator::creaseNormal(const glm::dvec3& parent, const glm::dvec3& own) {
    const double cosine = glm::dot(parent, own);
    const double share = cosine < kCrease ? (kCrease - cosine) / (1 - cosine) : 0;
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
    const CStem& stem = m_generation.stems[m_tube->stem];
    const CSegment& first = m_generation.segments[stem.firstSegment];
    for (std::uint32_t i = 0; i <= m_points; ++i) {
        const SurfacePoint point = collarPointAt(ring, i == m_points ? 0 : i);
        const double along = glm::dot(point.position - first.centre(0), first.tangent(0)) / stem.measures.length;
        sink.add(point.position, point.normal, m_wrap.x * i / m_points, m_wrap.y * along);
    }
}

void CPointGenerator::addLid(bool base, VertexSink& sink) const {
    if (base && m_tube->collarRings > 0) return addCollarLid(sink);
    const RingShape& ring = base ? m_rings.front() : m_rings.back();
    const glm::dvec3 normal = base ? -ring.frame[2] : ring.frame[2];
    const auto add = [&](const glm::dvec3& point, glm::dvec2 at) {
        sink.add(point, normal, m_wrap.x * (0.5 + at.x / 8), m_wrap.y * (ring.along + at.y / 8));
    };
    if (m_tube->middleOfLid(base)) add(ring.centre, {0, 0});
    for (std::uint32_t i = 0; i < m_points; ++i) add(pointAt(ring, i), m_circle[i]);
}

/// Closes a collar inside the parent: square to its first ring as a whole, the middle a little deeper.
void CPointGenerator::addCollarLid(VertexSink& sink) const {
    const SurfacePoint* points = &m_plan.collarPoints[m_tube->firstCollarPoint];
    glm::dvec3 middle(0), area(0);
    for (std::uint32_t i = 0; i < m_points; ++i) {
        middle += points[i].position / double(m_points);
        area += glm::cross(points[i].position - points[0].position,
                           points[(i + 1) % m_points].position - points[0].position);
    }
    const glm::dvec3 inwards = -glm::normalize(area);
    const auto add = [&](const glm::dvec3& point, glm::dvec2 at) {
        sink.add(point, inwards, m_wrap.x * (0.5 + at.x / 8), m_wrap.y * at.y / 8);
    };
    add(middle + kLidDepth * m_rings.front().radius * inwards, {0, 0});
    for (std::uint32_t i = 0; i < m_points; ++i) add(points[i].position, m_circle[i]);
}

} // namespace stromar
