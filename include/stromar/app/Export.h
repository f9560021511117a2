#pragma once
#include "stromar/app/TreeCreator.h"
#include <filesystem>

namespace stromar {

/// The folder of the presets and textures that come with the program.
std::filesystem::path dataFolder();

/// The picture a surface shows: the tree's own (its path starts at `folder`, that of the .tree file) or the built-in
/// one.
std::filesystem::path textureOf(const CParams& params, Surface surface, const std::filesystem::path& folder);

/// Writes the model in the format of the path's ending, and copies of its pictures beside it. All files appear together
/// or none. Throws CError (unknown format, no such picture, disk full) and CCancelled.
void exportModel(const TreeModel& model, const std::filesystem::path& treeFolder, const std::filesystem::path& path,
                 const CProgress& progress);

} // namespace stromar
