#pragma once
#include "join/Meetings.h"
#include "join/WoodPatch.h"
#include "stromar/mesh/Mesh.h"
#include <glm/vec2.hpp>
#include <map>
#include <set>
#include <utility>

namespace stromar {

/// Two surfaces of a patch that cross, by their triangles.
struct CrossingSurfaces {
    std::span<const CWoodPatch::Index> wood, branch;
    std::span<const CWoodPatch::Index> own;  ///< of the branch: its own walls
    std::span<const CWoodPatch::Index> base; ///< of its own: those that lie inside the wood
    double apart = 0;                        ///< metres: points of a curve that are nearer become one, where they can
    double inset = 0; ///< metres that its own walls are moved inwards before it is told where they cross: walls that
                      ///< lie in each other cross anywhere
    std::optional<glm::dvec3> start = {}; ///< where the base is moved to before, made smaller
};

/// The closed curves along which two surfaces cross. Points of edges of one with triangles of the other are found so
/// that neighbours agree on them whatever is rounded: a curve has no gaps.
class CCrossingCurves {
public:
    using Index = CWoodPatch::Index;
    enum class Surface : std::uint8_t { Wood, Branch };

    /// Where an edge of one surface crosses a triangle of the other.
    struct Node {
        Index low, high; ///< points of the edge
        Index triangle;
        Surface edgeOf;
        double share; ///< of the edge, from `low`
        glm::dvec3 place;
        std::vector<Index> segments = {};
    };
    /// Part of a curve, in a triangle of each surface.
    struct Segment {
        std::array<Index, 2> nodes;
        std::array<Index, 2> triangles; ///< by surface
        glm::dvec3 along;               ///< across the normals of both
        bool used = false;

        Index in(Surface surface) const { return triangles[static_cast<std::size_t>(surface)]; }
        Index other(Index node) const { return nodes[0] == node ? nodes[1] : nodes[0]; }
        bool meets(const Segment& own) const;
    };
    /// A triangle as it was moved.
    struct Facet {
        Index triangle;
        std::array<glm::dvec3, 3> corners;
        glm::dvec3 normal; ///< 0: it is flat
        Bounds bounds;
        glm::dvec3 middle; ///< of a sphere around it
        double radius;
        /// Whether it is certainly on one side of another one's plane.
        bool isBeside(const Facet& plane) const;
    };
    /// On the branch, inside the wood is on the left; on the wood, inside the branch is on the right.
    struct Curve {
        std::vector<Index> nodes, segments; ///< a segment starts at the node of its number
    };

    CCrossingCurves(const CrossingSurfaces& surfaces, const CWoodPatch& patch);

    /// False where that cannot be told. Time n log n in the triangles, and squared in the segments of one triangle.
    bool find();

    /// How many edges and triangles were looked at.
    std::size_t looked() const { return m_nodeOf.size(); }
    bool meet() const { return !m_segments.empty(); }
    /// Of the wood those near the branch.
    std::span<const Facet> facets(Surface surface) const { return m_facets[static_cast<std::size_t>(surface)]; }
    std::vector<Facet> allOfWood() const;
    std::span<const Node> nodes() const { return m_nodes; }
    std::span<const Segment> segments() const { return m_segments; }
    std::span<const Curve> curves() const { return m_curves; }
    /// Whether two curves cross each other, or one itself: where a surface does.
    bool cross(Index one, Index other) const { return m_conflicts.contains(std::minmax(one, other)); }

    const CrossingSurfaces& surfaces() const { return m_surfaces; }
    const std::array<Index, 3>& cornersOf(Index triangle) const { return m_patch.triangles()[triangle].points; }
    /// Where a point was moved to.
    glm::dvec3 placeOf(Index point) const {
        const Index moved = point < m_movedOf.size() ? m_movedOf[point] : CWoodPatch::kNone;
        return moved == CWoodPatch::kNone ? m_patch.place(point) : m_moved[moved];
    }
    /// Where a node of a triangle lies in it: the second and third barycentric coordinates.
    glm::dvec2 flatOf(Index node, Index triangle) const;

private:
    /// Of a triangle as it was moved.
    struct Corner {
        Index point;
        glm::dvec3 place;
    };
    void move(Index point, const glm::dvec3& place);
    void moveBase(const glm::dvec3& start);
    Corner corner(const Facet& facet, std::uint32_t c) const { return {cornersOf(facet.triangle)[c], facet.corners[c]}; }
    Index nodeOf(const Facet& edgeOf, std::uint32_t first, const Facet& facet, Surface surface);
    Facet facetOf(Index triangle) const;
    Bounds boundsOf(Index triangle) const;
    Bounds reachOfBranch() const;
    bool addSegment(const Facet& wood, const Facet& branch);
    bool findSegments();
    bool findCurves();
    void orient(Curve& curve) const;
    void findConflicts();

    CrossingSurfaces m_surfaces;
    const CWoodPatch& m_patch;
    std::vector<Index> m_movedOf; ///< by point: which of the moved it is; kNone, as for those beyond: none
    std::vector<glm::dvec3> m_moved;
    CMeetings m_nodeOf;                                ///< kNone: they do not cross
    std::size_t m_pairs = 0;                           ///< looked at
    std::array<std::vector<Facet>, 2> m_facets;        ///< by surface
    std::vector<Node> m_nodes;
    std::vector<Segment> m_segments;
    std::vector<Curve> m_curves;
    std::set<std::pair<Index, Index>> m_conflicts; ///< curves
};

} // namespace stromar
