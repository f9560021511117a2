#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/Mesh.h"
#include "stromar/params/Params.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <memory>
#include <vector>

namespace stromar {

/// A ring of points around a stem: t = 0..1 along a segment of the generation.
struct Ring {
    std::uint32_t segment;
    double t;
};

/// The drawn surface of one path of a stem: rings from its base to its tip.
struct Tube {
    std::uint32_t stem, path; ///< of the generation
    std::uint32_t firstRing, ringCount;
    std::uint32_t points; ///< of each ring
    bool lobed;           ///< the rings have bulges
    bool pointed;         ///< the last ring is a single point
};

/// Where the rings of one generation stand and how many points each has.
struct MeshPlan {
    std::vector<Ring> rings;
    std::vector<Tube> tubes;
};

/// Decides where the rings of a generation stand. Time linear in its segments; runs on progress.threads() threads.
MeshPlan planRings(const CTree& tree, int generation, const CParams& params, const Detail& detail,
                   const CProgress& progress);

/// The mesh of one generation of stems: every tube is closed at its base and its tip. Same result for any number of
/// threads. Throws CCancelled.
std::shared_ptr<const CMesh> meshOfStems(const CTree& tree, int generation, const MeshPlan& plan, const CParams& params,
                                         const CProgress& progress);

/// One rectangle per drawn leaf, its normal the leaf's upper side. Throws CCancelled.
std::shared_ptr<const CMesh> meshOfLeaves(const CTree& tree, const Detail& detail, const CProgress& progress);

} // namespace stromar
