#include "stromar/texture/Dds.h"
#include <array>
#include <string>

namespace stromar {

namespace {
// Words of a header of 124 bytes after the magic one: Microsoft's "DDS_HEADER".
constexpr std::uint32_t kHeaderBytes = 124, kFormatBytes = 32;
constexpr std::uint32_t kHasCaps = 0x1, kHasHeight = 0x2, kHasWidth = 0x4, kHasPitch = 0x8, kHasFormat = 0x1000, kHasMipmaps = 0x20000;
constexpr std::uint32_t kHasAlpha = 0x1, kIsRgb = 0x40;
constexpr std::uint32_t kIsComplex = 0x8, kIsTexture = 0x1000, kIsMipmap = 0x400000;

void append(std::string& bytes, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
}

std::string header(std::uint32_t width, std::uint32_t height, std::uint32_t levels) {
    constexpr std::array<std::uint32_t, 11> kReserved{};
    std::string bytes = "DDS ";
    for (const std::uint32_t word : {kHeaderBytes, kHasCaps | kHasHeight | kHasWidth | kHasPitch | kHasFormat | kHasMipmaps, height, width, 4 * width, 0u, levels}) append(bytes, word);
    for (const std::uint32_t word : kReserved) append(bytes, word);
    for (const std::uint32_t word : {kFormatBytes, kIsRgb | kHasAlpha, 0u, 32u, 0x00ff0000u, 0x0000ff00u, 0x000000ffu, 0xff000000u}) append(bytes, word);
    for (const std::uint32_t word : {kIsComplex | kIsTexture | kIsMipmap, 0u, 0u, 0u, 0u}) append(bytes, word);
    return bytes;
}
} // namespace

void writeDds(const std::vector<Pixels>& levels, int width, int height, const std::filesystem::path& path, CFileSet& files) {
    std::ostream& out = files.create(path);
    out << header(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), static_cast<std::uint32_t>(levels.size()));
    for (const Pixels& level : levels) {
        std::string bytes;
        bytes.reserve(4 * level.size());
        for (const auto& p : level)
            for (const std::uint8_t channel : {p[2], p[1], p[0], p[3]}) bytes += static_cast<char>(channel);
        out << bytes;
    }
}

} // namespace stromar
