#pragma once
#include "stromar/app/Prediction.h"
#include "stromar/model/TreeModel.h"
#include <filesystem>

namespace stromar {

/// How the relief of bark becomes triangles.
struct Displacement {
    double cell = 0;     ///< metres; 0: bark is flat
    double strength = 3; ///< of what the pictures of normals show
};

/// Level of detail 0 with its wood in one piece and the relief of its bark as triangles (see displaceStems());
/// other models as they are, and all without a cell. Heights are those of the bark's picture: a recipe's, or …_height.png beside a file, which
/// is taken for kBarkRelief of its width. Draws recipes that are new. Throws CError where no bark has heights or the limits do not
/// allow it, and CCancelled.
std::shared_ptr<const TreeModel> displaced(const std::shared_ptr<const TreeModel>& model, const Displacement& displacement, const std::filesystem::path& folder,
                                           const SizeLimits& limits, const CProgress& progress);

} // namespace stromar
