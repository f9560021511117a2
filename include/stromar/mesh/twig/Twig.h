#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/mesh/twig/CrownLook.h"
#include "stromar/tree/SizeBound.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Lazy.h"
#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

namespace stromar {

/// The share of pictures from all sides that is covered, with soft edges as the viewport draws them.
struct TwigCover {
    double near = 0, far = 0; ///< where levels of detail 2 and 3 are first seen
};

/// What a card shows instead of a twig (see twigsOf) with its leaves: a typical one of the tree, made straight. x to the
/// right, y along the stem from its base, z to the viewer; metres.
struct Twig {
    std::shared_ptr<const CMesh> wood, leaves;
    std::array<std::size_t, kLeafKinds + 1> kinds; ///< at which index of `leaves` those of each kind begin, and the end
    glm::dvec2 low, high; ///< what the card shows of x and y
    double length;        ///< of the stem
    double turn;          ///< radians from the stem's own X to z
    double bend;          ///< radians that the stem turns from base to tip
    bool flat;            ///< its leaves lie near the card's plane
    double leafArea;      ///< m² of a leaf's card, on average
    double shownArea;     ///< m² of the picture that its leaves' cards cover
    double seenPerLeaf;   ///< m² that are seen of its leaves' cards, on the average from all sides, over their number
    double allLeafArea;   ///< m² of all the tree's leaves that the season left
    LeafMasks masks;        ///< of its leaves
    double twigsCover = 0;  ///< TwigCover::near of the leaves of all twigs, with the wood of the tree
    TwigCover allCover;     ///< of all leaves of the tree, likewise
    TwigCover cardsCover;   ///< of the cards at level of detail 2, with the wood that they do not stand for
    double cardFit = 1;     ///< by how much the area of cards at level of detail 2 differs from what is right for a single twig
    std::shared_ptr<const CLazy<CardLooks>> looks; ///< for the picture alone: some tenths of a second

    double cardArea() const { return (high.x - low.x) * (high.y - low.y); }
};

/// Whether cards of whole twigs gain something: not where twigs bear few leaves (the season counts), or so many, or are so
/// long, that the leaves cannot be told apart in a picture.
bool suitsCards(const TwigBound& twigs, const SeasonShare& season);

/// A stem of a tree.
struct TwigPlace {
    std::uint32_t generation, stem;
};

/// The one of the twigs that is nearest to their mean; nothing where none bears leaves. Of the leaves only the counts
/// are looked at.
std::optional<TwigPlace> typicalOf(const StemSet& twigs, const CTree& tree, const COrgans& leaves, const MeshParams& params);
/// What that one with its leaves, which are grown, looks like. About a tenth of a second.
std::shared_ptr<const Twig> twigAt(const TwigPlace& place, const StemSet& twigs, const CTree& tree, const COrgans& leaves,
                                   const CrownOrgans& crown, const LeafMasks& masks, const MeshParams& params, const CProgress& progress);
/// The typical one of twigsOf() a tree whose leaves are all grown, without masks; null when it has none.
std::shared_ptr<const Twig> typicalTwig(const CTree& tree, const MeshParams& params, const CProgress& progress);

/// A card for every twig that bears leaves, bent with it, in the detail's number of planes. No
/// more rectangles than the detail's share of the leaves: else fewer planes, straight cards, at last fewer cards. Each
/// is so large that as much is seen of it as of its stem's leaves (Twig::seenPerLeaf), within half and four times the typical one's
/// area; then all grow or shrink until they cover as much as the twigs do, at level 3 as the cards of level 2, or, with the leaves `beside` them, as all leaves. Throws CCancelled.
/// Of the leaves only the counts are looked at.
std::shared_ptr<const CMesh> meshOfTwigs(const StemSet& twigs, const CTree& tree, const COrgans& leaves, const Twig& typical,
                                         const MeshParams& params, const Detail& detail, const CProgress& progress,
                                         const OrganMeshes& beside = {});
/// For which twigs those cards stand, in their order: equally many vertices each.
std::vector<TwigPlace> twigsOfCards(const StemSet& twigs, const CTree& tree, const COrgans& leaves, const Twig& typical,
                                    const MeshParams& params, const Detail& detail);
std::size_t maxVerticesOfCard(const Detail& detail);

} // namespace stromar
