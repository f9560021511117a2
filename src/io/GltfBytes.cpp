#include "Axes.h"
#include "GltfBytes.h"
#include "stromar/mesh/Shading.h"
#include "stromar/util/Error.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <meshoptimizer.h>
#include <vector>

namespace stromar {

namespace {
/// The values of all vertices, `stride` bytes each; write(vertex, where to).
template <typename Write>
std::string strided(std::size_t count, std::size_t stride, Write&& write) {
    std::string bytes(count * stride, '\0');
    for (std::size_t v = 0; v < count; ++v) write(v, bytes.data() + v * stride);
    return bytes;
}

template <typename Value> void put(char* place, const Value& value) { std::memcpy(place, &value, sizeof value); }

glm::i8vec4 signedBytes(const glm::vec4& v) { return glm::i8vec4(glm::round(glm::clamp(v, -1.0f, 1.0f) * 127.0f)); }
} // namespace

QuantisedBox::QuantisedBox(const Meshes& meshes) {
    glm::vec3 high(0);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Bounds bounds = meshes[i]->bounds();
        const glm::vec3 a = yUp(bounds.min), b = yUp(bounds.max);
        low = i == 0 ? glm::min(a, b) : glm::min(low, glm::min(a, b));
        high = i == 0 ? glm::max(a, b) : glm::max(high, glm::max(a, b));
    }
    const glm::vec3 size = high - low;
    step = std::max({size.x, size.y, size.z, 1e-6f}) / kSteps;
}

glm::u16vec3 QuantisedBox::of(const glm::vec3& place) const {
    return glm::u16vec3(glm::clamp(glm::round((place - low) / step), 0.0f, kSteps));
}

std::string quantisedPositions(const CMesh& mesh, const QuantisedBox& box) {
    return strided(mesh.vertexCount(), kPositionStride, [&](std::size_t v, char* to) { put(to, box.of(yUp(mesh.positions[v]))); });
}

std::string quantisedNormals(const CMesh& mesh) {
    return strided(mesh.vertexCount(), kDirectionStride, [&](std::size_t v, char* to) { put(to, signedBytes(glm::vec4(yUp(mesh.normals[v]), 0))); });
}

std::string quantisedTangents(const CMesh& mesh) {
    const std::vector<glm::vec4> tangents = tangentsOf(mesh);
    return strided(tangents.size(), kDirectionStride,
                   [&](std::size_t v, char* to) { put(to, signedBytes(glm::vec4(yUp(glm::vec3(tangents[v])), tangents[v].w))); });
}

std::string quantisedTexCoords(const CMesh& mesh) {
    return strided(mesh.vertexCount(), kTexCoordStride, [&](std::size_t v, char* to) {
        put(to, glm::u16vec2(glm::round(glm::vec2(mesh.texCoords[v].x, 1 - mesh.texCoords[v].y) * 65'535.0f)));
    });
}

std::string quantisedTurns(const std::vector<glm::vec4>& turns) {
    return strided(turns.size(), kTurnStride, [&](std::size_t i, char* to) {
        put(to, glm::i16vec4(glm::round(glm::vec4(yUp(glm::vec3(turns[i])), turns[i].w) * 32'767.0f)));
    });
}

bool hasUnitTexCoords(const CMesh& mesh) {
    return std::ranges::all_of(mesh.texCoords, [](const glm::vec2& t) { return t.x >= 0 && t.x <= 1 && t.y >= 0 && t.y <= 1; });
}

std::string packedVertices(const std::string& bytes, std::size_t stride) {
    const std::size_t count = bytes.size() / stride;
    std::string packed(meshopt_encodeVertexBufferBound(count, stride), '\0');
    packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(), bytes.data(), count, stride));
    if (packed.empty()) throw CError("the vertices cannot be compressed");
    return packed;
}

std::string packedIndices(std::span<const std::uint32_t> indices, std::size_t vertices) {
    [[maybe_unused]] static const bool once = (meshopt_encodeIndexVersion(1), true); // the extension's, for the whole program
    std::string packed(meshopt_encodeIndexBufferBound(indices.size(), vertices), '\0');
    packed.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(), indices.data(), indices.size()));
    if (packed.empty()) throw CError("the triangles cannot be compressed");
    return packed;
}

} // namespace stromar
