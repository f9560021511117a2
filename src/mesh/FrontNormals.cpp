#include "FrontNormals.h"
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr int kPasses = 8;
constexpr float kMargin = 0.02f; // cosine
constexpr float kEffort = 0.05f; // more than needed with every pass: faces that work against each other

/// The triangles of a tube; those of its rings share normals at the seam.
class CRingNormals {
public:
    CRingNormals(CMesh& mesh, const Tube& tube)
        : m_mesh(mesh), m_tube(tube), m_rings(tube.collarRings + tube.ringCount - (tube.pointed ? 1 : 0)) {
        m_ringsEnd = tube.firstVertex + m_rings * (tube.points + 1);
        m_end = tube.firstIndex + tube.indexCount();
    }

    /// Whether some had to be turned: further from the face, the greater `effort` is.
    bool turnOnce(float effort) {
        m_effort = effort;
        bool turned = false;
        for (std::size_t t = m_tube.firstIndex; t < m_end; t += 3) turned |= turnAt(&m_mesh.indices[t]);
        return turned;
    }

    /// Gives the doubled vertices of the seam the same normals again.
    void closeSeam() {
        for (std::uint32_t ring = 0; ring < m_rings; ++ring) {
            const std::uint32_t first = m_tube.firstVertex + ring * (m_tube.points + 1);
            m_mesh.normals[first + m_tube.points] = m_mesh.normals[first];
        }
    }

private:
    bool turnAt(const std::uint32_t* corners) {
        const glm::vec3& a = m_mesh.positions[corners[0]];
        const glm::vec3 face = glm::cross(m_mesh.positions[corners[1]] - a, m_mesh.positions[corners[2]] - a);
        const float area = glm::length(face);
        if (!(area > 0)) return false;
        bool turned = false;
        for (int c = 0; c < 3; ++c) turned |= turn(m_mesh.normals[seamless(corners[c])], face / area);
        return turned;
    }

    bool turn(glm::vec3& normal, const glm::vec3& face) const {
        const float cosine = glm::dot(normal, face);
        if (cosine >= kMargin / 2) return false;
        normal = glm::normalize(normal + (kMargin - cosine + m_effort) * face);
        return true;
    }

    std::uint32_t seamless(std::uint32_t vertex) const {
        const bool seam = vertex < m_ringsEnd && (vertex - m_tube.firstVertex) % (m_tube.points + 1) == m_tube.points;
        return seam ? vertex - m_tube.points : vertex;
    }

    CMesh& m_mesh;
    const Tube& m_tube;
    std::uint32_t m_rings; ///< a tip is none
    std::uint32_t m_ringsEnd;
    std::size_t m_end;
    float m_effort = 0;
};
} // namespace

bool turnNormalsToFront(CMesh& mesh, const Tube& tube) {
    CRingNormals normals(mesh, tube);
    int pass = 0;
    while (pass < kPasses && normals.turnOnce(kEffort * static_cast<float>(pass))) ++pass;
    normals.closeSeam();
    return pass < kPasses;
}

} // namespace stromar
