#include "ImpostorExport.h"
#include "stromar/app/Impostor.h"
#include "stromar/texture/Dds.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

namespace stromar {

namespace fs = std::filesystem;

namespace {
using nlohmann::ordered_json;

constexpr int kBillboard = 512, kLeastAtlas = 256; // pixels

/// The tree's axes and metres to those of the file.
class CFileAxes {
public:
    CFileAxes(const Arrangement& arrangement, const Format& format) : m_arrangement(arrangement), m_yUp(format.upAxis == "y") {}

    glm::dvec3 direction(const glm::dvec3& v) const {
        const glm::dvec3 own(m_arrangement.direction(glm::vec3(v)));
        return m_yUp ? glm::dvec3(own.x, own.z, -own.y) : own;
    }
    double length(double metres) const { return metres * double(m_arrangement.scale); }

private:
    Arrangement m_arrangement;
    bool m_yUp;
};

ordered_json jsonOf(const glm::dvec3& v) {
    const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6 + 0.0; };
    return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

/// Each frame by itself: no half mixes in its neighbours.
std::vector<Pixels> halvesOf(const ImpostorAtlas& atlas, const CProgress& progress) {
    constexpr int kAcross = ImpostorAtlas::kAcross;
    std::vector<Pixels> levels;
    for (int side = atlas.frame; side > 0; side /= 2) levels.emplace_back(static_cast<std::size_t>(kAcross * side) * static_cast<std::size_t>(kAcross * side));
    parallelFor(
        kAcross * kAcross, 1,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const std::size_t column = i % kAcross, row = i / kAcross, width = std::size_t(kAcross) * std::size_t(atlas.frame);
                Pixels frame;
                for (std::size_t y = 0; y < std::size_t(atlas.frame); ++y) {
                    const auto line = atlas.picture.albedo.begin() + std::ptrdiff_t((row * std::size_t(atlas.frame) + y) * width + column * std::size_t(atlas.frame));
                    frame.insert(frame.end(), line, line + atlas.frame);
                }
                const std::vector<Pixels> own = mipmapsKeepingCoverage(frame, atlas.frame, atlas.frame);
                std::size_t side = std::size_t(atlas.frame);
                for (std::size_t level = 0; level < levels.size(); ++level, side /= 2)
                    for (std::size_t y = 0; y < side; ++y)
                        std::copy_n(own[level].begin() + std::ptrdiff_t(y * side), side, levels[level].begin() + std::ptrdiff_t((row * side + y) * kAcross * side + column * side));
            }
        },
        progress);
    return levels;
}

/// Normals in the axes of the file.
Pixels turned(Pixels pixels, const CFileAxes& axes) {
    for (auto& pixel : pixels) {
        const glm::dvec3 n = 127.5 * (axes.direction(glm::dvec3(pixel[0], pixel[1], pixel[2]) / 127.5 - 1.0) + 1.0);
        for (int c = 0; c < 3; ++c) pixel[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(std::clamp(std::lround(n[c]), 0L, 255L));
    }
    return pixels;
}

void writeAtlas(const ImpostorAtlas& atlas, bool whole, const CFileAxes& axes, const fs::path& model, CFileSet& files, const CProgress& progress) {
    const std::string name = plainName(model) + "_impostor";
    const auto beside = [&](const std::string& suffix) { return model.parent_path() / (name + suffix); };
    constexpr const char *kAlbedo = "_albedo.png", *kHalves = "_albedo.dds", *kNormals = "_normal_depth.png";
    writePng(atlas.picture.albedo, atlas.picture.width, atlas.picture.height, beside(kAlbedo), files);
    writePng(turned(atlas.picture.normalDepth, axes), atlas.picture.width, atlas.picture.height, beside(kNormals), files);
    writeDds(halvesOf(atlas, progress), atlas.picture.width, atlas.picture.height, beside(kHalves), files);
    ordered_json views = ordered_json::array();
    for (int i = 0; i < ImpostorAtlas::kAcross * ImpostorAtlas::kAcross; ++i) {
        const ImpostorView view = atlas.grid.view(i % ImpostorAtlas::kAcross, i / ImpostorAtlas::kAcross);
        views.push_back({{"right", jsonOf(axes.direction(view.right))}, {"up", jsonOf(axes.direction(view.up))}, {"towards", jsonOf(axes.direction(view.towards))}});
    }
    const glm::dvec3 up = axes.direction({0, 0, 1});
    files.create(beside(".json")) << ordered_json{{"layout", whole ? "octahedral" : "hemi-octahedral"},
                                                  {"frames", ImpostorAtlas::kAcross},
                                                  {"frame_pixels", atlas.frame},
                                                  {"up", up.y > 0.5 ? "y" : "z"},
                                                  {"centre", jsonOf(axes.length(1) * axes.direction(atlas.centre))},
                                                  {"radius", axes.length(atlas.radius)},
                                                  {"alpha_cutoff", std::round(1000 * atlas.alphaCut) / 1000},
                                                  {"albedo", name + kAlbedo},
                                                  {"albedo_with_mips", name + kHalves},
                                                  {"normal_depth", name + kNormals},
                                                  {"views", views}}
                                         .dump(1)
                                  << "\n";
}

int atlasSide(const ExportOptions& options) {
    const int wanted = options.textureSize > 0 ? options.textureSize : ImpostorAtlas::kSide;
    return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::clamp(wanted, kLeastAtlas, ImpostorAtlas::kSide))));
}
} // namespace

std::optional<ImpostorLevel> impostorOf(const TreeModel& finest, const Meshes& meshes, const ExportOptions& options, const Format& format,
                                        const fs::path& treeFolder, const Output& to, CFileSet& files, const CProgress& progress) {
    const auto kind = static_cast<ExportedImpostor>(options.impostor);
    if (kind == ExportedImpostor::None) return {};
    const CImpostorCamera camera(finest, meshes, treeFolder, progress);
    const Arrangement arrangement = arrangementFor(options, format);
    if (kind == ExportedImpostor::Cross) {
        const ImpostorCross cross = drawImpostorCross(camera, kBillboard, progress);
        return ImpostorLevel{arranged({cross.mesh}, arrangement).front(), materialOf({Surface::Impostor, cross.picture}, surfaceOf(Surface::Impostor).name, options, format, to, files)};
    }
    const bool whole = kind == ExportedImpostor::Octahedral;
    writeAtlas(drawImpostorAtlas(camera, whole, atlasSide(options), progress), whole, CFileAxes(arrangement, format), to.path, files, progress);
    return {};
}

} // namespace stromar
