#include "ContentHash.h"
#include "stromar/app/Impostor.h"
#include "stromar/app/Pictures.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <string_view>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr int kBillboards = 2;
constexpr double kCrossMargin = 1.0 / 64;            // of a billboard's width and height, around the tree
constexpr std::uint8_t kRoughness = 191;        // as leaves are on the whole
constexpr glm::dvec3 kTowards[kBillboards] = {{0, -1, 0}, {1, 0, 0}};

/// In the plane through the trunk's axis, from the ground to the top.
ImpostorFrame frameOf(int billboard, const Bounds& box) {
    const ImpostorView view = ImpostorView::from(kTowards[billboard]);
    const glm::dvec3 low(box.min), high(box.max);
    const auto across = [&](const glm::dvec3& p) { return glm::dot(p, view.right); };
    const auto [left, right] = std::minmax({across(low), across(high)});
    const glm::dvec2 half = (1 + 2 * kCrossMargin) * glm::max(glm::dvec2(right - left, high.z - low.z) / 2.0, 1e-6);
    return {view, (left + right) / 2 * view.right + glm::dvec3(0, 0, (low.z + high.z) / 2), half, glm::length(high - low)};
}

void addBillboard(CMesh& mesh, const ImpostorFrame& frame, int billboard) {
    const auto first = static_cast<std::uint32_t>(mesh.vertexCount());
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
        const glm::dvec2 out = corner * frame.half;
        mesh.positions.push_back(glm::vec3(frame.centre + out.x * frame.view.right + out.y * frame.view.up));
        mesh.normals.push_back(glm::vec3(frame.view.towards));
        mesh.texCoords.push_back(glm::vec2((billboard + 0.5 * (corner.x + 1)) / kBillboards, 0.5 * (corner.y + 1)));
        mesh.looks.push_back({});
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + corner);
}

/// From the tree's axes to those of the billboard.
std::array<std::uint8_t, 3> turned(const std::array<std::uint8_t, 4>& normal, const ImpostorView& view) {
    const glm::dvec3 n = glm::dvec3(normal[0], normal[1], normal[2]) / 127.5 - 1.0;
    const glm::dvec3 own(glm::dot(n, view.right), glm::dot(n, view.up), std::max(0.05, glm::dot(n, view.towards)));
    const glm::dvec3 unit = 127.5 * (glm::normalize(own) + 1.0);
    return {static_cast<std::uint8_t>(std::lround(unit.x)), static_cast<std::uint8_t>(std::lround(unit.y)), static_cast<std::uint8_t>(std::lround(unit.z))};
}

/// One beside the other.
TextureMaps mapsOf(const std::array<ImpostorPicture, kBillboards>& pictures, const std::array<ImpostorFrame, kBillboards>& frames) {
    TextureMaps maps;
    maps.width = kBillboards * pictures[0].width;
    maps.height = pictures[0].height;
    for (int y = 0; y < maps.height; ++y)
        for (int x = 0; x < maps.width; ++x) {
            const auto own = static_cast<std::size_t>(x / pictures[0].width);
            const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(pictures[0].width) + static_cast<std::size_t>(x % pictures[0].width);
            maps.albedo.push_back(pictures[own].albedo[pixel]);
            maps.normal.push_back(turned(pictures[own].normalDepth[pixel], frames[own].view));
            maps.roughness.push_back(kRoughness);
        }
    return maps;
}

/// Named after what it shows.
fs::path kept(const TextureMaps& maps) {
    const auto bytes = [](const auto& pixels) { return std::string_view(reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof pixels[0]); };
    const fs::path file = pictureCache() / "impostors" / (nameOfHash(hashOfText(bytes(maps.albedo)) ^ hashOfText(bytes(maps.normal))) + ".png");
    if (isKept(file)) return file;
    std::error_code problem; // writing says it better
    fs::create_directories(file.parent_path(), problem);
    CFileSet files;
    writePngs(maps, file, files);
    files.commit();
    return file;
}
} // namespace

ImpostorCross drawImpostorCross(const CImpostorCamera& camera, int side, const CProgress& progress) {
    const Bounds box = camera.bounds();
    auto mesh = std::make_shared<CMesh>();
    mesh->name = "impostor";
    mesh->surface = Surface::Impostor;
    std::array<ImpostorFrame, kBillboards> frames;
    std::array<ImpostorPicture, kBillboards> pictures;
    for (int i = 0; i < kBillboards; ++i) addBillboard(*mesh, frames[static_cast<std::size_t>(i)] = frameOf(i, box), i);
    parallelFor(
        kBillboards, 1,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) pictures[i] = camera.draw(frames[i], side, side);
        },
        progress);
    return {mesh, kept(mapsOf(pictures, frames))};
}

} // namespace stromar
