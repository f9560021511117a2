#include "stromar/app/Formats.h"
#include "stromar/io/Writers.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <vector>
#ifdef STROMAR_WITH_OSG
#include "stromar/scene/OsgExport.h"
#endif

namespace stromar {

namespace {
// clang-format off
constexpr Format kFormats[] = {
    {.ending = ".glb", .name = N_("glTF, one file"), .upAxis = "y", .losses = N_("nothing"), .write = writeGlb, .bytesPerVertex = 68,
     .pictures = Pictures::Inside, .objects = true, .lods = true, .maps = Maps::NormalsAndRoughness, .sides = Sides::Material, .channels = Channels::All, .instances = true},
    {.ending = ".gltf", .name = N_("glTF, with its buffer and pictures beside it"), .upAxis = "y", .losses = N_("nothing"), .write = writeGltf,
     .bytesPerVertex = 68, .objects = true, .lods = true, .maps = Maps::NormalsAndRoughness, .sides = Sides::Material, .channels = Channels::All, .instances = true},
    {.ending = ".fbx", .name = N_("FBX, binary, centimetres"), .upAxis = "y",
     .losses = N_("occlusion as an attribute; roughness is not connected: its maps lie beside the file"), .write = writeFbx, .bytesPerVertex = 50,
     .objects = true, .lods = true, .maps = Maps::NormalsAndRoughness, .opacity = true, .embeds = true, .channels = Channels::ColoursAndUvs},
    {.ending = ".usda", .name = N_("USD, text"), .upAxis = "y", .losses = N_("occlusion, tints of leaves and tangents"), .write = writeUsda,
     .bytesPerVertex = 130, .objects = true, .maps = Maps::NormalsAndRoughness, .sides = Sides::Material},
    {.ending = ".usdz", .name = N_("USD, a package with its pictures"), .upAxis = "y", .losses = N_("occlusion, tints of leaves and tangents"),
     .write = writeUsdz, .bytesPerVertex = 130, .pictures = Pictures::AlwaysInside, .objects = true, .maps = Maps::NormalsAndRoughness, .sides = Sides::Material},
    {.ending = ".obj", .name = N_("Wavefront OBJ"), .upAxis = "y", .losses = N_("occlusion, tints of leaves and tangents"), .write = writeObj,
     .bytesPerVertex = 200, .objects = true, .anyUp = true, .maps = Maps::NormalsAndRoughness, .opacity = true, .sides = Sides::Triangles},
    {.ending = ".dae", .name = N_("COLLADA"), .upAxis = "y",
     .losses = N_("maps of roughness, occlusion, tints of leaves and tangents; Blender and Godot do not read where leaves are transparent"),
     .write = writeDae, .bytesPerVertex = 150, .objects = true, .maps = Maps::Normals, .sides = Sides::Triangles},
    {.ending = ".ply", .name = N_("Stanford PLY, binary"), .upAxis = "z", .losses = N_("materials and pictures; all stems and leaves are one mesh"),
     .write = writePly, .bytesPerVertex = 55, .pictures = Pictures::None, .anyUp = true},
    {.ending = ".stl", .name = N_("STL, binary"), .upAxis = "z", .losses = N_("materials, pictures, texture coordinates and smooth normals"),
     .write = writeStl, .bytesPerVertex = 35, .pictures = Pictures::None, .anyUp = true},
    {.ending = ".3ds", .name = N_("3D Studio"), .upAxis = "z",
     .losses = N_("normals (programs make their own), their maps and those of roughness, occlusion, tints of leaves, names beyond ten letters; large "
                  "meshes are cut into parts"),
     .write = write3ds, .bytesPerVertex = 70, .anyUp = true, .sides = Sides::Triangles},
    {.ending = ".lwo", .name = N_("LightWave object"), .upAxis = "y",
     .losses = N_("normals (the program makes its own), their maps and those of roughness, occlusion, tints of leaves, transparency of the leaf picture"),
     .write = writeLwo, .bytesPerVertex = 80, .sides = Sides::Triangles},
    {.ending = ".pov", .name = N_("POV-Ray scene"), .upAxis = "y",
     .losses = N_("maps of normals and roughness, occlusion, tints of leaves; a camera, lights and ground are added"), .write = writePov,
     .bytesPerVertex = 130},
#ifdef STROMAR_WITH_OSG
    {.ending = ".osgb", .name = N_("OpenSceneGraph binary"), .upAxis = "z",
     .losses = N_("maps of normals and roughness, occlusion, tints of leaves and tangents"), .write = writeOsg, .bytesPerVertex = 45, .lods = true,
     .anyUp = true},
    {.ending = ".osgt", .name = N_("OpenSceneGraph text"), .upAxis = "z",
     .losses = N_("maps of normals and roughness, occlusion, tints of leaves and tangents"), .write = writeOsg, .bytesPerVertex = 160, .lods = true,
     .anyUp = true},
    {.ending = ".osg", .name = N_("OpenSceneGraph, old text form"), .upAxis = "z",
     .losses = N_("maps of normals and roughness, occlusion, tints of leaves and tangents"), .write = writeOsg, .bytesPerVertex = 120, .lods = true,
     .anyUp = true},
#endif
};
// clang-format on
} // namespace

std::span<const Format> formatTable() { return kFormats; }

const Format* formatOf(const std::filesystem::path& path) {
    const std::string ending = lowerCase(path.extension().string());
    for (const Format& format : kFormats)
        if (format.ending == ending) return &format;
    return nullptr;
}

std::string unknownFormat(const std::filesystem::path& path) {
    std::vector<std::string> known;
    std::string all;
    for (const Format& format : kFormats) {
        known.emplace_back(format.ending);
        all += (all.empty() ? "" : " ") + known.back();
    }
    const std::string ending = path.extension().string();
    if (ending.empty()) return translated(NC_("stromar", "the name of the model file has no ending; it says the format: %1"), all);
    return translated(NC_("stromar", "cannot write '%1'"), ending) + suggestion(ending, known) + " (" + all + ")";
}

} // namespace stromar
