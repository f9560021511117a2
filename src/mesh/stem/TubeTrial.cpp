#include "stem/TubeTrial.h"
#include "stem/TubeWriter.h"
#include <glm/geometric.hpp>

namespace stromar {

namespace {
/// The lids' vertices belong to the last ring and to the first.
std::uint32_t ringOf(const Tube& tube, const MeshPlan& plan, std::uint32_t vertex) {
    std::uint32_t end = tube.collarRings * (tube.points + 1);
    for (std::uint32_t r = 0; r < tube.ringCount; ++r) {
        end += plan.ringsOf(tube)[r].points + 1;
        if (vertex < end) return r;
    }
    return tube.ringCount - 1;
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

std::uint32_t CTubeTrial::foldedRing(const MeshPlan& plan) const {
    const auto& indices = m_mesh.indices;
    for (std::size_t t = 0; t < m_tube.indexCount(); t += 3) {
        const auto at = [&](std::size_t c) { return m_mesh.positions[indices[t + c]]; };
        const glm::vec3 face = glm::cross(at(1) - at(0), at(2) - at(0));
        for (std::size_t c = 0; c < 3; ++c)
            if (glm::dot(face, m_mesh.normals[indices[t + c]]) <= 0) return ringOf(m_tube, plan, indices[t + c]);
    }
    return 1;
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
