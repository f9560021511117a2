#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/params/Params.h"
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace stromar {

using Meshes = std::vector<std::shared_ptr<const CMesh>>;

/// One row of the table of surfaces: what every writer, the viewport and the window have to know of one.
struct SurfaceInfo {
    const char* name;                 ///< of materials and pictures in files
    glm::vec3 colour;                 ///< where no picture can be shown
    bool cutOut;                      ///< seen from both sides; its picture's opacity says where it is
    std::string TextParams::*texture; ///< what the user chose; null: the picture is made of the tree's own parts
    const char* standard;             ///< what it has else: a file in textures/, or a recipe
    int GlobalParams::*number;        ///< how many of them the tree may bear; null: any tree has it
};
const SurfaceInfo& surfaceOf(Surface surface);
/// Whether every file has its material, even where no mesh needs it.
inline bool isInEveryFile(const SurfaceInfo& info) { return info.texture && !info.number; }
/// Whether the tree has a picture for it, which some month or some level of detail shows.
bool hasSurface(const CParams& params, Surface surface);

/// A picture of a model file.
struct PictureRef {
    std::string texture;           ///< as the model's file refers to it, relative to its folder; empty: inside
    std::filesystem::path picture; ///< where it lies now; empty: there is none
};

/// How one of the surfaces looks.
struct SurfaceLook {
    Surface surface;
    std::string name;              ///< of the material in files
    std::string texture;           ///< picture, as the model's file refers to it: relative to its folder; empty: inside
    std::filesystem::path picture; ///< where it lies now
    glm::vec3 colour;              ///< where no picture can be shown, 0..1
    bool cutOut;                   ///< the picture's alpha says where the surface is
    PictureRef normal{}, roughness{}; ///< maps of the relief, where the picture has some and the format takes them
};

/// The least part of a screen's height that the tree fills when a level of detail is shown.
constexpr std::array<double, 4> kScreenCoverage{0.5, 0.25, 0.1, 0.01};

/// What a writer of model files gets.
struct ExportModel {
    std::string name;
    Meshes meshes;                  ///< none is empty
    std::vector<Meshes> coarser;    ///< levels of detail 1, 2, …, for formats that hold them
    std::vector<SurfaceLook> looks; ///< of all surfaces of its meshes, perhaps of others

    /// Which of the looks a mesh has.
    std::size_t lookIndex(const CMesh& mesh) const;
    const SurfaceLook& lookOf(const CMesh& mesh) const { return looks[lookIndex(mesh)]; }
    std::size_t vertexCount() const; ///< of all levels of detail
    std::size_t triangleCount() const;
};

/// A part of a mesh that keeps a file format's limits: own vertices, named by their place in the whole mesh.
struct MeshChunk {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> indices; ///< into `vertices`
};

/// Cuts a mesh, triangle by triangle in their order, into parts of at most so many vertices and triangles (3 at least).
std::vector<MeshChunk> cutIntoChunks(const CMesh& mesh, std::size_t mostVertices, std::size_t mostTriangles);

} // namespace stromar
