#pragma once
#include "stromar/tree/Tree.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace stromar {

/// A stem's first path as if it were straight: y counts metres along it; before its base and beyond its tip it goes on
/// as there.
class CStraightStem {
public:
    /// z looks `turn` radians from the segments' X towards their Y.
    CStraightStem(const CGeneration& generation, const CStem& stem, double turn)
        : m_first(&generation.segments[generation.paths[stem.firstPath].firstSegment]),
          m_count(generation.paths[stem.firstPath].segmentCount), m_cosine(std::cos(turn)), m_sine(std::sin(turn)) {}

    double length() const { return m_first->length * m_count; }

    /// Columns: to the right, along, to the viewer.
    Frame frameOf(std::size_t segment) const {
        const Frame& f = m_first[segment].frame;
        const glm::dvec3 front = m_cosine * f[0] + m_sine * f[1];
        return {glm::cross(f[2], front), f[2], front};
    }

    std::size_t segmentAt(double y) const {
        return static_cast<std::size_t>(std::clamp(y / m_first->length, 0.0, m_count - 0.5));
    }
    /// Of the axis.
    glm::dvec3 pointAt(double y) const {
        const std::size_t i = segmentAt(y);
        return m_first[i].position + (y - double(i) * m_first->length) * m_first[i].frame[2];
    }

    /// Where on the stem a point is nearest to its axis.
    double nearest(const glm::dvec3& point) const {
        double best = 0, least = -1;
        for (std::uint32_t i = 0; i < m_count; ++i) {
            const CSegment& segment = m_first[i];
            const double along = std::clamp(glm::dot(point - segment.position, segment.frame[2]), 0.0, segment.length);
            const double distance = glm::distance(point, segment.axisPoint(along / segment.length));
            if (least >= 0 && distance >= least) continue;
            least = distance;
            best = i * m_first->length + along;
        }
        return best;
    }

    const CSegment& segment(std::size_t i) const { return m_first[i]; }
    std::uint32_t segmentCount() const { return m_count; }

private:
    const CSegment* m_first;
    std::uint32_t m_count;
    double m_cosine, m_sine;
};

} // namespace stromar
