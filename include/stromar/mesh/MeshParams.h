#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/tree/Tree.h"
#include <array>
#include <memory>

namespace stromar {

struct LeafBlade;

/// The shape of a leaf: an outline, or a card for a picture. Angles in radians.
struct LeafForm {
    int shape = 0; ///< row of the blades: the words of LeafShape
    bool outline = false;
    int planes = 1;      ///< of a card
    double fold = 0;     ///< of both halves about the midrib
    double stalk = 0;    ///< parts of the length
    double aspect = 1;   ///< width / length
    double rounding = 0; ///< 0..1: how far normals look out of the crown
    std::shared_ptr<const LeafBlade> mesh{}; ///< in place of both; null: none
};

/// Some of a tree's leaves.
struct LeafKind {
    double share = 0; ///< of all
    std::shared_ptr<const LeafBlade> mesh{}; ///< null: as the first kind
};

/// What a season leaves of an organ: a part of them, in a part of their size.
struct SeasonShare {
    double share = 1, size = 1;
};

/// All that the mesher is told beside the tree and the level of detail.
struct MeshParams {
    double minRadius = 0;                  ///< metres; thinner wood is drawn with it
    double barkAround = 1, barkAlong = 1;  ///< how often the bark's picture is repeated on a trunk (thesis §4.7)
    LeafForm leaf;                         ///< of the first kind
    std::array<LeafKind, kLeafKinds - 1> otherLeaves{};
    int blossomPlanes = 1;
    double blossomDome = 0;                ///< of each plane: how far its edge lies below its middle, in half widths
    double sunAndShade = 0;                ///< 0..1: how much larger leaves inside the crown are
    double fruitStalk = 0;                 ///< parts of the length
    std::array<SeasonShare, kOrgans.size()> season; ///< by Organ

    /// What the shares leave of all leaves for a kind; 0 is the first.
    double shareOf(std::size_t kind) const;
    /// The kind of a stem's n-th leaf: the same at every level of detail.
    std::size_t kindOf(const CStem& stem, std::uint32_t n) const;
    LeafForm formOf(std::size_t kind) const;
    const SeasonShare& seasonOf(Organ organ) const { return season[static_cast<std::size_t>(organ)]; }
};

} // namespace stromar
