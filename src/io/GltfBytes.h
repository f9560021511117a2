#pragma once
#include "stromar/mesh/Mesh.h"
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

namespace stromar {

// What the buffers of a glTF file hold, in fewer bytes. Axes as in the file, y up.

/// A cube of 65,535 steps a side around meshes that share a node (KHR_mesh_quantization): the node's scale and place
/// undo it.
struct QuantisedBox {
    glm::vec3 low{0};
    float step = 1; ///< metres

    static constexpr float kSteps = 65'535;
    explicit QuantisedBox(const Meshes& meshes);
    glm::u16vec3 of(const glm::vec3& place) const;
};

constexpr std::size_t kPositionStride = 8, kDirectionStride = 4, kTexCoordStride = 4, kTurnStride = 8; // bytes, padded to whole words
std::string quantisedPositions(const CMesh& mesh, const QuantisedBox& box); ///< three unsigned shorts
std::string quantisedNormals(const CMesh& mesh);                           ///< three signed bytes, 127 is 1
std::string quantisedTangents(const CMesh& mesh);                          ///< four
std::string quantisedTexCoords(const CMesh& mesh);                         ///< two unsigned shorts, 65,535 is 1
std::string quantisedTurns(const std::vector<glm::vec4>& turns);           ///< quaternions: four signed shorts, 32,767 is 1
/// Whether all lie in the unit square, as the above wants.
bool hasUnitTexCoords(const CMesh& mesh);

/// As EXT_meshopt_compression has them. Lossless; the corners of a triangle may begin with another one.
std::string packedVertices(const std::string& bytes, std::size_t stride);
std::string packedIndices(std::span<const std::uint32_t> indices, std::size_t vertices);

} // namespace stromar
