#include "stem/FrontNormals.h"
#include <algorithm>
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

bool turnAt(CMesh& mesh, const std::uint32_t* corners, float effort) {
    const glm::vec3& a = mesh.positions[corners[0]];
    const glm::vec3 face = glm::cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a);
    const float area = glm::length(face);
    if (!(area > 0)) return false;
    bool turned = false;
    for (int c = 0; c < 3; ++c) turned |= turn(mesh.normals[corners[c]], face / area, effort);
    return turned;
}

/// Whether some of the triangles' normals had to be turned: further from the face, the greater `effort` is.
bool turnOnce(CMesh& mesh, std::size_t begin, std::size_t end, float effort) {
    bool turned = false;
    for (std::size_t t = begin; t < end; t += 3) turned |= turnAt(mesh, &mesh.indices[t], effort);
    return turned;
}

/// The triangles of a tube; its rings' first and last vertices, at the seam of the bark, share a normal.
class CRingNormals {
public:
    CRingNormals(CMesh& mesh, const MeshPlan& plan, const Tube& tube)
        : m_mesh(mesh), m_plan(plan), m_tube(tube) {}

    bool turnOnce(float effort) {
        return stromar::turnOnce(m_mesh, m_tube.firstIndex, m_tube.firstIndex + m_tube.indexCount(), effort);
    }

    void closeSeam() {
        std::uint32_t first = m_tube.firstVertex;
        const auto close = [&](std::uint32_t points) {
            glm::vec3 &a = m_mesh.normals[first], &b = m_mesh.normals[first + points];
            if (a != b) a = b = glm::normalize(a + b);
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
    CMesh& m_mesh;
    const MeshPlan& m_plan;
    const Tube& m_tube;
};
} // namespace

bool turnNormalsToFront(CMesh& mesh, const MeshPlan& plan, const Tube& tube) {
    CRingNormals normals(mesh, plan, tube);
    for (int pass = 0; pass < kPasses; ++pass) {
        if (!normals.turnOnce(kEffort * static_cast<float>(pass))) return true;
        normals.closeSeam();
    }
    return false;
}

bool turnNormalsToFront(CMesh& mesh) {
    for (int pass = 0; pass < kPasses; ++pass)
        if (!turnOnce(mesh, 0, mesh.indices.size(), kEffort * static_cast<float>(pass))) return true;
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
