#pragma once
#include "ExportParts.h"
#include "stromar/app/ExportOptions.h"
#include "stromar/app/Motion.h"
#include "stromar/app/TreeCreator.h"
#include <mutex>

namespace stromar {

/// Levels of detail of a tree at one moment.
struct Pose {
    std::vector<std::shared_ptr<const TreeModel>> lods;
    std::vector<Meshes> meshes;                          ///< of each
    std::vector<std::shared_ptr<const ModelSway>> sways; ///< of each, where they go into the file

    std::size_t vertexCount() const;
    /// Only coarse ones have pictures of twigs, all the same.
    const TreeModel& coarsest() const { return *lods.back(); }
};

/// The levels of detail that the options ask for; `ready` may be one of them.
std::vector<std::shared_ptr<const TreeModel>> makeLods(CTreeCreator& creator, const CParams& params, const ExportOptions& options,
                                                       const CProgress& progress, const std::shared_ptr<const TreeModel>& ready = nullptr);
/// As files show them.
std::vector<std::shared_ptr<const TreeModel>> finishedLods(std::vector<std::shared_ptr<const TreeModel>> lods, const ExportOptions& options,
                                                           const std::filesystem::path& treeFolder, const SizeLimits& limits, const CProgress& progress);

/// Throws CError where what is exported cannot move so.
void refuseMotion(const ExportOptions& options, const Motion& motion);

/// Makes the poses of a motion, some at a time, of a tree that the limits allow.
class CPoseMaker {
public:
    CPoseMaker(const CParams& params, const ExportOptions& options, const Motion& motion, bool varied, const SizeLimits& limits,
               const std::filesystem::path& treeFolder)
        : m_params(params), m_options(options), m_motion(motion), m_varied(varied), m_limits(limits), m_folder(treeFolder) {}

    /// For wind: what all moments share.
    void prepare(double age, const CProgress& progress);
    std::vector<Moment> moments(double age) const;
    /// Any thread.
    Pose poseAt(const Moment& moment, const CProgress& progress);
    /// How many of so many fit into memory side by side.
    int workersFor(std::size_t moments, const CProgress& progress) const;

private:
    std::unique_ptr<CTreeCreator> takeCreator();
    void giveBack(std::unique_ptr<CTreeCreator> creator);

    const CParams& m_params;
    const ExportOptions& m_options;
    const Motion& m_motion;
    bool m_varied;
    SizeLimits m_limits;
    const std::filesystem::path& m_folder;
    std::vector<std::shared_ptr<const TreeModel>> m_lods;
    std::vector<CMovingModel> m_moving; ///< of the lods
    std::mutex m_mutex;
    std::vector<std::unique_ptr<CTreeCreator>> m_creators; ///< that nobody uses now
};

} // namespace stromar
