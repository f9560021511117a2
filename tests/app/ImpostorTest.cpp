// Pictures that stand for a tree: the same from all sides, and what files have of them.
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/app/Impostor.h"
#include "stromar/app/Pictures.h"
#include "stromar/texture/TextureMaps.h"
#include "util/Lab.h"
#include "util/TemporaryFolder.h"
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace stromar::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kHeight = 200;            // pixels that the tree is high
constexpr double kMaxCoverage = 0.1, kMaxColour = 6;
constexpr double kSun[] = {0.42, -0.5, 0.76};

glm::dvec3 directionTo(double azimuth, double height) {
    const double a = azimuth * std::numbers::pi / 180, h = height * std::numbers::pi / 180;
    return {std::cos(h) * std::cos(a), std::cos(h) * std::sin(a), std::sin(h)};
}

TEST(ImpostorGrid, IsAtItsViewsWhatTheyAre) {
    for (const bool whole : {false, true}) {
        const CImpostorGrid grid(8, whole);
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column) {
                const ImpostorView view = grid.view(column, row);
                EXPECT_NEAR(glm::length(view.towards), 1, 1e-12);
                EXPECT_NEAR(glm::dot(view.towards, view.right), 0, 1e-12);
                EXPECT_LT(glm::distance(glm::cross(view.right, view.up), view.towards), 1e-12);
                if (!whole) {
                    EXPECT_GE(view.towards.z, 0);
                }
                double weight = 0; // of views in the same direction: the edge of the whole octahedron is there twice
                for (const CImpostorGrid::Share& share : grid.around(view.towards))
                    if (glm::distance(grid.view(share.column, share.row).towards, view.towards) < 1e-9) weight += share.weight;
                EXPECT_NEAR(weight, 1, 1e-6) << column << ' ' << row;
            }
    }
}

TEST(ImpostorGrid, MixesTheViewsAround) {
    for (const bool whole : {false, true}) {
        const CImpostorGrid grid(8, whole);
        double widest = 0;
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 towards = directionTo(i * 137.5, whole ? i * 0.36 - 90 : i * 0.18);
            double sum = 0;
            for (const CImpostorGrid::Share& share : grid.around(towards)) {
                EXPECT_GE(share.weight, 0);
                sum += share.weight;
                widest = std::max(widest, glm::distance(grid.view(share.column, share.row).towards, towards));
            }
            EXPECT_NEAR(sum, 1, 1e-9);
        }
        EXPECT_LT(widest, 2 * std::sin(22.0 * std::numbers::pi / 180)) << "the octahedron stretches most between its corners";
    }
}

/// As integrations/three does it: leaves that look everywhere catch a quarter of the sun.
glm::dvec3 lit(const ImpostorSample& seen) {
    const double same = std::clamp(glm::length(seen.normal), 1e-3, 1.0);
    const double sun = glm::dot(seen.normal, glm::normalize(glm::dvec3(kSun[0], kSun[1], kSun[2])));
    return seen.colour * (0.9 * (0.25 * (1 - same) + std::max(0.0, sun)) + 0.35 + 0.15 * seen.normal.z);
}

struct Difference {
    double coverage; ///< of the impostor less that of the tree, as a part of the latter
    double mean;     ///< ΔE of the mean colours
};

Difference differenceFrom(const CImpostorCamera& camera, const ImpostorAtlas& atlas, const glm::dvec3& towards) {
    constexpr int kFiner = 2; // than the impostor's pixels: every leaf has its own light
    const Bounds box = camera.bounds();
    const int side = static_cast<int>(std::lround(kHeight * 2 * atlas.radius / double(box.max.z - box.min.z)));
    const ImpostorFrame frame{ImpostorView::from(towards), atlas.centre, glm::dvec2(atlas.radius), atlas.radius};
    const ImpostorPicture tree = camera.draw(frame, kFiner * side, kFiner * side);
    double treeCover = 0, ownCover = 0;
    glm::dvec3 treeSum(0), ownSum(0);
    for (int y = 0; y < tree.height; ++y)
        for (int x = 0; x < tree.width; ++x) {
            const ImpostorSample seen = sampleOf(tree, {x + 0.5, y + 0.5});
            if (seen.cover > kAlphaCut) treeCover += 1, treeSum += lit(seen);
        }
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::dvec2 place = 2.0 * glm::dvec2(x + 0.5, y + 0.5) / double(side) - 1.0;
            const glm::dvec3 origin = place.x * frame.view.right - place.y * frame.view.up + 4.0 * towards;
            const ImpostorSample seen = sampleAlong(atlas, origin, -towards);
            if (seen.cover > atlas.alphaCut) ownCover += kFiner * kFiner, ownSum += double(kFiner * kFiner) * lit(seen);
        }
    return {ownCover / treeCover - 1, glm::distance(labOf(treeSum / treeCover), labOf(ownSum / ownCover))};
}

const std::vector<std::string> kTrees{"quaking_aspen", "hop"};

/// Without the figures of bare wood, and the flat crown that loses up to 13 % of its area seen from its edge.
std::vector<std::string> otherTrees() {
    std::vector<std::string> others = presetsWithout(kTrees);
    std::erase_if(others, [](const std::string& name) { return name.starts_with("abop") || name == "umbrella_acacia"; });
    return others;
}

struct Sampled {
    std::shared_ptr<const TreeModel> model;
    CImpostorCamera camera;
};
Sampled sampled(const std::string& name) {
    CTreeCreator creator;
    const CProgress progress(2);
    const auto model = creator.create(preset(name), detailOf(Model::Full, 1), progress);
    makePictures(*model, {}, progress);
    return {model, CImpostorCamera(*model, model->meshes(progress), {}, progress)};
}

class Impostor : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Slow, Impostor, testing::ValuesIn(kTrees), [](const auto& one) { return one.param; });
INSTANTIATE_TEST_SUITE_P(Exhaustive, Impostor, testing::ValuesIn(otherTrees()), [](const auto& one) { return one.param; });

TEST_P(Impostor, LooksLikeTheTreeFromAllSides) {
    const Sampled tree = sampled(GetParam());
    const ImpostorAtlas atlas = drawImpostorAtlas(tree.camera, false, ImpostorAtlas::kSide, CProgress(2));
    for (int i = 0; i < 24; ++i) {
        glm::dvec3 towards = directionTo(i * 137.5, 3 + 3.2 * i); // four in the middle of three views
        if (i % 6 == 0) {
            towards = glm::dvec3(0);
            for (const auto& share : atlas.grid.around(directionTo(i * 137.5, 10 + 2 * i))) towards += atlas.grid.view(share.column, share.row).towards;
            towards = glm::normalize(towards);
        }
        const Difference difference = differenceFrom(tree.camera, atlas, towards);
        EXPECT_LE(std::abs(difference.coverage), kMaxCoverage) << i;
        EXPECT_LE(difference.mean, kMaxColour) << i;
    }
}

Json gltfOf(const fs::path& file) {
    const std::string bytes = readFile(file);
    std::uint32_t length;
    std::memcpy(&length, bytes.data() + 12, sizeof length);
    return Json::parse(bytes.substr(20, length));
}

class ImpostorFiles : public testing::Test {
protected:
    void write(std::string_view lods, std::string_view impostor, const std::string& name = "tree.glb", std::string_view wind = "none") {
        ExportOptions options;
        setChoice(options, "lods", lods);
        setChoice(options, "impostor", impostor);
        setChoice(options, "wind", wind);
        CTreeCreator creator;
        exportTree(creator, preset("quaking_aspen"), options, {}, m_folder / name, CProgress(2));
    }
    CTemporaryFolder m_folder;
};

TEST_F(ImpostorFiles, ACrossIsTheLastFile) {
    write("file-each", "cross");
    EXPECT_EQ(m_folder.names(), (std::set<std::string>{"tree_LOD0.glb", "tree_LOD1.glb", "tree_LOD2.glb", "tree_LOD3.glb", "tree_LOD4.glb"}));
    const Json gltf = gltfOf(m_folder / "tree_LOD4.glb");
    ASSERT_EQ(gltf["meshes"].size(), 1u);
    EXPECT_EQ(gltf["accessors"][std::size_t(gltf["meshes"][0]["primitives"][0]["indices"])]["count"], 12);
    ASSERT_EQ(gltf["materials"].size(), 1u);
    EXPECT_EQ(gltf["materials"][0]["name"], "impostor");
    EXPECT_EQ(gltf["materials"][0]["alphaMode"], "MASK");
    EXPECT_EQ(gltf["materials"][0]["doubleSided"], true);
    EXPECT_TRUE(gltf["materials"][0].contains("normalTexture"));
    const auto& box = gltf["accessors"][std::size_t(gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"])];
    const Json tree = gltfOf(m_folder / "tree_LOD0.glb");
    double top = 0;
    for (const Json& accessor : tree["accessors"])
        if (accessor.contains("max") && accessor["type"] == "VEC3") top = std::max(top, double(accessor["max"][1]));
    EXPECT_NEAR(double(box["max"][1]), top, 0.05 * top);
}

TEST_F(ImpostorFiles, ACrossIsTheLastLevelOfOneFile) {
    write("one-file", "cross", "tree.glb", "bones");
    const Json gltf = gltfOf(m_folder / "tree.glb");
    const auto finest = *std::ranges::find_if(gltf["nodes"], [](const Json& node) { return node.contains("extensions") && node["extensions"].contains("MSFT_lod"); });
    EXPECT_EQ(finest["extras"]["MSFT_screencoverage"], (Json{0.5, 0.25, 0.1, 0.03, 0.01}));
    const Json& last = gltf["nodes"][std::size_t(finest["extensions"]["MSFT_lod"]["ids"][3])];
    EXPECT_FALSE(last.contains("skin")) << "it hangs on no bone";
}

using SlowImpostorFiles = ImpostorFiles;
TEST_F(SlowImpostorFiles, AGridOfViewsLiesBesideTheModel) {
    write("none", "hemi-octahedral");
    EXPECT_EQ(m_folder.names(), (std::set<std::string>{"tree.glb", "tree_impostor.json", "tree_impostor_albedo.dds", "tree_impostor_albedo.png", "tree_impostor_normal_depth.png"}));
    const Json json = Json::parse(readFile(m_folder / "tree_impostor.json"));
    EXPECT_EQ(json["layout"], "hemi-octahedral");
    EXPECT_EQ(json["views"].size(), 64u);
    EXPECT_EQ(json["up"], "y");
    for (const Json& view : json["views"]) EXPECT_GE(double(view["towards"][1]), 0) << "nothing from below";
    const TextureMaps albedo = readPng(m_folder / "tree_impostor_albedo.png");
    EXPECT_EQ(albedo.width, 2048);
    const std::string dds = readFile(m_folder / "tree_impostor_albedo.dds");
    std::size_t pixels = 0;
    int levels = 0;
    for (std::size_t side = 2048; side >= 8; side /= 2, ++levels) pixels += side * side; // a pixel for each view at last
    std::uint32_t said;
    std::memcpy(&said, dds.data() + 28, sizeof said);
    EXPECT_EQ(said, static_cast<std::uint32_t>(levels));
    ASSERT_EQ(dds.size(), 128 + 4 * pixels);
    const auto covered = [&](std::size_t from, std::size_t count) { // cut
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) sum += static_cast<std::uint8_t>(dds[128 + 4 * (from + i) + 3]) > 255 * kAlphaCut;
        return sum / double(count);
    };
    EXPECT_NEAR(covered(2048 * 2048 + 1024 * 1024, 512 * 512) / covered(0, 2048 * 2048), 1, 0.08) << "a picture a quarter as large covers as much";
}

TEST_F(ImpostorFiles, WhatCannotBeIsRefused) {
    EXPECT_THROW(write("none", "cross"), CError);
    EXPECT_THROW(write("file-each", "cross", "tree.stl"), CError);
    EXPECT_TRUE(m_folder.names().empty());
}

} // namespace
} // namespace stromar::test
