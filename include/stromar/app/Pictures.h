#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/params/Params.h"
#include "stromar/util/Progress.h"
#include <filesystem>
#include <string_view>

namespace stromar {

/// The folder of the presets, textures and manual that come with the program.
std::filesystem::path dataFolder();

/// Whether a texture of a tree is not a file but a recipe: "bark:furrowed ridges=9".
bool isRecipe(std::string_view texture);

/// The picture a surface shows: the tree's own (its path starts at `folder`, that of the .tree file), that of its recipe,
/// which makePictures() draws, or the built-in one.
std::filesystem::path textureOf(const CParams& params, Surface surface, const std::filesystem::path& folder);

/// Draws the pictures of a tree's recipes that are not there yet; they are kept in the user's cache. A second or two
/// each. Any thread. Throws CError, which says what is wrong with a recipe, and CCancelled.
void makePictures(const CParams& params, const CProgress& progress);

} // namespace stromar
