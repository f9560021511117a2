#include "stromar/texture/PictureSize.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Error.h"
#include "stromar/util/Text.h"
#include <algorithm>
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

template <typename Channels>
std::uint8_t* roomFor(std::vector<Channels>& map, const TextureMaps& maps) {
    map.resize(static_cast<std::size_t>(maps.width) * static_cast<std::size_t>(maps.height));
    return reinterpret_cast<std::uint8_t*>(map.data());
}

/// The row of a map with its ending, channels and place.
template <auto Map>
constexpr MapFile row(const char* suffix, int channels) {
    return {suffix, channels, [](const TextureMaps& m) { return bytesOf(m.*Map); },
            [](TextureMaps& m) { return roomFor(m.*Map, m); }};
}

constexpr MapFile kMaps[] = {
    row<&TextureMaps::normal>("_normal", 3),   row<&TextureMaps::roughness>("_roughness", 1),
    row<&TextureMaps::height01>("_height", 1), row<&TextureMaps::translucency>("_translucency", 1),
    row<&TextureMaps::back>("_back", 4),
};

/// A PNG file that is being read.
class CPngReader {
public:
    explicit CPngReader(const std::filesystem::path& path) : m_path(path) {
        refuseHugePicture(path);
        m_image.version = PNG_IMAGE_VERSION;
        if (!png_image_begin_read_from_file(&m_image, path.c_str())) fail();
    }
    ~CPngReader() { png_image_free(&m_image); }
    CPngReader(const CPngReader&) = delete;
    CPngReader& operator=(const CPngReader&) = delete;

    int width() const { return static_cast<int>(m_image.width); }
    int height() const { return static_cast<int>(m_image.height); }

    void read(int channels, std::uint8_t* pixels) {
        m_image.format = channels == 1 ? PNG_FORMAT_GRAY : channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
        const png_color black{0, 0, 0};
        if (!png_image_finish_read(&m_image, &black, pixels, 0, nullptr)) fail();
    }

private:
    [[noreturn]] void fail() const {
        throw CError("cannot read the picture " + m_path.string() + ": " + m_image.message);
    }

    std::filesystem::path m_path;
    png_image m_image{};
};
} // namespace

std::span<const MapFile> mapFiles() { return kMaps; }

bool isPng(const std::filesystem::path& file) { return lowerCase(file.extension().string()) == ".png"; }

std::filesystem::path mapBeside(const std::filesystem::path& albedo, std::string_view suffix) {
    return albedo.parent_path() / (albedo.stem().string() + std::string(suffix) + albedo.extension().string());
}

void writePng(const std::vector<std::array<std::uint8_t, 4>>& pixels, int width, int height,
              const std::filesystem::path& path, CFileSet& files) {
    const bool opaque = std::ranges::all_of(pixels, [](const auto& pixel) { return pixel[3] == 255; });
    if (!opaque) return writePng(files.create(path), width, height, 4, bytesOf(pixels));
    std::vector<std::array<std::uint8_t, 3>> colours;
    colours.reserve(pixels.size());
    for (const auto& [red, green, blue, alpha] : pixels) colours.push_back({red, green, blue});
    writePng(files.create(path), width, height, 3, bytesOf(colours));
}

TextureMaps readPng(const std::filesystem::path& path) {
    TextureMaps maps;
    CPngReader albedo(path);
    maps.width = albedo.width();
    maps.height = albedo.height();
    albedo.read(4, roomFor(maps.albedo, maps));
    return maps;
}

TextureMaps readPngs(const std::filesystem::path& path) {
    TextureMaps maps = readPng(path);
    for (const MapFile& map : kMaps) {
        const std::filesystem::path file = mapBeside(path, map.suffix);
        if (std::error_code problem; !std::filesystem::is_regular_file(file, problem)) continue;
        CPngReader reader(file);
        if (reader.width() == maps.width && reader.height() == maps.height) reader.read(map.channels, map.room(maps));
    }
    return maps;
}

void writePngs(const TextureMaps& maps, const std::filesystem::path& path, CFileSet& files) {
    for (const MapFile& map : kMaps)
        if (const std::uint8_t* pixels = map.pixels(maps))
            writePng(files.create(mapBeside(path, map.suffix)), maps.width, maps.height, map.channels, pixels);
    writePng(maps.albedo, maps.width, maps.height, path, files); // the last: who sees it sees its maps
}

} // namespace stromar
