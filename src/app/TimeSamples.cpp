#include "ModelMaker.h"
#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "stromar/app/Pictures.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <atomic>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr double kSampleBytes = 60; // of a vertex, with its share of the triangles

/// One model of what a tree is at each moment. Meshes of the same name are the same.
class CSampledModel {
public:
    CSampledModel(const std::string& name, std::size_t moments, double perSecond) : m_moments(moments) {
        m_all.name = name;
        m_all.samplesPerSecond = perSecond;
    }

    void add(std::size_t moment, const ExportModel& model) {
        for (const auto& mesh : model.meshes) {
            const std::size_t place = placeOf(*mesh, model.materialOf(*mesh));
            m_all.meshes[place] = m_all.samples[place][moment] = mesh;
        }
    }
    const ExportModel& all() const { return m_all; }

private:
    std::size_t placeOf(const CMesh& mesh, const Material& material) {
        const auto found = std::ranges::find(m_all.meshes, mesh.name, [](const auto& one) { return one->name; });
        const auto place = static_cast<std::size_t>(found - m_all.meshes.begin());
        if (found == m_all.meshes.end()) {
            m_all.meshes.emplace_back();
            m_all.samples.emplace_back(m_moments);
            m_all.meshMaterials.push_back(placeOf(material));
        }
        return place;
    }
    std::size_t placeOf(const Material& material) {
        const auto found = std::ranges::find(m_all.materials, material.name, &Material::name);
        const auto place = static_cast<std::size_t>(found - m_all.materials.begin());
        if (found == m_all.materials.end()) m_all.materials.push_back(material);
        return place;
    }

    std::size_t m_moments;
    ExportModel m_all{};
};

void refuseSamples(const CParams& params, const ExportOptions& options, const Motion& motion, const Format& format, const SizeLimits& limits,
                   const CProgress& progress) {
    if (!format.timeSamples) throw CError(translated(NC_("stromar", "%1 holds no time samples; choose USD"), format.ending));
    if (options.lods == static_cast<int>(ExportedLods::InOneFile))
        throw CError(translated(NC_("stromar", "time samples belong to one level of detail; choose a file for each")));
    const std::vector<const Detail*> details = detailsOf(options);
    if (!motion.sways() && std::ranges::any_of(details, [](const Detail* detail) { return detail->twigPlanes > 0; }))
        throw CError(translated(NC_("stromar", "cards of a growing tree show another twig in every frame; choose level of detail 0 or 1")));
    double held = 0;
    for (const Detail* detail : details) {
        Prediction size = predictSize(params, *detail, progress);
        size.bytes += held += kSampleBytes * motion.frames * size.vertices;
        if (!limits.allow(size)) throw CTooLarge(size, limits);
    }
}

std::vector<Pose> posesOf(CPoseMaker& maker, const std::vector<Moment>& moments, const CProgress& progress) {
    std::vector<Pose> poses(moments.size());
    std::atomic<std::size_t> done = 0;
    const int workers = maker.workersFor(moments.size(), progress);
    const CProgress own = progress.piece(std::max(1, progress.threads() / workers));
    const auto make = [&](std::size_t i, std::size_t) {
        poses[i] = maker.poseAt(moments[i], own);
        progress.report(double(++done) / double(moments.size()));
    };
    parallelFor(moments.size(), 1, make, progress.piece(workers));
    return poses;
}

std::vector<Surface> shownSurfaces(const std::vector<Pose>& poses) {
    std::vector<Meshes> all;
    for (const Pose& pose : poses) all.insert(all.end(), pose.meshes.begin(), pose.meshes.end());
    return shownSurfaces(poses.back().coarsest(), all, false);
}

double perSecond(const std::vector<Moment>& moments, double fps) { return moments.size() > 1 ? 1 / (moments[1].seconds - moments[0].seconds) : fps; }

void writeSamples(const std::vector<Pose>& poses, double perSecond, const ExportOptions& options, const Format& format, const Motion& motion,
                  const fs::path& treeFolder, const fs::path& path, const CProgress& progress) {
    CFileSet files(progress);
    const TreeModel& coarsest = poses.back().coarsest();
    makePictures(coarsest, treeFolder, progress);
    CModelMaker maker(options, format, motion, progress);
    maker.findMaterials(coarsest, shownSurfaces(poses), treeFolder, {path, path}, files);
    const bool eachLevel = options.lods == static_cast<int>(ExportedLods::FileEach);
    for (std::size_t lod = 0; lod < poses.back().lods.size(); ++lod) {
        const std::string suffix = eachLevel ? suffixOfLevel(lod) : std::string(), name = plainName(path) + suffix;
        CSampledModel model(name, poses.size(), perSecond);
        for (std::size_t i = 0; i < poses.size(); ++i) model.add(i, maker.modelOf(poses[i], name, lod, 1));
        format.write(model.all(), withSuffix(path, suffix), files);
    }
    files.commit();
}
} // namespace

void exportTimeSamples(const CParams& params, const ExportOptions& options, const Motion& motion, double age, bool varied, const SizeLimits& limits,
                       const fs::path& treeFolder, const fs::path& path, const CProgress& progress) {
    const Format* format = formatOf(path);
    refuseUnless(options, format, path);
    refuseMotion(options, motion);
    refuseSamples(params, options, motion, *format, limits, progress);
    CPoseMaker maker(params, options, motion, varied, limits, treeFolder);
    maker.prepare(age, progress);
    const std::vector<Moment> moments = maker.moments(age);
    writeSamples(posesOf(maker, moments, progress), perSecond(moments, motion.fps), options, *format, motion, treeFolder, path, progress);
}

} // namespace stromar
