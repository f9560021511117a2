#pragma once
#include "stem/BarkScale.h"
#include "stem/PathSurface.h"
#include "stromar/mesh/MeshBuilder.h"
#include <cmath>
#include <vector>

namespace stromar {

/// A place of a tube's surface to write a vertex to.
struct VertexSink {
    glm::vec3* position;
    glm::vec3* normal;
    glm::vec2* texCoord;
    VertexLook* look;
    /// The one that was written so many before, with another place on the bark.
    void addAgain(std::size_t before, double u, double v) {
        *position = position[-static_cast<std::ptrdiff_t>(before)];
        *normal = normal[-static_cast<std::ptrdiff_t>(before)];
        *look = look[-static_cast<std::ptrdiff_t>(before)];
        *texCoord++ = glm::vec2(u, v);
        ++position, ++normal, ++look;
    }
    void add(const glm::dvec3& p, const glm::dvec3& n, double u, double v, VertexLook own) {
        *position++ = glm::vec3(p);
        *normal++ = glm::vec3(n);
        *texCoord++ = glm::vec2(u, v);
        *look++ = own;
    }
};

/// Makes the points of rings: position, normal, texture coordinates.
class CPointGenerator {
public:
    CPointGenerator(const CGeneration& generation, const MeshPlan& plan, const CStemSurface& surface)
        : m_generation(generation), m_plan(plan), m_surface(surface), m_path(generation, surface), m_bark(surface) {}

    /// Looks at all rings of a tube; the others speak of this one.
    void startTube(const Tube& tube);
    /// Points + 1 vertices: the seam is doubled.
    void addRing(std::size_t ring, VertexSink& sink) const;
    /// The same for a ring of the collar, counted from the parent's surface.
    void addCollarRing(std::uint32_t ring, VertexSink& sink) const;
    /// The tip of a pointed tube: one vertex per side.
    void addTip(VertexSink& sink) const;
    /// A lid on the lowest (`base`) or last ring, its middle vertex, if it has one, in front.
    void addLid(bool base, VertexSink& sink) const;
    /// Over the hole that a branch leaves at a fork.
    void addBranchLid(const ForkedBranch& branch, VertexSink& sink) const;

private:
    /// One of a tube, and how it is drawn.
    struct DrawnRing : RingShape {
        VertexLook look;
        std::uint32_t points;
        const ForkPoint* given = nullptr; ///< its points, at a fork
        std::int32_t seam = 0;            ///< the point it starts at, counted over whole turns
        bool onParent = false;            ///< given by a fork of the parent's
    };

    DrawnRing shapeOf(const Tube& tube, const Ring& ring) const;
    struct BaseOcclusion;
    BaseOcclusion baseOcclusionOf(const Tube& tube) const;
    void averageBaseOcclusion(const Tube& tube);
    VertexLook lookAt(const DrawnRing& ring, double skyVisibility) const;
    void setSlopes();
    void measureButtresses();
    double hangingBark(std::size_t ring, std::uint32_t i) const;
    const CStem& stem() const { return m_generation.stems[m_tube->stem]; }
    void lookAtForks(const Tube& tube);
    void addGivenRing(const DrawnRing& ring, VertexSink& sink) const;
    void addCollarLid(VertexSink& sink) const;
    void addForkLid(bool base, const LimbLayout& limb, const ForkPoint* given, VertexSink& sink) const;
    glm::dvec3 creaseNormal(const glm::dvec3& parent, const glm::dvec3& own) const;
    void startPath(const CStem& stem, const Tube& tube);
    void drawLowest();
    SurfacePoint collarPointAt(std::uint32_t ring, std::uint32_t i) const;
    glm::dvec3 pointAt(const DrawnRing& ring, std::uint32_t i) const {
        return m_path.pointAt(ring, angleOf(ring, i), circle(ring, i));
    }
    glm::dvec3 normalAt(const DrawnRing& ring, std::uint32_t i) const {
        return m_path.normalAt(ring, angleOf(ring, i), circle(ring, i));
    }
    double angleOf(const DrawnRing& ring, std::uint32_t i) const;
    double around(const DrawnRing& ring, double i) const { return m_bark.around(i / ring.points); }
    /// Cosine and sine of a point's angle.
    glm::dvec2 circle(const DrawnRing& ring, std::uint32_t i) const {
        if (m_points % ring.points == 0) return m_circle[i * (m_points / ring.points)];
        return {std::cos(angleOf(ring, i)), std::sin(angleOf(ring, i))};
    }

    const CGeneration& m_generation;
    const MeshPlan& m_plan;
    const CStemSurface& m_surface;
    CPathSurface m_path;
    CBarkScale m_bark;
    const Tube* m_tube = nullptr;
    std::uint32_t m_points = 0; ///< of the first ring
    std::vector<DrawnRing> m_rings;
    std::vector<std::vector<double>> m_buttresses; ///< of the rings from the lowest, by point: metres of bark more than of trunk above it
    std::vector<glm::dvec2> m_circle; ///< of the tube's first ring
    std::vector<SurfacePoint> m_lowest; ///< of a tube with a collar: the points of its first ring
};

} // namespace stromar
