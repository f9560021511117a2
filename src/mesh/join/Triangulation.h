#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

namespace stromar {

/// A triangulated surface unrolled into the plane, piece by piece: every triangle says where its own corners lie, and
/// neighbours may differ by whole turns (units of x). Points and edges can be added (constrained triangulation by flips: Sloan 1993,
/// "A fast algorithm for generating constrained Delaunay triangulations"). Nothing is computed exactly: what is nearly
/// degenerate is refused.
class CTriangulation {
public:
    using Index = std::uint32_t;
    static constexpr Index kNone = ~Index{0};

    struct Triangle {
        std::array<Index, 3> vertices; ///< counter-clockwise
        std::array<glm::dvec2, 3> at;  ///< of the corners
        std::array<Index, 3> next{kNone, kNone, kNone}; ///< beyond the edge from a corner to the one after it
        std::array<bool, 3> fixed{};                    ///< edges that stay
        std::array<bool, 3> settled{};                  ///< edges that were better so, and nothing beside them has changed since
        double turns = 0;     ///< that its plane was shifted by since the start
        bool changed = false; ///< or new
        bool removed = false;
    };
    /// A corner of a loop: where it lies in the plane that the triangle had at the start.
    struct LoopPoint {
        Index triangle;
        glm::dvec2 at;
    };
    /// Whether to turn the edge between two triangles: corners 0 and 1 are its ends, 2 and 3 opposite, in the first and the second.
    using BetterFlipped = std::function<bool(const std::array<Index, 4>& corners, const std::array<Index, 2>& triangles)>;

    /// Vertices are counted from 0. Linear in the triangles.
    CTriangulation(std::vector<Triangle> triangles, Index vertexCount);

    /// Adds a closed loop, counter-clockwise, as new vertices (the next indices), and takes out what lies inside. False when
    /// it cannot be, or something else was cut out there: then nothing is taken out, but new vertices stay.
    bool cutOut(std::span<const LoopPoint> loop);
    /// Flips edges of changed triangles that are not part of a loop, where that is better.
    void improve(const BetterFlipped& better);

    /// Flips the edge of a triangle that leads from one vertex to another, if it may be. False where there is none, or it stays.
    bool turnAway(Index triangle, Index from, Index to);

    std::span<const Triangle> triangles() const { return m_triangles; }
    Index vertexCount() const { return static_cast<Index>(m_touching.size()); }

private:
    struct Edge {
        Index triangle;
        std::uint32_t corner;
    };
    void findNeighbours();
    bool insert(const LoopPoint& point);
    bool fix(Index from, Index to, const glm::dvec2& way, bool fixed);
    bool makeEdge(Index from, Index to, const glm::dvec2& way);
    std::optional<Edge> edgeBetween(Index from, Index to, const glm::dvec2& way);
    bool areConnected(Index one, Index other);
    std::optional<Edge> crossedFrom(Index from, const glm::dvec2& way);
    bool flipTowards(Edge crossed, const glm::dvec2& way);
    bool removeInside(Index first, Index second, const glm::dvec2& way);
    std::span<const Edge> around(Index vertex);
    void split(Index triangle, Index vertex, const glm::dvec2& at);
    Edge twin(const Edge& edge) const;
    glm::dvec2 shiftTo(const Edge& edge, const Edge& twin) const;
    std::array<glm::dvec2, 4> quad(const Edge& edge, const Edge& twin) const;
    bool isConvex(const Edge& edge, const Edge& twin) const;
    bool isSettled(const Edge& edge, const BetterFlipped& better);
    void flip(const Edge& edge);
    void link(Index triangle, Index old, Index now);
    void touch(Index triangle);

    std::vector<Triangle> m_triangles;
    std::vector<Index> m_touching; ///< a triangle at each vertex
    std::vector<Edge> m_around;    ///< room for around()
};

} // namespace stromar
