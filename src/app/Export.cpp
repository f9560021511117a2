#include "stromar/app/Export.h"
#include "CollisionExport.h"
#include "ModelMaker.h"
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

/// Writes a pose: all files together, or none.
class CPoseWriter {
public:
    CPoseWriter(const Pose& pose, const ExportOptions& options, const fs::path& treeFolder, const Output& to, const CProgress& progress, const Motion& motion)
        : m_pose(pose), m_options(options), m_treeFolder(treeFolder), m_to(to), m_progress(progress), m_format(*formatOf(to.path)),
          m_maker(options, m_format, motion, progress), m_files(progress, static_cast<std::uint64_t>(bytesPerVertex(options, m_format) * double(pose.vertexCount()))) {}

    void write() {
        if (coarsest().age > 0 && std::ranges::any_of(m_pose.meshes, &Meshes::empty))
            throw CError(translated(NC_("stromar", "the tree is empty, there is nothing to export")));
        makePictures(coarsest(), m_treeFolder, m_progress);
        m_maker.findMaterials(coarsest(), shownSurfaces(coarsest(), m_pose.meshes, m_to.isFrame), m_treeFolder, m_to, m_files);
        m_impostor = impostorOf(*m_pose.lods.front(), m_pose.meshes.front(), m_options, m_format, m_treeFolder, m_to, m_files, m_progress);
        if (m_options.lods == static_cast<int>(ExportedLods::FileEach))
            writeFileEach();
        else
            writeInOne();
        if (!m_pose.sways.empty())
            addWindPictures(*m_pose.sways.front(), m_options, m_maker.arrangement(), m_to.path.parent_path() / plainName(m_to.path), m_files);
        m_files.commit();
    }

private:
    const TreeModel& coarsest() const { return m_pose.coarsest(); }

    void writeFileEach() {
        for (std::size_t i = 0; i < m_pose.lods.size(); ++i) write(m_maker.modelOf(m_pose, nameOfLevel(i), i, 1), i);
        if (m_impostor) write({nameOfLevel(m_pose.lods.size()), {m_impostor->mesh}, {}, {m_impostor->look}}, m_pose.lods.size());
    }
    std::string nameOfLevel(std::size_t lod) const { return plainName(m_to.path) + suffixOfLevel(lod); }
    void write(ExportModel model, std::size_t lod) {
        if (lod == 0) addCollisionTo(model);
        m_format.write(model, withSuffix(m_to.path, suffixOfLevel(lod)), m_files);
    }

    void writeInOne() {
        ExportModel model = m_maker.modelOf(m_pose, plainName(m_to.path), 0, m_pose.lods.size());
        if (m_impostor) {
            model.coarser.push_back({m_impostor->mesh});
            model.coarserChannels.resize(model.coarser.size());
            model.coarserChannels.back().resize(1);
            model.materials.push_back(m_impostor->look);
        }
        addCollisionTo(model);
        m_format.write(model, m_to.path, m_files);
    }

    void addCollisionTo(ExportModel& model) { addCollision(model, *m_pose.lods.front()->tree, m_options, m_format, m_maker.arrangement(), m_to.path, m_files); }

    const Pose& m_pose;
    const ExportOptions& m_options;
    const fs::path& m_treeFolder;
    const Output& m_to;
    const CProgress& m_progress;
    const Format& m_format;
    CModelMaker m_maker;
    CFileSet m_files;
    std::optional<ImpostorLevel> m_impostor;
};

void writePose(const Pose& pose, const ExportOptions& options, const fs::path& treeFolder, const Output& to,
               const CProgress& progress, const Motion& motion = {}) {
    CPoseWriter(pose, options, treeFolder, to, progress, motion).write();
}

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
    refuseMotion(options, motion);
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
    const int workers = maker.workersFor(moments.size(), progress);
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
