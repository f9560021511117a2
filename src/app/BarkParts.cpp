#include "BarkParts.h"
#include "ExportParts.h"
#include "stromar/mesh/Weld.h"
#include "stromar/model/BarkLevels.h"
#include "stromar/util/DisjointSets.h"
#include <algorithm>
#include <array>
#include <set>

namespace stromar {

namespace {
/// Of all vertices of a level's wood: the bark of which level they show.
std::vector<std::uint8_t> barkLevelsOf(const CMesh& mesh, std::size_t own, const CBarkLevels& levels) {
    const std::vector<std::uint32_t> places = weld(mesh.positions, std::vector<std::uint32_t>(mesh.vertexCount()));
    CDisjointSets stems(mesh.vertexCount());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t c = 1; c < 3; ++c) stems.join(places[mesh.indices[i]], places[mesh.indices[i + c]]);
    std::vector<std::uint8_t> thinness(mesh.vertexCount(), 255); // of each stem where it is thickest
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        std::uint8_t& least = thinness[stems.of(places[v])];
        least = std::min(least, mesh.looks[v].thinness);
    }
    std::vector<std::uint8_t> shown;
    shown.reserve(mesh.vertexCount());
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) shown.push_back(static_cast<std::uint8_t>(levels.levelOf(own, thinness[stems.of(places[v])])));
    return shown;
}

/// Of a mesh.
struct Part {
    std::shared_ptr<const CMesh> mesh;
    std::vector<std::uint32_t> vertices; ///< of the whole
};

template <class Shows> Part partOf(const CMesh& whole, const std::string& name, Surface surface, const Shows& shows) {
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    auto mesh = std::make_shared<CMesh>();
    mesh->name = name;
    mesh->surface = surface;
    Part part;
    std::vector<std::uint32_t> placeOf(whole.vertexCount(), kNone);
    for (std::uint32_t v = 0; v < whole.vertexCount(); ++v) {
        if (!shows(v)) continue;
        placeOf[v] = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.push_back(v);
        mesh->positions.push_back(whole.positions[v]);
        mesh->normals.push_back(whole.normals[v]);
        mesh->texCoords.push_back(whole.texCoords[v]);
        mesh->looks.push_back(whole.looks[v]);
    }
    for (const std::uint32_t index : whole.indices)
        if (placeOf[index] != kNone) mesh->indices.push_back(placeOf[index]);
    part.mesh = std::move(mesh);
    return part;
}

/// Those of the barks, by level.
std::array<std::size_t, kBarks.size()> barkMaterials(const ExportModel& model) {
    std::array<std::size_t, kBarks.size()> materials;
    std::ranges::transform(kBarks, materials.begin(), [&](Surface bark) {
        CMesh wood;
        wood.surface = bark;
        return model.materialIndex(wood);
    });
    return materials;
}

/// Nothing where all of a mesh shows its own bark.
std::vector<Part> partsOf(const ExportModel& model, const CMesh& mesh, const CBarkLevels& levels) {
    const std::array materials = barkMaterials(model);
    if (std::ranges::count(materials, materials[0]) == std::ssize(materials)) return {};
    const auto own = static_cast<std::size_t>(std::ranges::find(kBarks, mesh.surface) - kBarks.begin());
    const std::vector<std::uint8_t> levelOf = barkLevelsOf(mesh, own, levels);
    std::set<std::size_t> shown;
    for (const std::uint8_t level : levelOf) shown.insert(materials[level]);
    if (shown == std::set{materials[own]}) return {};
    std::vector<Part> parts;
    for (const std::size_t material : shown) {
        const bool isOwn = material == materials[own];
        const std::size_t level = isOwn ? own : static_cast<std::size_t>(std::ranges::find(materials, material) - materials.begin());
        const std::string name = isOwn ? mesh.name : mesh.name + "_" + model.materials[material].name;
        parts.push_back(partOf(mesh, name, kBarks[level], [&](std::uint32_t v) { return materials[levelOf[v]] == material; }));
    }
    return parts;
}

VertexChannels channelsOf(const VertexChannels& whole, const std::vector<std::uint32_t>& vertices) {
    VertexChannels own;
    for (const VertexChannel& channel : whole) {
        VertexChannel& part = own.emplace_back(VertexChannel{channel.name, channel.type, channel.components, {}});
        const std::size_t bytes = channel.bytesPerVertex();
        for (const std::uint32_t v : vertices) part.bytes.append(channel.bytes, v * bytes, bytes);
    }
    return own;
}

/// Whether limbs may be of other levels than the trunks that they part from.
bool mayStartAtForks(const CTree& tree) {
    for (std::size_t g = 0; g < tree.generationCount(); ++g)
        if (tree.branchesAtNodes(g)) return true;
    return false;
}

/// Of one level of detail.
void partByBark(const ExportModel& model, const CBarkLevels& levels, Meshes& meshes, std::vector<VertexChannels>* channels, std::vector<Instances>* instances) {
    Meshes newMeshes;
    std::vector<VertexChannels> newChannels;
    std::vector<Instances> newInstances;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        std::vector<Part> parts = isBark(meshes[i]->surface) ? partsOf(model, *meshes[i], levels) : std::vector<Part>();
        for (Part& part : parts) {
            newMeshes.push_back(std::move(part.mesh));
            if (channels) newChannels.push_back(channelsOf((*channels)[i], part.vertices));
            if (instances) newInstances.emplace_back();
        }
        if (!parts.empty()) continue;
        newMeshes.push_back(meshes[i]);
        if (channels) newChannels.push_back(std::move((*channels)[i]));
        if (instances) newInstances.push_back(i < instances->size() ? std::move((*instances)[i]) : Instances{});
    }
    meshes = std::move(newMeshes);
    if (channels) *channels = std::move(newChannels);
    if (instances) *instances = std::move(newInstances);
}
} // namespace

void partByBark(ExportModel& model, std::span<const std::shared_ptr<const TreeModel>> lods) {
    if (lods.empty() || !mayStartAtForks(*lods.front()->tree)) return;
    const CBarkLevels levels(*lods.front()->tree);
    forEachLevel(model, [&](Meshes& meshes, std::vector<VertexChannels>* channels, std::vector<Instances>* instances) {
        partByBark(model, levels, meshes, channels, instances);
    });
}

} // namespace stromar
