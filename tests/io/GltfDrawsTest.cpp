// Fewer draws: one object for each material, one picture for all leaves.
#include "Checkout.h"
#include "io/ExportedModels.h"
#include "io/NodeReads.h"
#include "io/Tools.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/app/ExportRow.h"
#include "stromar/params/ParamText.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/FileSet.h"
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
/// With leaves and blossoms; one bark.
CParams cherry() {
    CParams params = preset("wild_cherry");
    findParam("Season")->set(params, 4.4);
    findParam("LeafColourV")->set(params, 0.5);
    params.text.bark1Texture = params.text.bark2Texture = params.text.bark3Texture = "";
    return params;
}

void write(const fs::path& file, const CParams& params, const ExportOptions& options) {
    CTreeCreator creator;
    exportTree(creator, params, options, {}, file, CProgress(2));
}

/// A .gltf file and its buffer.
class CRead {
public:
    explicit CRead(const fs::path& file) : m_folder(file.parent_path()), m_json(Json::parse(readFile(file))) {
        m_buffer = readFile(m_folder / m_json["buffers"][0]["uri"].get<std::string>());
    }
    const Json& json() const { return m_json; }
    const Json& primitive(const std::string& mesh) const {
        for (const Json& one : m_json["meshes"])
            if (one["name"] == mesh) return one["primitives"][0];
        throw std::runtime_error("no mesh " + mesh);
    }
    std::string material(const std::string& mesh) const { return m_json["materials"][primitive(mesh)["material"].get<std::size_t>()]["name"]; }

    /// In the middle of every triangle, by its picture's name for the use.
    std::vector<glm::vec4> colours(const std::string& mesh, bool ofNormals) const {
        const Json& own = primitive(mesh);
        const Json& look = m_json["materials"][own["material"].get<std::size_t>()];
        const Json& texture = ofNormals ? look["normalTexture"] : look["pbrMetallicRoughness"]["baseColorTexture"];
        const Json& image = m_json["images"][m_json["textures"][texture["index"].get<std::size_t>()]["source"].get<std::size_t>()];
        const TextureMaps picture = readPng(m_folder / image["uri"].get<std::string>());
        const std::vector<float> uv = values<float>(own["attributes"]["TEXCOORD_0"]);
        const std::vector<std::uint32_t> corners = values<std::uint32_t>(own["indices"]);
        std::vector<glm::vec4> colours;
        for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
            glm::vec2 middle(0);
            for (std::size_t c = 0; c < 3; ++c) middle += glm::vec2(uv[2 * corners[t + c]], uv[2 * corners[t + c] + 1]) / 3.0f;
            const int x = glm::clamp(int(middle.x * float(picture.width)), 0, picture.width - 1), y = glm::clamp(int(middle.y * float(picture.height)), 0, picture.height - 1);
            const auto& pixel = picture.albedo[picture.at(x, y)];
            colours.emplace_back(pixel[0], pixel[1], pixel[2], pixel[3]);
        }
        return colours;
    }

private:
    template <typename Value> std::vector<Value> values(const Json& index) const {
        const Json& accessor = m_json["accessors"][index.get<std::size_t>()];
        const Json& view = m_json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const std::size_t at = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0}), bytes = view["byteLength"].get<std::size_t>();
        const bool narrow = accessor["componentType"] == 5123;
        std::vector<Value> all(bytes / (narrow ? 2 : sizeof(Value)));
        if (!narrow) {
            std::memcpy(all.data(), m_buffer.data() + at, bytes);
            return all;
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            std::uint16_t value = 0;
            std::memcpy(&value, m_buffer.data() + at + 2 * i, 2);
            all[i] = static_cast<Value>(value);
        }
        all.resize(accessor["count"].get<std::size_t>() * (accessor["type"] == "VEC2" ? 2 : 1));
        return all;
    }

    fs::path m_folder;
    Json m_json;
    std::string m_buffer;
};

double meanDifference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(glm::abs(a[i] - b[i]), glm::vec4(0.25f));
    return sum / double(a.size());
}
} // namespace

class GltfDraws : public testing::TestWithParam<const char*> {
    void SetUp() override { needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)"); }
};
INSTANTIATE_TEST_SUITE_P(All, GltfDraws, testing::Values("0", "2"), [](const auto& one) { return std::string("lod") + one.param; });

TEST_P(GltfDraws, AreAsManyAsMaterials) {
    const CTemporaryFolder folder;
    write(folder / "levels.glb", cherry(), chosen({{"lod", GetParam()}}));
    write(folder / "materials.glb", cherry(), chosen({{"lod", GetParam()}, {"objects", "materials"}}));
    const Json plain = readByThree(folder / "levels.glb"), merged = readByThree(folder / "materials.glb");
    EXPECT_GT(plain.at("objects").size(), merged.at("objects").size());
    EXPECT_EQ(merged.at("objects").size(), merged.at("looks"));
    for (const char* same : {"triangles", "vertices", "materials", "min", "max"}) EXPECT_EQ(merged.at(same), plain.at(same)) << same;
    for (const char* mean : {"normal", "uv"})
        for (std::size_t i = 0; i < plain.at(mean).size(); ++i) EXPECT_NEAR(merged.at(mean).at(i), plain.at(mean).at(i), 1e-6) << mean << i;
}

TEST_P(GltfDraws, AreTwoWithAnAtlas) {
    const CTemporaryFolder folder;
    write(folder / "tree.glb", cherry(), chosen({{"lod", GetParam()}, {"objects", "materials"}, {"atlas", "leaves"}}));
    const Json stats = readByThree(folder / "tree.glb");
    EXPECT_EQ(stats.at("objects"), (Json{"bark", "foliage"}));
    EXPECT_EQ(stats.at("materials").size(), 2u);
}

TEST_P(GltfDraws, ShowTheSameWithAnAtlas) {
    const CTemporaryFolder folder;
    write(folder / "plain.gltf", cherry(), chosen({{"lod", GetParam()}}));
    write(folder / "atlas.gltf", cherry(), chosen({{"lod", GetParam()}, {"atlas", "leaves"}}));
    const CRead plain(folder / "plain.gltf"), atlas(folder / "atlas.gltf");
    std::size_t compared = 0;
    for (const Json& mesh : plain.json()["meshes"]) {
        const std::string name = mesh["name"];
        const std::string own = plain.material(name);
        EXPECT_EQ(atlas.material(name), own == "bark" ? own : "foliage");
        for (const bool normals : {false, true}) {
            if (own == "bark") continue;
            const auto before = plain.colours(name, normals), after = atlas.colours(name, normals);
            ASSERT_EQ(after.size(), before.size());
            EXPECT_LT(meanDifference(after, before), 4) << name << (normals ? ", normals" : "");
            ++compared;
        }
    }
    EXPECT_EQ(compared, 4u) << "leaves or twigs, and blossoms";
    EXPECT_TRUE(folder.names().contains("atlas_foliage_normal.png"));
    EXPECT_FALSE(folder.names().contains("atlas_leaf.png"));
}

TEST(GltfMaterials, AreThoseThatMeshesShow) {
    const CTemporaryFolder folder;
    write(folder / "tree.gltf", cherry(), chosen({{"lod", "2"}}));
    const CRead file(folder / "tree.gltf");
    std::set<std::string> shown;
    for (const Json& mesh : file.json()["meshes"]) shown.insert(file.material(mesh["name"]));
    EXPECT_EQ(shown, (std::set<std::string>{"bark", "blossom", "twig"}));
    EXPECT_EQ(file.json()["materials"].size(), 3u);
    EXPECT_FALSE(folder.names().contains("tree_leaf.png"));
}

TEST(GltfAtlas, IsOneForAllLevelsOfDetail) {
    const CTemporaryFolder folder;
    write(folder / "tree.gltf", cherry(), chosen({{"lods", "file-each"}, {"atlas", "leaves"}}));
    for (int lod = 0; lod < 4; ++lod) {
        const CRead file(folder / ("tree_LOD" + std::to_string(lod) + ".gltf"));
        EXPECT_EQ(file.json()["materials"].back()["name"], "foliage") << lod;
        for (const Json& image : file.json()["images"]) EXPECT_TRUE(folder.names().contains(image["uri"])) << image;
    }
    EXPECT_FALSE(folder.names().contains("tree_twig.png"));
}

TEST(GltfAtlas, IsOneForAllFramesOfAGrowingTree) {
    const CTemporaryFolder folder;
    Motion growth;
    growth.frames = 3;
    const auto frames = [&](const char* lod, const char* name) {
        exportFrames(cherry(), chosen({{"atlas", "leaves"}, {"lod", lod}}), growth, 1, true, SizeLimits(), {}, folder / name, [](const fs::path&) {}, CProgress(2));
    };
    frames("0", "tree.gltf");
    for (int i = 1; i <= 3; ++i)
        for (const Json& image : CRead(framePath(folder / "tree.gltf", std::size_t(i - 1), 3)).json()["images"])
            EXPECT_TRUE(folder.names().contains(image["uri"])) << image;
    EXPECT_TRUE(folder.names().contains("tree_foliage.png"));
    EXPECT_FALSE(folder.names().contains("tree_leaf.png"));
    EXPECT_THROW(frames("2", "cards.gltf"), CError);
}

TEST(GltfAtlas, HoldsInstancesAndRows) {
    needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)");
    if (::testing::Test::HasFailure() || ::testing::Test::IsSkipped()) return;
    const CTemporaryFolder folder;
    write(folder / "one.glb", cherry(), chosen({{"objects", "materials"}, {"atlas", "leaves"}, {"instances", "leaves"}}));
    const Json one = readByThree(folder / "one.glb");
    EXPECT_EQ(one.at("materials").size(), 2u);
    EXPECT_EQ(one.at("objects").size(), 3u) << "each kind of instances is an object";
    EXPECT_GT(one.at("instances"), 1000);
    std::vector<RowTree> trees{{.params = cherry(), .name = "a"}, {.params = cherry(), .place = 10, .name = "b"}};
    exportRow(trees, chosen({{"objects", "materials"}, {"atlas", "leaves"}, {"lod", "2"}}), SizeLimits(), {}, folder / "row.glb", CProgress(2));
    const Json row = readByThree(folder / "row.glb");
    EXPECT_EQ(row.at("objects"), (Json{"a_bark", "a_foliage", "b_bark", "b_foliage"}));
    EXPECT_EQ(row.at("materials").size(), 2u);
}

TEST(GltfAtlas, RefusesLeavesThatRepeatTheirPicture) {
    const CTemporaryFolder folder;
    CFileSet files;
    files.create(folder / "leaf.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    files.commit();
    CParams params = cherry();
    params.text.leafMesh = (folder / "leaf.obj").string();
    EXPECT_THROW(write(folder / "tree.glb", params, chosen({{"atlas", "leaves"}})), CError);
    EXPECT_EQ(folder.names(), (std::set<std::string>{"leaf.obj"}));
}

} // namespace stromar::test
