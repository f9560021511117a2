// Every format holds what its row says: a tree with all there is, read back by a program that is not ours.
#include "Checkout.h"
#include "io/ExportedModels.h"
#include "io/NodeReads.h"
#include "io/Tools.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/FileSet.h"
#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
/// Leaves of several colours; maps of everything.
const TreeModel& richModel() {
    static const auto model = [] {
        CParams params = sampleModel("small").params;
        params.common.leafColourV = 0.5;
        return joined(CTreeCreator().create(params, detailOf(Model::Full), CProgress(2)), CProgress(2));
    }();
    return *model;
}

fs::path written(const CTemporaryFolder& folder, const Format& format) {
    ExportOptions options;
    options.twoSided = static_cast<int>(ExportedTwoSided::No); // as many triangles as the model
    fs::path file = folder / ("tree" + std::string(format.ending));
    exportModels({std::shared_ptr<const TreeModel>(std::shared_ptr<void>(), &richModel())}, options, {}, file, CProgress(2));
    return file;
}

class CContents {
public:
    void add(Content content, bool found) { m_found = found ? m_found | content : m_found; }
    unsigned found() const { return m_found; }

private:
    unsigned m_found = 0;
};

unsigned foundByThree(const fs::path& file) {
    const Json stats = readByThree(file);
    const auto vertices = [&](const char* name) { return std::ranges::count(stats.at("attributes"), name) == 1; };
    const auto shown = [&](const char* map) {
        return std::ranges::any_of(stats.at("materials"), [&](const Json& maps) { return std::ranges::count(maps, map) > 0; });
    };
    CContents contents;
    contents.add(Content::TexCoords, vertices("uv"));
    contents.add(Content::Normals, vertices("normal"));
    contents.add(Content::Tangents, vertices("tangent") || (file.extension() == ".fbx" && readFile(file).find("LayerElementTangent") != std::string::npos));
    contents.add(Content::Materials, stats.at("looks") >= 2);
    contents.add(Content::Pictures, shown("map"));
    contents.add(Content::Opacity, stats.at("opaque") == stats.at("objects").size() - 1);
    contents.add(Content::NormalMaps, shown("normalMap"));
    contents.add(Content::RoughnessMaps, shown("roughnessMap"));
    contents.add(Content::Tints, vertices("color"));
    contents.add(Content::Occlusion, vertices("_occlusion"));
    return contents.found();
}

/// The model's, to a thousandth: readers make some up where a file has none.
bool hasItsNormals(const aiScene& scene) {
    std::vector<glm::vec3> normals;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f)
            for (unsigned c = 0; c < scene.mMeshes[m]->mFaces[f].mNumIndices; ++c) {
                if (!scene.mMeshes[m]->HasNormals()) return false;
                const aiVector3D& n = scene.mMeshes[m]->mNormals[scene.mMeshes[m]->mFaces[f].mIndices[c]];
                normals.emplace_back(n.x, n.y, n.z);
            }
    const auto isOf = [&](Axes axes) {
        const std::vector<Corner> wanted = cornersOf(richModel(), axes);
        return std::ranges::equal(normals, wanted, [](const glm::vec3& n, const Corner& corner) { return glm::distance(n, corner.normal) < 1e-3f; });
    };
    return isOf(yUp) || isOf(zUp);
}

unsigned foundByAssimp(const fs::path& file) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (!scene) {
        ADD_FAILURE() << importer.GetErrorString();
        return 0;
    }
    const auto meshes = [&](const auto& has) { return std::any_of(scene->mMeshes, scene->mMeshes + scene->mNumMeshes, has); };
    const auto textures = [&](std::initializer_list<aiTextureType> types) {
        return std::any_of(scene->mMaterials, scene->mMaterials + scene->mNumMaterials, [&](const aiMaterial* material) {
            return std::ranges::any_of(types, [&](aiTextureType type) { return material->GetTextureCount(type) > 0; });
        });
    };
    CContents contents;
    contents.add(Content::TexCoords, meshes([](const aiMesh* mesh) { return mesh->HasTextureCoords(0); }));
    contents.add(Content::Normals, hasItsNormals(*scene));
    contents.add(Content::Tangents, meshes([](const aiMesh* mesh) { return mesh->HasTangentsAndBitangents(); }));
    contents.add(Content::Materials, std::count_if(scene->mMaterials, scene->mMaterials + scene->mNumMaterials, [](aiMaterial* material) {
                                         const std::string name = material->GetName().C_Str();
                                         return name == "bark" || name == "leaf";
                                     }) == 2);
    contents.add(Content::Pictures, textures({aiTextureType_DIFFUSE}));
    contents.add(Content::Opacity, textures({aiTextureType_OPACITY}));
    contents.add(Content::NormalMaps, textures({aiTextureType_NORMALS, aiTextureType_HEIGHT}));
    contents.add(Content::RoughnessMaps, textures({aiTextureType_DIFFUSE_ROUGHNESS}));
    contents.add(Content::Tints, meshes([](const aiMesh* mesh) { return mesh->HasVertexColors(0); }));
    return contents.found();
}

unsigned foundByOsg(const fs::path& file) {
    const Json stats = jsonBy({inBin("osg-stats"), file.string()}, file.parent_path());
    CContents contents;
    contents.add(Content::TexCoords, stats.at("tex_max").at(0) > stats.at("tex_min").at(0));
    contents.add(Content::Normals, stats.at("normals"));
    contents.add(Content::Tangents, stats.at("attributes") > 0);
    contents.add(Content::Materials, stats.at("materials") == Json{"bark", "leaf"});
    contents.add(Content::Pictures, stats.at("textures").size() == 2);
    contents.add(Content::Opacity, stats.at("transparent"));
    contents.add(Content::NormalMaps, stats.at("maps") > 0);
    contents.add(Content::Tints, stats.at("colours"));
    return contents.found();
}

/// POV-Ray renders these scenes in a test of its own; it takes the opacity of a PNG from the picture.
unsigned foundInPov(const fs::path& file) {
    const std::string text = readFile(file);
    const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
    CContents contents;
    contents.add(Content::TexCoords, has("uv_vectors") && has("uv_mapping"));
    contents.add(Content::Normals, has("normal_vectors"));
    contents.add(Content::Materials, has("Tree_bark") && has("Tree_leaf"));
    contents.add(Content::Pictures, has("image_map { png"));
    contents.add(Content::Opacity, has("image_map { png"));
    contents.add(Content::NormalMaps, has("bump_map"));
    return contents.found();
}

unsigned foundIn(const fs::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".pov") return foundInPov(file);
    if (ending.starts_with(".osg")) return foundByOsg(file);
    const auto byAssimp = {".obj", ".dae", ".3ds", ".lwo", ".ply", ".stl"};
    return std::ranges::count(byAssimp, ending) > 0 ? foundByAssimp(file) : foundByThree(file);
}

std::string namesOf(unsigned contents) {
    std::string names;
    for (const ContentInfo& one : contentTable())
        if (contents & static_cast<unsigned>(one.content)) names += std::string(one.name) + "; ";
    return names;
}

std::string endingOf(const testing::TestParamInfo<std::size_t>& info) { return std::string(formatTable()[info.param].ending.substr(1)); }
} // namespace

class Contents : public testing::TestWithParam<std::size_t> {
    void SetUp() override { needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)"); }
};
INSTANTIATE_TEST_SUITE_P(All, Contents, testing::Range<std::size_t>(0, formatTable().size()), endingOf);

TEST_P(Contents, AreWhatTheTableSays) {
    const Format& format = formatTable()[GetParam()];
    const CTemporaryFolder folder;
    EXPECT_EQ(namesOf(foundIn(written(folder, format))), namesOf(format.holds));
}

} // namespace stromar::test
