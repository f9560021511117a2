// FBX and USD by three.js; what its readers do not look at, by the bytes.
#include "Checkout.h"
#include "cli/Process.h"
#include "io/ExportedModels.h"
#include "io/NodeReads.h"
#include "io/Tools.h"
#include "stromar/app/Export.h"
#include "stromar/util/FileSet.h"
#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

namespace stromar::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
std::uint64_t numberAt(const std::string& bytes, std::size_t at, std::size_t size) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < size; ++i) number |= std::uint64_t(static_cast<unsigned char>(bytes.at(at + i))) << (8 * i);
    return number;
}
} // namespace

class ThreeReads : public testing::TestWithParam<const char*> {
    void SetUp() override { needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)"); }
};
INSTANTIATE_TEST_SUITE_P(All, ThreeReads, testing::Values(".fbx", ".usda", ".usdz"), [](const auto& one) { return std::string(one.param + 1); });

TEST_P(ThreeReads, TheWholeModel) {
    const TreeModel& model = sampleModel("aspen");
    const CExported file(model, GetParam());
    const Json stats = readByThree(file.path());
    EXPECT_EQ(stats.at("triangles"), model.triangleCount());
    EXPECT_EQ(stats.at("objects"), (Json{"branches_1", "branches_2", "leaves", "trunk"}));
    EXPECT_EQ(stats.at("scale"), 1);
    EXPECT_EQ(stats.at("opaque"), 3) << "leaves are cut out";
    const bool fbx = std::string(GetParam()) == ".fbx";
    const Bounds box = boundsOf(model, yUp);
    const double unit = fbx ? 100 : 1;
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(stats.at("min").at(std::size_t(i)), unit * box.min[i], 1e-3 * unit);
        EXPECT_NEAR(stats.at("max").at(std::size_t(i)), unit * box.max[i], 1e-3 * unit);
    }
    EXPECT_EQ(stats.at("pictures").size(), 5u) << "of the bark two; the leaf's roughness is not connected in FBX, but its opacity is a picture of its own";
    for (const std::string picture : stats.at("pictures")) EXPECT_TRUE(picture.starts_with("blob:") || fs::exists(picture)) << picture;
}

TEST(FbxFiles, InMetresAndInCentimetresAsTheScaleSays) {
    needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)");
    if (::testing::Test::HasFailure() || ::testing::Test::IsSkipped()) return;
    const CTemporaryFolder folder;
    const TreeModel& model = sampleModel("small");
    const double height = boundsOf(model, yUp).max.y;
    for (const double scale : {1.0, 0.01}) {
        ExportOptions options;
        options.scale = scale;
        exportModels({std::shared_ptr<const TreeModel>(std::shared_ptr<void>(), &model)}, options, {}, folder / "x.fbx", CProgress(2));
        EXPECT_NEAR(readByThree(folder / "x.fbx").at("max").at(1).get<double>(), 100 * scale * height, 1e-3 * 100 * scale * height);
    }
}

TEST(FbxFiles, HoldLevelsOfDetailColoursAndASecondUv) {
    needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)");
    if (::testing::Test::HasFailure() || ::testing::Test::IsSkipped()) return;
    const CTemporaryFolder folder;
    ExportOptions options;
    options.lods = static_cast<int>(ExportedLods::InOneFile);
    options.wind = static_cast<int>(ExportedWind::Unity);
    CTreeCreator creator;
    exportTree(creator, sampleModel("small").params, options, {}, folder / "oak.fbx", CProgress(2));
    const Json stats = readByThree(folder / "oak.fbx");
    EXPECT_EQ(stats.at("objects"), (Json{"oak_LOD0", "oak_LOD1", "oak_LOD2", "oak_LOD3"}));
    EXPECT_NE(readFile(folder / "oak.fbx").find("LodGroup"), std::string::npos) << "three.js does not look at it";
    EXPECT_EQ(stats.at("colours"), 4);
    EXPECT_EQ(stats.at("uv2"), 4);
}

TEST(FbxFiles, HoldTheirPicturesWhenThatIsWanted) {
    const CTemporaryFolder folder;
    ExportOptions options;
    options.textures = static_cast<int>(ExportedTextures::Embed);
    CTreeCreator creator;
    exportTree(creator, sampleModel("small").params, options, {}, folder / "oak.fbx", CProgress(2));
    EXPECT_EQ(folder.names().size(), 1u) << "nothing beside it";
    const std::string bytes = readFile(folder / "oak.fbx");
    std::size_t pictures = 0;
    for (std::size_t at = bytes.find("\x89PNG\r\n"); at != std::string::npos; at = bytes.find("\x89PNG\r\n", at + 1)) ++pictures;
    EXPECT_EQ(pictures, 5u);
}

TEST(FbxFiles, EveryRecordEndsWhereItSays) {
    const CExported file(sampleModel("small"), ".fbx");
    const std::string bytes = readFile(file.path());
    ASSERT_TRUE(bytes.starts_with("Kaydara FBX Binary  "));
    std::size_t at = 27, records = 0;
    while (const std::size_t end = numberAt(bytes, at, 4)) {
        ASSERT_GT(end, at);
        ASSERT_LT(end, bytes.size());
        at = end;
        ++records;
    }
    EXPECT_GE(records, 9u) << "header, settings, documents, definitions, objects, connections …";
}

TEST(UsdPackages, AreStoredAtMultiplesOf64Bytes) {
    const CExported file(sampleModel("small"), ".usdz");
    const std::string bytes = readFile(file.path());
    std::vector<std::string> names;
    for (std::size_t at = 0; numberAt(bytes, at, 4) == 0x04034b50;) {
        const std::size_t nameSize = numberAt(bytes, at + 26, 2), extra = numberAt(bytes, at + 28, 2), data = at + 30 + nameSize + extra;
        EXPECT_EQ(numberAt(bytes, at + 8, 2), 0u) << "stored";
        EXPECT_EQ(data % 64, 0u);
        names.push_back(bytes.substr(at + 30, nameSize));
        at = data + numberAt(bytes, at + 18, 4);
    }
    ASSERT_EQ(names.size(), 6u) << "the tree and five pictures";
    EXPECT_TRUE(names.front().ends_with(".usda")) << "the first file is the scene";
    EXPECT_EQ(runProcess({"unzip", "-tq", file.path()}).status, 0);
}

namespace {
/// The numbers of an array behind its name, the first after a place in the text.
std::vector<float> numbersOf(const std::string& text, const std::string& name, std::size_t after) {
    const std::size_t begin = text.find(name + " = [", after) + name.size() + 4, end = text.find(']', begin);
    std::string all = text.substr(begin, end - begin);
    std::ranges::replace_if(all, [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
    std::istringstream stream(all);
    return {std::istream_iterator<float>(stream), {}};
}

struct Box {
    glm::vec3 min{1e30f}, max{-1e30f};
    void add(const glm::vec3& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
};
} // namespace

TEST(UsdFiles, HoldLevelsOfDetailAsVariants) {
    const CTemporaryFolder folder;
    ExportOptions options;
    options.lods = static_cast<int>(ExportedLods::InOneFile);
    CTreeCreator creator;
    const auto lods = exportTree(creator, sampleModel("small").params, options, {}, folder / "oak.usda", CProgress(2));
    const std::string text = readFile(folder / "oak.usda");
    EXPECT_NE(text.find("variants = {\n        string LOD = \"LOD0\"\n    }\n    prepend variantSets = \"LOD\""), std::string::npos);
    std::size_t at = text.find("variantSet \"LOD\" = {");
    ASSERT_NE(at, std::string::npos);
    for (int lod = 0; lod < 4; ++lod) {
        at = text.find("\"LOD" + std::to_string(lod) + "\" {", at);
        ASSERT_NE(at, std::string::npos);
        const std::size_t end = lod < 3 ? text.find("\"LOD" + std::to_string(lod + 1) + "\" {", at) : text.find("def Scope \"Looks\"", at);
        std::size_t triangles = 0;
        for (std::size_t mesh = text.find("def Mesh", at); mesh < end; mesh = text.find("def Mesh", mesh + 1))
            triangles += numbersOf(text, "faceVertexCounts", mesh).size();
        EXPECT_EQ(triangles, lods[static_cast<std::size_t>(lod)]->triangleCount()) << lod;
    }
    EXPECT_EQ(std::ranges::count(text, '{'), std::ranges::count(text, '}'));
}

/// By the definition of a PointInstancer: scaled, then turned, then moved.
TEST(UsdFiles, HoldLeavesAsInstances) {
    const CTemporaryFolder folder;
    CTreeCreator creator;
    ExportOptions options;
    exportTree(creator, sampleModel("small").params, options, {}, folder / "plain.usda", CProgress(2));
    options.instances = static_cast<int>(ExportedInstances::Leaves);
    exportTree(creator, sampleModel("small").params, options, {}, folder / "instances.usda", CProgress(2));
    const std::string plain = readFile(folder / "plain.usda"), text = readFile(folder / "instances.usda");
    EXPECT_LT(text.size(), plain.size());
    Box wanted, found;
    const auto leaves = numbersOf(plain, "point3f[] points", plain.find("def Mesh \"leaves\""));
    for (std::size_t i = 0; i + 2 < leaves.size(); i += 3) wanted.add({leaves[i], leaves[i + 1], leaves[i + 2]});
    const std::size_t at = text.find("def PointInstancer \"leaves\"");
    ASSERT_NE(at, std::string::npos);
    EXPECT_NE(text.find("rel prototypes = </instances/leaves/prototype>", at), std::string::npos);
    const auto places = numbersOf(text, "positions", at), turns = numbersOf(text, "orientations", at), scales = numbersOf(text, "scales", at),
               points = numbersOf(text, "point3f[] points", at);
    ASSERT_EQ(places.size() / 3, numbersOf(text, "protoIndices", at).size());
    ASSERT_EQ(turns.size() / 4, places.size() / 3);
    ASSERT_EQ(places.size() / 3 * points.size(), leaves.size());
    for (std::size_t i = 0; i < places.size() / 3; ++i)
        for (std::size_t v = 0; v + 2 < points.size(); v += 3) {
            const glm::vec3 scaled(points[v] * scales[3 * i], points[v + 1] * scales[3 * i + 1], points[v + 2] * scales[3 * i + 2]);
            const glm::vec3 axis(turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]);
            found.add(glm::vec3(places[3 * i], places[3 * i + 1], places[3 * i + 2]) + scaled + 2.0f * glm::cross(axis, glm::cross(axis, scaled) + turns[4 * i] * scaled));
        }
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(found.min[i], wanted.min[i], 1e-3);
        EXPECT_NEAR(found.max[i], wanted.max[i], 1e-3);
    }
}

TEST(UsdFiles, OfAMotionShowTheGrownTreeWithoutIt) {
    needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)");
    const CTemporaryFolder folder;
    const TreeModel& model = sampleModel("small");
    Motion growth;
    growth.frames = 3;
    exportTimeSamples(model.params, {}, growth, 1, true, SizeLimits(), {}, folder / "oak.usda", CProgress(2));
    EXPECT_EQ(readByThree(folder / "oak.usda").at("triangles"), model.triangleCount());
}

TEST(UsdFiles, SayWhatAStageIs) {
    const CExported file(sampleModel("small"), ".usda");
    const std::string text = readFile(file.path());
    for (const char* said : {"#usda 1.0", "defaultPrim = \"tree\"", "metersPerUnit = 1", "upAxis = \"Y\"", "uniform bool doubleSided = 1", "inputs:opacityThreshold = 0.4",
                             "subdivisionScheme = \"none\"", "\"UsdPreviewSurface\""})
        EXPECT_NE(text.find(said), std::string::npos) << said;
}

} // namespace stromar::test
