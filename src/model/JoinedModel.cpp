#include "stromar/model/JoinedModel.h"
#include "stromar/model/MeshValues.h"
#include <cassert>

namespace stromar {

StemMesh planned(const TreeModel& model, std::size_t generation, std::span<const StemMesh> below, const CProgress& progress) {
    if (model.planned) return (*model.planned)[generation];
    const Meshes& stems = model.unjoined ? model.unjoined->stems : model.stems;
    StemMesh own{planRings(*model.tree, static_cast<int>(generation), meshParamsOf(model.params), *model.detail, stemsBelow(below, generation), progress, *model.choice),
                 stems[generation]};
    assert(own.plan.vertexCount == own.mesh->vertexCount());
    return own;
}

namespace {
std::shared_ptr<const std::vector<StemMesh>> allPlanned(const TreeModel& model, const CProgress& progress) {
    if (model.planned) return model.planned;
    std::vector<StemMesh> all;
    for (std::size_t g = 0; g < model.stems.size(); ++g) all.push_back(planned(model, g, all, progress));
    return std::make_shared<const std::vector<StemMesh>>(std::move(all));
}
} // namespace

std::shared_ptr<const TreeModel> joined(const std::shared_ptr<const TreeModel>& model, const CProgress& progress) {
    if (model->unjoined || model->detail->collarRings == 0) return model;
    JoinedStems wood = joinStems(*model->tree, *allPlanned(*model, progress), progress);
    auto whole = std::make_shared<TreeModel>(*model);
    whole->stems = std::move(wood.meshes);
    whole->planned.reset(); // their memory is for the writers
    whole->unjoined = std::make_shared<const UnjoinedStems>(UnjoinedStems{model->stems, std::move(wood.sources)});
    return whole;
}

} // namespace stromar
