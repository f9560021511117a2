#include "stromar/model/TreeModel.h"
#include <glm/common.hpp>

namespace stromar {

void TreeModel::visitMeshes(const MeshVisitor& visit, const OrganVisitor& visitOrgans) const {
    for (std::size_t g = 0; g < stems.size(); ++g)
        if (stems[g]->vertexCount() > 0) visit(stems[g], static_cast<int>(g));
    for (const auto& mesh : organs)
        if (mesh->vertexCount() > 0) visitOrgans(mesh, kLeaves - static_cast<int>(mesh->organ()));
    if (cards && cards->vertexCount() > 0) visit(cards, kLeaves);
}

Meshes TreeModel::meshes(const CProgress& progress) const {
    Meshes all;
    visitMeshes([&](const auto& mesh, int) { all.push_back(mesh); },
                [&](const auto& instances, int) { all.push_back(instances->expanded(progress)); });
    return all;
}

std::size_t TreeModel::leafCount() const {
    std::size_t count = 0;
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) count += leaves(kind)->count();
    return count;
}

std::size_t TreeModel::vertexCount() const {
    std::size_t count = 0;
    const auto add = [&](const auto& mesh, int) { count += mesh->vertexCount(); };
    visitMeshes(add, add);
    return count;
}

std::size_t TreeModel::triangleCount() const {
    std::size_t count = 0;
    const auto add = [&](const auto& mesh, int) { count += mesh->triangleCount(); };
    visitMeshes(add, add);
    return count;
}

std::optional<Bounds> TreeModel::bounds() const {
    std::optional<Bounds> all;
    const auto add = [&](const Bounds& own) {
        all = all ? Bounds{glm::min(all->min, own.min), glm::max(all->max, own.max)} : own;
    };
    visitMeshes([&](const auto& mesh, int) { add(mesh->bounds()); },
                [&](const auto& instances, int) { add(instances->bounds(CProgress())); });
    return all;
}

std::size_t TreeModel::bytes() const {
    std::size_t bytes = 0;
    visitMeshes([&](const auto& mesh, int) { bytes += mesh->bytes(); },
                [&](const auto& instances, int) { bytes += instances->bytes(); });
    return bytes;
}

} // namespace stromar
