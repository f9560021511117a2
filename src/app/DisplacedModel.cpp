#include "stromar/app/DisplacedModel.h"
#include "stromar/app/Pictures.h"
#include "stromar/mesh/Displacement.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/texture/Draw.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Error.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr double kBytesPerTriangle = 200; ///< while it is divided, and in the model
constexpr double kTrianglesPerVertex = 2;

DisplacementLimit limitOf(const SizeLimits& limits) {
    const double most = std::min({kTrianglesPerVertex * limits.vertices, limits.bytes / kBytesPerTriangle, 4e9});
    return {static_cast<std::size_t>(std::max(0.0, most))};
}

/// Null where its picture has no heights.
std::shared_ptr<const CBarkRelief> reliefOf(const CParams& params, Surface bark, const fs::path& folder, double strength) {
    const Surface shown = shownSurface(params, bark);
    const std::string picture = pictureOf(params, shown);
    const fs::path file = textureOf(params, shown, folder);
    if (!isPng(file)) return nullptr;
    TextureMaps maps = readPngs(file);
    if (maps.height01.empty()) return nullptr;
    const double depth = strength * (isRecipe(picture) ? CRecipe(picture).relief() : kBarkRelief);
    return std::make_shared<const CBarkRelief>(std::move(maps.height01), maps.width, maps.height, depth);
}
} // namespace

std::shared_ptr<const TreeModel> displaced(const std::shared_ptr<const TreeModel>& model, const Displacement& displacement, const fs::path& folder,
                                           const SizeLimits& limits, const CProgress& progress) {
    if (displacement.cell <= 0 || model->detail != &detailOf(Model::Full) || model->stems.empty()) return model;
    makePictures(model->params, progress);
    BarkReliefs reliefs;
    for (std::size_t g = 0; g < model->stems.size(); ++g)
        reliefs.push_back(g < kBarks.size() ? reliefOf(model->params, kBarks[g], folder, displacement.strength) : reliefs.back());
    if (std::ranges::none_of(reliefs, [](const auto& relief) { return relief != nullptr; }))
        throw CError(
            translated(NC_("stromar", "displacement needs the heights of the bark: a recipe, or beside its picture %1"),
                       mapBeside(textureOf(model->params, Surface::Bark, folder), "_height").string()));
    const auto whole = joined(model, progress);
    DisplacedStems wood = displaceStems(whole->stems, whole->unjoined->sources, reliefs, displacement.cell, limitOf(limits), progress);
    auto rough = std::make_shared<TreeModel>(*whole);
    rough->stems = std::move(wood.meshes);
    rough->unjoined = std::make_shared<const UnjoinedStems>(UnjoinedStems{whole->unjoined->stems, std::move(wood.sources)});
    return rough;
}

} // namespace stromar
