#include "stromar/app/LeafMesh.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/app/Prediction.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/io/LeafMeshReader.h"
#include "stromar/mesh/LeafMeshes.h"
#include "stromar/mesh/check/MeshCheck.h"
#include "stromar/params/TreeFile.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {
namespace {
namespace fs = std::filesystem;

/// A kite of length 4 and width 2, its foot at the origin and its middle raised by 0.2.
struct Kite {
    glm::vec3 along{0, 1, 0}, across{1, 0, 0};

    std::string obj() const {
        const glm::vec3 up = glm::cross(across, along);
        std::string text;
        const auto add = [&](const glm::vec3& v) {
            text += "v " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
        };
        add({0, 0, 0});
        add(across + 1.5f * along);
        add(4.f * along);
        add(-across + 1.5f * along);
        add(1.5f * along + 0.2f * up);
        return text + "vt 0.5 0\nvt 1 0.4\nvt 0.5 1\nvt 0 0.4\nvt 0.5 0.4\n"
                      "f 1/1 2/2 5/5\nf 2/2 3/3 5/5\nf 3/3 4/4 5/5\nf 4/4 1/1 5/5\n";
    }
};

class LeafMeshFile : public testing::Test {
protected:
    LeafMeshFile() {
        m_params.text.leafMesh = "kite.obj";
        m_params.folder = m_folder.path();
    }
    void keep(const std::string& obj, const std::string& name = "kite.obj") { writeFile(m_folder / name, obj); }
    std::shared_ptr<const TreeModel> model(Model kind = Model::Full, int lod = 0) const {
        return CTreeCreator().create(m_params, detailOf(kind, lod), CProgress(2));
    }
    std::string fault() const {
        try {
            leafMeshOf(m_params);
        } catch (const CError& e) {
            return e.what();
        }
        return "";
    }

    CTemporaryFolder m_folder;
    CParams m_params = [] {
        CParams params = preset("quaking_aspen");
        params.common.leafStalk = 0;
        return params;
    }();
};

TEST_F(LeafMeshFile, IsTheSameLeafHoweverItStands) {
    m_params.common.leafScaleX = 0.8;
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    int n = 0;
    for (const auto& [along, across] : {std::pair{y, x}, {y, -x}, {-z, x}, {z, -x}, {x, -y}, {x, z}, {-y, z}}) {
        m_params.text.leafMesh = "kite" + std::to_string(n++) + ".obj";
        keep(Kite{along, across}.obj(), m_params.text.leafMesh);
        const auto blade = leafMeshOf(m_params);
        ASSERT_EQ(blade->points.size(), 5u);
        ASSERT_EQ(blade->indices.size(), 12u);
        std::size_t found = 0;
        for (const LeafBlade::Point& point : blade->points) {
            EXPECT_NEAR(glm::length(point.normal), 1, 1e-6);
            EXPECT_GT(point.normal.z, 0.5) << "it faces up";
            const glm::dvec3 natural = point.place * glm::dvec3(0.8, 1, 0.8); // as wide as it is drawn
            for (const glm::dvec3& expected : {glm::dvec3(0, 0, 0), {0.25, 0.375, 0}, {0, 1, 0}, {-0.25, 0.375, 0}, {0, 0.375, 0.05}})
                if (glm::distance(natural, expected) < 1e-5) ++found;
            EXPECT_NEAR(point.texCoord.y > 0.99 ? natural.y : 1, 1, 1e-5) << "the texture's tip is the leaf's";
        }
        EXPECT_EQ(found, 5u);
    }
}

TEST_F(LeafMeshFile, StandsForEveryLeaf) {
    keep(Kite().obj());
    const auto tree = model();
    EXPECT_EQ(tree->leaves()->vertexCount(), 5 * tree->tree->leaves().size());
    EXPECT_TRUE(checkLeaves(*tree->leaves()->expanded(CProgress())).sound());
    EXPECT_GE(predictSize(m_params, detailOf(Model::Full)).vertices, double(tree->vertexCount()));
    const auto cards = model(Model::Full, 2);
    ASSERT_TRUE(cards->twig);
    EXPECT_EQ(cards->twig->leaves->vertexCount() % 5, 0u) << "cards show it too";
}

TEST_F(LeafMeshFile, IsReadAgainWhenItHasChanged) {
    keep(Kite().obj());
    EXPECT_EQ(leafMeshOf(m_params)->points.size(), 5u);
    keep("v 0 0 0\nv 1 2 0\nv -1 2 0\nf 1 2 3\n");
    fs::last_write_time(m_folder / "kite.obj", fs::file_time_type::clock::now() + std::chrono::seconds(5));
    EXPECT_EQ(leafMeshOf(m_params)->points.size(), 3u);
}

TEST_F(LeafMeshFile, SaysWhatIsWrong) {
    const std::string name = (m_folder / "kite.obj").string();
    EXPECT_TRUE(fault().starts_with(name + ": cannot be read")) << fault();
    for (const auto& [text, problem] : {std::pair<std::string, std::string>{"no mesh at all", "is no mesh that can be read"},
                                        {"v 0 0 0\nv 0 1 0\nv 0 2 0\nf 1 2 3\n", "no width"}}) {
        keep(text);
        fs::last_write_time(m_folder / "kite.obj", fs::file_time_type::clock::now() + std::chrono::seconds(text.size()));
        EXPECT_TRUE(fault().starts_with(name + ": ")) << fault();
        EXPECT_NE(fault().find(problem), std::string::npos) << fault();
    }
    std::string many;
    for (int i = 0; i < 8000; ++i)
        for (const char* corner : {"0 0", "1 0", "0 1"}) many += "v " + std::string(corner) + " " + std::to_string(i) + "\n";
    for (int i = 0; i < 8000; ++i)
        many += "f " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + " " + std::to_string(3 * i + 3) + "\n";
    keep(many, "many.obj");
    m_params.text.leafMesh = "many.obj";
    EXPECT_NE(fault().find("at most 20000 vertices"), std::string::npos) << fault();
    m_params.text.leafMesh = "leaf.fbx";
    EXPECT_NE(fault().find("neither .obj nor .glb"), std::string::npos) << fault();
    m_params.text.leafMesh = "mesh:kite";
    EXPECT_NE(fault().find("mesh:curved"), std::string::npos) << fault();
}

/// A .glb of one triangle that `meshes` primitives refer to, and `nodes` nodes to them.
std::string glb(std::size_t meshes, std::size_t nodes, std::size_t count = 3) {
    const float points[] = {0, 0, 0, 1, 4, 0, -1, 4, 0};
    std::string primitives, all, roots;
    for (std::size_t i = 0; i < meshes; ++i) primitives += std::string(i ? "," : "") + R"({"attributes":{"POSITION":0}})";
    for (std::size_t i = 0; i < nodes; ++i) {
        all += std::string(i ? "," : "") + R"({"mesh":0,"translation":[0,0,0.001]})";
        roots += (i ? "," : "") + std::to_string(i);
    }
    std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + all +
                       R"(],"meshes":[{"primitives":[)" + primitives + R"(]}],"buffers":[{"byteLength":36}],"bufferViews":[{"buffer":0,)" +
                       R"("byteOffset":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" + std::to_string(count) +
                       R"(,"type":"VEC3","min":[-1,0,0],"max":[1,4,0]}]})";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t value) {
        const auto small = static_cast<std::uint32_t>(value);
        return std::string(reinterpret_cast<const char*>(&small), 4);
    };
    return "glTF" + word(2) + word(12 + 8 + json.size() + 8 + 36) + word(json.size()) + "JSON" + json + word(36) + std::string("BIN\0", 4) +
           std::string(reinterpret_cast<const char*>(points), 36);
}

/// A few bytes can stand for more than there is memory.
TEST_F(LeafMeshFile, DoesNotGrowBeyondItsLimit) {
    const auto read = [&](const std::string& bytes, const std::string& name) {
        keep(bytes, name);
        m_params.text.leafMesh = name;
        return fault();
    };
    EXPECT_EQ(read(glb(1, 1), "one.glb"), "");
    EXPECT_EQ(leafMeshOf(m_params)->points.size(), 3u);
    EXPECT_EQ(read(glb(2, 50), "fifty.glb"), "");
    EXPECT_EQ(leafMeshOf(m_params)->points.size(), 300u) << "as often as it stands there";
    EXPECT_NE(read(glb(10, 3000), "nodes.glb").find("at most 20000 vertices"), std::string::npos);
    EXPECT_NE(read(glb(1, 1, 4'000'000'000), "count.glb").find("too large"), std::string::npos);
    EXPECT_NE(read(glb(400'000, 1), "meshes.glb").find("too large"), std::string::npos);
    EXPECT_NE(read(glb(1, 1).substr(0, 30), "cut.glb"), "");
    std::string deep = glb(1, 1);
    deep.replace(deep.find(R"("asset")"), 0, R"("extras":)" + std::string(200'000, '[') + std::string(200'000, ']') + ",");
    const auto length = static_cast<std::uint32_t>(deep.size() - 20 - 8 - 36);
    deep.replace(12, 4, std::string(reinterpret_cast<const char*>(&length), 4));
    EXPECT_NE(read(deep, "deep.glb").find("too large"), std::string::npos);
    EXPECT_NE(read(Kite().obj() + std::string(5 << 20, '#'), "long.obj").find("too large"), std::string::npos);
    EXPECT_EQ(read("mtllib /dev/zero\n" + Kite().obj(), "other.obj"), "") << "no other file is opened";
}

TEST_F(LeafMeshFile, AFileKeepsItsWidthABuiltInOneDoesNot) {
    const ParamRef width = *findParam("LeafScaleX");
    EXPECT_NE(inactiveReason(width, m_params), "");
    m_params.common.leafShare2 = 0.5;
    m_params.text.leaf2Mesh = "mesh:curved";
    EXPECT_EQ(inactiveReason(width, m_params), "") << "of the second kind";
}

TEST_F(LeafMeshFile, ABuiltInOneNeedsNoFile) {
    weberPenn(m_params).leaves = 3;
    for (const BuiltInLeaf& own : builtInLeaves()) {
        m_params.text.leafMesh = "mesh:" + std::string(own.name);
        const auto tree = model();
        EXPECT_TRUE(checkLeaves(*tree->leaves()->expanded(CProgress())).sound()) << own.name;
        EXPECT_GT(tree->leaves()->blade().points.size(), 4u);
        for (const LeafBlade::Point& point : tree->leaves()->blade().points) {
            EXPECT_NEAR(point.texCoord.x, point.place.x + 0.5, 1e-6) << "it shows the whole picture";
            EXPECT_NEAR(point.texCoord.y, point.place.y, 1e-6);
        }
    }
}

TEST_F(LeafMeshFile, PathsStartAtTheTreesFile) {
    keep(Kite().obj());
    writeFile(m_folder / "a.tree", "Format = 1\nLeafMesh = \"kite.obj\"\n");
    EXPECT_EQ(leafMeshOf(CTreeFile::read(m_folder / "a.tree").params())->points.size(), 5u);
}

TEST_F(LeafMeshFile, AGlbIsReadAsWell) {
    m_params.text.leafMesh = "";
    weberPenn(m_params).levels = 1;
    const auto pole = model(Model::Simple);
    exportModel(*pole, {}, m_folder / "pole.glb", CProgress(2));
    const LeafBlade mesh = readLeafMesh(m_folder / "pole.glb");
    EXPECT_EQ(mesh.indices.size(), 3 * pole->triangleCount());
    double height = 0;
    for (const LeafBlade::Point& point : mesh.points) height = std::max(height, point.place.y);
    EXPECT_NEAR(height, double(pole->bounds()->max.z), 1e-3 * height);
}

} // namespace
} // namespace stromar::test
