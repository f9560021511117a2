#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/mesh/OrganMesh.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <memory>
#include <span>
#include <vector>

namespace stromar {

/// A ring of points around a stem: t = 0..1 along a segment of the generation.
struct Ring {
    std::uint32_t segment;
    std::uint32_t points; ///< as many as the ring below has, or half of them
    double t;
};

/// A place on the surface of a parent's wood, as its triangles have it.
struct SurfacePoint {
    glm::dvec3 position, normal;
};

/// The drawn surface of one path of a stem: perhaps a collar, then rings from its base to its tip.
struct Tube {
    std::uint32_t stem, path; ///< of the generation
    std::uint32_t firstRing = 0, ringCount = 0;
    std::uint32_t points = 0;           ///< of the collar and of the first ring
    double maxTurn = 0;                ///< radians of a bend between its rings; 0: bends are mitred
    bool lobed = false;                 ///< the rings have bulges
    bool pointed = false;               ///< the last ring is a single point
    std::uint32_t collarRings = 0;      ///< in front of the first ring, the lowest pressed onto the parent
    std::uint32_t firstCollarPoint = 0; ///< `points` of them, in the plan
    std::uint32_t firstVertex = 0;      ///< in the mesh
    std::size_t firstIndex = 0;
    std::uint32_t vertices = 0; ///< how many it has there
    std::size_t indices = 0;

    /// The lid at the base (of a collar or a lobed ring) or at the tip (of a lobed ring) has a vertex in its middle.
    bool middleOfLid(bool base) const { return lobed || (base && collarRings > 0); }
    std::size_t vertexCount() const { return vertices; }
    std::size_t indexCount() const { return indices; }
};

/// Corners of the triangles between two rings: two per point when both have as many, else one per point of each.
inline std::size_t wallIndices(std::uint32_t low, std::uint32_t high) { return 3 * (std::size_t{low} + high); }

/// Where the rings of one generation stand and how many points each has.
struct MeshPlan {
    const Ring* ringsOf(const Tube& tube) const { return &rings[tube.firstRing]; }

    std::vector<Ring> rings;
    std::vector<Tube> tubes;
    std::vector<SurfacePoint> collarPoints;
    std::vector<std::int32_t> tubeOfPath; ///< −1: too short to be drawn
    std::vector<bool> stemIsChosen;       ///< to be drawn, if it is long enough, and its leaves
    std::size_t vertexCount = 0, indexCount = 0;
};

/// The stems of one generation as they are drawn: what the next generation's branches grow out of.
struct StemMesh {
    MeshPlan plan;
    std::shared_ptr<const CMesh> mesh;
};

/// Whether a level of detail may leave out stems of a generation: only of the last one, and where no cards stand for
/// twigs.
bool isSparse(const CTree& tree, int generation, const Detail& detail, const StemSet& asCards = {});

/// Decides where the rings of a generation stand. With the `parents`' mesh, that of the generation before at the same
/// level of detail, branches get collars on it. A sparse generation keeps so many stems, chosen evenly, that all wood
/// together has about the detail's share of the triangles of LOD 0, but never less than that share of them.
/// Stems that cards show (see Twig.h) have no tubes, but count as chosen: what they bear besides leaves is drawn.
/// Time linear in the segments; runs on progress.threads() threads.
MeshPlan planRings(const CTree& tree, int generation, const MeshParams& params, const Detail& detail,
                   const StemMesh* parents, const CProgress& progress, const StemSet& asCards = {});

/// The mesh of one generation of stems: every tube is closed at its base and its tip. Same result for any number of
/// threads. Throws CCancelled.
std::shared_ptr<const CMesh> meshOfStems(const CTree& tree, int generation, const MeshPlan& plan, const MeshParams& params,
                                         const CProgress& progress);

/// The meshes of all generations, each on the one before.
std::vector<StemMesh> meshAllStems(const CTree& tree, const MeshParams& params, const Detail& detail,
                                   const CProgress& progress);

/// By generation.
std::vector<const MeshPlan*> plansOf(std::span<const StemMesh> stems);

} // namespace stromar
