#pragma once
#include "stromar/mesh/Model.h"
#include "stromar/params/Params.h"
#include "stromar/util/Progress.h"
#include <filesystem>
#include <string>

namespace stromar {

/// The folder of the presets, textures and manual that come with the program.
std::filesystem::path dataFolder();

/// What a surface shows: the tree's own picture or recipe, with the month where it changes a recipe, else the standard.
std::string pictureOf(const CParams& params, Surface surface);

/// A preview of a leaf is small and quickly drawn, for a slider that is being dragged.
enum class Drawn { Whole, Preview };

/// The file of that picture: the tree's own (its path starts at `folder`, that of the .tree file), that of a recipe,
/// which makePictures() draws, or the built-in one.
std::filesystem::path textureOf(const CParams& params, Surface surface, const std::filesystem::path& folder,
                                Drawn drawn = Drawn::Whole);

/// The same for all surfaces; empty for blossoms and fruits that the tree has not.
using SurfaceTextures = std::array<std::filesystem::path, kSurfaces.size()>;
SurfaceTextures texturesOf(const CParams& params, const std::filesystem::path& folder);

/// Draws the pictures of a tree's recipes that are not there yet; they are kept in the user's cache. A second or two
/// each; previews, which only leaves have, some hundredths. Any thread. Throws CError, which says what is wrong with a
/// recipe, and CCancelled.
void makePictures(const CParams& params, const CProgress& progress, Drawn drawn = Drawn::Whole);

} // namespace stromar
