#pragma once
#include "stromar/util/FileSet.h"
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace stromar {

/// A picture of one surface as renderers take it. Rows from the top; all maps have the same size.
struct TextureMaps {
    int width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 4>> albedo; ///< sRGB and opacity
    std::vector<std::array<std::uint8_t, 3>> normal; ///< x to the right, y up, z out of the surface; 128 is 0
    std::vector<std::uint8_t> roughness;             ///< 0 a mirror, 255 chalk; linear
    std::vector<std::uint8_t> height01;              ///< 0 the deepest, 255 the highest; linear

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Writes `path` (albedo) and beside it `…_normal.png`, `…_roughness.png`, `…_height.png`. The caller commits.
void writePngs(const TextureMaps& maps, const std::filesystem::path& path, CFileSet& files);

} // namespace stromar
