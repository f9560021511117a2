#include "stromar/app/Export.h"
#include "CollisionExport.h"
#include "ExportParts.h"
#include "Merge.h"
#include "VertexColours.h"
#include "impostor/ImpostorExport.h"
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

/// Writes a pose: all files together, or none.
class CPoseWriter {
public:
    CPoseWriter(const Pose& pose, const ExportOptions& options, const fs::path& treeFolder, const Output& to, const CProgress& progress, const Motion& motion)
        : m_pose(pose), m_options(options), m_treeFolder(treeFolder), m_to(to), m_progress(progress), m_motion(motion), m_format(*formatOf(to.path)),
          m_arrangement(arrangementFor(options, m_format)), m_files(progress, static_cast<std::uint64_t>(bytesPerVertex(options, m_format) * double(pose.vertexCount()))) {}

    void write() {
        if (coarsest().age > 0 && std::ranges::any_of(m_pose.meshes, &Meshes::empty))
            throw CError(translated(NC_("stromar", "the tree is empty, there is nothing to export")));
        makePictures(coarsest(), m_treeFolder, m_progress);
        findMaterials();
        m_impostor = impostorOf(*m_pose.lods.front(), m_pose.meshes.front(), m_options, m_format, m_treeFolder, m_to, m_files, m_progress);
        if (m_options.lods == static_cast<int>(ExportedLods::FileEach))
            writeFileEach();
        else
            writeInOne();
        if (!m_pose.sways.empty())
            addWindPictures(*m_pose.sways.front(), m_options, m_arrangement, m_to.path.parent_path() / plainName(m_to.path), m_files);
        m_files.commit();
    }

private:
    /// Only coarse ones have pictures of twigs, all the same.
    const TreeModel& coarsest() const { return *m_pose.lods.back(); }

    void findMaterials() {
        const std::vector<Surface> shown = shownSurfaces(coarsest(), m_pose.meshes, m_to.isFrame);
        m_atlas = atlasFor(coarsest(), shown, m_options, m_treeFolder, m_progress);
        for (const Surface surface : shown)
            m_materials.push_back(m_atlas && surfaceOf(surface).cutOut
                                      ? plainMaterial(surface)
                                      : materialOf({surface, textureOf(coarsest(), surface, m_treeFolder)}, surfaceOf(surface).name, m_options, m_format, m_to, m_files));
        if (m_atlas) m_foliage = materialOf({Surface::Leaf, m_atlas->file()}, CAtlas::kName, m_options, m_format, m_to, m_files);
    }

    void writeFileEach() {
        for (std::size_t i = 0; i < m_pose.lods.size(); ++i) write(modelOf(nameOfLevel(i), i, 1), i);
        if (m_impostor) write({nameOfLevel(m_pose.lods.size()), {m_impostor->mesh}, {}, {m_impostor->look}}, m_pose.lods.size());
    }
    static std::string suffixOf(std::size_t lod) { return "_LOD" + std::to_string(lod); }
    std::string nameOfLevel(std::size_t lod) const { return plainName(m_to.path) + suffixOf(lod); }
    void write(ExportModel model, std::size_t lod) {
        if (lod == 0) addCollisionTo(model);
        m_format.write(model, withSuffix(m_to.path, suffixOf(lod)), m_files);
    }

    void writeInOne() {
        ExportModel model = modelOf(plainName(m_to.path), 0, m_pose.lods.size());
        if (m_impostor) {
            model.coarser.push_back({m_impostor->mesh});
            model.coarserChannels.resize(model.coarser.size());
            model.coarserChannels.back().resize(1);
            model.materials.push_back(m_impostor->look);
        }
        addCollisionTo(model);
        m_format.write(model, m_to.path, m_files);
    }

    void addCollisionTo(ExportModel& model) { addCollision(model, *m_pose.lods.front()->tree, m_options, m_format, m_arrangement, m_to.path, m_files); }

    /// So many levels of detail.
    ExportModel modelOf(const std::string& name, std::size_t first, std::size_t count) const {
        ExportModel model{name, arranged(m_pose.meshes[first], m_arrangement), {}, {}};
        const std::vector<Meshes> own(m_pose.meshes.begin() + std::ptrdiff_t(first), m_pose.meshes.begin() + std::ptrdiff_t(first + count));
        std::ranges::copy_if(m_materials, std::back_inserter(model.materials),
                             [&](const Material& material) { return needsMaterial(coarsest(), own, material.surface); });
        for (std::size_t i = first + 1; i < first + count; ++i) model.coarser.push_back(arranged(m_pose.meshes[i], m_arrangement));
        const std::span lods(m_pose.lods);
        if (!m_pose.sways.empty()) addWind(model, std::span(m_pose.sways).subspan(first, count), m_options, m_motion, m_arrangement);
        if (m_format.channels != Channels::None) addColours(model, isSolid(m_options) ? lods.first(0) : lods.subspan(first, count), m_options);
        if (isTwoSided(m_options, m_format)) addBacks(model, m_arrangement.scale);
        if (m_options.instances != static_cast<int>(ExportedInstances::None) && !isSolid(m_options)) addInstances(model, *m_pose.lods[first], m_arrangement);
        if (m_atlas) m_atlas->replaceIn(model, *m_foliage);
        if (m_options.objects == static_cast<int>(ExportedObjects::Materials)) mergeByMaterial(model);
        model.compression = static_cast<ExportedCompression>(m_options.compression);
        model.leafLight = m_options.leafLight == static_cast<int>(ExportedLeafLight::Transmission);
        return model;
    }

    const Pose& m_pose;
    const ExportOptions& m_options;
    const fs::path& m_treeFolder;
    const Output& m_to;
    const CProgress& m_progress;
    const Motion& m_motion;
    const Format& m_format;
    Arrangement m_arrangement;
    CFileSet m_files;
    std::vector<Material> m_materials;
    std::optional<CAtlas> m_atlas;
    std::optional<Material> m_foliage;
    std::optional<ImpostorLevel> m_impostor;
};

void writePose(const Pose& pose, const ExportOptions& options, const fs::path& treeFolder, const Output& to,
               const CProgress& progress, const Motion& motion = {}) {
    CPoseWriter(pose, options, treeFolder, to, progress, motion).write();
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
    if (motion.frames > 0 && options.impostor != static_cast<int>(ExportedImpostor::None))
        throw CError(translated(NC_("stromar", "frames of a motion have no impostor; choose one tree or none")));
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
