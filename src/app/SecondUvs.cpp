#include "SecondUvs.h"
#include "stromar/mesh/Unwrap.h"

namespace stromar {

namespace {
template <typename Values> Values picked(const Values& values, const std::vector<std::uint32_t>& sources) {
    Values all;
    all.reserve(sources.size());
    for (const std::uint32_t source : sources) all.push_back(values[source]);
    return all;
}

std::shared_ptr<const CMesh> cutMesh(const CMesh& mesh, const Unwrapped& to) {
    auto cut = std::make_shared<CMesh>();
    cut->name = mesh.name;
    cut->surface = mesh.surface;
    cut->positions = picked(mesh.positions, to.sources);
    cut->normals = picked(mesh.normals, to.sources);
    cut->texCoords = picked(mesh.texCoords, to.sources);
    cut->looks = picked(mesh.looks, to.sources);
    cut->indices = to.indices;
    return cut;
}

VertexChannel cutChannel(const VertexChannel& channel, std::size_t vertices, const std::vector<std::uint32_t>& sources) {
    const std::size_t bytes = channel.bytes.size() / vertices;
    VertexChannel cut{channel.name, channel.type, channel.components, {}};
    cut.bytes.reserve(bytes * sources.size());
    for (const std::uint32_t source : sources) cut.bytes.append(channel.bytes, source * bytes, bytes);
    return cut;
}

void addTo(Meshes& meshes, std::vector<VertexChannels>& channels, const CProgress& progress) {
    const std::vector<Unwrapped> all = unwrap(meshes, progress);
    channels.resize(meshes.size());
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        for (VertexChannel& channel : channels[i]) channel = cutChannel(channel, meshes[i]->vertexCount(), all[i].sources);
        channels[i].push_back({"TEXCOORD_1", VertexChannel::Type::Float, 2,
                               std::string(reinterpret_cast<const char*>(all[i].texCoords.data()), all[i].texCoords.size() * sizeof(glm::vec2))});
        meshes[i] = cutMesh(*meshes[i], all[i]);
    }
}
} // namespace

void addSecondUvs(ExportModel& model, const CProgress& progress) {
    addTo(model.meshes, model.channels, progress);
    model.coarserChannels.resize(model.coarser.size());
    for (std::size_t lod = 0; lod < model.coarser.size(); ++lod) addTo(model.coarser[lod], model.coarserChannels[lod], progress);
}

} // namespace stromar
