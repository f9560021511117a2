#include "stem/TubeTrial.h"
#include "stem/TubeWriter.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
/// Of every vertex; the lids' belong to the last ring and to the first.
std::vector<std::uint32_t> ringsOfVertices(const Tube& tube, const MeshPlan& plan) {
    std::vector<std::uint32_t> rings(tube.collarRings * (tube.points + 1), 0);
    for (std::uint32_t r = 0; r < tube.ringCount; ++r) rings.resize(rings.size() + plan.ringsOf(tube)[r].points + 1, r);
    rings.resize(std::max<std::size_t>(rings.size(), tube.vertexCount()), tube.ringCount - 1);
    return rings;
}
} // namespace

bool CTubeTrial::write(const MeshPlan& plan, const Tube& tube) {
    m_tube = tube;
    m_tube.firstVertex = 0;
    m_tube.firstIndex = 0;
    measure(plan, m_tube);
    m_mesh.positions.resize(m_tube.vertexCount());
    m_mesh.normals.resize(m_tube.vertexCount());
    m_mesh.texCoords.resize(m_tube.vertexCount());
    m_mesh.looks.resize(m_tube.vertexCount());
    m_mesh.indices.resize(m_tube.indexCount());
    CPointGenerator points(m_generation, plan, m_surface);
    return writeTube(plan, m_tube, points, m_mesh);
}

std::vector<std::uint32_t> CTubeTrial::foldedRings(const MeshPlan& plan) const {
    const std::vector<std::uint32_t> rings = ringsOfVertices(m_tube, plan);
    std::vector<std::uint32_t> folded;
    const auto& indices = m_mesh.indices;
    for (std::size_t t = 0; t < m_tube.indexCount(); t += 3) {
        const auto at = [&](std::size_t c) { return m_mesh.positions[indices[t + c]]; };
        const glm::vec3 face = glm::cross(at(1) - at(0), at(2) - at(0));
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t ring = rings[indices[t + c]];
            if (glm::dot(face, m_mesh.normals[indices[t + c]]) > 0 || (!folded.empty() && ring <= folded.back() + 1)) continue;
            folded.push_back(ring);
        }
    }
    if (folded.empty()) folded.push_back(1);
    return folded;
}

bool CTubeTrial::enclosesWood() const {
    double volume = 0;
    const glm::dvec3 origin(m_mesh.positions[0]);
    for (std::size_t t = 0; t < m_tube.indexCount(); t += 3) {
        const auto at = [&](std::size_t c) { return glm::dvec3(m_mesh.positions[m_mesh.indices[t + c]]) - origin; };
        volume += glm::dot(at(0), glm::cross(at(1), at(2)));
    }
    return volume > 0;
}

} // namespace stromar
