#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/mesh/OrganMesh.h"
#include "stromar/mesh/twig/CutOut.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace stromar {

/// What is seen of a crown.
enum class CrownLayer : std::uint8_t {
    Leaf,
    Wood,      ///< of twigs that cards stand for
    OtherWood, ///< what cards do not stand for: this and
    Blossom
};
constexpr bool isBesideCards(CrownLayer layer) { return layer >= CrownLayer::OtherWood; }
constexpr bool isWood(CrownLayer layer) { return layer == CrownLayer::Wood || layer == CrownLayer::OtherWood; }

/// A place of a crown that is seen.
struct LitPlace {
    glm::vec3 normal; ///< of the side that is seen
    glm::vec3 toViewer;
    float sunVisibility, skyVisibility; ///< 0..1: how much of them the rest of the crown leaves
    bool back;                          ///< it is the under side of a leaf
    bool behind;                        ///< of a card that is seen from behind; of a leaf the same as `back`
    CrownLayer layer;
};

/// What shows in a pixel: up to four places.
using SeenPixel = std::vector<LitPlace>;

/// What is seen of a crown, with the wood and the blossoms between its leaves, from eight sides where cards take over, in the light of a sun that stands as the viewport's does at ten o'clock.
struct CrownLook {
    glm::vec3 sun{0, 0, 1};        ///< towards it
    std::vector<SeenPixel> pixels; ///< about four thousand, evenly chosen: of fewer, chance decides how much sun is seen
};

/// All twigs with their leaves, and the cards that stand for them at level of detail 2; both with what is beside them.
struct CardLooks {
    CrownLook crown, cards;
};

using LeafMasks = std::array<CCutOut, kLeafKinds>;

/// Of the whole tree: all, or some, evenly chosen (OrganDemand::max).
struct CrownOrgans {
    std::shared_ptr<const COrgans> leaves, blossoms; ///< null: none
    CCutOut blossomMask;
};

constexpr double kMeasuredLeaves = 250'000; ///< are enough to see how a crown looks

/// Thinned leaves, by kind, in the size in which they cover as much as all leaves of the same stems do (`all`) where the level of detail, 1 or
/// more, is first seen: larger ones hang over the edges of what smaller ones fill. Some tenths of a second; of more than kMeasuredLeaves it is not
/// worth it: they come back as they are.
OrganMeshes fittingLeaves(const OrganMeshes& thinned, const std::shared_ptr<const COrgans>& all, const CTree& tree, const LeafMasks& masks,
                          const MeshParams& params, const Detail& detail, const CProgress& progress);
/// Likewise blossoms: `whole` is all of them as seen from near. Fewer and larger ones hang out of the leaves: where `crown` has any, as much is seen
/// of them between these.
OrganMeshes fittingBlossoms(const OrganMeshes& thinned, const OrganMeshes& whole, const CrownOrgans& crown, const CTree& tree, const LeafMasks& masks,
                            const MeshParams& params, const Detail& detail, const CProgress& progress);

} // namespace stromar
