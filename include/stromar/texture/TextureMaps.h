#pragma once
#include "stromar/util/FileSet.h"
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace stromar {

/// A picture of one surface as renderers take it. Rows from the top; all maps have the same size.
struct TextureMaps {
    int width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 4>> albedo; ///< sRGB and opacity
    std::vector<std::array<std::uint8_t, 3>> normal; ///< x to the right, y up, z out of the surface; 128 is 0
    std::vector<std::uint8_t> roughness;             ///< 0 a mirror, 255 chalk; linear
    std::vector<std::uint8_t> height01;              ///< 0 the deepest, 255 the highest; linear
    std::vector<std::uint8_t> translucency;          ///< light that goes through, 255 all; empty: none does
    std::vector<std::array<std::uint8_t, 4>> back;   ///< albedo of the under side; empty: there is none

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// One row of the table of maps that lie beside the albedo.
struct MapFile {
    const char* suffix; ///< of the file's name, before its ending
    int channels;
    const std::uint8_t* (*pixels)(const TextureMaps&); ///< null: this picture has no such map
    std::uint8_t* (*room)(TextureMaps&);               ///< makes the map as large as the others
};
std::span<const MapFile> mapFiles();
/// "oak.png" and "_normal" → "oak_normal.png"
std::filesystem::path mapBeside(const std::filesystem::path& albedo, std::string_view suffix);

/// Writes `path` (albedo) and beside it `…_normal.png`, `…_roughness.png`, `…_height.png` and, where light goes
/// through, `…_translucency.png` and `…_back.png`. The caller commits.
void writePngs(const TextureMaps& maps, const std::filesystem::path& path, CFileSet& files);
/// By its ending.
bool isPng(const std::filesystem::path& file);
/// What writePngs() wrote, or any PNG; maps of another size than the albedo are left out. Throws CError.
TextureMaps readPngs(const std::filesystem::path& path);
/// The picture alone, without maps beside it.
TextureMaps readPng(const std::filesystem::path& path);
/// One picture with its opacity.
void writePng(const std::vector<std::array<std::uint8_t, 4>>& pixels, int width, int height,
              const std::filesystem::path& path, CFileSet& files);
/// One picture without its opacity, as JPEG. Throws CError.
void writeJpeg(const std::vector<std::array<std::uint8_t, 4>>& pixels, int width, int height, const std::filesystem::path& path, CFileSet& files);

} // namespace stromar
