#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/mesh/OrganMesh.h"
#include "stromar/mesh/twig/CutOut.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <array>
#include <memory>

namespace stromar {

/// What is seen of a crown without its wood: the mean over four sides, with the sun at 51°, as the viewport has it at ten o'clock.
struct CrownLook {
    double sun = 0;     ///< cosine between the normal of what is seen and the sun where it shines, else 0
    double through = 0; ///< likewise where it shines on the other side
    double sky = 0;     ///< how much it faces the sky: 0 downwards, 1 upwards
    double backs = 0;   ///< share that are the under sides of leaves
};

using LeafMasks = std::array<CCutOut, kLeafKinds>;

constexpr double kMeasuredLeaves = 250'000; ///< are enough to see how a crown looks

/// Thinned leaves, by kind, in the size in which they cover as much as all leaves of the same stems do (`all`) where the level of detail, 1 or
/// more, is first seen: larger ones hang over the edges of what smaller ones fill. Some tenths of a second; of more than kMeasuredLeaves it is not
/// worth it: they come back as they are.
OrganMeshes fittingLeaves(const OrganMeshes& thinned, const std::shared_ptr<const COrgans>& all, const CTree& tree, const LeafMasks& masks,
                          const MeshParams& params, const Detail& detail, const CProgress& progress);

} // namespace stromar
