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
} // namespace

void writePngs(const TextureMaps& maps, const std::filesystem::path& path, CFileSet& files) {
    const auto beside = [&](const char* what) {
        return path.parent_path() / (path.stem().string() + what + path.extension().string());
    };
    writePng(files.create(path), maps.width, maps.height, 4, maps.albedo.front().data());
    writePng(files.create(beside("_normal")), maps.width, maps.height, 3, maps.normal.front().data());
    writePng(files.create(beside("_roughness")), maps.width, maps.height, 1, maps.roughness.data());
    writePng(files.create(beside("_height")), maps.width, maps.height, 1, maps.height01.data());
}

} // namespace stromar
