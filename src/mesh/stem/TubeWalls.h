#pragma once
#include "stromar/mesh/MeshBuilder.h"
#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace stromar {

/// Finds the triangles of a tube by their place along its stem. Its walls lie one after the other: the collar's first, then one
/// above each ring; the last of a pointed tube is a cone. Made in time linear in the rings, asked in that of a search.
class CTubeWalls {
public:
    CTubeWalls(const CGeneration& generation, const MeshPlan& plan, const Tube& tube) : m_collar(tube.collarRings) {
        const Ring* rings = plan.ringsOf(tube);
        std::size_t index = tube.firstIndex;
        m_starts.push_back(index);
        for (std::uint32_t c = 0; c < m_collar; ++c) m_starts.push_back(index += wallIndices(tube.points, tube.points));
        for (std::uint32_t r = 0; r + 1 < tube.ringCount; ++r) {
            const bool cone = tube.pointed && r + 2 == tube.ringCount;
            m_starts.push_back(index += cone ? wallIndices(rings[r].points, 0) : wallIndices(rings[r], rings[r + 1]));
        }
        std::uint32_t vertex = tube.firstVertex + m_collar * (tube.points + 1);
        for (std::uint32_t r = 0; r < tube.ringCount; ++r) {
            const CSegment& segment = generation.segments[rings[r].segment];
            m_places.push_back(segment.start + rings[r].t * segment.length);
            m_vertices.push_back(vertex);
            vertex += tube.pointed && r + 1 == tube.ringCount ? 1 : rings[r].points + 1;
        }
        m_vertices.push_back(vertex);
    }

    /// The indices of the walls that reach between two places, metres from the stem's base; at least of one wall.
    std::pair<std::size_t, std::size_t> between(double low, double high) const {
        const auto walls = static_cast<std::ptrdiff_t>(m_starts.size()) - 1, collar = static_cast<std::ptrdiff_t>(m_collar);
        const auto above = std::upper_bound(m_places.begin(), m_places.end() - 1, high) - m_places.begin();
        const std::ptrdiff_t last = std::min(walls, std::max(collar + 1, collar + above));
        const auto below = std::lower_bound(m_places.begin() + 1, m_places.end(), low) - m_places.begin();
        const std::ptrdiff_t first = m_places.front() < low ? collar + below - 1 : 0;
        return {m_starts[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(first, 0, std::max<std::ptrdiff_t>(0, last - 1)))],
                m_starts[static_cast<std::size_t>(last)]};
    }

    /// The middle of what is drawn at a place, metres from the stem's base: between those of the rings around it.
    glm::dvec3 middleAt(const CMesh& mesh, double along) const {
        const auto above = std::upper_bound(m_places.begin() + 1, m_places.end() - 1, along) - m_places.begin();
        const auto high = static_cast<std::size_t>(above), low = high - 1;
        const double length = m_places[high] - m_places[low];
        const double share = length > 0 ? std::clamp((along - m_places[low]) / length, 0.0, 1.0) : 0.0;
        return glm::mix(middleOf(mesh, low), middleOf(mesh, high), share);
    }

    /// Where the walls' indices end and those of the lids start.
    std::size_t end() const { return m_starts.back(); }

private:
    glm::dvec3 middleOf(const CMesh& mesh, std::size_t ring) const {
        const std::uint32_t first = m_vertices[ring], end = std::max(m_vertices[ring + 1] - 1, first + 1); // the last repeats the first
        glm::dvec3 sum(0);
        for (std::uint32_t v = first; v < end; ++v) sum += glm::dvec3(mesh.positions[v]);
        return sum / double(end - first);
    }

    std::uint32_t m_collar;
    std::vector<double> m_places;      ///< of the rings
    std::vector<std::uint32_t> m_vertices; ///< the first of each ring, and the end
    std::vector<std::size_t> m_starts; ///< of the walls' indices, and the end
};

} // namespace stromar
