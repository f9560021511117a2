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
    {".glb", N_("glTF, one file"), "y", N_("nothing"), writeGlb, 68, Pictures::Inside, true, false, true, true},
    {".gltf", N_("glTF, with its buffer and pictures beside it"), "y", N_("nothing"), writeGltf, 68, Pictures::Beside, true, false, true, true},
    {".obj", N_("Wavefront OBJ"), "y", N_("occlusion and tangents; two-sided leaves are up to the program"), writeObj, 120,
     Pictures::Beside, false, true},
    {".dae", N_("COLLADA"), "z", N_("occlusion and tangents; two-sided leaves are up to the program"), writeDae, 110},
    {".ply", N_("Stanford PLY, binary"), "z", N_("materials and pictures; all stems and leaves are one mesh"), writePly, 55,
     Pictures::None, false, true},
    {".stl", N_("STL, binary"), "z", N_("materials, pictures, texture coordinates and smooth normals"), writeStl, 35,
     Pictures::None, false, true},
    {".3ds", N_("3D Studio"), "z",
     N_("normals (programs make their own), names beyond ten letters; large meshes are cut into parts"), write3ds, 40,
     Pictures::Beside, false, true},
    {".lwo", N_("LightWave object"), "y", N_("normals (the program makes its own), transparency of the leaf picture"), writeLwo, 45},
    {".pov", N_("POV-Ray scene"), "y", N_("nothing a picture shows; a camera, lights and ground are added"), writePov, 130},
#ifdef STROMAR_WITH_OSG
    {".osgb", N_("OpenSceneGraph binary"), "z", N_("occlusion and tangents"), writeOsg, 45, Pictures::Beside, true, true},
    {".osgt", N_("OpenSceneGraph text"), "z", N_("occlusion and tangents"), writeOsg, 160, Pictures::Beside, true, true},
    {".osg", N_("OpenSceneGraph, old text form"), "z", N_("occlusion and tangents"), writeOsg, 120, Pictures::Beside, true, true},
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
    if (ending.empty()) return "the name of the model file has no ending; it says the format: " + all;
    return "cannot write '" + ending + "'" + suggestion(ending, known) + " (" + all + ")";
}

} // namespace stromar
