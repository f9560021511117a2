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
using enum Content;

constexpr ContentInfo kContents[] = {
    {Materials, N_("materials")},
    {Pictures, N_("textures")},
    {TexCoords, N_("texture coordinates")},
    {Normals, N_("normals (programs make their own)")},
    {Opacity, N_("opacity of leaves"), unsigned(Pictures)},
    {NormalMaps, N_("normal maps"), unsigned(Pictures)},
    {RoughnessMaps, N_("roughness maps"), unsigned(Pictures)},
    {Tints, N_("leaf tints")},
    {Occlusion, N_("ambient occlusion (attribute)")},
    {Tangents, N_("tangents"), Normals | TexCoords},
};

constexpr unsigned kShape = TexCoords | Normals, kColours = Materials | Pictures | Opacity;
constexpr unsigned kEverything = kShape | kColours | NormalMaps | RoughnessMaps | Tangents | Tints | Occlusion;
constexpr unsigned kMaps = NormalMaps | RoughnessMaps;

constexpr const char* kUsdRemark = N_("instances (PointInstancer), levels of detail in one file (variants) and time samples are for programs that are built on OpenUSD: three.js shows none of them");

// clang-format off
constexpr Format kFormats[] = {
    {.ending = ".glb", .name = N_("glTF, one file"), .upAxis = "y", .holds = kEverything, .write = writeGlb, .bytesPerVertex = 68,
     .pictures = Pictures::Inside, .objects = true, .lods = true, .sides = Sides::Material, .channels = Channels::All, .instances = true},
    {.ending = ".gltf", .name = N_("glTF, with its buffer and pictures beside it"), .upAxis = "y", .holds = kEverything, .write = writeGltf,
     .bytesPerVertex = 68, .objects = true, .lods = true, .sides = Sides::Material, .channels = Channels::All, .instances = true},
    {.ending = ".fbx", .name = N_("FBX, binary, centimetres"), .upAxis = "y",
     .holds = kShape | kColours | NormalMaps | Tangents | Tints, .write = writeFbx, .bytesPerVertex = 50,
     .objects = true, .lods = true, .remark = N_("the roughness maps lie beside the file"), .looseRoughness = true, .opacity = true, .embeds = true,
     .channels = Channels::ColoursAndUvs},
    {.ending = ".usda", .name = N_("USD, text"), .upAxis = "y", .holds = kShape | kColours | kMaps, .write = writeUsda,
     .bytesPerVertex = 130, .objects = true, .lods = true, .remark = kUsdRemark, .sides = Sides::Material, .instances = true, .timeSamples = true},
    {.ending = ".usdz", .name = N_("USD, a package with its pictures"), .upAxis = "y", .holds = kShape | kColours | kMaps,
     .write = writeUsdz, .bytesPerVertex = 130, .pictures = Pictures::AlwaysInside, .objects = true, .lods = true,
     .remark = kUsdRemark, .sides = Sides::Material, .instances = true, .timeSamples = true},
    {.ending = ".obj", .name = N_("Wavefront OBJ"), .upAxis = "y", .holds = kShape | kColours | kMaps, .write = writeObj,
     .bytesPerVertex = 200, .objects = true, .anyUp = true, .opacity = true, .sides = Sides::Triangles},
    {.ending = ".dae", .name = N_("COLLADA"), .upAxis = "y", .holds = kShape | kColours | NormalMaps,
     .write = writeDae, .bytesPerVertex = 150, .objects = true,
     .remark = N_("Blender and Godot do not read where leaves are transparent"), .sides = Sides::Triangles},
    {.ending = ".ply", .name = N_("Stanford PLY, binary"), .upAxis = "z", .holds = kShape, .write = writePly, .bytesPerVertex = 55,
     .pictures = Pictures::None, .anyUp = true, .remark = N_("all stems and leaves are one mesh")},
    {.ending = ".stl", .name = N_("STL, binary"), .upAxis = "z", .holds = 0, .write = writeStl, .bytesPerVertex = 35,
     .pictures = Pictures::None, .anyUp = true},
    {.ending = ".3ds", .name = N_("3D Studio"), .upAxis = "z", .holds = kColours | TexCoords, .write = write3ds, .bytesPerVertex = 70,
     .anyUp = true, .remark = N_("names end after ten letters; large meshes are cut into parts"), .sides = Sides::Triangles},
    {.ending = ".lwo", .name = N_("LightWave object"), .upAxis = "y", .holds = Materials | Pictures | TexCoords,
     .write = writeLwo, .bytesPerVertex = 80, .sides = Sides::Triangles},
    {.ending = ".pov", .name = N_("POV-Ray scene"), .upAxis = "y", .holds = kShape | kColours, .write = writePov, .bytesPerVertex = 130,
     .remark = N_("a camera, lights and ground are added")},
#ifdef STROMAR_WITH_OSG
    {.ending = ".osgb", .name = N_("OpenSceneGraph binary"), .upAxis = "z", .holds = kShape | kColours, .write = writeOsg, .bytesPerVertex = 45,
     .lods = true, .anyUp = true},
    {.ending = ".osgt", .name = N_("OpenSceneGraph text"), .upAxis = "z", .holds = kShape | kColours, .write = writeOsg, .bytesPerVertex = 160,
     .lods = true, .anyUp = true},
    {.ending = ".osg", .name = N_("OpenSceneGraph, old text form"), .upAxis = "z", .holds = kShape | kColours, .write = writeOsg,
     .bytesPerVertex = 120, .lods = true, .anyUp = true},
#endif
};
// clang-format on
} // namespace

std::span<const ContentInfo> contentTable() { return kContents; }

std::span<const Format> formatTable() { return kFormats; }

std::string lossesOf(const Format& format) {
    std::string all;
    for (const ContentInfo& one : kContents)
        if (!format.has(one.content) && (format.holds & one.needs) == one.needs) all += (all.empty() ? "" : ", ") + translated(one.name);
    if (!format.remark.empty()) all += (all.empty() ? "" : "; ") + translated(format.remark);
    return all.empty() ? translated(NC_("stromar", "nothing")) : all;
}

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
