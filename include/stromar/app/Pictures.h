#pragma once
#include "stromar/app/TreeCreator.h"
#include "stromar/model/ExportModel.h"
#include "stromar/params/Params.h"
#include "stromar/util/Progress.h"
#include <filesystem>
#include <string>

namespace stromar {

/// The folder of the presets, textures and manual that come with the program.
std::filesystem::path dataFolder();

/// The user's folder of pictures that were drawn, which can be drawn again: textures, twigs, thumbnails.
std::filesystem::path pictureCache();
/// The folder in it of what recipes draw, named by recipe and size.
std::filesystem::path recipePictures();
/// What they take, bytes.
std::uintmax_t pictureCacheSize();
/// Whether a picture of the cache is there; then it counts as used now.
bool isKept(const std::filesystem::path& picture);
/// Removes what has not been used for the longest time until no more than so many bytes are left; a picture goes with its maps. What was
/// used in the last ten minutes stays, since another process may be about to read it, unless 0 bytes shall be left. What cannot be removed stays.
void trimPictureCache(std::uintmax_t bytes);

/// What a surface that the user can choose shows: the tree's own picture or recipe, with the month where it changes a
/// recipe, else the standard.
std::string pictureOf(const CParams& params, Surface surface);

/// A preview is small and quickly drawn, for a slider that is being dragged.
enum class PictureQuality { Full, Preview };

/// Whether pictures of twigs can be made of the leaf's: a recipe or a PNG.
bool isBakeable(const CParams& params);

/// The file of that picture: the tree's own (its path starts at `folder`, that of the .tree file), that of a recipe,
/// which makePictures() draws, or the built-in one.
std::filesystem::path textureOf(const CParams& params, Surface surface, const std::filesystem::path& folder,
                                PictureQuality quality = PictureQuality::Full);

/// The same for all surfaces; empty for blossoms and fruits that the tree has not, and for twigs, which are a model's.
using SurfaceTextures = std::array<std::filesystem::path, kSurfaces.size()>;
SurfaceTextures texturesOf(const CParams& params, const std::filesystem::path& folder);

/// Draws the pictures of a tree's recipes that are not there yet; they are kept in the user's cache. A second or two
/// each; previews some hundredths. Any thread. Throws CError, which says what is wrong with a
/// recipe, and CCancelled.
void makePictures(const CParams& params, const CProgress& progress, PictureQuality quality = PictureQuality::Full);

/// Where the picture of a surface is not cut out; one that cannot be read covers all. Recipes are drawn as previews. What is known of a file is
/// kept until it changes. Any thread. Throws CCancelled.
CCutOut maskOf(const CParams& params, Surface surface, const CProgress& progress);
/// Of leaves, by kind.
LeafMasks leafMasksOf(const CParams& params, const CProgress& progress);

/// The same with what a model shows, and the picture of its twigs, if it has some: by how their crown looks, which is measured when it is first
/// asked for (Twig::looks). Throws CCancelled.
std::filesystem::path textureOf(const TreeModel& model, Surface surface, const std::filesystem::path& folder, const CProgress& progress = CProgress());
void makePictures(const TreeModel& model, const std::filesystem::path& folder, const CProgress& progress);

} // namespace stromar
