#include "ExportPictures.h"
#include "ContentHash.h"
#include "stromar/app/Pictures.h"
#include "stromar/texture/Opacity.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr std::size_t kKnownGreys = 256; // pictures whose grey is known
constexpr int kPictureVersion = 2; // rises when the same is made differently

struct Picture {
    Pixels pixels;
    int width, height;
};

Picture halved(const Picture& large, bool normals) {
    Picture half{{}, std::max(1, large.width / 2), std::max(1, large.height / 2)};
    half.pixels.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    const auto at = [&](int x, int y, std::size_t c) {
        return int(large.pixels[static_cast<std::size_t>(std::min(y, large.height - 1) * large.width + std::min(x, large.width - 1))][c]);
    };
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            auto& to = half.pixels[static_cast<std::size_t>(y * half.width + x)];
            double n[3], length = 0;
            for (std::size_t c = 0; c < 4; ++c) {
                const int sum = at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) + at(2 * x + 1, 2 * y + 1, c);
                to[c] = static_cast<std::uint8_t>((sum + 2) / 4);
                if (c == 3) continue;
                n[c] = sum / 4.0 - 128;
                length += n[c] * n[c];
            }
            if (!normals || length == 0) continue;
            for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<std::uint8_t>(std::lround(128 + 127 * n[c] / std::sqrt(length)));
        }
    return half;
}

/// Cut-out pictures keep how much they cover.
Picture limited(Picture picture, PictureUse use, int most) {
    if (most <= 0) return picture;
    const auto tooLarge = [&] { return std::max(picture.width, picture.height) > most; };
    const bool cutOut = use == PictureUse::CutOutAlbedo || use == PictureUse::Opacity;
    const std::vector<Pixels> levels = cutOut && tooLarge() ? mipmapsKeepingCoverage(picture.pixels, picture.width, picture.height) : std::vector<Pixels>();
    for (std::size_t level = 1; tooLarge(); ++level) {
        if (cutOut)
            picture = {levels[level], std::max(1, picture.width / 2), std::max(1, picture.height / 2)};
        else
            picture = halved(picture, use == PictureUse::Normal);
    }
    return picture;
}

std::uint8_t inverse(std::uint8_t value) { return static_cast<std::uint8_t>(255 - value); }

/// Wood and leaves are no metal; nothing is known of occlusion.
void recolour(Pixels& pixels, PictureUse use, const ExportOptions& options) {
    const bool down = options.normalMaps == static_cast<int>(ExportedNormalMaps::DirectX);
    const bool orm = options.packedMaps == static_cast<int>(ExportedPackedMaps::Orm);
    for (auto& p : pixels) {
        if (use == PictureUse::Normal && down) p[1] = static_cast<std::uint8_t>(std::min(255, 256 - int(p[1])));
        if (use == PictureUse::Roughness && orm) p = {255, p[1], 0, 255};
        if (use == PictureUse::Opacity) p = {p[3], p[3], p[3], p[3]};
        if (use == PictureUse::UnityMask) p = {0, 255, 0, inverse(p[1])};
    }
}

/// JPEG has no alpha, and its blocks would show in normals.
bool isJpeg(PictureUse use, const ExportOptions& options) {
    return use == PictureUse::Albedo && options.textureFormat == static_cast<int>(ExportedTextureFormat::Jpeg);
}

bool changes(const Picture& picture, PictureUse use, const ExportOptions& options) {
    if (options.textureSize > 0 && std::max(picture.width, picture.height) > options.textureSize) return true;
    switch (use) {
    case PictureUse::Albedo: return isJpeg(use, options);
    case PictureUse::CutOutAlbedo: return false;
    case PictureUse::Normal: return options.normalMaps == static_cast<int>(ExportedNormalMaps::DirectX);
    case PictureUse::Roughness: return options.packedMaps == static_cast<int>(ExportedPackedMaps::Orm);
    case PictureUse::Opacity:
    case PictureUse::UnityMask: return true;
    }
    return false;
}

/// By the file, when it was written, and what is made of it.
fs::path keptFile(const fs::path& source, PictureUse use, const ExportOptions& options) {
    std::string all = fs::absolute(source).string() + ' ' + std::to_string(fs::last_write_time(source).time_since_epoch().count()) + ' ' +
                      std::to_string(fs::file_size(source)) + ' ' + std::to_string(kPictureVersion);
    for (const int choice : {static_cast<int>(use), options.textureSize, options.normalMaps, options.packedMaps}) all += ' ' + std::to_string(choice);
    return pictureCache() / "exports" / (nameOfHash(hashOfText(all)) + (isJpeg(use, options) ? ".jpg" : ".png"));
}

std::optional<int> readUniformGrey(const fs::path& picture) {
    const TextureMaps maps = readPng(picture);
    if (maps.albedo.empty()) return {};
    const auto first = maps.albedo.front();
    return std::ranges::all_of(maps.albedo, [&](const auto& pixel) { return pixel == first; }) ? std::optional<int>(first[1]) : std::nullopt;
}
} // namespace

std::optional<int> uniformGrey(const fs::path& picture) {
    static std::mutex mutex;
    static std::map<std::pair<fs::path, fs::file_time_type>, std::optional<int>> known;
    if (!isPng(picture)) return {};
    std::error_code problem; // reading says it better
    const std::pair key(picture, fs::last_write_time(picture, problem));
    const std::lock_guard lock(mutex);
    if (known.size() > kKnownGreys) known.clear();
    const auto found = known.find(key);
    return found != known.end() ? found->second : known[key] = readUniformGrey(picture);
}

fs::path preparedPicture(const fs::path& source, PictureUse use, const ExportOptions& options) {
    if (!isPng(source)) return source;
    const bool mayChange = options.textureSize > 0 || isJpeg(use, options) || use == PictureUse::Normal || use == PictureUse::Roughness || use == PictureUse::Opacity ||
                           use == PictureUse::UnityMask;
    if (!mayChange) return source;
    try {
        const fs::path file = keptFile(source, use, options);
        if (isKept(file)) return file;
        TextureMaps maps = readPng(source);
        Picture picture{std::move(maps.albedo), maps.width, maps.height};
        if (!changes(picture, use, options)) return source;
        picture = limited(std::move(picture), use, options.textureSize);
        recolour(picture.pixels, use, options);
        fs::create_directories(file.parent_path());
        CFileSet files;
        if (isJpeg(use, options))
            writeJpeg(picture.pixels, picture.width, picture.height, file, files);
        else
            writePng(picture.pixels, picture.width, picture.height, file, files);
        files.commit();
        return file;
    } catch (const fs::filesystem_error& e) {
        throw CError(std::string("cannot prepare the picture: ") + e.what());
    }
}

} // namespace stromar
