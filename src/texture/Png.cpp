#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Error.h"
#include <csetjmp>
#include <png.h>

namespace stromar {

namespace {
void writeTo(png_structp png, png_bytep data, png_size_t size) {
    static_cast<std::ostream*>(png_get_io_ptr(png))
        ->write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}
void flushTo(png_structp) {}
[[noreturn]] void onError(png_structp, png_const_charp why) {
    throw CError(std::string("cannot write a PNG picture: ") + why);
}
void onWarning(png_structp, png_const_charp) {}

/// Eight bits for each of 1 (grey), 3 or 4 channels.
void writePng(std::ostream& out, int width, int height, int channels, const std::uint8_t* pixels) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (!info) throw CError("cannot write a PNG picture: no memory");
    try {
        const int type = channels == 1 ? PNG_COLOR_TYPE_GRAY : channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA;
        png_set_write_fn(png, &out, writeTo, flushTo);
        png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8, type,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png, info);
        for (int y = 0; y < height; ++y) png_write_row(png, pixels + static_cast<std::ptrdiff_t>(y) * width * channels);
        png_write_end(png, nullptr);
    } catch (...) {
        png_destroy_write_struct(&png, &info);
        throw;
    }
    png_destroy_write_struct(&png, &info);
}

template <typename Channels>
const std::uint8_t* bytesOf(const std::vector<Channels>& map) {
    return map.empty() ? nullptr : reinterpret_cast<const std::uint8_t*>(map.data());
}

constexpr MapFile kMaps[] = {
    {"_normal", 3, [](const TextureMaps& m) { return bytesOf(m.normal); }},
    {"_roughness", 1, [](const TextureMaps& m) { return bytesOf(m.roughness); }},
    {"_height", 1, [](const TextureMaps& m) { return bytesOf(m.height01); }},
    {"_translucency", 1, [](const TextureMaps& m) { return bytesOf(m.translucency); }},
    {"_back", 4, [](const TextureMaps& m) { return bytesOf(m.back); }},
};
} // namespace

std::span<const MapFile> mapFiles() { return kMaps; }

std::filesystem::path mapBeside(const std::filesystem::path& albedo, std::string_view suffix) {
    return albedo.parent_path() / (albedo.stem().string() + std::string(suffix) + albedo.extension().string());
}

void writePng(const std::vector<std::array<std::uint8_t, 4>>& pixels, int width, int height,
              const std::filesystem::path& path, CFileSet& files) {
    writePng(files.create(path), width, height, 4, bytesOf(pixels));
}

void writePngs(const TextureMaps& maps, const std::filesystem::path& path, CFileSet& files) {
    writePng(maps.albedo, maps.width, maps.height, path, files);
    for (const MapFile& map : kMaps)
        if (const std::uint8_t* pixels = map.pixels(maps))
            writePng(files.create(mapBeside(path, map.suffix)), maps.width, maps.height, map.channels, pixels);
}

} // namespace stromar
