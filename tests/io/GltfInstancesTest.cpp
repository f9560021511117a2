// Leaves of glTF files as instances: three.js reads the tree that the plain file holds.
#include "Checkout.h"
#include "io/ExportedModels.h"
#include "io/NodeReads.h"
#include "io/Tools.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/app/ExportRow.h"
#include "stromar/params/ParamText.h"
#include "stromar/util/FileSet.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
struct Wanted {
    const char* name;
    ExportOptions options;
};
void expectSame(const Json& one, const Json& plain, double metre) {
    for (const char* same : {"triangles", "vertices", "materials", "opaque", "colours"}) EXPECT_EQ(one.at(same), plain.at(same)) << same;
    EXPECT_EQ(one.at("objects").size(), plain.at("objects").size());
    for (const char* corner : {"min", "max"})
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one.at(corner).at(i), plain.at(corner).at(i), 0.0005 * metre) << corner << i;
    for (const char* mean : {"normal", "uv", "colour"})
        for (std::size_t i = 0; i < plain.at(mean).size(); ++i) EXPECT_NEAR(one.at(mean).at(i), plain.at(mean).at(i), 2e-3) << mean << i << ": occlusion is of whole leaves";
}
} // namespace

class GltfInstances : public testing::TestWithParam<Wanted> {};
INSTANTIATE_TEST_SUITE_P(All, GltfInstances,
                         testing::Values(Wanted{"plain", chosen({})}, Wanted{"centimetres", chosen({{"scale", "100"}})},
                                         Wanted{"meshopt", chosen({{"compress", "meshopt"}})},
                                         Wanted{"cards", chosen({{"lod", "2"}, {"occlusion", "color"}})}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(GltfInstances, ThreeReadsTheSameTree) {
    needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)");
    if (HasFailure() || IsSkipped()) return;
    const CTemporaryFolder folder;
    CParams params = preset("wild_cherry"); // leaves and blossoms
    findParam("Season")->set(params, 4.3);
    findParam("LeafColourV")->set(params, 0.5);
    const auto written = [&](const char* word) {
        ExportOptions options = GetParam().options;
        setChoice(options, "instances", word);
        const fs::path path = folder / (std::string(word) + ".glb");
        CTreeCreator creator;
        exportTree(creator, params, options, {}, path, CProgress(2));
        return path;
    };
    const fs::path instanced = written("leaves"), plain = written("none");
    const Json found = readByThree(instanced);
    EXPECT_GT(found.at("instances"), 1000);
    expectSame(found, readByThree(plain), GetParam().options.scale);
    EXPECT_LT(double(fs::file_size(instanced)), 0.9 * double(fs::file_size(plain)));
    const Json issues = validatedGltf(instanced).at("issues");
    EXPECT_EQ(issues.at("numErrors"), 0) << issues.dump(1);
    EXPECT_EQ(issues.at("numWarnings"), 0) << issues.dump(1);
}

TEST(GltfInstancesOfARow, StandWhereTheirTreesDo) {
    needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)");
    if (HasFailure() || IsSkipped()) return;
    const CTemporaryFolder folder;
    const std::vector<RowTree> trees{{.params = preset("sapling"), .name = "a"}, {.params = preset("sapling"), .place = 5, .name = "b"}};
    const auto read = [&](const char* word) {
        const fs::path path = folder / (std::string(word) + ".glb");
        exportRow(trees, chosen({{"instances", word}}), SizeLimits::none(), {}, path, CProgress(2));
        return readByThree(path);
    };
    expectSame(read("leaves"), read("none"), 1);
}

TEST(GltfInstancesOptions, RefuseWhatCannotBe) {
    const auto conflict = [](std::initializer_list<std::pair<const char*, const char*>> words, const char* ending) {
        ExportOptions options = chosen(words);
        setChoice(options, "instances", "leaves");
        return conflictText(options, *formatOf(ending));
    };
    EXPECT_EQ(conflict({}, "a.glb"), "");
    EXPECT_EQ(conflict({{"lods", "file-each"}}, "a.gltf"), "");
    EXPECT_EQ(conflict({}, "a.obj"), ".obj cannot hold instances; choose glTF or USD");
    EXPECT_EQ(conflict({{"wind", "attributes"}}, "a.glb"), "leaves that move in the wind cannot be instances");
    EXPECT_EQ(conflict({{"lods", "one-file"}}, "a.glb"), "instances belong to one level of detail; choose a file for each");
}

} // namespace stromar::test
