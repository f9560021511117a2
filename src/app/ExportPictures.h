#pragma once
#include "stromar/app/ExportOptions.h"
#include "stromar/model/Material.h"
#include <filesystem>
#include <optional>

namespace stromar {

/// What an export makes of a picture.
enum class PictureUse { Albedo, CutOutAlbedo, Normal, Roughness, Opacity, UnityMask };

/// The picture as the options want it: itself where nothing is to change or it is no PNG, else one that is made of it and kept in the
/// user's cache. `source` is the albedo for Opacity, the roughness for UnityMask. Throws CError.
std::filesystem::path preparedPicture(const std::filesystem::path& source, PictureUse use, const ExportOptions& options);

/// The grey, 0..255, that a picture has everywhere; nothing where it has several or is no PNG. What is known of a file is kept until it changes. Any thread.
std::optional<int> uniformGrey(const std::filesystem::path& picture);

} // namespace stromar
