#pragma once
#include "stem/TubeWalls.h"
#include "stromar/mesh/MeshBuilder.h"
#include <optional>
#include <span>
#include <vector>

namespace stromar {

/// The base of a branch: a ring of points on the surface of the wood that it leaves.
struct Collar {
    std::vector<SurfacePoint> points;
    std::uint32_t standsOn; ///< generations below its own: 1 on its parent's
    double clear; ///< how far along the branch, from its base, its own rings may start; metres

    /// The shortest distance between neighbours; metres.
    double minGap() const;
};

/// How a collar is to be made.
struct CollarShape {
    double width = 1;   ///< times the usual one
    double above = 0.3; ///< between its highest point and the first own ring, radii of the branch
};

/// How it is found where a branch leaves the wood.
struct ExitSearch {
    double ahead = 1;   ///< looks so many times as far along the parent, which may bend after the branch
    bool aside = false; ///< starts in the middle of what is drawn of the parent: a thin one is a prism beside its axis
};

/// The base of a branch, as its rings are drawn.
struct BranchBase {
    std::span<const CSegment> path; ///< its first
    double radius;                  ///< metres
    std::uint32_t points;           ///< of its rings
};

/// Presses the first rings of branches onto the triangles of their parents (thesis §4.4, "branch connection"); of those that start where
/// their parent is still inside the wood it grows on, onto that.
class CCollarMaker {
public:
    static constexpr double kAlong = 1.5, kAcross = 1.2; ///< width, in radii, along the parent's axis and across it

    /// For the branches that grow on the last of `below`.
    CCollarMaker(const CTree& tree, StemsBelow below) : m_tree(tree), m_below(below) {}

    /// Nothing when the branch does not leave the wood, or leaves it so late that too little of it would be seen: then
    /// it simply starts inside.
    const Collar* make(const CStem& stem, const BranchBase& base, const CollarShape& shape, const ExitSearch& search = {});
    /// Whether the last branch that one was to be made for leaves the wood at all.
    bool leavesWood() const { return m_leavesWood; }

    /// Whether almost all of the centre line of a branch without clones lies inside its parent's wood, or what that one starts in.
    bool hides(const CStem& stem, std::span<const CSegment> branch);

private:
    struct Triangle {
        glm::dvec3 corner, edge1, edge2;
        std::size_t firstIndex;
    };
    /// Of a line with a triangle.
    struct Crossing {
        double distance, u, v;
        bool leaves; ///< the wood
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

    void standOn(std::size_t generation);
    bool isApartFromCollarOf(const CStem& sitting) const;
    bool surrounds(const CStem& sitting, const glm::dvec3& place);
    bool isInside(const glm::dvec3& place, const Frame& wood) const;
    bool isBelowItsWalls(const CStem& parent, double offset) const;
    const Collar* makeOnAnyPath(const CStem& stem);
    bool partAt(const CStem& branch, const CStem& parent, std::uint32_t other) const;
    double endOfLimb(std::uint32_t path) const;
    double placeOf(const Ring& ring) const;
    const Collar* makeOn(std::uint32_t path, const CStem& stem);
    void collectAllTriangles(const CStem& sitting, double offset);
    void clearTriangles();
    void addTriangles(std::uint32_t path, double offset);
    std::optional<Exit> findExit(const glm::dvec3& aside) const;
    glm::dvec3 asideOf(const CStem& stem) const;
    void setReach(const CStem& stem, const glm::dvec3& woodAxis);
    std::optional<double> pressOn(const Exit& exit, const glm::dvec3& woodAxis);
    static std::optional<Crossing> crossingOf(const Triangle& triangle, const glm::dvec3& origin, const glm::dvec3& direction, bool entering);
    std::optional<Hit> lastExit(const glm::dvec3& origin, const glm::dvec3& direction) const;
    std::optional<Hit> nearestExit(const Exit& exit, const glm::dvec3& offset) const;
    SurfacePoint surfaceAt(const Triangle& triangle, double u, double v) const;

    const CTree& m_tree;
    StemsBelow m_below;
    BranchBase m_base{};
    CollarShape m_shape;
    ExitSearch m_search;
    const CGeneration* m_parents = nullptr; ///< the generation whose wood is looked at
    const StemMesh* m_wood = nullptr;
    std::optional<CTubeWalls> m_walls; ///< of its tube that was looked at last
    const Tube* m_wallsOf = nullptr;
    std::vector<Triangle> m_triangles;
    glm::dvec3 m_low{0}, m_high{0}; ///< of their box
    double m_reach = 0; ///< metres along the parent and the branch within which they can meet
    double m_reachAhead = 0; ///< likewise, but towards their tips
    bool m_leavesWood = false;
    Collar m_collar;
};

} // namespace stromar
