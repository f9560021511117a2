#include "stromar/app/Pictures.h"
#include "ContentHash.h"
#include "TwigPicture.h"
#include "stromar/params/ParamTable.h"
#include "stromar/texture/Draw.h"
#include "stromar/texture/Opacity.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Random.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <map>
#include <mutex>
#include <sys/stat.h>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr int kTileSize = 1024, kPreviewTileSize = 192, kCutOutSize = 512, kPreviewSize = 96, kMaskSize = 256;
constexpr std::int64_t kSecond = 1'000'000'000, kInUse = 600 * kSecond;
constexpr double kSeasonSteps = 0.2;      // of a month: the picture follows the slider in so many
constexpr std::uint64_t kRecipeVersion = 4; // rises when the same recipe is drawn differently

int sizeOf(Surface surface, PictureQuality quality) {
    if (!surfaceOf(surface).cutOut) return quality == PictureQuality::Preview ? kPreviewTileSize : kTileSize;
    return quality == PictureQuality::Preview ? kPreviewSize : kCutOutSize;
}

/// " season=9.4" where the month changes the picture.
std::string seasonWords(const CParams& params) {
    const CommonParams& g = params.common;
    const double month = std::round(g.season / kSeasonSteps) * kSeasonSteps;
    const bool summer = month >= kGreenFrom && month <= kGreenUntil;
    return g.evergreen || summer ? std::string() : " season=" + numberText(month);
}

std::string nameOf(std::uint64_t hash) { return nameOfHash(hash) + ".png"; }

/// By the recipe's letters: the same recipe written otherwise is drawn again.
fs::path recipeFile(std::string_view recipe, int size) {
    std::uint64_t hash = hashCombine(kRecipeVersion, static_cast<std::uint64_t>(size));
    for (const char c : recipe) hash = hashCombine(hash, static_cast<unsigned char>(c));
    return recipePictures() / nameOf(hash);
}

void keepPicture(const TextureMaps& maps, const fs::path& file) {
    std::error_code problem; // creating the file says it better
    fs::create_directories(file.parent_path(), problem);
    CFileSet files;
    writePngs(maps, file, files);
    files.commit();
}

TwigSource twigSource(const TreeModel& model, const fs::path& folder) {
    const Surface bark = shownSurface(model.params, model.twig->wood->surface);
    TwigSource source{{}, textureOf(model.params, bark, folder), surfaceOf(bark).colour, textureOf(model.params, shownSurface(model.params, Surface::Blossom), folder),
                      model.params.common.leafSunShade};
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind)
        source.leaves[kind] = textureOf(model.params, shownSurface(model.params, kLeafSurfaces[kind]), folder);
    return source;
}
/// A picture with its maps.
struct KeptPicture {
    std::vector<fs::path> files;
    std::uintmax_t bytes = 0;
    std::int64_t used = 0; ///< nanoseconds, when it was last written or used
};

std::int64_t nanoseconds(const timespec& time) { return time.tv_sec * kSecond + time.tv_nsec; }

std::vector<KeptPicture> keptPictures() {
    std::map<fs::path, KeptPicture> kept;
    std::error_code problem; // of files that others remove meanwhile
    for (fs::recursive_directory_iterator at(pictureCache(), problem), end; !problem && at != end; at.increment(problem)) {
        struct stat found {};
        if (stat(at->path().c_str(), &found) != 0 || !S_ISREG(found.st_mode)) continue;
        const std::string name = at->path().stem().string();
        KeptPicture& picture = kept[at->path().parent_path() / name.substr(0, name.find('_'))];
        picture.files.push_back(at->path());
        picture.bytes += static_cast<std::uintmax_t>(found.st_size);
        picture.used = std::max({picture.used, nanoseconds(found.st_atim), nanoseconds(found.st_mtim)});
    }
    std::vector<KeptPicture> all;
    for (auto& [name, picture] : kept) all.push_back(std::move(picture));
    return all;
}

CCutOut maskOf(TextureMaps picture) {
    constexpr int kSide = CCutOut::kSide;
    double covered = 0;
    for (const auto& pixel : picture.albedo) covered += pixel[3] / 255.0 / double(picture.albedo.size());
    setCoverage(picture.albedo, picture.width, picture.height, covered); // needles are thinner than a pixel
    std::vector<bool> cells;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const int px = (2 * x + 1) * picture.width / (2 * kSide), py = (2 * (kSide - y) - 1) * picture.height / (2 * kSide);
            cells.push_back(picture.albedo[picture.at(px, py)][3] >= 255 * kAlphaCut);
        }
    return {cells, false};
}

/// By a recipe, or by a file and when it was written.
CCutOut maskOf(const std::string& chosen, const fs::path& file, const CProgress& progress) {
    constexpr std::size_t kKept = 256;
    static std::mutex mutex;
    static std::map<std::string, CCutOut> known;
    std::error_code problem; // reading says it better
    const std::string key = isRecipe(chosen) ? chosen : file.string() + ' ' + std::to_string(fs::last_write_time(file, problem).time_since_epoch().count());
    {
        const std::lock_guard lock(mutex);
        if (const auto found = known.find(key); found != known.end()) return found->second;
    }
    CCutOut mask;
    try {
        mask = maskOf(isRecipe(chosen) ? CRecipe(chosen).draw(kMaskSize, progress) : readPng(file));
    } catch (const CError&) { // whoever shows the picture tells of it
    }
    const std::lock_guard lock(mutex);
    if (known.size() > kKept) known.clear();
    return known[key] = mask;
}

std::uintmax_t sizeOf(const std::vector<KeptPicture>& kept) {
    std::uintmax_t sum = 0;
    for (const KeptPicture& picture : kept) sum += picture.bytes;
    return sum;
}
} // namespace

fs::path pictureCache() {
    if (const char* own = std::getenv("XDG_CACHE_HOME"); own && *own) return fs::path(own) / "stromar";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "stromar";
    return fs::temp_directory_path() / "stromar-cache";
}

fs::path recipePictures() { return pictureCache() / "textures"; }

std::uintmax_t pictureCacheSize() { return sizeOf(keptPictures()); }

void trimPictureCache(std::uintmax_t bytes) {
    auto kept = keptPictures();
    std::uintmax_t left = sizeOf(kept);
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    const std::int64_t inUse = nanoseconds(now) - kInUse;
    std::ranges::sort(kept, {}, &KeptPicture::used);
    for (const KeptPicture& oldest : kept) {
        if (left <= bytes || (bytes > 0 && oldest.used > inUse)) return;
        std::error_code problem;
        for (const fs::path& file : oldest.files) fs::remove(file, problem);
        if (!problem) left -= oldest.bytes;
    }
}

bool isKept(const fs::path& picture) {
    constexpr timespec kUsedNow[] = {{0, UTIME_NOW}, {0, UTIME_OMIT}}; // when it was written is part of what is made of it
    return utimensat(AT_FDCWD, picture.c_str(), kUsedNow, 0) == 0 || fs::exists(picture);
}

fs::path dataFolder() {
    if (const char* own = std::getenv("STROMAR_DATA")) return own;
    std::error_code problem;
    const fs::path program = fs::read_symlink("/proc/self/exe", problem);
    const fs::path installed = program.parent_path().parent_path() / "share" / "stromar";
    return fs::exists(installed / "presets", problem) ? installed : fs::path(STROMAR_SOURCE_FOLDER);
}

std::string pictureOf(const CParams& params, Surface surface) {
    assert(surfaceOf(surface).texture);
    const std::string& own = params.text.*surfaceOf(surface).texture;
    std::string chosen = own.empty() ? surfaceOf(surface).standard : own;
    const bool ages = isLeaf(surface) && isRecipe(chosen) && chosen.find(" season=") == std::string::npos;
    return ages ? chosen + seasonWords(params) : chosen;
}

fs::path textureOf(const CParams& params, Surface surface, const fs::path& folder, PictureQuality quality) {
    const std::string chosen = pictureOf(params, surface);
    if (isRecipe(chosen)) return recipeFile(chosen, sizeOf(surface, quality));
    const bool own = !(params.text.*surfaceOf(surface).texture).empty();
    return own ? folder / chosen : dataFolder() / "textures" / chosen;
}

bool isBakeable(const CParams& params) {
    return std::ranges::all_of(kLeafSurfaces, [&](Surface surface) {
        const std::string leaf = pictureOf(params, shownSurface(params, surface));
        return isRecipe(leaf) || isPng(leaf);
    });
}

SurfaceTextures texturesOf(const CParams& params, const fs::path& folder) {
    SurfaceTextures all;
    for (const Surface surface : kSurfaces)
        if (hasSurface(params, surface)) all[static_cast<std::size_t>(surface)] = textureOf(params, surface, folder);
    return all;
}

void makePictures(const CParams& params, const CProgress& progress, PictureQuality quality) {
    for (const Surface surface : kSurfaces) {
        if (!hasSurface(params, surface)) continue;
        const std::string recipe = pictureOf(params, surface);
        if (!isRecipe(recipe)) continue;
        const CRecipe read(recipe);
        const fs::path file = textureOf(params, surface, {}, quality);
        const bool enough = quality == PictureQuality::Preview && isKept(textureOf(params, surface, {}, PictureQuality::Full));
        if (enough || isKept(file)) continue;
        keepPicture(read.draw(sizeOf(surface, quality), progress), file);
    }
}

CCutOut maskOf(const CParams& params, Surface surface, const CProgress& progress) {
    const Surface shown = shownSurface(params, surface);
    return maskOf(pictureOf(params, shown), textureOf(params, shown, params.folder), progress);
}

LeafMasks leafMasksOf(const CParams& params, const CProgress& progress) {
    LeafMasks masks;
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) masks[kind] = maskOf(params, kLeafSurfaces[kind], progress);
    return masks;
}

fs::path textureOf(const TreeModel& model, Surface surface, const fs::path& folder, const CProgress& progress) {
    if (surface != Surface::Twig) return textureOf(model.params, surface, folder);
    return model.twig ? pictureCache() / "twigs" / nameOf(twigHash(*model.twig, twigSource(model, folder), progress)) : fs::path();
}

void makePictures(const TreeModel& model, const fs::path& folder, const CProgress& progress) {
    makePictures(model.params, progress);
    const fs::path file = textureOf(model, Surface::Twig, folder, progress);
    if (file.empty() || isKept(file)) return;
    keepPicture(drawTwig(*model.twig, twigSource(model, folder), progress), file);
}

} // namespace stromar
