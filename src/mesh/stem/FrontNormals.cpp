#include "stem/FrontNormals.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr int kPasses = 24;
constexpr float kMargin = 0.02f; // cosine
constexpr float kEffort = 0.05f; // more than needed with every pass: faces that work against each other

bool turn(glm::vec3& normal, const glm::vec3& face, float effort) {
    const float cosine = glm::dot(normal, face);
    if (cosine >= kMargin / 2) return false;
    normal = glm::normalize(normal + (kMargin - cosine + effort) * face);
    return true;
}

/// The normals at a triangle's corners; false where none had to be turned, or it has no area.
bool turnAt(CMesh& mesh, const std::uint32_t* corners, float effort) {
    const glm::vec3& a = mesh.positions[corners[0]];
    const glm::vec3 across = glm::cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a);
    const auto cosine = [&](int c) { return glm::dot(mesh.normals[corners[c]], across); };
    const float least = std::min({cosine(0), cosine(1), cosine(2)}), squared = glm::dot(across, across);
    if (least > 0 && least * least > kMargin * kMargin * squared) return false; // as it is of nearly all
    const float area = std::sqrt(squared);
    if (!(area > 0)) return false;
    const glm::vec3 face = across / area;
    bool turned = false;
    for (int c = 0; c < 3; ++c) turned |= turn(mesh.normals[corners[c]], face, effort);
    return turned;
}

/// The triangles of a tube; its rings' first and last vertices, at the seam of the bark, share a normal.
class CRingNormals {
public:
    CRingNormals(CMesh& mesh, const MeshPlan& plan, const Tube& tube)
        : m_mesh(mesh), m_plan(plan), m_tube(tube) {}

    /// Whether some of the triangles' normals had to be turned: further from the face, the greater `effort` is. All are looked
    /// at the first time, then those where a normal has changed.
    bool turn(float effort) {
        bool turned = false;
        const bool first = m_changed.empty();
        const std::size_t end = m_tube.firstIndex + m_tube.indexCount();
        for (std::size_t t = m_tube.firstIndex; t < end; t += 3) {
            const std::uint32_t* corners = &m_mesh.indices[t];
            if (!first && !changed(corners[0]) && !changed(corners[1]) && !changed(corners[2])) continue;
            if (!turnAt(m_mesh, corners, effort)) continue;
            if (m_changed.empty()) m_changed.resize(m_tube.vertices);
            for (std::size_t c = 0; c < 3; ++c) changed(corners[c]) = true;
            turned = true;
        }
        return turned;
    }

    void closeSeam() {
        std::uint32_t first = m_tube.firstVertex;
        const auto close = [&](std::uint32_t points) {
            glm::vec3 &a = m_mesh.normals[first], &b = m_mesh.normals[first + points];
            if (a != b) {
                a = b = glm::normalize(a + b);
                changed(first) = changed(first + points) = true;
            }
            first += points + 1;
        };
        for (std::uint32_t r = 0; r < m_tube.collarRings; ++r) close(m_tube.points);
        for (std::uint32_t r = 0; r + (m_tube.pointed ? 1 : 0) < m_tube.ringCount; ++r) {
            const std::uint32_t points = m_plan.ringsOf(m_tube)[r].points;
            if (isOpen(r))
                first += points + 1;
            else
                close(points);
        }
    }

private:
    /// Whether a ring runs from valley to valley at a fork.
    bool isOpen(std::uint32_t r) const {
        const Fork* fork = m_plan.forkAt(m_tube, r);
        return fork && m_plan.ringsOf(m_tube)[fork->ring].parted;
    }
    std::uint8_t& changed(std::uint32_t vertex) { return m_changed[vertex - m_tube.firstVertex]; }

    CMesh& m_mesh;
    const MeshPlan& m_plan;
    const Tube& m_tube;
    std::vector<std::uint8_t> m_changed; ///< by vertex of the tube; empty before the first is
};
} // namespace

bool turnNormalsToFront(CMesh& mesh, const MeshPlan& plan, const Tube& tube) {
    CRingNormals normals(mesh, plan, tube);
    for (int pass = 0; pass < kPasses; ++pass) {
        if (!normals.turn(kEffort * static_cast<float>(pass))) return true;
        normals.closeSeam();
    }
    return false;
}

bool turnNormalsToFront(CMesh& mesh) {
    for (int pass = 0; pass < kPasses; ++pass) {
        bool turned = false;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
            turned |= turnAt(mesh, &mesh.indices[t], kEffort * static_cast<float>(pass));
        if (!turned) return true;
    }
    return false;
}

bool turnNormalsToFront(CMesh& mesh, const std::vector<std::size_t>& triangles) {
    for (int pass = 0; pass < kPasses; ++pass) {
        bool turned = false;
        for (const std::size_t t : triangles) turned |= turnAt(mesh, &mesh.indices[t], kEffort * static_cast<float>(pass));
        if (!turned) return true;
    }
    return false;
}

} // namespace stromar
