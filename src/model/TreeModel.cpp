#include "stromar/model/TreeModel.h"

namespace stromar {

void TreeModel::visitMeshes(const MeshVisitor& visit) const {
    for (std::size_t g = 0; g < stems.size(); ++g)
        if (stems[g]->vertexCount() > 0) visit(stems[g], static_cast<int>(g));
    for (const Organ organ : kOrgans)
        if (const auto& mesh = organs[static_cast<std::size_t>(organ)]; mesh->vertexCount() > 0)
            visit(mesh, kLeaves - static_cast<int>(organ));
    if (cards && cards->vertexCount() > 0) visit(cards, kLeaves);
}

Meshes TreeModel::meshes() const {
    Meshes all;
    visitMeshes([&](const auto& mesh, int) { all.push_back(mesh); });
    return all;
}

std::size_t TreeModel::vertexCount() const {
    std::size_t count = 0;
    for (const auto& mesh : meshes()) count += mesh->vertexCount();
    return count;
}

std::size_t TreeModel::triangleCount() const {
    std::size_t count = 0;
    for (const auto& mesh : meshes()) count += mesh->triangleCount();
    return count;
}

} // namespace stromar
