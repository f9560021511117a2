#pragma once
#include "Arrangement.h"
#include "Atlas.h"
#include "stromar/app/ExportOptions.h"
#include "stromar/app/Prediction.h"
#include "stromar/model/ExportModel.h"
#include "stromar/model/TreeModel.h"
#include <filesystem>
#include <optional>

// What exports of one tree and of several have in common.

namespace stromar {

class CFileSet;

/// The model's name with only letters that every format and reader takes inside a line, a name or a path.
std::string plainName(const std::filesystem::path& path);
/// oak.glb → oak_LOD1.glb
std::filesystem::path withSuffix(const std::filesystem::path& path, const std::string& suffix);
/// Throws CError where there is no such format, it cannot do what is wanted, or there is no such folder.
void refuseUnless(const ExportOptions& options, const Format* format, const std::filesystem::path& path);

/// A model as files show it: the wood in one piece, perhaps with the relief of its bark.
std::shared_ptr<const TreeModel> finishedModel(const std::shared_ptr<const TreeModel>& model, const ExportOptions& options,
                                               const std::filesystem::path& treeFolder, const SizeLimits& limits, const CProgress& progress);
/// What of a finished model goes into the file.
Meshes meshesFor(const TreeModel& model, const ExportOptions& options, const CProgress& progress);

Arrangement arrangementFor(const ExportOptions& options, const Format& format);
Meshes arranged(const Meshes& meshes, const Arrangement& to);
/// The backs of leaves, with what their vertices carry. `metre` in the unit of the model.
void addBacks(ExportModel& model, float metre);

/// Calls what there is to do with the meshes of each level of detail, the channels of their vertices (null: there are none) and where they stand
/// (null: each once).
template <class Do> void forEachLevel(ExportModel& model, const Do& act) {
    act(model.meshes, model.channels.empty() ? nullptr : &model.channels, model.instances.empty() ? nullptr : &model.instances);
    for (std::size_t lod = 0; lod < model.coarser.size(); ++lod) {
        const bool carries = lod < model.coarserChannels.size() && !model.coarserChannels[lod].empty();
        act(model.coarser[lod], carries ? &model.coarserChannels[lod] : nullptr, nullptr);
    }
}

/// Organs as instances of their blade instead of vertices of their own, with what these carry. The model has the meshes of `tree` in the
/// order of TreeModel::visitMeshes(), moved by `shift` along x before they were arranged.
void addInstances(ExportModel& model, const TreeModel& tree, const Arrangement& arrangement, float shift = 0);

/// Where a model goes.
struct Output {
    std::filesystem::path path;
    std::filesystem::path named; ///< that its pictures are named after: shared by the frames of a motion
    bool copiesPictures = true;  ///< else they are there
    bool isFrame = false;        ///< of a motion: another may show what this one does not
};
/// Whether some of the meshes show the surface.
bool needsMaterial(const TreeModel& model, const std::vector<Meshes>& lods, Surface surface);
/// Those that some of the meshes show, or those of another frame may.
std::vector<Surface> shownSurfaces(const TreeModel& model, const std::vector<Meshes>& lods, bool isFrame);
/// How a surface looks that shows a picture (empty: none); its pictures are put where the options want them, named after it.
Material materialOf(const SurfacePicture& shown, const std::string& name, const ExportOptions& options, const Format& format, const Output& to,
                    CFileSet& files);
/// A material that says no more than which surface it is of.
Material plainMaterial(Surface surface);
/// The picture that leaves, blossoms and twigs share, where that is wanted and there are several.
std::optional<CAtlas> atlasFor(const TreeModel& model, const std::vector<Surface>& shown, const ExportOptions& options,
                               const std::filesystem::path& treeFolder, const CProgress& progress);

} // namespace stromar
