#pragma once
#include "stem/TubeWalls.h"
#include "stromar/mesh/MeshBuilder.h"
#include <optional>
#include <span>
#include <vector>

namespace stromar {

/// The base of a branch: a ring of points on its parent's surface.
struct Collar {
    std::vector<SurfacePoint> points;
    double clear; ///< how far along the branch, from its base, its own rings may start; metres

    /// The shortest distance between neighbours; metres.
    double minGap() const;
};

/// Presses the first rings of branches onto the triangles of their parents (thesis §4.4, "branch connection").
class CCollarMaker {
public:
    static constexpr double kAlong = 1.5, kAcross = 1.2; ///< width, in radii, along the parent's axis and across it

    CCollarMaker(const CGeneration& parents, const StemMesh& parentMesh) : m_parents(parents), m_mesh(parentMesh) {}

    /// `branch` are the segments of its first path, `radius` is its at the base, `points` how many its rings have.
    /// Nothing when the branch does not leave the wood, or leaves it so late that too little of it would be seen: then
    /// it simply starts inside.
    const Collar* make(const CStem& stem, std::span<const CSegment> branch, double radius, std::uint32_t points);

private:
    struct Triangle {
        glm::dvec3 corner, edge1, edge2;
        std::size_t firstIndex;
    };
    struct Hit {
        double distance;
        SurfacePoint point;
    };

    /// Where the centre line of a branch leaves the wood: the last place that is inside.
    struct Exit {
        glm::dvec3 centre;
        Frame frame;     ///< Z along the line
        double along;    ///< of the branch, metres from its base
        double rise; ///< of the axis per metre of a helix's line, 1 when straight
        double helixArc; ///< length of the helix's turn, 0 when straight
    };

    bool partAt(const CStem& branch, const CStem& parent, std::uint32_t other) const;
    const Collar* makeOn(std::uint32_t path, const CStem& stem, std::span<const CSegment> branch, double radius, std::uint32_t points);
    bool collectTriangles(std::uint32_t path, double offset);
    double reachOf(const CStem& stem, const glm::dvec3& parentAxis, const glm::dvec3& axis, double radius) const;
    std::optional<Exit> findExit(std::span<const CSegment> branch) const;
    std::optional<Hit> lastExit(const glm::dvec3& origin, const glm::dvec3& direction) const;
    std::optional<Hit> nearestExit(const Exit& exit, const glm::dvec3& offset) const;
    SurfacePoint surfaceAt(const Triangle& triangle, double u, double v) const;

    const CGeneration& m_parents;
    const StemMesh& m_mesh;
    std::optional<CTubeWalls> m_walls; ///< of the parents' tube that was looked at last
    std::int32_t m_wallsOf = -1;
    std::vector<Triangle> m_triangles;
    double m_reach = 0; ///< metres along the parent and the branch within which they can meet
    Collar m_collar;
};

} // namespace stromar
