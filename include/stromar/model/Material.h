#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/params/Params.h"
#include <filesystem>
#include <string>

namespace stromar {

/// One row of the table of surfaces: what every writer, the viewport and the window have to know of one.
struct SurfaceInfo {
    const char* name;                 ///< of materials and pictures in files
    glm::vec3 colour;                 ///< where no picture can be shown
    bool cutOut;                      ///< seen from both sides; its picture's opacity says where it is
    std::string TextParams::*texture; ///< what the user chose; null: the picture is made of the tree's own parts
    const char* standard;             ///< what it has else: a file in textures/, or a recipe
    bool (*borne)(const CParams&);    ///< whether the tree may bear some; null: any tree has it

    /// Whether a picture with gaps shows more than one leaf.
    bool manyLeaves() const { return cutOut && !texture; }
};
const SurfaceInfo& surfaceOf(Surface surface);
/// Whether the tree has a picture for it, which some month or some level of detail shows.
bool hasSurface(const CParams& params, Surface surface);
/// What a surface of a mesh shows: itself, or where the user chose nothing for it what stands in for it.
Surface shownSurface(const CParams& params, Surface surface);

/// A picture of a model file.
struct PictureRef {
    std::string texture;           ///< as the model's file refers to it, relative to its folder; empty: inside
    std::filesystem::path picture; ///< where it lies now; empty: there is none
};

/// How one of the surfaces looks.
struct Material {
    Surface surface;
    std::string name;              ///< of the material in files
    std::string texture;           ///< picture, as the model's file refers to it: relative to its folder; empty: inside
    std::filesystem::path picture; ///< where it lies now
    glm::vec3 colour;              ///< where no picture can be shown, 0..1
    bool cutOut;                   ///< the picture's alpha says where the surface is
    PictureRef normal{}, roughness{}; ///< maps of the relief, where the picture has some and the format takes them
    float roughnessFactor = 0.9f;     ///< where it has no picture
    bool packed = false;              ///< roughness has occlusion in its red and metal in its blue
    PictureRef opacity{};             ///< of a cut-out picture, where the format wants a picture of its own
};

} // namespace stromar
