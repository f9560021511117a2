#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "stromar/params/ParamTable.h"
#include <cstdlib>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr const char* kBuiltIn[] = {"bark.png", "leaf.png"};
constexpr const char* kLookNames[] = {"bark", "leaf"};

/// The model's name with only letters that every format and reader takes inside a line, a name or a path.
std::string plainName(const fs::path& path) {
    constexpr std::string_view kUnsafe = " \"'\\#%&{}<>*?/$!:@+`|=,;()[]~^";
    std::string name = path.stem().string();
    for (char& c : name)
        if (c <= ' ' || c > '~' || kUnsafe.find(c) != std::string_view::npos) c = '_';
    return name;
}

/// Where the copy of a picture goes: beside the model, named after it.
fs::path pictureBeside(const fs::path& model, Surface surface, const fs::path& picture) {
    return model.parent_path() /
           (plainName(model) + "_" + kLookNames[static_cast<std::size_t>(surface)] + picture.extension().string());
}

ExportModel describe(const TreeModel& model, const fs::path& path) {
    ExportModel description{plainName(path), model.meshes(), {}};
    const glm::vec3 colours[] = {{0.42f, 0.34f, 0.26f}, {0.30f, 0.45f, 0.18f}};
    for (const Surface surface : {Surface::Bark, Surface::Leaf}) {
        const auto i = static_cast<std::size_t>(surface);
        description.looks[i] = {kLookNames[i], {}, colours[i], surface == Surface::Leaf};
    }
    return description;
}
} // namespace

fs::path dataFolder() {
    if (const char* own = std::getenv("STROMAR_DATA")) return own;
    std::error_code problem;
    const fs::path program = fs::read_symlink("/proc/self/exe", problem);
    const fs::path installed = program.parent_path().parent_path() / "share" / "stromar";
    return fs::exists(installed / "presets", problem) ? installed : fs::path(STROMAR_SOURCE_FOLDER);
}

fs::path textureOf(const CParams& params, Surface surface, const fs::path& folder) {
    const std::string& own = surface == Surface::Bark ? params.text.barkTexture : params.text.leafTexture;
    return own.empty() ? dataFolder() / "textures" / kBuiltIn[static_cast<std::size_t>(surface)] : folder / own;
}

void exportModel(const TreeModel& model, const fs::path& treeFolder, const fs::path& path, const CProgress& progress) {
    const Format* format = formatOf(path);
    if (!format) throw CError(unknownFormat(path));
    ExportModel description = describe(model, path);
    if (description.meshes.empty()) throw CError("the tree is empty, there is nothing to export");
    CFileSet files(progress, static_cast<std::uint64_t>(format->bytesPerVertex * double(description.vertexCount())));
    for (const Surface surface : {Surface::Bark, Surface::Leaf}) {
        const fs::path picture = textureOf(model.params, surface, treeFolder);
        const fs::path copy = pictureBeside(path, surface, picture);
        files.copy(picture, copy);
        description.looks[static_cast<std::size_t>(surface)].texture = copy.filename().string();
    }
    format->write(description, path, files);
    files.commit();
}

} // namespace stromar
