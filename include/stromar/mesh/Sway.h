#pragma once
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/mesh/twig/Twig.h"
#include "stromar/tree/Wind.h"
#include "stromar/util/RawVector.h"

namespace stromar {

/// Where the vertices of a mesh, or the instances of a blade, hang on the axes of a tree.
using SwayPlaces = RawVector<SwayPlace>;

/// Of a generation's wood; `plan` is the one that `mesh` was made by, with its rings and tubes. The edge of a collar
/// goes with the wood it stands on, what is above with the branch. Linear in the vertices.
SwayPlaces swayOfStems(const CWindTable& table, std::size_t generation, const MeshPlan& plan, const CMesh& mesh,
                       const CProgress& progress);
/// One for each instance, on the stem that bears it.
SwayPlaces swayOfOrgans(const CWindTable& table, const COrganMesh& organs, const CProgress& progress);
/// Of cards, equally many vertices for each of `twigs`.
SwayPlaces swayOfCards(const CWindTable& table, const std::vector<TwigPlace>& twigs, const CMesh& cards,
                       const CProgress& progress);

/// A leaf's own motion.
Flutter flutterOf(const CTree& tree, const CLeaf& leaf);

/// The mesh in a pose of its tree.
std::shared_ptr<const CMesh> swayed(const CMesh& mesh, const SwayPlaces& places, const CWindTable& table,
                                    const WindPose& pose, const CProgress& progress);
/// The same of leaves that flutter, with vertices of their own.
std::shared_ptr<const CMesh> swayed(const COrganMesh& organs, const SwayPlaces& places, const CWindTable& table,
                                    const WindPose& pose, double seconds, double loop, const CProgress& progress);

} // namespace stromar
