// Bark whose relief is triangles, from the picture to the file.
#include "stromar/app/DisplacedModel.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/ModelSway.h"
#include "stromar/texture/Draw.h"
#include "stromar/util/Error.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

const stromar::Displacement kDisplacement{0.04};

std::shared_ptr<const TreeModel> model(const CParams& params, int lod = 0) {
    return CTreeCreator().create(params, detailOf(Model::Full, lod), CProgress(2));
}

std::shared_ptr<const TreeModel> rough(const CParams& params, const std::filesystem::path& folder = {}) {
    return displaced(model(params), kDisplacement, folder, {}, CProgress(2));
}

std::vector<const CMesh*> all(const Meshes& meshes) {
    std::vector<const CMesh*> all;
    for (const auto& mesh : meshes) all.push_back(mesh.get());
    return all;
}
} // namespace

TEST(DisplacedModel, StaysClosedInTheWind) {
    const auto tree = rough(preset("quaking_aspen"));
    EXPECT_EQ(openEdges(all(tree->stems)), 0u);
    const auto sway = swayOf(tree, nullptr, CProgress(2));
    WindPose pose;
    sway->table->pose({.strength = 0.8}, 1.7, pose, CProgress(2));
    Meshes moved;
    for (const auto& mesh : tree->stems) moved.push_back(swayed(*mesh, *sway->placesOf(*mesh), *sway->table, pose, CProgress(2)));
    EXPECT_EQ(openEdges(all(moved)), 0u);
}

TEST(DisplacedModel, IsOfLevelOfDetail0AndOnRequest) {
    const auto fine = model(preset("quaking_aspen")), coarse = model(preset("quaking_aspen"), 1);
    EXPECT_EQ(displaced(coarse, kDisplacement, {}, {}, CProgress(2)), coarse);
    EXPECT_EQ(displaced(fine, {}, {}, {}, CProgress(2)), fine);
    EXPECT_GT(displaced(fine, kDisplacement, {}, {}, CProgress(2))->vertexCount(), fine->vertexCount());
}

TEST(DisplacedModel, TakesTheHeightsBesideAPictureOfOnesOwn) {
    const CTemporaryFolder folder;
    CFileSet files;
    writePngs(CRecipe("bark:furrowed").draw(64, CProgress(2)), folder.path() / "own.png", files);
    files.commit();
    CParams params = preset("quaking_aspen");
    params.text.barkTexture = "own.png";
    params.text.bark1Texture = params.text.bark2Texture = params.text.bark3Texture = "";
    const auto tree = rough(params, folder.path());
    EXPECT_GT(tree->vertexCount(), model(params)->vertexCount());
    std::filesystem::remove(folder.path() / "own_height.png");
    try {
        rough(params, folder.path());
        FAIL();
    } catch (const CError& e) {
        EXPECT_NE(std::string(e.what()).find("own_height.png"), std::string::npos) << e.what();
    }
}

TEST(DisplacedModel, GoesIntoAFileOnceAndOnlyWhereItMay) {
    const CTemporaryFolder folder;
    ExportOptions options;
    options.displacement = 0.05;
    CTreeCreator creator;
    const auto lods = exportTree(creator, preset("quaking_aspen"), options, {}, folder.path() / "a.obj", CProgress(2));
    const auto once = displaced(model(preset("quaking_aspen")), {0.05, options.displacementStrength}, {}, {}, CProgress(2));
    EXPECT_EQ(lods[0]->vertexCount(), once->vertexCount());
    EXPECT_TRUE(sameBytes(*lods[0]->stems[0], *once->stems[0]));
    options.lod = 1;
    EXPECT_THROW(exportTree(creator, preset("quaking_aspen"), options, {}, folder.path() / "b.obj", CProgress(2)), CError);
    options = {.model = static_cast<int>(ExportedModel::Simple), .displacement = 0.05};
    EXPECT_NE(conflictText(options, *formatOf("a.obj")), "");
}

TEST(DisplacedModel, StopsAtItsLimit) {
    EXPECT_THROW(displaced(model(preset("quaking_aspen")), {0.001}, {}, {.vertices = 2e5}, CProgress(2)), CError);
}

} // namespace stromar::test
