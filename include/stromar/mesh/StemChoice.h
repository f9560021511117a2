#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <vector>

namespace stromar {

/// Stems of a generation that are drawn thicker than they are.
struct Thickening {
    std::vector<bool> stems; ///< empty: none
    double growth = 1;       ///< of their radius

    bool operator==(const Thickening&) const = default;
};

/// Which stems a level of detail draws. Where it has too few triangles for all wood, stems are left out by chance; where that is not
/// seen, thin branches with all that grows on them, and those that stay are as much thicker: they cover as much (Cook, Halstead,
/// Planck & Ryu 2007, Stochastic Simplification of Aggregate Detail).
struct StemChoice {
    StemSet asCards; ///< shown by cards (Twig.h)
    StemSet leftOut;
    StemSet thicker;
    double growth = 1;       ///< of the radius of those
    double fullTriangles = 0;  ///< about so many all wood has at LOD 0; 0 where nothing may be left out
    bool organsStay = false;   ///< leaves, blossoms and fruits are drawn where their stem is left out

    /// Of so many stems of a generation.
    std::vector<bool> drawn(std::size_t generation, std::size_t stems) const;
    bool draws(std::size_t generation, std::size_t stem) const { return !asCards.has(generation, stem) && !leftOut.has(generation, stem); }
    bool bears(std::size_t generation, std::size_t stem) const { return organsStay || !leftOut.has(generation, stem); }
    Thickening thickening(std::size_t generation) const;
    bool operator==(const StemChoice&) const = default;
};

/// Of the thin branches that may be left out, at least this part stays.
constexpr double kLeastShareOfThinBranches = 0.25;

/// Chooses so many that all wood has about the detail's share of the triangles of LOD 0. A smaller share keeps of what a larger one does.
/// Linear in the segments, about as long as planning their rings; nothing where the detail draws all. Throws CCancelled.
StemChoice chooseStems(const CTree& tree, const MeshParams& params, const Detail& detail, StemSet asCards, const CProgress& progress);

} // namespace stromar
