#include "stromar/app/Export.h"
#include "CollisionExport.h"
#include "ExportParts.h"
#include "Merge.h"
#include "VertexColours.h"
#include "wind/WindExport.h"
#include "stromar/app/Formats.h"
#include "stromar/params/ParamTable.h"
#include "stromar/model/ModelSway.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr double kCardsTake = 0.45; // of a detail's share of triangles, on the average of the presets

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
    CFileSet files(progress, static_cast<std::uint64_t>(bytesPerVertex(options, format) * double(pose.vertexCount())));
    const std::vector<Surface> shown = shownSurfaces(coarsest, pose.meshes, to.isFrame);
    const std::optional<CAtlas> atlas = atlasFor(coarsest, shown, options, treeFolder, progress);
    std::vector<Material> materials;
    for (const Surface surface : shown)
        materials.push_back(atlas && surfaceOf(surface).cutOut
                                ? plainMaterial(surface)
                                : materialOf({surface, textureOf(coarsest, surface, treeFolder)}, surfaceOf(surface).name, options, format, to, files));
    std::optional<Material> foliage;
    if (atlas) foliage = materialOf({Surface::Leaf, atlas->file()}, CAtlas::kName, options, format, to, files);
    const Arrangement arrangement = arrangementFor(options, format);
    const bool instances = options.instances != static_cast<int>(ExportedInstances::None) && !isSolid(options);
    const auto write = [&](const std::string& suffix, std::size_t first, std::size_t count) {
        ExportModel model{plainName(to.path) + suffix, arranged(pose.meshes[first], arrangement), {}, {}};
        const std::vector<Meshes> own(pose.meshes.begin() + std::ptrdiff_t(first), pose.meshes.begin() + std::ptrdiff_t(first + count));
        std::ranges::copy_if(materials, std::back_inserter(model.materials),
                             [&](const Material& material) { return needsMaterial(coarsest, own, material.surface); });
        for (std::size_t i = first + 1; i < first + count; ++i) model.coarser.push_back(arranged(pose.meshes[i], arrangement));
        if (!pose.sways.empty()) addWind(model, std::span(pose.sways).subspan(first, count), options, motion, arrangement);
        if (format.channels != Channels::None) addColours(model, isSolid(options) ? std::span<const std::shared_ptr<const TreeModel>>() : std::span(pose.lods).subspan(first, count), options);
        if (isTwoSided(options, format)) addBacks(model, arrangement.scale);
        if (instances) addInstances(model, *pose.lods[first], arrangement);
        if (atlas) atlas->replaceIn(model, *foliage);
        if (options.objects == static_cast<int>(ExportedObjects::Materials)) mergeByMaterial(model);
        model.compression = static_cast<ExportedCompression>(options.compression);
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

/// As files show them.
std::vector<std::shared_ptr<const TreeModel>> finishedLods(std::vector<std::shared_ptr<const TreeModel>> lods, const ExportOptions& options,
                                                           const fs::path& treeFolder, const SizeLimits& limits, const CProgress& progress) {
    for (auto& lod : lods) lod = finishedModel(lod, options, treeFolder, limits, progress);
    return lods;
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
        if (m_options.instances != static_cast<int>(ExportedInstances::None))
            throw CError(translated(NC_("stromar", "leaves that move in the wind cannot be instances")));
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
    const auto hasCards = [](const Detail* detail) { return detail->twigPlanes > 0; };
    if (motion.frames > 0 && !motion.sways() && options.atlas != static_cast<int>(ExportedAtlas::None) && std::ranges::any_of(detailsOf(options), hasCards))
        throw CError(translated(NC_("stromar", "cards of a growing tree show another twig in every frame; choose no atlas, or level of detail 0 or 1")));
    for (const Detail* detail : detailsOf(options)) refuseTooLarge(params, *detail, limits, progress);
    CPoseMaker maker(params, options, motion, varied, limits, treeFolder);
    maker.prepare(age, progress);
    const std::vector<Moment> moments = maker.moments(age);
    std::atomic<std::size_t> done = 0;
    const auto write = [&](std::size_t i, const CProgress& own) {
        const Output to{motion.frames == 0 ? path : framePath(path, i, moments.size()), path, i == 0, motion.frames > 0};
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
    return share * fullVertices * bytesPerVertex(options, format);
}

} // namespace stromar
