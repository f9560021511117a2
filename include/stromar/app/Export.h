#pragma once
#include "stromar/app/ExportOptions.h"
#include "stromar/app/Motion.h"
#include "stromar/app/Pictures.h"
#include "stromar/app/TreeCreator.h"
#include <filesystem>
#include <functional>

namespace stromar {

/// Writes one model, or its levels of detail, the finest first, in the format of the path's ending, and copies of its
/// pictures as the options say. All files appear together or none. `motion` is the wind of clips. Throws CError (unknown format, what
/// the format cannot do, no such picture, disk full) and CCancelled.
void exportModels(const std::vector<std::shared_ptr<const TreeModel>>& lods, const ExportOptions& options,
                  const std::filesystem::path& treeFolder, const std::filesystem::path& path,
                  const CProgress& progress, const Motion& motion = {});
/// Grows the tree at the levels of detail that the options ask for, and writes them: the one door of all front ends.
/// `ready` may be one of the models, already made. Gives what was written.
std::vector<std::shared_ptr<const TreeModel>> exportTree(CTreeCreator& creator, const CParams& params,
                                                         const ExportOptions& options,
                                                         const std::filesystem::path& treeFolder,
                                                         const std::filesystem::path& path, const CProgress& progress,
                                                         const std::shared_ptr<const TreeModel>& ready = nullptr,
                                                         const Motion& motion = {});
/// The same for every moment of a motion, a file or set of files each, numbered: oak_0001.glb … They are made side by side, as many as
/// threads and memory allow, and appear one by one; `written` is told of each, on any thread. Pictures that lie beside the models are
/// shared by all. `limits` are those of one tree. Throws as exportTree(); what has appeared stays.
void exportFrames(const CParams& params, const ExportOptions& options, const Motion& motion, double age, bool varied,
                  const SizeLimits& limits, const std::filesystem::path& treeFolder, const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path&)>& written, const CProgress& progress);
/// The same as one file (or one for each level of detail), with a sample of every mesh at each moment, in formats that hold them. All moments
/// are held in memory; `limits` are those of all.
void exportTimeSamples(const CParams& params, const ExportOptions& options, const Motion& motion, double age, bool varied, const SizeLimits& limits,
                       const std::filesystem::path& treeFolder, const std::filesystem::path& path, const CProgress& progress);
/// The same as exportModels() for one model with the usual options.
void exportModel(const TreeModel& model, const std::filesystem::path& treeFolder, const std::filesystem::path& path,
                 const CProgress& progress);

/// About how many bytes the export takes without its pictures, when the full model has so many vertices.
double estimatedBytes(double fullVertices, const ExportOptions& options, const Format& format);

} // namespace stromar
