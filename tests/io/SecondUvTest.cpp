#include "Checkout.h"
#include "io/ExportedModels.h"
#include "io/NodeReads.h"
#include "io/Tools.h"
#include "stromar/app/Export.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
using Choices = std::vector<std::pair<const char*, const char*>>;

void write(const fs::path& path, const Choices& choices) {
    ExportOptions options;
    for (const auto& [key, value] : choices) setChoice(options, key, value);
    CTreeCreator creator;
    exportTree(creator, sampleModel("small").params, options, {}, path, CProgress(2));
}
} // namespace

class SecondUv : public testing::Test {
protected:
    void SetUp() override { needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)"); }

    /// Every mesh has it, inside the square, and all else is as without.
    void expectIn(const std::string& name, Choices choices, const std::string& read = {}) {
        const fs::path path = m_folder / name, written = read.empty() ? path : m_folder / read;
        write(path, choices);
        const Json without = readByThree(written);
        choices.emplace_back("second-uv", "lightmap");
        write(path, choices);
        const Json stats = readByThree(written);
        EXPECT_EQ(stats.at("uv2"), stats.at("objects").size()) << name;
        EXPECT_GT(stats.at("uv2Range").at(0), 0) << name;
        EXPECT_LT(stats.at("uv2Range").at(1), 1) << name;
        EXPECT_GT(stats.at("uv2Range").at(1), 0.7) << name;
        for (const char* same : {"triangles", "objects", "materials", "colours"}) EXPECT_EQ(stats.at(same), without.at(same)) << name << ' ' << same;
        for (const char* place : {"min", "max"})
            for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(stats.at(place).at(i), without.at(place).at(i), 1e-3) << name << ' ' << place;
    }

    CTemporaryFolder m_folder;
};

TEST_F(SecondUv, IsInEveryMesh) {
    expectIn("tree.glb", {});
    expectIn("tree.fbx", {});
    expectIn("merged.glb", {{"objects", "materials"}, {"atlas", "leaves"}});
    expectIn("both.fbx", {{"two-sided", "yes"}});
    expectIn("small.glb", {{"compress", "meshopt"}});
    expectIn("wind.glb", {{"wind", "attributes"}});
}

TEST_F(SecondUv, IsInEveryLevelOfDetail) { expectIn("level.glb", {{"lods", "file-each"}}, "level_LOD3.glb"); }

TEST_F(SecondUv, IsRefusedWhereItCannotBe) {
    EXPECT_THROW(write(m_folder / "tree.obj", {{"second-uv", "lightmap"}}), CError);
    for (const auto& other : Choices{{"instances", "leaves"}, {"wind", "unity"}, {"wind", "pivot-painter"}, {"watertight", "voxel"}})
        EXPECT_THROW(write(m_folder / "tree.glb", {{"second-uv", "lightmap"}, other}), CError) << other.first;
    EXPECT_TRUE(m_folder.names().empty());
}

} // namespace stromar::test
