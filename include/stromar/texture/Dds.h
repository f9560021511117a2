#pragma once
#include "stromar/texture/Opacity.h"
#include "stromar/util/FileSet.h"
#include <filesystem>

namespace stromar {

/// A DirectDraw Surface of plain pixels (B8G8R8A8, rows from the top) with the mip-maps as they are: what most engines take where their own
/// would thin a picture out. `levels`: the whole picture, then halves of it. Throws CError.
void writeDds(const std::vector<Pixels>& levels, int width, int height, const std::filesystem::path& path, CFileSet& files);

} // namespace stromar
