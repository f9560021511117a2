// Several trees in one file.
#include "stromar/app/ExportRow.h"
#include "app/SameModel.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace stromar::test {

namespace {
namespace fs = std::filesystem;

CParams smallAspen(int seed = 1) {
    CParams params = preset("quaking_aspen");
    weberPenn(params).level[1].branches = 6;
    weberPenn(params).level[2].branches = 4;
    params.text.bark1Texture = params.text.bark2Texture = "";
    params.common.seed = seed;
    return params;
}

CParams inMonth(double month) {
    CParams params = smallAspen();
    params.common.season = static_cast<decltype(params.common.season)>(month);
    return params;
}

std::vector<RowTree> threeTrees() {
    return {{smallAspen(1), 1, nullptr, 0, "seed_1"},
            {smallAspen(2), 1, nullptr, 20, "seed_2"},
            {inMonth(10.5), 1, nullptr, -15.5, "month_10"}};
}

/// What an OBJ file says of one of its objects.
struct Object {
    std::string material;
    std::size_t triangles = 0;
    double left = 1e30, right = -1e30;
};

std::map<std::string, Object> objectsIn(const fs::path& path) {
    std::map<std::string, Object> objects;
    Object* own = nullptr;
    std::istringstream in(readFile(path));
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string kind, word;
        words >> kind;
        if (kind == "o") words >> word, own = &objects[word];
        if (kind == "usemtl") words >> own->material;
        if (kind == "f") ++own->triangles;
        if (double x = 0; kind == "v" && words >> x)
            own->left = std::min(own->left, x), own->right = std::max(own->right, x);
    }
    return objects;
}

std::size_t materialsIn(const fs::path& library) {
    const std::string text = readFile(library);
    std::size_t count = 0;
    for (std::size_t at = text.find("newmtl "); at != std::string::npos; at = text.find("newmtl ", at + 1)) ++count;
    return count;
}
} // namespace

TEST(ExportRow, EveryTreeStandsAtItsPlaceAsItIsAlone) {
    const CTemporaryFolder folder;
    const std::vector<RowTree> trees = threeTrees();
    exportRow(trees, {}, {}, {}, folder / "row.obj", CProgress(2));
    const auto row = objectsIn(folder / "row.obj");
    std::size_t found = 0;
    for (const RowTree& tree : trees) {
        const fs::path single = folder / (tree.name + ".obj");
        exportModel(*createAnew(tree.params, detailOf(Model::Full)), {}, single, CProgress(2));
        for (const auto& [name, alone] : objectsIn(single)) {
            ASSERT_TRUE(row.contains(tree.name + "_" + name)) << name;
            const Object& own = row.at(tree.name + "_" + name);
            ++found;
            EXPECT_EQ(own.triangles, alone.triangles) << name;
            EXPECT_NEAR(own.left, alone.left + tree.place, 1e-4) << name;
            EXPECT_NEAR(own.right, alone.right + tree.place, 1e-4) << name;
        }
    }
    EXPECT_EQ(found, row.size());
}

TEST(ExportRow, PicturesThatAreTheSameAreThereOnce) {
    const CTemporaryFolder folder;
    exportRow(threeTrees(), {}, {}, {}, folder / "row.obj", CProgress(2));
    const auto row = objectsIn(folder / "row.obj");
    std::map<std::string, std::set<std::string>> materials;
    for (const auto& [name, object] : row)
        materials[name.substr(0, name.find('_', name.find('_') + 1))].insert(object.material);
    EXPECT_EQ(materials.at("seed_1"), materials.at("seed_2"));
    EXPECT_EQ(materials.at("seed_1"), (std::set<std::string>{"bark", "leaf"}));
    EXPECT_EQ(materials.at("month_10"), (std::set<std::string>{"bark", "leaf_month_10"}))
        << "autumn leaves, the same bark";
    EXPECT_EQ(materialsIn(folder / "row.mtl"), 3u);
    for (const char* picture : {"row_bark.png", "row_leaf.png", "row_month_10_leaf.png"})
        EXPECT_TRUE(fs::exists(folder / picture)) << picture;
    EXPECT_NE(readFile(folder / "row_leaf.png"), readFile(folder / "row_month_10_leaf.png"));
}

TEST(ExportRow, EveryFormatTakesIt) {
    std::vector<RowTree> trees = threeTrees();
    for (RowTree& tree : trees) tree.detail = &detailOf(Model::Simple);
    for (const Format& format : formatTable()) {
        const CTemporaryFolder folder, alone;
        const std::string file = "row" + std::string(format.ending);
        exportRow(trees, {}, {}, {}, folder / file, CProgress(2));
        exportRow(std::span(trees).first(1), {}, {}, {}, alone / file, CProgress(2));
        EXPECT_GT(fs::file_size(folder / file), fs::file_size(alone / file)) << format.ending;
    }
}

TEST(ExportRow, LevelsOfDetailHaveAFileEachOrStandBesideEachOther) {
    const CTemporaryFolder folder;
    ExportOptions options;
    options.lods = static_cast<int>(ExportedLods::FileEach);
    const std::vector<RowTree> two{threeTrees()[0], threeTrees()[1]};
    exportRow(two, options, {}, {}, folder / "row.obj", CProgress(2));
    for (int lod = 0; lod < 4; ++lod)
        EXPECT_TRUE(fs::exists(folder / ("row_LOD" + std::to_string(lod) + ".obj"))) << lod;
    std::vector<RowTree> levels;
    for (int lod = 0; lod < 4; ++lod)
        levels.push_back({smallAspen(), 1, &detailOf(Model::Full, lod), 12.0 * lod, "LOD" + std::to_string(lod)});
    exportRow(levels, {}, {}, {}, folder / "levels.obj", CProgress(2));
    std::map<std::string, std::size_t> triangles;
    for (const auto& [name, object] : objectsIn(folder / "levels.obj"))
        triangles[name.substr(0, 4)] += object.triangles;
    for (int lod = 1; lod < 4; ++lod)
        EXPECT_LT(triangles.at("LOD" + std::to_string(lod)), triangles.at("LOD" + std::to_string(lod - 1)));
}

TEST(ExportRow, IsTheSameForAnyNumberOfThreads) {
    const CTemporaryFolder one, many;
    exportRow(threeTrees(), {}, {}, {}, one / "row.glb", CProgress(1));
    exportRow(threeTrees(), {}, {}, {}, many / "row.glb", CProgress(7));
    EXPECT_EQ(readFile(one / "row.glb"), readFile(many / "row.glb"));
}

TEST(ExportRow, WhatIsOfOneTreeIsRefused) {
    const CTemporaryFolder folder;
    const auto refused = [&](auto ExportOptions::*field, int value) {
        ExportOptions options;
        options.*field = value;
        EXPECT_THROW(exportRow(threeTrees(), options, {}, {}, folder / "row.glb", CProgress()), CError);
    };
    refused(&ExportOptions::lods, static_cast<int>(ExportedLods::InOneFile));
    refused(&ExportOptions::wind, static_cast<int>(ExportedWind::Attributes));
    refused(&ExportOptions::collision, static_cast<int>(ExportedCollision::Json));
    EXPECT_TRUE(folder.names().empty());
}

TEST(ExportRow, AllTogetherKeepToTheLimits) {
    const CTemporaryFolder folder;
    SizeLimits limits;
    limits.vertices = 1.5 * predictSize(smallAspen(), detailOf(Model::Full)).vertices;
    EXPECT_NO_THROW(exportRow(std::vector<RowTree>{threeTrees()[0]}, {}, limits, {}, folder / "one.obj", CProgress(2)));
    EXPECT_THROW(exportRow(threeTrees(), {}, limits, {}, folder / "row.obj", CProgress(2)), CTooLarge);
    EXPECT_FALSE(fs::exists(folder / "row.obj"));
}

TEST(ExportRow, WhatDisplacementAddsKeepsToTheLimitsForAllTogether) {
    const CTemporaryFolder folder;
    const RowTree tree{smallAspen(), 1, nullptr, 0, "one"};
    const std::vector<RowTree> alone{tree};
    std::vector<RowTree> many;
    for (const char* name : {"one", "two", "three", "four"}) many.push_back({smallAspen(), 1, nullptr, 10.0 * double(many.size()), name});
    ExportOptions options;
    options.displacement = 0.02;
    exportRow(alone, options, {}, {}, folder / "alone.obj", CProgress(2));
    std::size_t triangles = 0;
    for (const auto& [name, object] : objectsIn(folder / "alone.obj")) triangles += object.triangles;
    SizeLimits limits;
    limits.vertices = std::max(1.5 * double(triangles), 5 * predictSize(smallAspen(), detailOf(Model::Full)).vertices);
    for (int halvings = 0; halvings < 8; ++halvings, options.displacement /= 2) { // until one fits and four do not
        try {
            exportRow(alone, options, limits, {}, folder / "fits.obj", CProgress(2));
        } catch (const CError&) {
            FAIL() << "one tree was refused before four were";
        }
        try {
            exportRow(many, options, limits, {}, folder / "many.obj", CProgress(2));
        } catch (const CError&) {
            return;
        }
    }
    FAIL() << "no limit was met";
}

} // namespace stromar::test
