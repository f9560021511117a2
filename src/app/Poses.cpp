#include "Poses.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace fs = std::filesystem;

std::size_t Pose::vertexCount() const {
    std::size_t count = 0;
    for (const auto& lod : lods) count += lod->vertexCount();
    return count;
}

std::vector<std::shared_ptr<const TreeModel>> makeLods(CTreeCreator& creator, const CParams& params, const ExportOptions& options,
                                                       const CProgress& progress, const std::shared_ptr<const TreeModel>& ready) {
    std::vector<std::shared_ptr<const TreeModel>> lods;
    for (const Detail* detail : detailsOf(options))
        lods.push_back(ready && ready->detail == detail ? ready : creator.create(params, *detail, progress, CTreeCreator::Plans::Keep));
    return lods;
}

std::vector<std::shared_ptr<const TreeModel>> finishedLods(std::vector<std::shared_ptr<const TreeModel>> lods, const ExportOptions& options,
                                                           const fs::path& treeFolder, const SizeLimits& limits, const CProgress& progress) {
    for (auto& lod : lods) lod = finishedModel(lod, options, treeFolder, limits, progress);
    return lods;
}

void refuseMotion(const ExportOptions& options, const Motion& motion) {
    if (isSolid(options) && motion.sways()) throw CError(translated(NC_("stromar", "one solid does not move in the wind")));
    const auto hasCards = [](const Detail* detail) { return detail->twigPlanes > 0; };
    if (motion.frames > 0 && !motion.sways() && options.atlas != static_cast<int>(ExportedAtlas::None) && std::ranges::any_of(detailsOf(options), hasCards))
        throw CError(translated(NC_("stromar", "cards of a growing tree show another twig in every frame; choose no atlas, or level of detail 0 or 1")));
    if (motion.frames > 0 && options.impostor != static_cast<int>(ExportedImpostor::None))
        throw CError(translated(NC_("stromar", "frames of a motion have no impostor; choose one tree or none")));
}

void CPoseMaker::prepare(double age, const CProgress& progress) {
    if (!m_motion.sways()) return;
    if (m_options.instances != static_cast<int>(ExportedInstances::None))
        throw CError(translated(NC_("stromar", "leaves that move in the wind cannot be instances")));
    CTreeCreator creator(m_varied, SizeLimits::none());
    creator.setAge(age);
    m_lods = finishedLods(makeLods(creator, m_params, m_options, progress), m_options, m_folder, m_limits, progress);
    for (const auto& lod : m_lods) m_moving.emplace_back(lod, m_motion, progress);
}

std::vector<Moment> CPoseMaker::moments(double age) const { return m_motion.moments(age, m_moving.empty() ? 0 : m_moving.front().fallSeconds()); }

Pose CPoseMaker::poseAt(const Moment& moment, const CProgress& progress) {
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

int CPoseMaker::workersFor(std::size_t moments, const CProgress& progress) const {
    if (m_options.displacement > 0) return 1; // which may take all that is allowed
    double bytes = 1;
    for (const Detail* detail : detailsOf(m_options)) bytes += predictSize(m_params, *detail, progress).bytes;
    const double most = std::min(double(progress.threads()), double(moments));
    return static_cast<int>(std::clamp(std::floor(m_limits.bytes / bytes), 1.0, most));
}

std::unique_ptr<CTreeCreator> CPoseMaker::takeCreator() {
    const std::lock_guard lock(m_mutex);
    if (m_creators.empty()) return std::make_unique<CTreeCreator>(m_varied, SizeLimits::none());
    auto creator = std::move(m_creators.back());
    m_creators.pop_back();
    return creator;
}

void CPoseMaker::giveBack(std::unique_ptr<CTreeCreator> creator) {
    const std::lock_guard lock(m_mutex);
    m_creators.push_back(std::move(creator));
}

} // namespace stromar
