#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/mesh/OrganMesh.h"
#include "stromar/mesh/StemChoice.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <memory>
#include <span>
#include <vector>

namespace stromar {

/// A ring of points around a stem: t = 0..1 along a segment of the generation.
struct Ring {
    std::uint32_t segment;
    std::uint32_t points; ///< as many as the ring below has, or half of them; at forks any number
    double t;
    bool parted = false; ///< from the ring below by no wall: at a fork it has a part of that one's points, or all of them
};

/// A place on the surface of the wood that a branch stands on, as its triangles have it.
struct SurfacePoint {
    glm::dvec3 position, normal;
    std::size_t triangle = 0; ///< the first of its indices in that generation's mesh
};

/// A point of a ring at a fork.
struct ForkPoint {
    glm::vec3 position, normal;
    float turn;  ///< about the path, 1 all around
    float along; ///< metres from the base of the stem that forks
    float depth; ///< in the crotch: 0 outside .. 1
};

/// Rings of a tube at a fork that are given by their points: the common one, or those of a path above it. Over the latter
/// stands a ring whose seam is turned, and over that the same without.
struct Fork {
    std::uint32_t ring, rings; ///< of the tube: the first, and how many
    std::uint32_t firstPoint;  ///< in the plan; those of a ring lie one after the other, one more than it has points
    std::int32_t seam = 0;     ///< at which point the ring above starts, counted over whole turns
};

/// Where the bark of a branch that starts at a fork takes over from its parent's: its repeats, around and along.
struct BarkJoint {
    double turn;             ///< about the branch: the middle of its share of the common ring
    double from, until;      ///< metres from the branch's base: from the common ring to the first of its own one goes over into the other
    glm::dvec2 at;           ///< the parent's at that middle
    double around, perMetre; ///< of the parent's there
};

/// How the given points of a limb at a fork lie, one ring after the other: its share of the common one, then whole ones from valley to valley.
struct LimbLayout {
    std::uint32_t points; ///< of the common ring
    std::uint32_t share;  ///< how many edges of that are the limb's
    std::uint32_t rings;  ///< given ones: the first has share + 1 points, others one more than the common one

    /// Of a ring's points.
    std::uint32_t firstOf(std::uint32_t ring) const { return ring == 0 ? 0 : share + 1 + (ring - 1) * (points + 1); }
    std::uint32_t pointCount() const { return firstOf(rings); }
    /// Around the middle of a lid over what bounds the walls below the saddle.
    std::uint32_t lidPoints() const { return share + 2 * (rings - 1); }
    /// Those, from the saddle down the left valley, along the common ring and up the right one.
    std::vector<std::uint32_t> boundary() const;
};

/// A branch that starts at a fork of its parent, between the parent's path and its other branches. The hole that this leaves in
/// the parent's wall is closed by a lid over what bounds it; another closes the branch's.
struct ForkedBranch {
    std::uint32_t stem;          ///< of the next generation
    LimbLayout limb;
    std::uint32_t firstPoint;    ///< of its given ones, in the plan
    double clear;                ///< metres from the branch's base: the first ring of its own
    std::int32_t seam;           ///< at which point that one starts, counted over whole turns
    BarkJoint bark;
};

/// The drawn surface of one path of a stem: perhaps a collar, then rings from its base to its tip. Where clones part from
/// it, the ring below is closed by the first rings of all the paths: a saddle lies between them (Fork.h).
struct Tube {
    std::uint32_t stem, path; ///< of the generation
    std::uint32_t firstRing = 0, ringCount = 0;
    std::uint32_t points = 0;           ///< of the collar and of the first ring, or of the fork's it starts on
    double maxTurn = 0;                ///< radians of a bend between its rings; 0: bends are mitred
    bool lobed = false;                 ///< the rings have bulges
    bool pointed = false;               ///< the last ring is a single point
    std::uint32_t collarRings = 0;      ///< in front of the first ring, the lowest pressed onto the parent
    std::uint32_t firstCollarPoint = 0; ///< `points` of them, in the plan
    std::uint32_t standsOn = 1; ///< the wood of its collar, generations below its own: more than one where its parent is still inside that
    std::uint32_t firstFork = 0, forkCount = 0; ///< in the plan
    bool joined = false; ///< starts at a fork, on the tube before it: without a lid
    bool forked = false; ///< starts at a fork of the parent's, closed by a lid
    std::uint32_t barkJoint = 0;     ///< in the plan
    std::uint32_t firstBranch = 0, branchCount = 0; ///< those that start at its forks, in the plan
    std::uint32_t firstVertex = 0;      ///< in the mesh
    std::size_t firstIndex = 0;
    std::uint32_t vertices = 0; ///< how many it has there
    std::size_t indices = 0;

    /// The lid at the base (of a collar or a lobed ring) or at the tip (of a lobed ring) has a vertex in its middle.
    bool middleOfLid(bool base) const { return lobed || (base && (collarRings > 0 || forked)); }
    bool startsAtFork() const { return joined || forked; }
    std::size_t vertexCount() const { return vertices; }
    std::size_t indexCount() const { return indices; }
};

/// Corners of the triangles between two rings: two per point when both have as many, else one per point of each.
inline std::size_t wallIndices(std::uint32_t low, std::uint32_t high) { return 3 * (std::size_t{low} + high); }
/// Of the wall below a ring.
inline std::size_t wallIndices(const Ring& low, const Ring& high) {
    return high.parted ? 0 : wallIndices(low.points, high.points);
}

/// Where the rings of one generation stand and how many points each has.
struct MeshPlan {
    const Ring* ringsOf(const Tube& tube) const { return &rings[tube.firstRing]; }
    std::span<const Fork> forksOf(const Tube& tube) const { return std::span(forks).subspan(tube.firstFork, tube.forkCount); }
    /// That which gives a ring of a tube its points; null where none does. Time logarithmic in the tube's forks.
    const Fork* forkAt(const Tube& tube, std::uint32_t ring) const;
    /// Of a tube that starts at a fork.
    LimbLayout limbOf(const Tube& tube) const { return {tube.points, ringsOf(tube)->points, forksOf(tube)[0].rings}; }
    /// How many points lie around the lid at its base.
    std::uint32_t baseLidPoints(const Tube& tube) const { return tube.forked ? limbOf(tube).lidPoints() : tube.points; }

    /// Which path of a stem is drawn where one of them lies: itself, or the nearest of those it split from that has a tube; 0 where none has.
    std::uint32_t drawnPath(const CGeneration& generation, const CStem& stem, std::uint32_t path) const;

    std::span<const ForkedBranch> branchesOf(const Tube& tube) const { return std::span(branches).subspan(tube.firstBranch, tube.branchCount); }
    /// The one that a stem of the next generation is; null where it is none.
    const ForkedBranch* branch(std::uint32_t stem) const;
    /// The tube whose walls a branch with a collar stands on, a tube of a later generation's plan: by its `standsOn` that on this one. Time logarithmic in the tubes.
    const Tube& bearerOf(const MeshPlan& later, const Tube& branch) const;

    std::vector<Ring> rings;
    std::vector<Tube> tubes; ///< those that are joined to one follow it: together they are one closed surface
    std::vector<SurfacePoint> collarPoints;
    std::vector<Fork> forks;
    std::vector<ForkPoint> forkPoints;
    std::vector<ForkedBranch> branches; ///< ascending by stem
    std::vector<ForkPoint> branchPoints; ///< of their given rings
    std::vector<BarkJoint> barkJoints;   ///< of tubes that start at forks of their parents
    std::vector<std::int32_t> tubeOfPath; ///< −1: not drawn, as it is too short or hidden by others
    std::vector<bool> stemBears;          ///< its leaves, blossoms and fruits are to be drawn
    const Detail* detail = nullptr;       ///< of the table
    Thickening thickening;                ///< with which its stems are drawn
    std::size_t vertexCount = 0, indexCount = 0;
};

/// The tubes that are one closed surface together: one, and those that forks join to it.
std::vector<std::span<const Tube>> surfacesOf(const MeshPlan& plan);

/// The stems of one generation as they are drawn: what the next generation's branches grow out of.
struct StemMesh {
    MeshPlan plan;
    std::shared_ptr<const CMesh> mesh;
};

/// The stems of all generations before one, from the trunks.
using StemsBelow = std::span<const StemMesh* const>;
std::vector<const StemMesh*> stemsBelow(std::span<const StemMesh> stems, std::size_t generation);

/// Decides where the rings of a generation stand. With the meshes `below`, those of all generations before at the same
/// level of detail, branches get collars on them. Only stems that are chosen have tubes.
/// Time linear in the segments; runs on progress.threads() threads.
MeshPlan planRings(const CTree& tree, int generation, const MeshParams& params, const Detail& detail,
                   StemsBelow below, const CProgress& progress, const StemChoice& choice = {});

/// The mesh of one generation of stems: every tube is closed at its base and its tip. Same result for any number of
/// threads. Throws CCancelled.
std::shared_ptr<const CMesh> meshOfStems(const CTree& tree, int generation, const MeshPlan& plan, const MeshParams& params,
                                         const CProgress& progress);

/// The meshes of all generations, each on the one before, without cards.
std::vector<StemMesh> meshAllStems(const CTree& tree, const MeshParams& params, const Detail& detail,
                                   const CProgress& progress);

/// By generation.
std::vector<const MeshPlan*> plansOf(std::span<const StemMesh> stems);

} // namespace stromar
