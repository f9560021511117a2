#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/tree/SizeBound.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

namespace stromar {

/// What a card shows instead of a stem of the last generation with its leaves: a typical one of the tree, made
/// straight. x to the right, y along the stem from its base, z to the viewer; metres.
struct Twig {
    std::shared_ptr<const CMesh> wood, leaves;
    glm::dvec2 low, high; ///< what the card shows of x and y
    double length;        ///< of the stem
    double turn;          ///< radians from the stem's own X to z
    double bend;          ///< radians that the stem turns from base to tip
    bool flat;            ///< its leaves lie near the card's plane
    double leafArea;      ///< m² of a leaf's card, on average
    double shownArea;     ///< m² of the picture that its leaves' cards cover
    double allLeafArea;   ///< m² of all the tree's leaves that the season left

    double cardArea() const { return (high.x - low.x) * (high.y - low.y); }
};

/// Whether cards of whole twigs gain something: not where stems bear few leaves (the season counts), or are too long for
/// the leaves to be seen in a picture.
bool suitsCards(const BearerBound& bearers, const SeasonShare& season);

/// The generation whose stems cards stand for: the last one.
inline std::uint32_t cardGeneration(const CTree& tree) { return static_cast<std::uint32_t>(tree.generationCount()) - 1; }

/// The stem of the last generation that is nearest to the mean of those that bear leaves; nothing where none does. Only
/// the counts are looked at.
std::optional<std::uint32_t> typicalStem(const CTree& tree, const COrgans& leaves, const MeshParams& params);
/// What that stem with its leaves, which are grown, looks like.
std::shared_ptr<const Twig> twigOf(const CTree& tree, const COrgans& leaves, std::uint32_t stem,
                                   const MeshParams& params);
/// Of a tree whose leaves are all grown; null when the last generation bears none.
std::shared_ptr<const Twig> typicalTwig(const CTree& tree, const MeshParams& params);

/// A card for every stem of the last generation that bears leaves, bent with it, in the detail's number of planes. No
/// more rectangles than the detail's share of the leaves: else fewer planes, straight cards, at last fewer cards. Each
/// shows as much leaf as its stem has, as far as kMaxLeafGrowth allows. Throws CCancelled.
/// Of the leaves only the counts are looked at.
std::shared_ptr<const CMesh> meshOfTwigs(const CTree& tree, const COrgans& leaves, const Twig& twig,
                                         const MeshParams& params, const Detail& detail, const CProgress& progress);
std::size_t maxVerticesOfCard(const Detail& detail);

} // namespace stromar
