#include "stromar/app/Export.h"
#include "CollisionExport.h"
#include "ContentHash.h"
#include "ExportPictures.h"
#include "VertexColours.h"
#include "wind/WindExport.h"
#include "stromar/app/DisplacedModel.h"
#include "stromar/app/Formats.h"
#include "stromar/params/ParamTable.h"
#include "stromar/mesh/VoxelMesh.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/model/MeshValues.h"
#include "stromar/model/ModelSway.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>
#include <optional>

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

Arrangement arrangementFor(const ExportOptions& options, const Format& format) {
    const auto up = static_cast<ExportedUp>(options.up);
    const bool turn = up != ExportedUp::Format && (up == ExportedUp::Y) != (format.upAxis == "y");
    return {static_cast<float>(options.scale), turn, up == ExportedUp::Y ? 1.0f : -1.0f};
}

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

/// A leaf's triangles once more, turned round, as far behind as a leaf is thick: faces at the same place would shade each other.
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
void addBacks(ExportModel& model, float metre) {
    addBacks(model.meshes, model.channels, metre);
    model.coarserChannels.resize(model.coarser.size());
    for (std::size_t lod = 0; lod < model.coarser.size(); ++lod) addBacks(model.coarser[lod], model.coarserChannels[lod], metre);
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

bool isUsed(const std::vector<Meshes>& lods, Surface surface) {
    return std::ranges::any_of(lods, [&](const Meshes& meshes) {
        return std::ranges::any_of(meshes, [&](const auto& mesh) { return mesh->surface == surface; });
    });
}

/// Where a model goes.
struct Output {
    fs::path path;
    fs::path named;             ///< that its pictures are named after: shared by the frames of a motion
    bool copiesPictures = true; ///< else they are there
};

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
std::string placed(const fs::path& picture, const fs::path& copy, ExportedTextures textures, const ExportOptions& options, const Output& to,
                   CFileSet& files) {
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
void addMaps(Material& material, const fs::path& whole, const ExportOptions& options, Place&& place) {
    if (const auto normal = mapOf(whole, "_normal")) material.normal = place(preparedPicture(*normal, PictureUse::Normal, options), "_normal");
    const auto rough = mapOf(whole, "_roughness");
    if (!rough) return;
    material.packed = options.packedMaps == static_cast<int>(ExportedPackedMaps::Orm) && lowerCase(rough->extension().string()) == ".png";
    material.roughness = place(preparedPicture(*rough, PictureUse::Roughness, options), material.packed ? "_orm" : "_roughness");
}

/// Which surface looks how; the pictures are put where the options want them.
std::vector<Material> materialsOf(const TreeModel& model, const std::vector<Meshes>& lods, const ExportOptions& options,
                                 const Format& format, const fs::path& treeFolder, const Output& to,
                                 CFileSet& files) {
    std::vector<Material> materials;
    auto textures = static_cast<ExportedTextures>(options.textures);
    if (textures == ExportedTextures::Format)
        textures = format.pictures >= Pictures::Inside ? ExportedTextures::Embed : ExportedTextures::Copy;
    for (const Surface surface : kSurfaces) {
        const SurfaceInfo& info = surfaceOf(surface);
        const bool shown = shownSurface(model.params, surface) == surface && isUsed(lods, surface);
        if (!isInEveryFile(info) && !shown) continue;
        Material& material = materials.emplace_back(Material{surface, info.name, {}, {}, info.colour, info.cutOut});
        if (format.pictures == Pictures::None) continue;
        const fs::path whole = textureOf(model, surface, treeFolder);
        material.picture = preparedPicture(whole, info.cutOut ? PictureUse::CutOutAlbedo : PictureUse::Albedo, options);
        const fs::path copy = pictureBeside(to.named, surface, material.picture);
        const auto place = [&](const fs::path& picture, const char* suffix) {
            return PictureRef{placed(picture, mapBeside(copy, suffix), textures, options, to, files), picture};
        };
        material.texture = placed(material.picture, copy, textures, options, to, files);
        if (format.opacity && info.cutOut && lowerCase(whole.extension().string()) == ".png" && textures != ExportedTextures::Refer)
            material.opacity = place(preparedPicture(whole, PictureUse::Opacity, options), "_opacity");
        if (format.maps) addMaps(material, whole, options, place);
        if (options.packedMaps == static_cast<int>(ExportedPackedMaps::UnityMask) && to.copiesPictures)
            if (const auto rough = mapOf(whole, "_roughness")) files.copy(preparedPicture(*rough, PictureUse::UnityMask, options), mapBeside(copy, "_mask"));
    }
    return materials;
}

fs::path withSuffix(const fs::path& path, const std::string& suffix) {
    return path.parent_path() / (path.stem().string() + suffix + path.extension().string());
}

void refuseUnless(const ExportOptions& options, const Format* format, const fs::path& path) {
    if (!format) throw CError(unknownFormat(path));
    if (const std::string conflict = conflictText(options, *format); !conflict.empty()) throw CError(conflict);
    const fs::path folder = path.parent_path();
    if (std::error_code problem; !folder.empty() && !fs::is_directory(folder, problem))
        throw CError(translated(NC_("stromar", "cannot write %1: there is no folder %2"), path.string(), folder.string()));
}
} // namespace

namespace {
/// Levels of detail of a tree at one moment.
struct Pose {
    std::vector<std::shared_ptr<const TreeModel>> lods;
    std::vector<Meshes> meshes; ///< of each
    std::vector<std::shared_ptr<const ModelSway>> sways; ///< of each, where they go into the file

    std::size_t vertexCount() const {
        std::size_t count = 0;
        for (const auto& lod : lods) count += lod->vertexCount();
        return count;
    }
};

void writePose(const Pose& pose, const ExportOptions& options, const fs::path& treeFolder, const Output& to,
               const CProgress& progress, const Motion& motion = {}) {
    const Format& format = *formatOf(to.path);
    const TreeModel& coarsest = *pose.lods.back(); // only coarse ones have pictures of twigs, all the same
    if (coarsest.age > 0 && std::ranges::any_of(pose.meshes, &Meshes::empty))
        throw CError(translated(NC_("stromar", "the tree is empty, there is nothing to export")));
    makePictures(coarsest, treeFolder, progress);
    CFileSet files(progress, static_cast<std::uint64_t>(format.bytesPerVertex * double(pose.vertexCount())));
    const auto materials = materialsOf(coarsest, pose.meshes, options, format, treeFolder, to, files);
    const Arrangement arrangement = arrangementFor(options, format);
    const auto write = [&](const std::string& suffix, std::size_t first, std::size_t count) {
        ExportModel model{plainName(to.path) + suffix, arranged(pose.meshes[first], arrangement), {}, materials};
        for (std::size_t i = first + 1; i < first + count; ++i) model.coarser.push_back(arranged(pose.meshes[i], arrangement));
        if (!pose.sways.empty()) addWind(model, std::span(pose.sways).subspan(first, count), options, motion, arrangement);
        if (format.channels != Channels::None) addColours(model, isSolid(options) ? std::span<const std::shared_ptr<const TreeModel>>() : std::span(pose.lods).subspan(first, count), options);
        if (isTwoSided(options, format)) addBacks(model, arrangement.scale);
        model.leafLight = options.leafLight == static_cast<int>(ExportedLeafLight::Transmission);
        if (first == 0) addCollision(model, *pose.lods.front()->tree, options, format, arrangement, to.path, files);
        format.write(model, withSuffix(to.path, suffix), files);
    };
    if (options.lods == static_cast<int>(ExportedLods::FileEach))
        for (std::size_t i = 0; i < pose.lods.size(); ++i) write("_LOD" + std::to_string(i), i, 1);
    else
        write("", 0, pose.lods.size());
    if (!pose.sways.empty())
        addWindPictures(*pose.sways.front(), options, arrangement, to.path.parent_path() / plainName(to.path), files);
    files.commit();
}

std::vector<std::shared_ptr<const TreeModel>> makeLods(CTreeCreator& creator, const CParams& params, const ExportOptions& options,
                                                       const CProgress& progress,
                                                       const std::shared_ptr<const TreeModel>& ready = nullptr) {
    std::vector<std::shared_ptr<const TreeModel>> lods;
    for (const Detail* detail : detailsOf(options))
        lods.push_back(ready && ready->detail == detail ? ready : creator.create(params, *detail, progress));
    return lods;
}

/// As files show them: the wood in one piece, perhaps with the relief of its bark.
std::vector<std::shared_ptr<const TreeModel>> finishedLods(std::vector<std::shared_ptr<const TreeModel>> lods, const ExportOptions& options,
                                                           const fs::path& treeFolder, const SizeLimits& limits, const CProgress& progress) {
    if (isSolid(options)) return lods;
    for (auto& lod : lods) {
        lod = joined(lod, progress);
        lod = displaced(lod, {options.displacement, options.displacementStrength}, treeFolder, limits, progress);
    }
    return lods;
}

/// What of a model goes into the file.
Meshes meshesFor(const TreeModel& model, const ExportOptions& options, const CProgress& progress) {
    if (!isSolid(options)) return model.meshes(progress);
    return {voxelMesh(*model.tree, meshParamsOf(model.params), options.voxelSize, progress)};
}

/// Makes the poses of a motion, some at a time, of a tree that the limits allow.
class CPoseMaker {
public:
    CPoseMaker(const CParams& params, const ExportOptions& options, const Motion& motion, bool varied, const SizeLimits& limits,
               const fs::path& treeFolder)
        : m_params(params), m_options(options), m_motion(motion), m_varied(varied), m_limits(limits), m_folder(treeFolder) {}

    /// For wind: what all moments share.
    void prepare(double age, const CProgress& progress) {
        if (!m_motion.sways()) return;
        CTreeCreator creator(m_varied, SizeLimits::none());
        creator.setAge(age);
        m_lods = finishedLods(makeLods(creator, m_params, m_options, progress), m_options, m_folder, m_limits, progress);
        for (const auto& lod : m_lods) m_moving.emplace_back(lod, m_motion, progress);
    }

    std::vector<Moment> moments(double age) const { return m_motion.moments(age, m_moving.empty() ? 0 : m_moving.front().fallSeconds()); }

    Pose poseAt(const Moment& moment, const CProgress& progress) {
        Pose pose{m_lods, {}, {}};
        if (!m_motion.sways()) {
            std::unique_ptr<CTreeCreator> creator = takeCreator();
            creator->setAge(moment.age);
            pose.lods = finishedLods(makeLods(*creator, m_params, m_options, progress), m_options, m_folder, m_limits, progress);
            giveBack(std::move(creator));
            for (const auto& lod : pose.lods) pose.meshes.push_back(meshesFor(*lod, m_options, progress));
            return pose;
        }
        for (const CMovingModel& moving : m_moving)
            pose.meshes.push_back(swayedMeshes(*moving.sway(), *moving.poseAt(moment.seconds, progress), moment.seconds, moving.loop(), progress));
        return pose;
    }

private:
    std::unique_ptr<CTreeCreator> takeCreator() {
        const std::lock_guard lock(m_mutex);
        if (m_creators.empty()) return std::make_unique<CTreeCreator>(m_varied, SizeLimits::none());
        auto creator = std::move(m_creators.back());
        m_creators.pop_back();
        return creator;
    }
    void giveBack(std::unique_ptr<CTreeCreator> creator) {
        const std::lock_guard lock(m_mutex);
        m_creators.push_back(std::move(creator));
    }

    const CParams& m_params;
    const ExportOptions& m_options;
    const Motion& m_motion;
    bool m_varied;
    SizeLimits m_limits;
    const fs::path& m_folder;
    std::vector<std::shared_ptr<const TreeModel>> m_lods;
    std::vector<CMovingModel> m_moving; ///< of the lods
    std::mutex m_mutex;
    std::vector<std::unique_ptr<CTreeCreator>> m_creators; ///< that nobody uses now
};

/// How many trees fit into memory side by side.
int workersFor(const CParams& params, const ExportOptions& options, const SizeLimits& limits, std::size_t moments, const CProgress& progress) {
    if (options.displacement > 0) return 1; // which may take all that is allowed
    double bytes = 1;
    for (const Detail* detail : detailsOf(options)) bytes += predictSize(params, *detail, progress).bytes;
    const double most = std::min(double(progress.threads()), double(moments));
    return static_cast<int>(std::clamp(std::floor(limits.bytes / bytes), 1.0, most));
}
} // namespace

namespace {
/// Of finished models.
void writeModels(const std::vector<std::shared_ptr<const TreeModel>>& lods, const ExportOptions& options, const fs::path& treeFolder,
                 const fs::path& path, const CProgress& progress, const Motion& motion) {
    Pose pose{lods, {}, {}};
    const bool carriesWind = options.wind != static_cast<int>(ExportedWind::None);
    for (std::size_t i = 0; carriesWind && i < lods.size(); ++i) {
        pose.sways.push_back(CMovingModel(pose.lods[i], motion, progress).sway());
        pose.lods[i] = pose.sways[i]->model; // perhaps felled
    }
    for (const auto& lod : pose.lods) pose.meshes.push_back(meshesFor(*lod, options, progress));
    writePose(pose, options, treeFolder, {path, path}, progress, motion);
}
} // namespace

void exportModels(const std::vector<std::shared_ptr<const TreeModel>>& lods, const ExportOptions& options,
                  const fs::path& treeFolder, const fs::path& path, const CProgress& progress, const Motion& motion) {
    refuseUnless(options, formatOf(path), path);
    writeModels(finishedLods(lods, options, treeFolder, SizeLimits(), progress), options, treeFolder, path, progress, motion);
}

void exportFrames(const CParams& params, const ExportOptions& options, const Motion& motion, double age, bool varied,
                  const SizeLimits& limits, const fs::path& treeFolder, const fs::path& path,
                  const std::function<void(const fs::path&)>& written, const CProgress& progress) {
    refuseUnless(options, formatOf(path), path);
    if (isSolid(options) && motion.sways()) throw CError(translated(NC_("stromar", "one solid does not move in the wind")));
    for (const Detail* detail : detailsOf(options)) refuseTooLarge(params, *detail, limits, progress);
    CPoseMaker maker(params, options, motion, varied, limits, treeFolder);
    maker.prepare(age, progress);
    const std::vector<Moment> moments = maker.moments(age);
    std::atomic<std::size_t> done = 0;
    const auto write = [&](std::size_t i, const CProgress& own) {
        const Output to{motion.frames == 0 ? path : framePath(path, i, moments.size()), path, i == 0};
        writePose(maker.poseAt(moments[i], own), options, treeFolder, to, own);
        written(to.path);
        progress.report(double(++done) / double(moments.size()));
    };
    write(0, progress.piece(progress.threads())); // with the pictures
    const int workers = workersFor(params, options, limits, moments.size(), progress);
    const CProgress own = progress.piece(std::max(1, progress.threads() / workers));
    parallelFor(
        moments.size() - 1, 1, [&](std::size_t first, std::size_t) { write(first + 1, own); }, progress.piece(workers));
}

std::vector<std::shared_ptr<const TreeModel>> exportTree(CTreeCreator& creator, const CParams& params,
                                                         const ExportOptions& options, const fs::path& treeFolder,
                                                         const fs::path& path, const CProgress& progress,
                                                         const std::shared_ptr<const TreeModel>& ready, const Motion& motion) {
    refuseUnless(options, formatOf(path), path); // before anything grows
    const auto lods = finishedLods(makeLods(creator, params, options, progress, ready), options, treeFolder, creator.limits(), progress);
    writeModels(lods, options, treeFolder, path, progress, motion);
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
