// Models read back by assimp, which has readers of its own for these formats.
#include "io/ExportedModels.h"
#include "mesh/SampleTrees.h"
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace stromar::test {

namespace {
struct ReadModel {
    std::vector<Corner> corners;                 ///< right-handed, y up
    std::vector<std::string> materials;          ///< of each triangle
    std::map<std::string, std::string> textures; ///< by material
    std::size_t meshCount = 0, maxFaces = 0;
};

glm::vec3 toGlm(const aiVector3D& v) { return {v.x, v.y, v.z}; }

void addMesh(const aiMesh& mesh, const aiMatrix4x4& place, const std::string& material, ReadModel& model) {
    ASSERT_TRUE(mesh.HasTextureCoords(0)) << mesh.mName.C_Str();
    const aiMatrix3x3 turn(place);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        ASSERT_EQ(mesh.mFaces[f].mNumIndices, 3u);
        for (unsigned c = 0; c < 3; ++c) {
            const unsigned v = mesh.mFaces[f].mIndices[c];
            const aiVector3D& t = mesh.mTextureCoords[0][v];
            const aiVector3D normal = mesh.HasNormals() ? turn * mesh.mNormals[v] : aiVector3D();
            model.corners.push_back({toGlm(place * mesh.mVertices[v]), toGlm(normal), {t.x, t.y}});
        }
        model.materials.push_back(material);
    }
    ++model.meshCount;
    model.maxFaces = std::max<std::size_t>(model.maxFaces, mesh.mNumFaces);
}

void addNode(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, ReadModel& model) {
    const aiMatrix4x4 place = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
        addMesh(mesh, place, scene.mMaterials[mesh.mMaterialIndex]->GetName().C_Str(), model);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) addNode(scene, *node.mChildren[i], place, model);
}

ReadModel read(const std::string& path) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path, 0);
    ReadModel model;
    if (!scene) {
        ADD_FAILURE() << importer.GetErrorString();
        return model;
    }
    EXPECT_FALSE(scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE);
    addNode(*scene, *scene->mRootNode, aiMatrix4x4(), model);
    for (unsigned i = 0; i < scene->mNumMaterials; ++i) {
        aiString file;
        const std::string name = scene->mMaterials[i]->GetName().C_Str();
        if (scene->mMaterials[i]->GetTexture(aiTextureType_DIFFUSE, 0, &file) == aiReturn_SUCCESS)
            model.textures[name] = file.C_Str();
    }
    return model;
}

Bounds boundsOf(const std::vector<Corner>& corners) {
    Bounds box{corners.front().position, corners.front().position};
    for (const Corner& c : corners) box = {glm::min(box.min, c.position), glm::max(box.max, c.position)};
    return box;
}

double barkVolume(const ReadModel& model) {
    double volume = 0;
    for (std::size_t t = 0; t < model.materials.size(); ++t) {
        if (model.materials[t] != "bark") continue;
        const glm::dvec3 a(model.corners[3 * t].position), b(model.corners[3 * t + 1].position),
            c(model.corners[3 * t + 2].position);
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return volume;
}

/// By how many places the first triangle's corners are turned.
std::size_t cornersTurned(const std::vector<Corner>& got, const std::vector<Corner>& wanted) {
    const auto gap = [&](std::size_t turn) { return glm::distance(got[0].position, wanted[turn].position); };
    return gap(0) <= gap(1) && gap(0) <= gap(2) ? 0 : gap(1) <= gap(2) ? 1 : 2;
}
} // namespace

class AssimpReads : public testing::TestWithParam<ReadCase> {};
INSTANTIATE_TEST_SUITE_P(All, AssimpReads, testing::ValuesIn(readCases(kAssimp, {"small", "aspen", "tupelo"})), labelOf);

TEST_P(AssimpReads, TheWholeModel) {
    const TreeModel& model = sampleModel(GetParam().sample);
    const CExported file(model, GetParam().ending);
    const ReadModel got = read(file.path());
    const std::vector<Corner> wanted = cornersOf(model, yUp);
    ASSERT_EQ(got.corners.size(), wanted.size());
    expectNear(boundsOf(got.corners), boundsOf(model, yUp));
    EXPECT_NEAR(barkVolume(got), barkVolume(model), 0.01 * barkVolume(model)) << "the bark does not face outwards";
    std::map<std::string, std::string> pictures = {{"bark", "tree_bark.png"}, {"leaf", "tree_leaf.png"}};
    if (GetParam().ending == ".glb") pictures = {{"bark", "*0"}, {"leaf", "*2"}}; // assimp's names of embedded ones
    EXPECT_EQ(got.textures, pictures);
    EXPECT_EQ(std::set<std::string>(got.materials.begin(), got.materials.end()),
              (std::set<std::string>{"bark", "leaf"}));
}

/// These formats keep the triangles in their order; a cyclic turn of the corners is no change.
TEST_P(AssimpReads, EveryCornerInItsPlace) {
    const TreeModel& model = sampleModel(GetParam().sample);
    const ReadModel got = read(CExported(model, GetParam().ending).path());
    const std::vector<Corner> wanted = cornersOf(model, yUp);
    ASSERT_EQ(got.corners.size(), wanted.size());
    const std::size_t leafCorners = 3 * model.leaves()->triangleCount();
    const float tolerance = 1e-6f * static_cast<float>(model.tree->height());
    const std::size_t turn = cornersTurned(got.corners, wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Corner& corner = wanted[i - i % 3 + (i + turn) % 3];
        ASSERT_LE(glm::distance(got.corners[i].position, corner.position), tolerance) << "corner " << i;
        ASSERT_LE(glm::distance(got.corners[i].texCoord, corner.texCoord), 1e-5f) << "corner " << i;
        ASSERT_EQ(got.materials[i / 3], i + leafCorners < wanted.size() ? "bark" : "leaf") << "corner " << i;
    }
}

TEST(AssimpReadsBarks, ByLevel) {
    CParams params = preset("quaking_aspen");
    ASSERT_FALSE(params.text.bark1Texture.empty() || params.text.bark2Texture.empty());
    const auto model = CTreeCreator().create(params, detailOf(Model::Simple), CProgress(2));
    for (const std::string& ending : kAssimp.endings) {
        const ReadModel got = read(CExported(*model, ending).path());
        std::map<std::string, std::size_t> triangles;
        for (const std::string& material : got.materials) ++triangles[material];
        const std::map<std::string, std::size_t> wanted{{"bark", model->stems[0]->triangleCount()},
                                                        {"bark_1", model->stems[1]->triangleCount()},
                                                        {"bark_2", model->stems[2]->triangleCount()},
                                                        {"leaf", model->leaves()->triangleCount()}};
        EXPECT_EQ(triangles, wanted) << ending;
        EXPECT_EQ(got.textures.size(), 4u) << ending;
    }
}

TEST(AssimpReads3ds, MeshesWithinTheFormatsLimits) {
    const ReadModel got = read(CExported(sampleModel("tupelo"), ".3ds").path());
    EXPECT_GT(got.meshCount, sampleModel("tupelo").meshes().size()) << "nothing had to be cut";
    EXPECT_LE(got.maxFaces, 65535u);
}

class AssimpReadsNormals : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, AssimpReadsNormals, testing::Values(".obj", ".glb", ".gltf"),
                         [](const auto& one) { return std::string(one.param + 1); });

TEST_P(AssimpReadsNormals, AsTheyAre) {
    const TreeModel& model = sampleModel("aspen");
    const ReadModel got = read(CExported(model, GetParam()).path());
    const std::vector<Corner> wanted = cornersOf(model, yUp);
    ASSERT_EQ(got.corners.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        ASSERT_LE(glm::distance(got.corners[i].normal, wanted[i].normal), 1e-5f) << "corner " << i;
}

TEST(AssimpReadsNames, ThatAreUnusual) {
    for (const std::string& ending : kAssimp.endings)
        for (const char* stem : {"my tree", "Břečťan", "tree.v2", "a#b", "it's", "50% (copy)"}) {
            const CExported file(sampleModel("small"), ending, stem);
            const ReadModel got = read(file.path());
            EXPECT_EQ(got.corners.size(), 3 * sampleModel("small").triangleCount()) << stem << ending;
            EXPECT_EQ(got.textures.size(), 2u) << stem << ending;
            for (const auto& [material, texture] : got.textures)
                EXPECT_TRUE(texture.starts_with('*') || file.temporary().names().contains(texture))
                    << stem << ending << ": " << material << " shows " << texture;
        }
}

} // namespace stromar::test
