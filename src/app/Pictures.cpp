#include "stromar/app/Pictures.h"
#include "stromar/texture/Bark.h"
#include "stromar/util/Random.h"
#include <cstdlib>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr const char* kBuiltIn[] = {"bark.png", "leaf.png"};
constexpr std::string_view kBark = "bark:";
constexpr int kSize = 1024;
constexpr std::uint64_t kLookVersion = 1; // rises when the same recipe is drawn differently

const std::string& textureText(const CParams& params, Surface surface) {
    return surface == Surface::Bark ? params.text.barkTexture : params.text.leafTexture;
}

fs::path cacheFolder() {
    if (const char* own = std::getenv("XDG_CACHE_HOME"); own && *own) return fs::path(own) / "stromar";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "stromar";
    return fs::temp_directory_path() / "stromar-cache";
}

/// By the recipe's letters: the same recipe written otherwise is drawn again.
fs::path recipeFile(std::string_view recipe) {
    std::uint64_t hash = hashCombine(kLookVersion, kSize);
    for (const char c : recipe) hash = hashCombine(hash, static_cast<unsigned char>(c));
    char name[32];
    std::snprintf(name, sizeof name, "%016llx.png", static_cast<unsigned long long>(hash));
    return cacheFolder() / "textures" / name;
}
} // namespace

fs::path dataFolder() {
    if (const char* own = std::getenv("STROMAR_DATA")) return own;
    std::error_code problem;
    const fs::path program = fs::read_symlink("/proc/self/exe", problem);
    const fs::path installed = program.parent_path().parent_path() / "share" / "stromar";
    return fs::exists(installed / "presets", problem) ? installed : fs::path(STROMAR_SOURCE_FOLDER);
}

bool isRecipe(std::string_view texture) { return texture.starts_with(kBark); }

fs::path textureOf(const CParams& params, Surface surface, const fs::path& folder) {
    const std::string& own = textureText(params, surface);
    if (isRecipe(own)) return recipeFile(own);
    return own.empty() ? dataFolder() / "textures" / kBuiltIn[static_cast<std::size_t>(surface)] : folder / own;
}

void makePictures(const CParams& params, const CProgress& progress) {
    for (const Surface surface : {Surface::Bark, Surface::Leaf}) {
        const std::string& recipe = textureText(params, surface);
        if (!isRecipe(recipe)) continue;
        const BarkParams bark = barkFromText(std::string_view(recipe).substr(kBark.size()));
        const fs::path file = recipeFile(recipe);
        if (fs::exists(file)) continue;
        std::error_code problem; // creating the file says it better
        fs::create_directories(file.parent_path(), problem);
        CFileSet files;
        writePngs(makeBark(bark, kSize, progress), file, files);
        files.commit();
    }
}

} // namespace stromar
