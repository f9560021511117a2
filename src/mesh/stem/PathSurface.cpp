#include "stem/PathSurface.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr double kSlopeStep = 0.05; // radii
} // namespace

std::pair<std::uint32_t, double> placeAlong(const CGeneration& generation, const CStem& stem, const CPath& path,
                                            double along) {
    const std::span<const CSegment> segments = generation.segmentsOf(path);
    const CSegment* at = generation.segmentBelow(stem, path);
    if (!at || along >= segments.front().start) {
        const auto above = std::ranges::upper_bound(segments.subspan(1), along, {}, &CSegment::start);
        at = &*(above - 1);
    }
    return {static_cast<std::uint32_t>(at - generation.segments.data()),
            std::clamp((along - at->start) / at->length, 0.0, 1.0)};
}

void CPathSurface::start(const CStem& stem, const CPath& path, double maxTurn, bool lobed, std::uint32_t segments) {
    m_stem = &stem;
    m_path = &path;
    m_lobed = lobed;
    m_floor = m_surface.drawnFloor(stem, m_generation.segments[stem.firstSegment]);
    m_roots = lobed ? m_surface.rootsOf(stem) : CRootFlare();
    m_line.start(stem, path, maxTurn, segments);
}

RingShape CPathSurface::shapeAt(std::uint32_t index, double t) const {
    const CSegment& segment = m_generation.segments[index];
    RingShape shape{};
    static_cast<CCentreLine::Place&>(shape) = m_line.at(index, t);
    shape.radius = std::max(m_floor, m_surface.woodRadius(*m_stem, segment, t));
    shape.along = segment.start + t * segment.length;
    shape.lobes = m_lobed ? m_surface.lobes() : 0;
    shape.lobeDepth = m_lobed ? m_surface.lobeDepth(*m_stem, shape.along) : 0;
    return shape;
}

RingShape CPathSurface::shapeAt(double along) const {
    const auto [segment, t] = placeAlong(m_generation, *m_stem, *m_path, along);
    RingShape shape = shapeAt(segment, t);
    const double step = kSlopeStep * shape.radius;
    shape.slope = (woodRadiusAt(along + step) - woodRadiusAt(along - step)) / (2 * step);
    return shape;
}

double CPathSurface::woodRadiusAt(double along) const {
    const auto [segment, t] = placeAlong(m_generation, *m_stem, *m_path, along);
    return std::max(m_floor, m_surface.woodRadius(*m_stem, m_generation.segments[segment], t));
}

double CPathSurface::radiusAt(const RingShape& ring, double angle) const {
    const double round = ring.lobes == 0
                             ? ring.radius
                             : std::max(m_floor, ring.radius * (1 + ring.lobeDepth * std::sin(ring.lobes * angle)));
    return m_roots.empty() ? round : round + m_stem->radius * m_roots.at(angle, ring.along / m_stem->length).out;
}

glm::dvec3 CPathSurface::pointAt(const RingShape& ring, double angle, glm::dvec2 direction) const {
    const glm::dvec3 offset = radiusAt(ring, angle) * (direction.x * ring.frame[0] + direction.y * ring.frame[1]);
    if (ring.stretch == 1) return ring.centre + offset;
    return ring.centre + offset + (ring.stretch - 1) * glm::dot(offset, ring.stretchAxis) * ring.stretchAxis;
}

glm::dvec3 CPathSurface::normalAt(const RingShape& ring, double angle, glm::dvec2 direction) const {
    const glm::dvec3 outwards = direction.x * ring.frame[0] + direction.y * ring.frame[1];
    if (ring.lobes == 0 && m_roots.empty()) return glm::normalize(outwards - ring.slope * ring.frame[2]);
    const CRootFlare::Rise root = m_roots.at(angle, ring.along / m_stem->length);
    const double trunk = m_stem->radius, radius = radiusAt(ring, angle), round = radius - trunk * root.out;
    const double turned =
        ring.radius * ring.lobeDepth * ring.lobes * std::cos(ring.lobes * angle) + trunk * root.around;
    const double slope = ring.slope * (round / ring.radius) + trunk * root.up / std::max(1e-12, m_stem->length);
    const glm::dvec3 around = direction.x * ring.frame[1] - direction.y * ring.frame[0];
    return glm::normalize(outwards - turned / radius * around - slope * ring.frame[2]);
}

} // namespace stromar
