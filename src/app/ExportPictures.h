#pragma once
#include "stromar/app/ExportOptions.h"
#include "stromar/model/Material.h"
#include <filesystem>

namespace stromar {

/// What an export makes of a picture.
enum class PictureUse { Albedo, CutOutAlbedo, Normal, Roughness, Opacity, UnityMask };

/// The picture as the options want it: itself where nothing is to change or it is no PNG, else one that is made of it and kept in the
/// user's cache. `source` is the albedo for Opacity, the roughness for UnityMask. Throws CError.
std::filesystem::path preparedPicture(const std::filesystem::path& source, PictureUse use, const ExportOptions& options);

} // namespace stromar
