#pragma once
#include "join/TubeJoiner.h"
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace stromar {

/// Some triangles of joined wood, of whatever generations, as one surface that can be cut open and sewn up. Vertices at equal places of one
/// closed surface are one *point*. What was changed since mark() can be undone.
class CWoodPatch {
public:
    using Index = std::uint32_t;
    static constexpr Index kNone = ~Index{0};

    struct Vertex {
        JoinedWalls::Vertex value;
        std::uint32_t generation; ///< whose mesh it is of
        Index index;              ///< there; kNone: new
    };
    struct Triangle {
        std::array<Index, 3> vertices; ///< counter-clockwise
        std::array<Index, 3> points;
        std::uint32_t generation;
        std::size_t first; ///< of its indices in that mesh; of no meaning when new
        bool isNew = false, removed = false;
        Index whole = kNone; ///< which it was parted from since keepWholes(), or itself
        std::uint32_t selection = 0, flooded = 0; ///< by which select() and flood() it was found last; what is cut out of it is too
    };
    /// Of a triangle: from a corner to the one after it.
    struct Side {
        Index triangle;
        std::uint32_t corner;
    };
    /// Of a line with a triangle.
    struct Crossing {
        double share; ///< of the line
        Index triangle;
        glm::dvec3 place;
        bool leaves; ///< the wood
    };

    /// All within a distance from a line.
    struct Capsule {
        glm::dvec3 from, to;
        double radius;
    };

    CWoodPatch() = default;
    /// `pointOf` numbers the places of the vertices from 0.
    CWoodPatch(std::vector<Vertex> vertices, std::vector<Index> pointOf, std::vector<Triangle> triangles);

    /// What follows works on these triangles of those there were at the start, and on all that are new.
    void select(std::span<const Index> near);
    std::span<const Index> selected() const { return m_selected; } ///< some may be removed since
    /// Marks all of these that are connected with `seeds`, and no other.
    void flood(std::span<const Index> seeds);
    /// Marks these, which are all that are marked.
    void markOnly(std::span<const Index> triangles);
    bool isMarked(Index triangle) const { return m_triangles[triangle].flooded == m_flood; }
    /// Of a line with some triangles, from its start.
    std::vector<Crossing> crossings(const glm::dvec3& from, const glm::dvec3& to, std::span<const Index> among) const;
    /// The marked triangles that may touch one.
    std::vector<Index> near(const Capsule& capsule) const;

    /// A point at a place on a marked triangle: a new one, or one that is nearer than `apart`, metres. kNone where it cannot be.
    Index pointAt(Index triangle, const glm::dvec3& at, double apart);
    /// Likewise at the nearest place of the marked surface.
    Index pointNear(const glm::dvec3& at, double apart);
    /// Of a crossing, also when its triangle has been parted since.
    Index pointAt(const Crossing& crossing, double apart) {
        return m_triangles[crossing.triangle].removed ? pointNear(crossing.place, apart) : pointAt(crossing.triangle, crossing.place, apart);
    }
    /// Makes edges from one point to another where a plane through both, with a normal across, cuts the marked surface; appends the points
    /// on the way and the last. It does not touch points of `closed`. False where there is no short way.
    bool cut(Index from, Index to, const glm::dvec3& across, double apart, std::span<const Index> closed, std::vector<Index>& way);
    /// Takes out what lies on the left of a closed loop of edges. False where that is not bounded by the loop, is of a later generation or,
    /// where it must be near, reaches far beyond it.
    bool removeLeftOf(std::span<const Index> loop, std::uint32_t generation, bool near);

    /// Lets the triangles that are selected now be those that others are parted from.
    void keepWholes();
    Index addPoint(const glm::dvec3& place, const VertexSource& source);
    const VertexSource& sourceOf(Index point) const { return m_sources[point]; }
    /// Parts the triangles on both sides of an edge, at a share of its length. False where there are not two.
    bool splitEdge(Index one, Index other, double share, Index point);
    /// Parts a triangle into three. `shares`: barycentric.
    void splitFace(Index triangle, const glm::dvec3& shares, Index point);
    /// Takes out some parts of one triangle and puts others there, with corners at points of those.
    void replace(std::span<const Index> parts, std::span<const std::array<Index, 3>> points);
    void remove(Index triangle);
    /// Moves a point to one at the other end of an edge, whose two triangles are left out. False, and nothing done, where anything would fold.
    bool collapse(Index from, Index to);
    /// The triangle on the other side; kNone at the patch's border.
    Index beyond(const Side& side) const;
    /// Calls work(triangle) for those at a point.
    template <typename Do> void forEachAround(Index point, Do&& work) const {
        for (const Index t : m_around[point])
            if (!m_triangles[t].removed) work(t);
    }

    /// A vertex like what lies so far between two others, whose picture is `below` it, repeats.
    Index addBetween(Index one, Index other, double share, double below, Index point);
    /// Of a triangle at a point: the vertex there.
    Index vertexAt(Index point) const;
    /// Of the triangle to the left of an edge: the vertex at its start or its end.
    Index vertexAt(Index from, Index to, bool end) const;
    void addTriangle(const std::array<Index, 3>& vertices, std::uint32_t generation);
    /// Whether all that was added since mark() is closed, not flat, and no side or place is there twice. Gives corners that look away from their normal another one.
    bool finish();

    void mark();
    void undo();

    std::span<const Triangle> triangles() const { return m_triangles; }
    std::span<const Vertex> vertices() const { return m_vertices; }
    glm::dvec3 place(Index point) const { return glm::dvec3(m_places[point]); }
    /// The mean of the normals of what lies around a point.
    glm::dvec3 normalAt(Index point) const;

private:
    struct Plane {
        glm::dvec3 place, normal;
        double apart; ///< points so near are on it, metres
    };
    Index addVertex(const Vertex& vertex, Index point);
    Index addMixed(const Triangle& of, const glm::dvec3& shares, Index point);
    Index add(Triangle triangle);
    bool isEdgeAlone(Index from, Index to) const;
    std::vector<Side> sidesOf(Index one, Index other) const;
    Index pointOn(Index one, Index other, double share);
    Index pointInside(Index triangle, const glm::dvec3& shares);
    bool areConnected(Index one, Index other) const;
    struct Step {
        Index one = kNone, other = kNone; ///< to a point, or to a place on an edge
        double share = 0;
    };
    Step stepFrom(Index current, Index previous, const glm::dvec3& ahead, const Plane& plane) const;
    std::vector<Index> leftOf(std::span<const Index> loop) const;
    bool areApart() const;
    bool isSewn(Index from, Index to) const;
    glm::dvec3 faceOf(const Triangle& triangle) const;

    std::vector<Vertex> m_vertices;
    std::vector<Index> m_pointOf; ///< by vertex
    std::vector<Triangle> m_triangles;
    std::vector<glm::vec3> m_places;     ///< by point
    std::vector<VertexSource> m_sources; ///< likewise
    std::vector<std::vector<Index>> m_around; ///< likewise: triangles, removed ones too
    std::vector<Index> m_removed; ///< since the mark
    std::vector<Index> m_selected;
    std::size_t m_oldCount = 0;   ///< of triangles, at the start
    std::uint32_t m_selection = 0, m_flood = 0; ///< how many there were
    std::size_t m_vertexMark = 0, m_triangleMark = 0, m_pointMark = 0;
};

} // namespace stromar
