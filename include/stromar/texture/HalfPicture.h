#pragma once
#include "stromar/util/FileSet.h"
#include <array>

namespace stromar {

/// A picture of 16-bit floats (OpenEXR): red, green, blue, alpha; rows from the top. Values beyond ±65,504 become
/// infinite. The caller commits. Throws CError.
void writeExr(const std::vector<std::array<float, 4>>& pixels, int width, int height, const std::filesystem::path& path,
              CFileSet& files);

} // namespace stromar
