#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/model/Material.h"
#include <array>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace stromar {

/// More that the vertices of a mesh carry, in formats that hold it.
struct VertexChannel {
    enum class Type { Float, Byte, Short }; ///< Byte: 255 is 1; Short: whole numbers

    std::string name; ///< as glTF has it: "COLOR_0", "_OCCLUSION", "JOINTS_0"
    Type type;
    int components;
    std::string bytes; ///< of all vertices

    std::size_t bytesPerVertex() const {
        constexpr std::size_t kBytes[] = {4, 1, 2};
        return kBytes[static_cast<std::size_t>(type)] * static_cast<std::size_t>(components);
    }
};
using VertexChannels = std::vector<VertexChannel>;

/// A bone: a stem that others follow. At rest it is not turned.
struct Joint {
    std::string name;
    int parent; ///< −1: none
    glm::vec3 base;
};

/// How joints move: each at all times, or not at all (empty).
struct Clip {
    std::string name;
    std::vector<float> seconds;
    std::vector<std::vector<glm::vec4>> turns; ///< by joint: quaternions x y z w in the parent's frame
    std::vector<std::vector<float>> scales;    ///< by joint
};

/// Numbers that a shader reads besides, in cells of 4 bytes; already in the axes of the format.
struct DataTable {
    std::string name;
    std::vector<std::string> columns; ///< "seed:uint32" for whole numbers
    std::string bytes;
};

/// Where a mesh stands that stands at many places: scaled along its axes, then turned, then moved.
struct Instances {
    std::vector<glm::vec3> places, sizes;
    std::vector<glm::vec4> turns; ///< unit quaternions x y z w
    VertexChannels channels{};    ///< of the instances instead of vertices
};

/// What a writer of model files gets.
struct ExportModel {
    std::string name;
    Meshes meshes;                  ///< none is empty
    std::vector<Meshes> coarser;    ///< levels of detail 1, 2, …, for formats that hold them
    std::vector<Material> materials; ///< of all surfaces of its meshes, perhaps of others
    std::vector<VertexChannels> channels{};                   ///< by mesh; or empty
    std::vector<std::vector<VertexChannels>> coarserChannels{}; ///< likewise of the levels of detail 1, 2, …
    std::vector<Joint> joints{};                              ///< of a skeleton that all meshes hang on, the root first
    std::vector<Clip> clips{};
    std::vector<DataTable> tables{};
    std::vector<std::size_t> meshMaterials{}; ///< by mesh: which of the materials it has; empty: that of its surface
    enum class Compression { None, Quantised, Meshopt } compression = Compression::None; ///< in formats that hold it; without joints and tables
    bool leafLight = false; ///< light comes through what is cut out, in formats that hold it
    std::vector<Instances> instances{}; ///< by mesh, of a single level of detail; without places, or beyond the end: it stands once, as it is

    std::vector<Meshes> samples{}; ///< by mesh: what it is at each moment of a motion, null where it is not there; or empty: nothing moves
    double samplesPerSecond = 0;

    bool isInstanced(std::size_t mesh) const { return mesh < instances.size() && !instances[mesh].places.empty(); }
    /// Which of the materials a mesh has.
    std::size_t materialIndex(const CMesh& mesh) const;
    const Material& materialOf(const CMesh& mesh) const { return materials[materialIndex(mesh)]; }
    std::size_t vertexCount() const; ///< of all levels of detail
    std::size_t triangleCount() const;
};

/// A part of a mesh that keeps a file format's limits: own vertices, named by their place in the whole mesh.
struct MeshChunk {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> indices; ///< into `vertices`
};

/// Cuts a mesh, triangle by triangle in their order, into parts of at most so many vertices and triangles (3 at least).
std::vector<MeshChunk> cutIntoChunks(const CMesh& mesh, std::size_t maxVertices, std::size_t maxTriangles);

} // namespace stromar
