#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "stromar/params/ParamTable.h"
#include "stromar/texture/TextureMaps.h"
#include <algorithm>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr double kCardsTake = 0.45; // of a detail's share of triangles, on the average of the presets

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
    return model.parent_path() / (plainName(model) + "_" + surfaceOf(surface).name + picture.extension().string());
}

/// Meshes in the unit and with the axis up that were chosen. Writers turn z to the axis that is usual in the format.
Meshes arranged(const Meshes& meshes, const ExportOptions& options, const Format& format) {
    const auto up = static_cast<ExportedUp>(options.up);
    const bool turn = up != ExportedUp::Format && (up == ExportedUp::Y) != (format.upAxis == "y");
    if (!turn && options.scale == 1) return meshes;
    const float side = up == ExportedUp::Y ? 1.0f : -1.0f; // y up: z becomes y; z up in a writer of y: the way back
    const auto turned = [&](const glm::vec3& v) { return turn ? glm::vec3(v.x, side * v.z, -side * v.y) : v; };
    Meshes all;
    for (const auto& mesh : meshes) {
        auto copy = std::make_shared<CMesh>(*mesh);
        for (glm::vec3& p : copy->positions) p = static_cast<float>(options.scale) * turned(p);
        for (glm::vec3& n : copy->normals) n = turned(n);
        all.push_back(std::move(copy));
    }
    return all;
}

bool isUsed(const std::vector<Meshes>& lods, Surface surface) {
    return std::ranges::any_of(lods, [&](const Meshes& meshes) {
        return std::ranges::any_of(meshes, [&](const auto& mesh) { return mesh->surface == surface; });
    });
}

/// How a model's file refers to a picture, which is copied if that is wanted. Empty: it is embedded.
std::string placed(const fs::path& picture, const fs::path& copy, ExportedTextures textures, const fs::path& model,
                   CFileSet& files) {
    if (textures == ExportedTextures::Refer)
        return fs::proximate(picture, fs::absolute(model).parent_path()).generic_string();
    if (textures != ExportedTextures::Copy) return {};
    files.copy(picture, copy);
    return copy.filename().string();
}

/// Which surface looks how; the pictures are put where the options want them.
std::vector<Material> materialsOf(const TreeModel& model, const std::vector<Meshes>& lods, const ExportOptions& options,
                                 const Format& format, const fs::path& treeFolder, const fs::path& path,
                                 CFileSet& files) {
    std::vector<Material> materials;
    auto textures = static_cast<ExportedTextures>(options.textures);
    if (textures == ExportedTextures::Format)
        textures = format.pictures == Pictures::Inside ? ExportedTextures::Embed : ExportedTextures::Copy;
    for (const Surface surface : kSurfaces) {
        const SurfaceInfo& info = surfaceOf(surface);
        if (!isInEveryFile(info) && !isUsed(lods, surface)) continue;
        Material& material = materials.emplace_back(Material{surface, info.name, {}, {}, info.colour, info.cutOut});
        if (format.pictures == Pictures::None) continue;
        material.picture = textureOf(model, surface, treeFolder);
        const fs::path copy = pictureBeside(path, surface, material.picture);
        material.texture = placed(material.picture, copy, textures, path, files);
        if (!format.maps) continue;
        for (auto [map, suffix] : {std::pair{&material.normal, "_normal"}, std::pair{&material.roughness, "_roughness"}}) {
            const fs::path picture = mapBeside(material.picture, suffix);
            if (std::error_code problem; !fs::is_regular_file(picture, problem)) continue;
            *map = {placed(picture, mapBeside(copy, suffix), textures, path, files), picture};
        }
    }
    return materials;
}

fs::path withSuffix(const fs::path& path, const std::string& suffix) {
    return path.parent_path() / (path.stem().string() + suffix + path.extension().string());
}

void refuseUnless(const ExportOptions& options, const Format* format, const fs::path& path) {
    if (!format) throw CError(unknownFormat(path));
    if (const std::string conflict = conflictText(options, *format); !conflict.empty()) throw CError(conflict);
}
} // namespace

void exportModels(const std::vector<std::shared_ptr<const TreeModel>>& lods, const ExportOptions& options,
                  const fs::path& treeFolder, const fs::path& path, const CProgress& progress) {
    const Format* format = formatOf(path);
    refuseUnless(options, format, path);
    std::vector<Meshes> meshes;
    std::size_t vertices = 0;
    for (const auto& lod : lods) {
        meshes.push_back(lod->meshes(progress));
        if (meshes.back().empty()) throw CError("the tree is empty, there is nothing to export");
        vertices += lod->vertexCount();
    }
    const TreeModel& coarsest = *lods.back(); // only coarse ones have pictures of twigs, all the same
    makePictures(coarsest, treeFolder, progress);
    CFileSet files(progress, static_cast<std::uint64_t>(format->bytesPerVertex * double(vertices)));
    const auto materials = materialsOf(coarsest, meshes, options, *format, treeFolder, path, files);
    const auto write = [&](const std::string& suffix, std::size_t first, std::size_t count) {
        ExportModel model{plainName(path) + suffix, arranged(meshes[first], options, *format), {}, materials};
        for (std::size_t i = first + 1; i < first + count; ++i)
            model.coarser.push_back(arranged(meshes[i], options, *format));
        format->write(model, withSuffix(path, suffix), files);
    };
    if (options.lods == static_cast<int>(ExportedLods::FileEach))
        for (std::size_t i = 0; i < lods.size(); ++i) write("_LOD" + std::to_string(i), i, 1);
    else
        write("", 0, lods.size());
    files.commit();
}

std::vector<std::shared_ptr<const TreeModel>> exportTree(CTreeCreator& creator, const CParams& params,
                                                         const ExportOptions& options, const fs::path& treeFolder,
                                                         const fs::path& path, const CProgress& progress,
                                                         const std::shared_ptr<const TreeModel>& ready) {
    refuseUnless(options, formatOf(path), path); // before anything grows
    std::vector<std::shared_ptr<const TreeModel>> lods;
    for (const Detail* detail : detailsOf(options))
        lods.push_back(ready && ready->detail == detail ? ready : creator.create(params, *detail, progress));
    exportModels(lods, options, treeFolder, path, progress);
    return lods;
}

void exportModel(const TreeModel& model, const fs::path& treeFolder, const fs::path& path, const CProgress& progress) {
    const std::shared_ptr<const TreeModel> borrowed(std::shared_ptr<const TreeModel>(), &model);
    exportModels({borrowed}, {}, treeFolder, path, progress);
}

double estimatedBytes(double fullVertices, const ExportOptions& options, const Format& format) {
    double share = 0;
    for (const Detail* detail : detailsOf(options)) share += detail->share * (detail->twigPlanes > 0 ? kCardsTake : 1);
    return share * fullVertices * format.bytesPerVertex;
}

} // namespace stromar
