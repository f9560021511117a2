#include "PointGenerator.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace stromar {

namespace {
constexpr double kTurn = 2 * std::numbers::pi;

/// A frame half way between two that differ by a bend.
Frame between(const Frame& a, const Frame& b) { return transported(a, glm::normalize(a[2] + b[2])); }
} // namespace

void CPointGenerator::startTube(const Tube& tube) {
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

void CPointGenerator::addLid(bool base, VertexSink& sink) const {
    const RingShape& ring = base ? m_rings.front() : m_rings.back();
    const glm::dvec3 normal = base ? -ring.frame[2] : ring.frame[2];
    const auto add = [&](const glm::dvec3& point, glm::dvec2 at) {
        sink.add(point, normal, m_wrap.x * (0.5 + at.x / 8), m_wrap.y * (ring.along + at.y / 8));
    };
    if (ring.lobes > 0) add(ring.centre, {0, 0});
    for (std::uint32_t i = 0; i < m_points; ++i) add(pointAt(ring, i), m_circle[i]);
}

} // namespace stromar
