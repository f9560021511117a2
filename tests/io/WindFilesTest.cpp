// What lets a tree sway elsewhere, by the Khronos validator, three.js, Blender and a script of our own that knows the
// file alone.
#include "cli/Process.h"
#include "io/Tools.h"
#include "stromar/app/Export.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kTests = STROMAR_SOURCE "/tests/io/";
bool hasModule(const char* name) { return fs::exists(std::string(STROMAR_BIN "/../node_modules/") + name); }

CParams treeOf(const char* name) {
    return CTreeFile::read(std::string(STROMAR_SOURCE "/presets/") + name + ".tree").params();
}

ExportOptions carrying(ExportedWind wind, ExportedLods lods = ExportedLods::None) {
    ExportOptions options;
    options.wind = static_cast<int>(wind);
    options.lods = static_cast<int>(lods);
    return options;
}

void write(const fs::path& path, const char* tree, const ExportOptions& options, const Motion& motion = {}) {
    CTreeCreator creator;
    exportTree(creator, treeOf(tree), options, {}, path, CProgress(2), nullptr, motion);
}

Json jsonOf(const fs::path& glb) {
    const std::string bytes = readFile(glb);
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + 12, 4);
    return Json::parse(bytes.substr(20, size));
}

class WindFiles : public ::testing::TestWithParam<ExportedWind> {
protected:
    CTemporaryFolder m_folder;
};
INSTANTIATE_TEST_SUITE_P(All, WindFiles,
                         ::testing::Values(ExportedWind::Attributes, ExportedWind::CryEngine, ExportedWind::Unity,
                                           ExportedWind::Bones));

TEST_P(WindFiles, HaveNoErrorsOrWarnings) {
    needTool(hasModule("gltf-validator"), "the validator of glTF files (npm)");
    if (HasFailure() || IsSkipped()) return;
    write(m_folder / "one.glb", "apple", carrying(GetParam()));
    write(m_folder / "lods.glb", "apple", carrying(GetParam(), ExportedLods::InOneFile));
    for (const char* name : {"one.glb", "lods.glb"}) {
        const ProcessResult run = runProcess({"node", kTests + "validate-gltf.js", (m_folder / name).string()},
                                             {.folder = STROMAR_BIN "/.."});
        ASSERT_EQ(run.status, 0) << run.err;
        const Json issues = Json::parse(run.out).at("issues");
        EXPECT_EQ(issues.at("numErrors"), 0) << issues.dump(1);
        EXPECT_EQ(issues.at("numWarnings"), 0) << issues.dump(1);
    }
}

TEST_P(WindFiles, KeepTheColoursOfATreeUnlessTheEngineReadsThem) {
    write(m_folder / "plain.glb", "apple", {});
    write(m_folder / "wind.glb", "apple", carrying(GetParam()));
    const auto coloursOf = [&](const char* name) {
        const std::string bytes = readFile(m_folder / name);
        const Json file = jsonOf(m_folder / name);
        std::uint32_t size = 0;
        std::memcpy(&size, bytes.data() + 12, 4);
        const Json& accessor =
            file["accessors"][file["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"].get<std::size_t>()];
        const Json& view = file["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        return bytes.substr(28 + size + view.value("byteOffset", std::size_t{0}),
                            view["byteLength"].get<std::size_t>());
    };
    const bool engines = GetParam() == ExportedWind::CryEngine || GetParam() == ExportedWind::Unity;
    EXPECT_EQ(coloursOf("plain.glb") == coloursOf("wind.glb"), !engines);
}

TEST(WindFormats, OnesThatCannotCarryItSaySo) {
    const CTemporaryFolder folder;
    for (const Format& format : formatTable()) {
        if (format.wind) continue;
        EXPECT_THROW(write(folder / ("x" + std::string(format.ending)), "apple", carrying(ExportedWind::Bones)), CError)
            << format.ending;
        EXPECT_TRUE(folder.names().empty());
    }
}

TEST(WindAttributes, AScriptThatKnowsTheFileAloneBendsTheTreeAsTheProgramDoes) {
    needTool(runProcess({"/usr/bin/python3", "-c", "import numpy"}).status == 0, "NumPy");
    if (::testing::Test::HasFailure() || ::testing::Test::IsSkipped()) return;
    const CTemporaryFolder folder;
    const Motion motion{
        .wind = {.direction = windDirection(30), .strength = 0.8, .gusts = 0.6}, .frames = 4, .seconds = 2};
    for (const char* tree : {"quaking_aspen", "apple", "strand_birch", "abop_2_6c"}) { // with and without clones
        write(folder / "still.glb", tree, carrying(ExportedWind::Attributes));
        exportFrames(
            treeOf(tree), {}, motion, 1, true, {}, {}, folder / "w.glb", [](const fs::path&) {}, CProgress(2));
        const ProcessResult run =
            runProcess({"/usr/bin/python3", kTests + "wind-pose.py", (folder / "still.glb").string(),
                        (folder / "w_0002.glb").string(), "0.8", "30", "0.6", "0.5", "2"});
        ASSERT_EQ(run.status, 0) << run.err;
        const Json result = Json::parse(run.out);
        EXPECT_LT(result.at("worst").get<double>(), 1e-4) << tree << ": metres";
        EXPECT_GT(result.at("moved").get<double>(), 0.02) << tree;
    }
}

TEST(WindBones, ThreeJsPlaysTheClips) {
    needTool(hasModule("three"), "three.js (npm)");
    if (::testing::Test::HasFailure() || ::testing::Test::IsSkipped()) return;
    const CTemporaryFolder folder;
    write(folder / "bones.glb", "quaking_aspen", carrying(ExportedWind::Bones),
          {.wind = {.strength = 1}, .seconds = 3});
    const ProcessResult run = runProcess({"node", kTests + "three-clips.mjs", (folder / "bones.glb").string()},
                                         {.folder = STROMAR_BIN "/.."});
    ASSERT_EQ(run.status, 0) << run.err;
    const Json file = Json::parse(run.out), wind = file["clips"]["wind"], growth = file["clips"]["growth"];
    EXPECT_EQ(file["bones"], 65) << "64 stems and the ground";
    EXPECT_NEAR(wind["seconds"].get<double>(), 3, 1e-6);
    EXPECT_GT(wind["moves"].get<double>(), 0.1);
    EXPECT_LT(wind["closes"].get<double>(), 1e-5) << "a loop";
    EXPECT_LT(growth["height"].get<double>(), 0.01 * file["height"].get<double>()) << "a seed first";
    EXPECT_LT(growth["ends"].get<double>(), 1e-4) << "the grown tree at last";
}

TEST(WindBones, AFelledTreeHasAClipInWhichItFallsAndAStumpThatStands) {
    needTool(hasModule("three"), "three.js (npm)");
    if (::testing::Test::HasFailure() || ::testing::Test::IsSkipped()) return;
    const CTemporaryFolder folder;
    for (const double height : {0.0, 1.5}) {
        write(folder / "fall.glb", "quaking_aspen", carrying(ExportedWind::Bones),
              {.wind = {.strength = 1}, .felling = Felling{30, height}});
        const ProcessResult run = runProcess({"node", kTests + "three-clips.mjs", (folder / "fall.glb").string()},
                                             {.folder = STROMAR_BIN "/.."});
        ASSERT_EQ(run.status, 0) << run.err;
        const Json file = Json::parse(run.out), fall = file["clips"]["fall"];
        EXPECT_GT(fall["ends"].get<double>(), 10) << "its tip has moved by more than its height";
        EXPECT_EQ(fall["unmoved"].get<int>() > 10, height > 0) << "a stump stays";
        EXPECT_LT(fall["top"].get<double>(), 0.75 * file["height"].get<double>());
    }
}

TEST(WindBones, BlenderHasTheArmatureAndItsActions) {
    needTool(std::system("command -v blender > /dev/null") == 0, "Blender");
    if (::testing::Test::HasFailure() || ::testing::Test::IsSkipped()) return;
    const CTemporaryFolder folder;
    ExportOptions options = carrying(ExportedWind::Bones);
    options.bones = 20;
    write(folder / "bones.glb", "apple", options, {.wind = {.strength = 1}});
    const ProcessResult run = runProcess({"blender", "-b", "--factory-startup", "--python", kTests + "blender-clips.py",
                                          "--", (folder / "bones.glb").string()});
    const std::size_t at = run.out.find("STATS ");
    ASSERT_NE(at, std::string::npos) << run.out << run.err;
    const Json stats = Json::parse(run.out.substr(at + 6, run.out.find('\n', at) - at - 6));
    EXPECT_EQ(stats["bones"], 21);
    EXPECT_EQ(stats["actions"].size(), 2u);
    for (const auto& [name, action] : stats["actions"].items()) {
        EXPECT_GT(action["moves"].get<double>(), 0.05) << name;
        if (name.starts_with("wind")) {
            EXPECT_LT(action["closes"].get<double>(), 1e-4) << name;
        }
    }
}

} // namespace
} // namespace stromar::test
