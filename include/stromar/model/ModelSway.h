#pragma once
#include "stromar/mesh/Cut.h"
#include "stromar/mesh/Sway.h"
#include "stromar/model/TreeModel.h"

namespace stromar {

/// How a model hangs on the axes of its tree, for the wind. Immutable, any thread.
struct ModelSway {
    std::shared_ptr<const TreeModel> model;
    std::shared_ptr<const CWindTable> table;
    std::vector<std::shared_ptr<const SwayPlaces>> stems;                 ///< by generation: of the vertices
    std::vector<std::shared_ptr<const SwayPlaces>> organs;                ///< as in the model: of the instances
    std::shared_ptr<const SwayPlaces> cards;                              ///< of the vertices; null without cards

    const std::shared_ptr<const SwayPlaces>& placesOf(const CMesh& mesh) const;
    const std::shared_ptr<const SwayPlaces>& placesOf(const COrganMesh& organs) const;
};

/// Plans the model's rings once more: cheaper than to keep them. What is the same as in `known` (or null) is taken
/// over. Throws CCancelled.
std::shared_ptr<const ModelSway> swayOf(const std::shared_ptr<const TreeModel>& model, const ModelSway* known,
                                        const CProgress& progress);

/// The same where a tree is felled: the trunks are cut in two. Without a cut above the ground it is `sway` itself.
std::shared_ptr<const ModelSway> felled(const std::shared_ptr<const ModelSway>& sway, const CFall& fall);

/// The model's meshes, as TreeModel::meshes() gives them, in a pose at a time. Throws CCancelled.
Meshes swayedMeshes(const ModelSway& sway, const WindPose& pose, double seconds, double loop,
                    const CProgress& progress);

} // namespace stromar
