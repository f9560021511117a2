#include "ExportParts.h"
#include "ContentHash.h"
#include "ExportPictures.h"
#include "stromar/app/DisplacedModel.h"
#include "stromar/app/Formats.h"
#include "stromar/app/Pictures.h"
#include "stromar/mesh/VoxelMesh.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/model/MeshValues.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <optional>
#include <type_traits>
#include <utility>

namespace stromar {

namespace fs = std::filesystem;

std::string plainName(const fs::path& path) {
    constexpr std::string_view kUnsafe = " \"'\\#%&{}<>*?/$!:@+`|=,;()[]~^";
    std::string name = path.stem().string();
    for (char& c : name)
        if (c <= ' ' || c > '~' || kUnsafe.find(c) != std::string_view::npos) c = '_';
    return name;
}

fs::path withSuffix(const fs::path& path, const std::string& suffix) {
    return path.parent_path() / (path.stem().string() + suffix + path.extension().string());
}

void refuseUnless(const ExportOptions& options, const Format* format, const fs::path& path) {
    if (!format) throw CError(unknownFormat(path));
    if (const std::string conflict = conflictText(options, *format); !conflict.empty()) throw CError(conflict);
    const fs::path folder = path.parent_path();
    if (std::error_code problem; !folder.empty() && !fs::is_directory(folder, problem))
        throw CError(
            translated(NC_("stromar", "cannot write %1: there is no folder %2"), path.string(), folder.string()));
}

std::shared_ptr<const TreeModel> finishedModel(const std::shared_ptr<const TreeModel>& model,
                                               const ExportOptions& options, const fs::path& treeFolder,
                                               const SizeLimits& limits, const CProgress& progress) {
    if (isSolid(options)) return model;
    return displaced(joined(model, progress), {options.displacement, options.displacementStrength}, treeFolder, limits,
                     progress);
}

Meshes meshesFor(const TreeModel& model, const ExportOptions& options, const CProgress& progress) {
    if (!isSolid(options)) return model.meshes(progress);
    return {voxelMesh(*model.tree, meshParamsOf(model.params), options.voxelSize, progress)};
}

Arrangement arrangementFor(const ExportOptions& options, const Format& format) {
    const auto up = static_cast<ExportedUp>(options.up);
    const bool turn = up != ExportedUp::Format && (up == ExportedUp::Y) != (format.upAxis == "y");
    return {static_cast<float>(options.scale), turn, up == ExportedUp::Y ? 1.0f : -1.0f};
}

Meshes arranged(const Meshes& meshes, const Arrangement& to) {
    if (to.isPlain()) return meshes;
    Meshes all;
    for (const auto& mesh : meshes) {
        auto copy = std::make_shared<CMesh>(*mesh);
        for (glm::vec3& p : copy->positions) p = to.point(p);
        for (glm::vec3& n : copy->normals) n = to.direction(n);
        all.push_back(std::move(copy));
    }
    return all;
}

namespace {
/// Towards the back of the triangles at each vertex, unit; nothing where they are flat.
std::vector<glm::vec3> backwardsOf(const CMesh& mesh) {
    std::vector<glm::vec3> sums(mesh.vertexCount(), glm::vec3(0));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t c) { return mesh.positions[mesh.indices[i + c]]; };
        const glm::vec3 across = glm::cross(corner(2) - corner(0), corner(1) - corner(0));
        for (std::size_t c = 0; c < 3; ++c) sums[mesh.indices[i + c]] += across;
    }
    for (glm::vec3& sum : sums)
        if (const float length = glm::length(sum); length > 0) sum /= length;
    return sums;
}

/// A leaf's triangles once more, turned round, as far behind as a leaf is thick: faces at the same place would shade
/// each other.
std::shared_ptr<const CMesh> withBacks(const CMesh& mesh, float metre) {
    const float thickness = 3e-4f * metre;
    auto both = std::make_shared<CMesh>(mesh);
    const std::vector<glm::vec3> backwards = backwardsOf(mesh);
    const auto twice = [](auto& values, const auto& turned) {
        const std::size_t count = values.size();
        values.reserve(2 * count);
        for (std::size_t i = 0; i < count; ++i) values.push_back(turned(values[i]));
    };
    const auto first = static_cast<std::uint32_t>(mesh.vertexCount());
    twice(both->positions, [](const glm::vec3& p) { return p; });
    twice(both->normals, [](const glm::vec3& n) { return -n; });
    twice(both->texCoords, [](const glm::vec2& t) { return t; });
    twice(both->looks, [](const VertexLook& look) { return look; });
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) both->positions[first + v] += thickness * backwards[v];
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (const std::size_t corner : {i, i + 2, i + 1}) both->indices.push_back(first + mesh.indices[corner]);
    return both;
}

/// The backs of leaves, with what their vertices carry.
void addBacks(Meshes& meshes, std::vector<VertexChannels>& channels, float metre) {
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (!surfaceOf(meshes[i]->surface).cutOut) continue;
        meshes[i] = withBacks(*meshes[i], metre);
        if (channels.empty()) continue;
        for (VertexChannel& channel : channels[i]) channel.bytes += std::string(channel.bytes);
    }
}
} // namespace

void addBacks(ExportModel& model, float metre) {
    addBacks(model.meshes, model.channels, metre);
    model.coarserChannels.resize(model.coarser.size());
    for (std::size_t lod = 0; lod < model.coarser.size(); ++lod)
        addBacks(model.coarser[lod], model.coarserChannels[lod], metre);
}

namespace {
/// Of length and width 1.
std::shared_ptr<const CMesh> meshOfBlade(const COrganMesh& organs) {
    auto mesh = std::make_shared<CMesh>();
    mesh->name = organs.name();
    mesh->surface = organs.surface();
    for (const LeafBlade::Point& point : organs.blade().points) {
        mesh->positions.emplace_back(point.place);
        mesh->normals.emplace_back(point.normal);
        mesh->texCoords.push_back(point.texCoord);
        mesh->looks.emplace_back();
    }
    mesh->indices.assign(organs.blade().indices.begin(), organs.blade().indices.end());
    return mesh;
}

Instances placesOf(const COrganMesh& organs, const Arrangement& arrangement, float shift) {
    assert(!arrangement.turns && "formats that hold instances have one axis up");
    Instances all;
    for (std::size_t i = 0; i < organs.count(); ++i) {
        const InstancePlace own = organs.place(i);
        all.places.push_back(arrangement.point(own.position + glm::vec3(shift, 0, 0)));
        all.turns.push_back(own.turn);
        all.sizes.push_back(arrangement.scale * glm::vec3(own.width, own.length, own.width));
    }
    return all;
}

template <typename Value> std::string meansOfInstances(const VertexChannel& channel, const COrganMesh& organs) {
    const auto components = static_cast<std::size_t>(channel.components);
    const std::size_t points = organs.blade().points.size();
    std::vector<Value> all(channel.bytes.size() / sizeof(Value));
    std::memcpy(all.data(), channel.bytes.data(), all.size() * sizeof(Value));
    std::string means;
    for (std::size_t i = 0; i < organs.count(); ++i)
        for (std::size_t c = 0; c < components; ++c) {
            double sum = 0;
            for (std::size_t point = i * points; point < (i + 1) * points; ++point) sum += double(all[point * components + c]);
            const double mean = sum / double(points);
            const auto value = static_cast<Value>(std::is_integral_v<Value> ? std::round(mean) : mean);
            means.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
    return means;
}

/// The mean of what the vertices of each instance carry; its name is one of the program's own, as those of instances have to be.
VertexChannel channelOfInstances(const VertexChannel& channel, const COrganMesh& organs) {
    assert(channel.type != VertexChannel::Type::Short && "joints have no mean");
    const bool bytes = channel.type == VertexChannel::Type::Byte;
    return {channel.name.starts_with('_') ? channel.name : "_" + channel.name, channel.type, channel.components,
            bytes ? meansOfInstances<std::uint8_t>(channel, organs) : meansOfInstances<float>(channel, organs)};
}
} // namespace

void addInstances(ExportModel& model, const TreeModel& tree, const Arrangement& arrangement, float shift) {
    model.instances.resize(model.meshes.size());
    std::size_t next = 0;
    tree.visitMeshes([&](const auto&, int) { ++next; },
                     [&](const std::shared_ptr<const COrganMesh>& organs, int) {
                         const std::size_t i = next++;
                         model.meshes[i] = meshOfBlade(*organs);
                         model.instances[i] = placesOf(*organs, arrangement, shift);
                         if (model.channels.empty()) return;
                         for (const VertexChannel& channel : std::exchange(model.channels[i], {}))
                             model.instances[i].channels.push_back(channelOfInstances(channel, *organs));
                     });
}

namespace {
/// Where the copy of a picture goes: beside the model, named after it.
fs::path pictureBeside(const fs::path& model, const std::string& name, const fs::path& picture) {
    return model.parent_path() / (plainName(model) + "_" + name + picture.extension().string());
}

bool isUsed(const std::vector<Meshes>& lods, Surface surface) {
    return std::ranges::any_of(lods, [&](const Meshes& meshes) {
        return std::ranges::any_of(meshes, [&](const auto& mesh) { return mesh->surface == surface; });
    });
}

/// A copy that other models may have made already.
fs::path shared(const fs::path& picture, const fs::path& folder) {
    const fs::path copy = folder / (nameOfHash(hashOfFile(picture)) + picture.extension().string());
    std::error_code problem; // copying says it better
    if (fs::exists(copy, problem)) return copy;
    fs::create_directories(folder, problem);
    CFileSet files;
    files.copy(picture, copy);
    files.commit();
    return copy;
}

/// How a model's file refers to a picture, which is copied if that is wanted. Empty: it is embedded.
std::string placed(const fs::path& picture, const fs::path& copy, ExportedTextures textures,
                   const ExportOptions& options, const Output& to, CFileSet& files) {
    const auto fromModel = [&](const fs::path& file) {
        return fs::proximate(fs::absolute(file), fs::absolute(to.path).parent_path()).generic_string();
    };
    if (textures == ExportedTextures::Refer) return fromModel(picture);
    if (textures != ExportedTextures::Copy) return {};
    if (!options.sharedPictures.empty()) return fromModel(shared(picture, options.sharedPictures));
    if (to.copiesPictures) files.copy(picture, copy);
    return copy.filename().string();
}

/// The map beside a picture.
std::optional<fs::path> mapOf(const fs::path& picture, const char* suffix) {
    const fs::path map = mapBeside(picture, suffix);
    std::error_code problem;
    return fs::is_regular_file(map, problem) ? std::optional(map) : std::nullopt;
}

/// Of normals and roughness, where there are some.
template <typename Place>
void addMaps(Material& material, const fs::path& whole, const Format& format, const ExportOptions& options, Place&& place) {
    if (const auto normal = format.has(Content::NormalMaps) ? mapOf(whole, "_normal") : std::nullopt)
        material.normal = place(preparedPicture(*normal, PictureUse::Normal, options), "_normal");
    const auto rough = format.has(Content::RoughnessMaps) || format.looseRoughness ? mapOf(whole, "_roughness") : std::nullopt;
    if (!rough) return;
    const bool wantsPicture = options.packedMaps != static_cast<int>(ExportedPackedMaps::None);
    if (const auto same = wantsPicture ? std::nullopt : uniformGrey(*rough)) {
        material.roughnessFactor = float(*same) / 255;
        return;
    }
    material.packed = options.packedMaps == static_cast<int>(ExportedPackedMaps::Orm) &&
                      isPng(*rough);
    material.roughness =
        place(preparedPicture(*rough, PictureUse::Roughness, options), material.packed ? "_orm" : "_roughness");
}
} // namespace

bool needsMaterial(const TreeModel& model, const std::vector<Meshes>& lods, Surface surface) {
    return std::ranges::any_of(kSurfaces, [&](Surface own) { return shownSurface(model.params, own) == surface && isUsed(lods, own); });
}

Material plainMaterial(Surface surface) {
    const SurfaceInfo& info = surfaceOf(surface);
    return {surface, info.name, {}, {}, info.colour, info.cutOut};
}

namespace {
/// Whether the tree shows it at some time of its life.
bool willShow(const TreeModel& model, Surface surface) {
    if (!hasSurface(model.params, surface)) return false;
    const auto level = static_cast<std::size_t>(std::ranges::find(kBarks, surface) - kBarks.begin());
    return !isBark(surface) || !model.grown || (level < model.grown->generationCount() && !model.grown->generation(level).stems.empty());
}
} // namespace

std::vector<Surface> shownSurfaces(const TreeModel& model, const std::vector<Meshes>& lods, bool isFrame) {
    std::vector<Surface> shown;
    for (const Surface surface : kSurfaces)
        if (needsMaterial(model, lods, surface) || (isFrame && willShow(model, surface))) shown.push_back(surface);
    return shown;
}

std::optional<CAtlas> atlasFor(const TreeModel& model, const std::vector<Surface>& shown, const ExportOptions& options, const fs::path& treeFolder,
                               const CProgress& progress) {
    if (options.atlas == static_cast<int>(ExportedAtlas::None)) return {};
    std::vector<SurfacePicture> pictures;
    for (const Surface surface : shown)
        if (surfaceOf(surface).cutOut) pictures.push_back({surface, textureOf(model, surface, treeFolder)});
    if (pictures.size() < 2) return {};
    return CAtlas(std::move(pictures), progress);
}

Material materialOf(const SurfacePicture& shown, const std::string& name, const ExportOptions& options, const Format& format, const Output& to,
                    CFileSet& files) {
    const SurfaceInfo& info = surfaceOf(shown.surface);
    auto textures = static_cast<ExportedTextures>(options.textures);
    if (textures == ExportedTextures::Format)
        textures = format.pictures >= Pictures::Inside ? ExportedTextures::Embed : ExportedTextures::Copy;
    Material material = plainMaterial(shown.surface);
    material.name = name;
    material.roughnessFactor = info.cutOut ? 0.7f : 0.9f;
    if (format.pictures == Pictures::None) return material;
    const fs::path& whole = shown.file;
    material.picture = preparedPicture(whole, info.cutOut ? PictureUse::CutOutAlbedo : PictureUse::Albedo, options);
    const fs::path copy = pictureBeside(to.named, name, whole); // maps keep its format
    const auto place = [&](const fs::path& picture, const char* suffix) {
        return PictureRef{placed(picture, mapBeside(copy, suffix), textures, options, to, files), picture};
    };
    material.texture = placed(material.picture, pictureBeside(to.named, name, material.picture), textures, options, to, files);
    if (format.opacity && info.cutOut && isPng(whole) &&
        textures != ExportedTextures::Refer)
        material.opacity = place(preparedPicture(whole, PictureUse::Opacity, options), "_opacity");
    addMaps(material, whole, format, options, place);
    if (options.packedMaps == static_cast<int>(ExportedPackedMaps::UnityMask) && to.copiesPictures)
        if (const auto rough = mapOf(whole, "_roughness"))
            files.copy(preparedPicture(*rough, PictureUse::UnityMask, options), mapBeside(copy, "_mask"));
    return material;
}

} // namespace stromar
