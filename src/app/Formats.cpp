#include "stromar/app/Formats.h"
#include "stromar/io/Writers.h"
#include "stromar/util/Text.h"
#include <vector>
#ifdef STROMAR_WITH_OSG
#include "stromar/scene/OsgExport.h"
#endif

namespace stromar {

namespace {
constexpr Format kFormats[] = {
#ifdef STROMAR_WITH_OSG
    {".osg", "OpenSceneGraph, old text form", "z", "nothing", writeOsg, 120},
    {".osgt", "OpenSceneGraph text", "z", "nothing", writeOsg, 160},
    {".osgb", "OpenSceneGraph binary", "z", "nothing", writeOsg, 45},
#endif
    {".3ds", "3D Studio", "z",
     "normals (programs make their own), names beyond ten letters; large meshes are cut into parts", write3ds, 40},
    {".lwo", "LightWave object", "y", "normals (the program makes its own), transparency of the leaf picture", writeLwo,
     45},
    {".obj", "Wavefront OBJ", "y", "nothing; two-sided leaves are up to the program", writeObj, 120},
    {".pov", "POV-Ray scene", "y", "nothing; a camera, lights and ground are added", writePov, 130},
};
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
