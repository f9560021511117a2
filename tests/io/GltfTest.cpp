// glTF by the Khronos validator and by the standard's own rules; large formats by Blender.
#include "Checkout.h"
#include "cli/Process.h"
#include "io/ExportedModels.h"
#include "io/Tools.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/app/Export.h"
#include "stromar/app/ExportRow.h"
#include "stromar/mesh/Shading.h"
#include "stromar/util/FileSet.h"
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
std::vector<std::shared_ptr<const TreeModel>> lodsOf(const CParams& params) {
    CTreeCreator creator;
    std::vector<std::shared_ptr<const TreeModel>> lods;
    for (const Detail& detail : detailTable())
        if (detail.model == Model::Full) lods.push_back(joined(creator.create(params, detail, CProgress(2)), CProgress(2)));
    return lods;
}

ExportOptions inOneFile() {
    ExportOptions options;
    options.lods = static_cast<int>(ExportedLods::InOneFile);
    return options;
}

/// What the validator says of a file.
Json validate(const fs::path& path) {
    const ProcessResult run =
        runProcess({"node", inSource("tests/io/validate-gltf.js"), path.string()}, {.folder = inBin("..")});
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out);
}

bool validatorIsInstalled() { return fs::exists(inBin("../node_modules/gltf-validator")); }
} // namespace

class GltfFile : public testing::TestWithParam<const char*> {
    void SetUp() override { needTool(validatorIsInstalled(), "the validator of glTF files (npm)"); }
};
INSTANTIATE_TEST_SUITE_P(All, GltfFile, testing::Values(".glb", ".gltf"),
                         [](const auto& one) { return std::string(one.param + 1); });

TEST_P(GltfFile, ARowOfTreesHasNoErrorsOrWarnings) {
    const CTemporaryFolder folder;
    const fs::path path = folder / ("row" + std::string(GetParam()));
    CParams autumn = sampleModel("aspen").params;
    autumn.common.season = 10;
    exportRow(std::vector<RowTree>{{sampleModel("aspen").params, 1, nullptr, 0, "summer"}, {autumn, 1, nullptr, 14, "autumn"}, {autumn, 0.3, nullptr, 25, "young"}}, {}, {}, {}, path, CProgress(2));
    const Json report = validate(path);
    EXPECT_EQ(report.at("issues").at("numErrors"), 0) << report.at("issues").dump(1);
    EXPECT_EQ(report.at("issues").at("numWarnings"), 0) << report.at("issues").dump(1);
}

TEST_P(GltfFile, HasNoErrorsOrWarnings) {
    const CTemporaryFolder folder;
    const fs::path single = folder / ("one" + std::string(GetParam())),
                   lods = folder / ("lods" + std::string(GetParam()));
    exportModel(sampleModel("tupelo"), {}, single, CProgress(2));
    exportModels(lodsOf(sampleModel("aspen").params), inOneFile(), {}, lods, CProgress(2));
    for (const fs::path& path : {single, lods}) {
        const Json report = validate(path);
        EXPECT_EQ(report.at("issues").at("numErrors"), 0) << report.at("issues").dump(1);
        EXPECT_EQ(report.at("issues").at("numWarnings"), 0) << report.at("issues").dump(1);
        const std::size_t pictures = path == single ? 2 : 3; // levels of detail have one of a twig
        EXPECT_EQ(report.at("info").at("resources").size(), 1 + 3 * pictures - 1) << "a buffer, pictures with their relief; the bark is as rough all over";
    }
}

TEST(GltfLods, NameTheLevelsOfDetail) {
    const CTemporaryFolder folder;
    const auto lods = lodsOf(sampleModel("small").params);
    exportModels(lods, inOneFile(), {}, folder / "oak.gltf", CProgress(2));
    const Json file = Json::parse(readFile(folder / "oak.gltf"));
    ASSERT_EQ(file.at("meshes").size(), 4u);
    ASSERT_EQ(file.at("nodes").size(), 4u);
    for (std::size_t lod = 0; lod < 4; ++lod) {
        EXPECT_EQ(file["meshes"][lod].at("name"), "oak_LOD" + std::to_string(lod));
        std::size_t corners = 0;
        for (const Json& primitive : file["meshes"][lod].at("primitives"))
            corners += file["accessors"][primitive.at("indices").get<std::size_t>()].at("count").get<std::size_t>();
        EXPECT_EQ(corners, 3 * lods[lod]->triangleCount());
    }
    EXPECT_EQ(file["nodes"][0]["extensions"]["MSFT_lod"]["ids"], (Json{1, 2, 3}));
    EXPECT_EQ(file["nodes"][0]["extras"]["MSFT_screencoverage"], (Json{0.5, 0.25, 0.1, 0.01}));
    EXPECT_EQ(file["scenes"][0]["nodes"], (Json{0}));
    EXPECT_EQ(file["extensionsUsed"], (Json{"MSFT_lod"}));
    EXPECT_FALSE(file.contains("extensionsRequired")) << "readers that know no levels of detail show the finest";
}

TEST(GltfLods, MaterialsAreWhatEnginesExpect) {
    const CTemporaryFolder folder;
    exportModel(sampleModel("small"), {}, folder / "oak.gltf", CProgress(2));
    const Json materials = Json::parse(readFile(folder / "oak.gltf")).at("materials");
    EXPECT_EQ(materials[0]["name"], "bark");
    EXPECT_FALSE(materials[0].contains("alphaMode"));
    EXPECT_EQ(materials[1]["name"], "leaf");
    EXPECT_EQ(materials[1]["alphaMode"], "MASK");
    EXPECT_EQ(materials[1]["doubleSided"], true);
    for (const Json& material : materials) EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 0.0);
}

TEST(Shading, TangentsAreSquareToTheNormalsAndFollowThePicture) {
    for (const auto& mesh : sampleModel("aspen").meshes()) {
        const auto tangents = tangentsOf(*mesh);
        ASSERT_EQ(tangents.size(), mesh->vertexCount());
        std::size_t along = 0;
        for (std::size_t t = 0; t < mesh->indices.size(); t += 3) {
            const std::uint32_t a = mesh->indices[t], b = mesh->indices[t + 1];
            const glm::vec3 edge = mesh->positions[b] - mesh->positions[a];
            const float du = mesh->texCoords[b].x - mesh->texCoords[a].x,
                        dv = mesh->texCoords[b].y - mesh->texCoords[a].y;
            if (std::abs(du) > 10 * std::abs(dv)) along += glm::dot(edge, glm::vec3(tangents[a])) * du > 0 ? 0 : 1;
        }
        EXPECT_LT(double(along), 0.02 * double(mesh->triangleCount())) << mesh->name;
        for (std::size_t v = 0; v < tangents.size(); ++v) {
            ASSERT_NEAR(glm::length(glm::vec3(tangents[v])), 1, 1e-4);
            ASSERT_NEAR(glm::dot(glm::vec3(tangents[v]), mesh->normals[v]), 0, 1e-4);
            ASSERT_EQ(std::abs(tangents[v].w), 1);
        }
    }
}

TEST(Shading, TheCrownsInsideAndForksAreDarker) {
    const TreeModel& model = sampleModel("tupelo");
    const Crown crown = crownOf(model.meshes());
    double inside = 0, outside = 0;
    std::size_t insides = 0, outsides = 0;
    const auto expanded = model.leaves()->expanded(CProgress());
    const CMesh& leaves = *expanded;
    for (std::size_t v = 0; v < leaves.vertexCount(); ++v) {
        const float place = glm::length((leaves.positions[v] - crown.centre) / crown.radii);
        if (place < 0.4f) inside += ambientAt(crown, leaves, v), ++insides;
        if (place > 0.8f) outside += ambientAt(crown, leaves, v), ++outsides;
    }
    ASSERT_GT(insides, 100u);
    ASSERT_GT(outsides, 100u);
    EXPECT_LT(inside / double(insides), 0.75 * outside / double(outsides));
    const CMesh& branches = *model.stems[1];
    EXPECT_LT(branches.looks[0].skyVisibility, 140) << "the foot of a branch";
    EXPECT_GT(std::ranges::max(branches.looks, {}, &VertexLook::skyVisibility).skyVisibility, 250);
}

TEST_P(GltfFile, LightComesThroughLeavesOnRequest) {
    const CTemporaryFolder folder;
    const fs::path path = folder / ("oak" + std::string(GetParam()));
    ExportOptions options;
    options.leafLight = static_cast<int>(ExportedLeafLight::Transmission);
    CTreeCreator creator;
    exportTree(creator, sampleModel("small").params, options, {}, path, CProgress(2));
    const Json report = validate(path);
    EXPECT_EQ(report.at("issues").at("numErrors"), 0) << report.at("issues").dump(1);
    EXPECT_EQ(report.at("info").at("extensionsUsed"), (Json{"KHR_materials_diffuse_transmission"}));
    if (path.extension() != ".gltf") return;
    const Json file = Json::parse(readFile(path));
    for (const Json& material : file.at("materials")) {
        EXPECT_EQ(material.contains("extensions"), material["name"] == "leaf") << material["name"];
        if (!material.contains("extensions")) continue;
        EXPECT_EQ(material["extensions"]["KHR_materials_diffuse_transmission"]["diffuseTransmissionColorTexture"]["index"], material["pbrMetallicRoughness"]["baseColorTexture"]["index"]);
    }
    EXPECT_FALSE(file.contains("extensionsRequired"));
}

TEST(GltfIndices, AreAsShortAsTheMeshAllows) {
    const CExported small(sampleModel("small"), ".gltf"), large(sampleModel("tupelo"), ".gltf");
    for (const CExported* one : {&small, &large}) {
        const Json file = Json::parse(readFile(one->path()));
        for (const Json& mesh : file["meshes"])
            for (const Json& primitive : mesh["primitives"]) {
                const auto accessor = [&](const Json& index) { return file["accessors"][index.get<std::size_t>()]; };
                const bool few = accessor(primitive["attributes"]["POSITION"])["count"] <= 65535;
                EXPECT_EQ(accessor(primitive["indices"])["componentType"], few ? 5123 : 5125) << mesh["name"];
            }
    }
}

class BlenderReads : public testing::TestWithParam<const char*> {
    void SetUp() override { needTool(runProcess({"blender", "--version"}).status == 0, "Blender"); }
};
INSTANTIATE_TEST_SUITE_P(Slow, BlenderReads, testing::Values(".glb", ".gltf", ".obj", ".dae", ".fbx"),
                         [](const auto& one) { return std::string(one.param + 1); });

TEST_P(BlenderReads, TheWholeModel) {
    const TreeModel& model = sampleModel("aspen");
    const CExported file(model, GetParam());
    const ProcessResult run = runProcess(
        {"blender", "-b", "--factory-startup", "-P", inSource("tests/io/blender-stats.py"), "--", file.path()});
    const auto at = run.out.find("STATS ");
    ASSERT_NE(at, std::string::npos) << run.out << run.err;
    const Json stats = Json::parse(run.out.substr(at + 6, run.out.find('\n', at) - at - 6));
    EXPECT_EQ(stats.at("triangles"), model.triangleCount());
    EXPECT_EQ(stats.at("materials"), (Json{"bark", "leaf"}));
    EXPECT_EQ(stats.at("objects"), (Json{"branches_1", "branches_2", "leaves", "trunk"}));
    const Format& format = *formatOf(file.path());
    Json images = Json::array(); // of leaf and bark: albedo, normals, the leaf's roughness and opacity
    const bool twice = format.ending == ".fbx"; // Blender has the leaf's albedo once more, for its alpha
    images.insert(images.end(), std::size_t(1) + format.has(Content::NormalMaps) + format.has(Content::RoughnessMaps) + format.opacity + twice, Json{512, 512});
    images.insert(images.end(), format.has(Content::NormalMaps) ? 2 : 1, Json{1024, 1024});
    EXPECT_EQ(stats.at("images"), images);
    EXPECT_EQ(stats.at("without_uv"), 0);
    const Bounds box = boundsOf(model, zUp);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(stats.at("min").at(std::size_t(i)), box.min[i], 1e-3);
        EXPECT_NEAR(stats.at("max").at(std::size_t(i)), box.max[i], 1e-3);
    }
}

} // namespace stromar::test
