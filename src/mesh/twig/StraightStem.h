#pragma once
#include "stromar/tree/Tree.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

namespace stromar {

/// A stem's first path as if it were straight: y counts metres along it; before its base and beyond its tip it goes on
/// as there.
class CStraightStem {
public:
    /// z looks `turn` radians from the segments' X towards their Y.
    CStraightStem(const CGeneration& generation, const CStem& stem, double turn)
        : m_segments(generation.segmentsOf(generation.paths[stem.firstPath])), m_cosine(std::cos(turn)),
          m_sine(std::sin(turn)) {}

    double length() const { return m_segments.back().end(); }

    /// Columns: to the right, along, to the viewer.
    Frame frameOf(std::size_t segment) const {
        const Frame& f = m_segments[segment].frame;
        const glm::dvec3 front = m_cosine * f[0] + m_sine * f[1];
        return {glm::cross(f[2], front), f[2], front};
    }

    std::size_t segmentAt(double y) const {
        const auto above = std::ranges::upper_bound(m_segments.subspan(1), y, {}, &CSegment::start);
        return static_cast<std::size_t>(above - m_segments.begin()) - 1;
    }
    /// Of the axis.
    glm::dvec3 pointAt(double y) const {
        const CSegment& segment = m_segments[segmentAt(y)];
        return segment.position + (y - segment.start) * segment.frame[2];
    }

    /// Where on the stem a point is nearest to its axis.
    double nearest(const glm::dvec3& point) const {
        double best = 0, smallest = -1;
        for (const CSegment& segment : m_segments) {
            const double along = std::clamp(glm::dot(point - segment.position, segment.frame[2]), 0.0, segment.length);
            const double distance = glm::distance(point, segment.axisPoint(along / segment.length));
            if (smallest >= 0 && distance >= smallest) continue;
            smallest = distance;
            best = segment.start + along;
        }
        return best;
    }

    std::span<const CSegment> segments() const { return m_segments; }

private:
    std::span<const CSegment> m_segments;
    double m_cosine, m_sine;
};

} // namespace stromar
