#include "Merge.h"
#include "ExportParts.h"
#include <algorithm>
#include <utility>

namespace stromar {

namespace {
/// Meshes that become one.
struct MaterialGroup {
    std::size_t material;
    std::vector<std::size_t> members;
};

std::vector<MaterialGroup> groupsOf(const ExportModel& model, const Meshes& meshes, bool finest) {
    std::vector<MaterialGroup> groups;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const std::size_t material = model.materialIndex(*meshes[i]);
        const auto known = std::ranges::find(groups, material, &MaterialGroup::material);
        const bool apart = finest && model.isInstanced(i);
        if (apart || known == groups.end())
            groups.push_back({apart ? SIZE_MAX : material, {i}}); // SIZE_MAX: none joins it
        else
            known->members.push_back(i);
    }
    return groups;
}

template <typename Values> void append(Values& all, const Values& own) { all.insert(all.end(), own.begin(), own.end()); }

std::shared_ptr<const CMesh> merged(const Meshes& meshes, const MaterialGroup& group, const Material& look) {
    auto mesh = std::make_shared<CMesh>();
    mesh->name = look.name;
    mesh->surface = look.surface;
    for (const std::size_t i : group.members) {
        const auto first = static_cast<std::uint32_t>(mesh->vertexCount());
        append(mesh->positions, meshes[i]->positions);
        append(mesh->normals, meshes[i]->normals);
        append(mesh->texCoords, meshes[i]->texCoords);
        append(mesh->looks, meshes[i]->looks);
        mesh->indices.reserve(mesh->indices.size() + meshes[i]->indices.size());
        for (const std::uint32_t index : meshes[i]->indices) mesh->indices.push_back(first + index);
    }
    return mesh;
}

/// Vertices of a mesh that has no such channel are white, or nothing.
VertexChannels merged(const std::vector<VertexChannels>& channels, const Meshes& meshes, const MaterialGroup& group) {
    VertexChannels all;
    std::size_t before = 0;
    const auto fill = [&](VertexChannel& channel, std::size_t vertices) {
        channel.bytes.append(vertices * channel.bytesPerVertex(), channel.type == VertexChannel::Type::Byte ? '\xff' : '\0');
    };
    for (const std::size_t i : group.members) {
        for (const VertexChannel& own : channels[i]) {
            auto known = std::ranges::find(all, own.name, &VertexChannel::name);
            if (known == all.end()) {
                known = all.insert(all.end(), {own.name, own.type, own.components, {}});
                fill(*known, before);
            }
            known->bytes += own.bytes;
        }
        before += meshes[i]->vertexCount();
        for (VertexChannel& channel : all)
            if (const std::size_t has = channel.bytes.size() / channel.bytesPerVertex(); has < before) fill(channel, before - has);
    }
    return all;
}

/// Of one level of detail.
void merge(const ExportModel& model, Meshes& meshes, std::vector<VertexChannels>* channels, std::vector<Instances>* instances) {
    Meshes newMeshes;
    std::vector<VertexChannels> newChannels;
    std::vector<Instances> newInstances;
    for (const MaterialGroup& group : groupsOf(model, meshes, instances != nullptr)) {
        const std::size_t first = group.members.front();
        const bool apart = group.material == SIZE_MAX;
        newMeshes.push_back(apart ? meshes[first] : merged(meshes, group, model.materials[group.material]));
        if (channels) newChannels.push_back(apart ? (*channels)[first] : merged(*channels, meshes, group));
        if (instances) newInstances.push_back(apart ? (*instances)[first] : Instances{});
    }
    meshes = std::move(newMeshes);
    if (channels) *channels = std::move(newChannels);
    if (instances) *instances = std::move(newInstances);
}
} // namespace

void mergeByMaterial(ExportModel& model) {
    forEachLevel(model, [&](Meshes& meshes, std::vector<VertexChannels>* channels, std::vector<Instances>* instances) {
        merge(model, meshes, channels, instances);
    });
}

} // namespace stromar
