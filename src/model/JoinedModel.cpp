#include "stromar/model/JoinedModel.h"
#include "stromar/model/MeshValues.h"
#include <cassert>

namespace stromar {

StemMesh planned(const TreeModel& model, std::size_t generation, const StemMesh* below, const CProgress& progress) {
    const Meshes& stems = model.unjoined ? model.unjoined->stems : model.stems;
    StemMesh own{planRings(*model.tree, static_cast<int>(generation), meshParamsOf(model.params), *model.detail, below, progress, *model.choice),
                 stems[generation]};
    assert(own.plan.vertexCount == own.mesh->vertexCount());
    return own;
}

std::shared_ptr<const TreeModel> joined(const std::shared_ptr<const TreeModel>& model, const CProgress& progress) {
    if (model->unjoined || model->detail->collarRings == 0) return model;
    std::vector<StemMesh> stems;
    for (std::size_t g = 0; g < model->stems.size(); ++g)
        stems.push_back(planned(*model, g, g > 0 ? &stems.back() : nullptr, progress));
    JoinedStems wood = joinStems(*model->tree, stems, progress);
    auto whole = std::make_shared<TreeModel>(*model);
    whole->stems = std::move(wood.meshes);
    whole->unjoined = std::make_shared<const UnjoinedStems>(UnjoinedStems{model->stems, std::move(wood.sources)});
    return whole;
}

} // namespace stromar
