// What lets a tree sway elsewhere, by the Khronos validator, three.js, Blender and a script of our own that knows the
// file alone.
#include "Checkout.h"
#include "cli/Process.h"
#include "io/Tools.h"
#include "stromar/app/Export.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include "stromar/texture/TextureMaps.h"
#include <ImfRgbaFile.h>
#include <cstring>
#include <filesystem>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kTests = inSource("tests/io/");
bool hasModule(const char* name) { return fs::exists(inBin("../node_modules/") + name); }

CParams treeOf(const char* name) {
    return CTreeFile::read(inSource("presets/") + name + ".tree").params();
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
                                           ExportedWind::PivotPainter, ExportedWind::Bones));

TEST_P(WindFiles, HaveNoErrorsOrWarnings) {
    needTool(hasModule("gltf-validator"), "the validator of glTF files (npm)");
    if (HasFailure() || IsSkipped()) return;
    write(m_folder / "one.glb", "apple", carrying(GetParam()));
    write(m_folder / "lods.glb", "apple", carrying(GetParam(), ExportedLods::InOneFile));
    for (const char* name : {"one.glb", "lods.glb"}) {
        const ProcessResult run = runProcess({"node", kTests + "validate-gltf.js", (m_folder / name).string()},
                                             {.folder = inBin("..")});
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
            file["accessors"][file["meshes"].back()["primitives"][0]["attributes"]["COLOR_0"].get<std::size_t>()]; // of leaves
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
        if (format.channels != Channels::None) continue;
        EXPECT_THROW(write(folder / ("x" + std::string(format.ending)), "apple", carrying(ExportedWind::Bones)), CError)
            << format.ending;
        EXPECT_TRUE(folder.names().empty());
    }
}

TEST(SlowWindAttributes, AScriptThatKnowsTheFileAloneBendsTheTreeAsTheProgramDoes) {
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

/// Floats of an attribute of the first mesh.
std::vector<float> floatsOf(const fs::path& glb, const char* attribute) {
    const std::string bytes = readFile(glb);
    const Json file = jsonOf(glb);
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + 12, 4);
    const Json& accessor =
        file["accessors"][file["meshes"][0]["primitives"][0]["attributes"][attribute].get<std::size_t>()];
    const Json& view = file["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::vector<float> all(view["byteLength"].get<std::size_t>() / sizeof(float));
    std::memcpy(all.data(), bytes.data() + 28 + size + view.value("byteOffset", std::size_t{0}),
                all.size() * sizeof(float));
    return all;
}

struct HalfPicture {
    std::vector<Imf::Rgba> pixels;
    std::size_t width, height;
};
HalfPicture readExr(const fs::path& path) {
    Imf::RgbaInputFile file(path.c_str());
    const Imath::Box2i window = file.dataWindow();
    HalfPicture picture{{}, std::size_t(window.max.x + 1), std::size_t(window.max.y + 1)};
    picture.pixels.resize(picture.width * picture.height);
    file.setFrameBuffer(picture.pixels.data(), 1, picture.width);
    file.readPixels(0, window.max.y);
    return picture;
}

/// Epic's unpacking of the index.
std::size_t unpacked(Imath::half index) { return std::size_t(index.bits()) - 1024; }

TEST(WindPivotPainter, EveryVertexFindsItsPivotAndAWayToTheRoot) {
    const CTemporaryFolder folder;
    for (const char* tree : {"apple", "strand_birch"}) {
        write(folder / "a.glb", tree, carrying(ExportedWind::PivotPainter));
        const HalfPicture pivots = readExr(folder / "a_PivotPos_Index.exr");
        const TextureMaps axes = readPngs(folder / "a_XVector_Extent.png");
        ASSERT_EQ(axes.width, int(pivots.width));
        ASSERT_EQ(axes.height, int(pivots.height));
        const auto uvs = floatsOf(folder / "a.glb", "TEXCOORD_1"), places = floatsOf(folder / "a.glb", "POSITION");
        ASSERT_EQ(uvs.size() / 2, places.size() / 3);
        double farthest = 0; // from the line that the pictures tell of
        for (std::size_t v = 0; v < uvs.size() / 2; ++v) {
            const double x = uvs[2 * v] * double(pivots.width), y = uvs[2 * v + 1] * double(pivots.height);
            ASSERT_NEAR(x - std::floor(x), 0.5, 1e-3);
            ASSERT_NEAR(y - std::floor(y), 0.5, 1e-3);
            std::size_t texel = std::size_t(y) * pivots.width + std::size_t(x);
            // Unreal's place of the vertex: x, z and y of the file, in centimetres.
            const glm::dvec3 at = 100.0 * glm::dvec3(places[3 * v], places[3 * v + 2], places[3 * v + 1]);
            const Imf::Rgba& pivot = pivots.pixels[texel];
            const auto& packedAxis = axes.albedo[texel];
            const glm::dvec3 axis = glm::dvec3(packedAxis[0], packedAxis[1], packedAxis[2]) / 127.5 - 1.0;
            ASSERT_NEAR(glm::length(axis), 1, 0.02);
            const double extent = packedAxis[3] / 255.0 * 2048;
            const double along = glm::dot(at - glm::dvec3(pivot.r, pivot.g, pivot.b), axis);
            ASSERT_LT(along, extent + 40) << "the stem, and stems that follow it";
            const double on = std::clamp(along, 0.0, extent);
            farthest = std::max(farthest, glm::distance(at, glm::dvec3(pivot.r, pivot.g, pivot.b) + on * axis));
            int steps = 0;
            for (; unpacked(pivots.pixels[texel].a) != texel; ++steps) {
                ASSERT_LT(unpacked(pivots.pixels[texel].a), texel) << "parents come first";
                texel = unpacked(pivots.pixels[texel].a);
            }
            ASSERT_LT(steps, 4);
        }
        EXPECT_LT(farthest, 250) << "centimetres; stems bend, an axis does not";
    }
}

TEST(WindBones, ThreeJsPlaysTheClips) {
    needTool(hasModule("three"), "three.js (npm)");
    if (::testing::Test::HasFailure() || ::testing::Test::IsSkipped()) return;
    const CTemporaryFolder folder;
    write(folder / "bones.glb", "quaking_aspen", carrying(ExportedWind::Bones),
          {.wind = {.strength = 1}, .seconds = 3});
    const ProcessResult run = runProcess({"node", kTests + "three-clips.mjs", (folder / "bones.glb").string()},
                                         {.folder = inBin("..")});
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
                                             {.folder = inBin("..")});
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
