// The bark that wood has in files.
#include "BarkParts.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/BarkLevels.h"
#include "stromar/model/JoinedModel.h"
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <tuple>

namespace stromar::test {
namespace {

std::shared_ptr<const TreeModel> joinedModel(const std::string& name, int lod = 0) {
    return joined(CTreeCreator().create(preset(name), detailOf(Model::Full, lod), CProgress(2)), CProgress(2));
}

Material material(Surface surface) { return {surface, surfaceOf(surface).name, {}, {}, {}, false}; }

/// With the positions as what the vertices carry.
VertexChannels placesIn(const CMesh& mesh) {
    return {{"PLACE", VertexChannel::Type::Float, 3, std::string(reinterpret_cast<const char*>(mesh.positions.data()), 12 * mesh.vertexCount())}};
}

ExportModel exported(const TreeModel& tree, const std::vector<Surface>& barks) {
    ExportModel model{"tree", {}, {}, {}};
    tree.visitMeshes([&](const auto& mesh, int) { if (isBark(mesh->surface)) model.meshes.push_back(mesh); }, [](const auto&, int) {});
    for (const Surface bark : barks) model.materials.push_back(material(bark));
    for (const auto& mesh : model.meshes) model.channels.push_back(placesIn(*mesh));
    return model;
}

std::map<std::string, std::size_t> trianglesByName(const Meshes& meshes) {
    std::map<std::string, std::size_t> all;
    for (const auto& mesh : meshes) all[mesh->name] += mesh->triangleCount();
    return all;
}

class BarkParts : public ::testing::TestWithParam<std::tuple<const char*, int>> {};
INSTANTIATE_TEST_SUITE_P(Trees, BarkParts, ::testing::Combine(::testing::Values("strand_acacia", "strand_winter"), ::testing::Values(0, 2)));

TEST_P(BarkParts, KeepTheWoodAndWhatItsVerticesCarry) {
    const auto [name, lod] = GetParam();
    const auto tree = joinedModel(name, lod);
    ExportModel model = exported(*tree, {Surface::Bark, Surface::Bark1, Surface::Bark2});
    const std::map<std::string, std::size_t> before = trianglesByName(model.meshes);
    partByBark(model, std::span(&tree, 1));
    std::map<std::string, std::size_t> after;
    std::vector<const CMesh*> wood;
    ASSERT_EQ(model.channels.size(), model.meshes.size());
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        const CMesh& mesh = *model.meshes[i];
        after[mesh.name.substr(0, mesh.name.find("_bark"))] += mesh.triangleCount();
        wood.push_back(&mesh);
        EXPECT_GT(mesh.triangleCount(), 0u) << mesh.name;
        ASSERT_EQ(model.channels[i].size(), 1u);
        EXPECT_EQ(model.channels[i][0].bytes, placesIn(mesh)[0].bytes) << mesh.name;
    }
    EXPECT_EQ(after, before);
    EXPECT_GT(trianglesByName(model.meshes).size(), before.size()) << "some stems are as thick as those of another level";
    EXPECT_EQ(openEdges(wood), 0u);
}

TEST(BarkParts, ALimbAsThickAsTheTrunkHasItsBark) {
    const auto tree = joinedModel("strand_acacia");
    ExportModel model = exported(*tree, {Surface::Bark, Surface::Bark1});
    partByBark(model, std::span(&tree, 1));
    std::map<std::string, int> thickest;
    for (const auto& mesh : model.meshes) {
        int& least = thickest.try_emplace(model.materialOf(*mesh).name, 255).first->second;
        for (const VertexLook& look : mesh->looks) least = std::min<int>(least, look.thinness);
    }
    const CBarkLevels levels(*tree->tree);
    EXPECT_LE(thickest.at("bark"), 1);
    EXPECT_GE(thickest.at("bark_1"), (levels.thinness(0) + levels.thinness(1)) / 2);
}

TEST(BarkParts, BranchesOfWeberAndPennHaveThatOfTheirLevel) {
    const auto tree = joinedModel("silver_birch");
    ExportModel model = exported(*tree, {Surface::Bark, Surface::Bark1, Surface::Bark2});
    const Meshes before = model.meshes;
    partByBark(model, std::span(&tree, 1));
    EXPECT_EQ(model.meshes, before);
}

TEST(BarkParts, WoodOfOneBarkStaysAsItIs) {
    const auto tree = joinedModel("strand_acacia");
    ExportModel model = exported(*tree, {Surface::Bark});
    partByBark(model, std::span(&tree, 1));
    EXPECT_EQ(model.meshes, tree->stems);
}

TEST(BarkLevels, WoodBelongsToTheLevelWhoseStemsAreAsThick) {
    const auto level = [](std::initializer_list<double> radii) {
        auto generation = std::make_shared<CGeneration>();
        for (const double radius : radii) generation->stems.emplace_back().radius = radius;
        return generation;
    };
    const CTree tree(10, {level({0.8}), level({0.1, 0.3}), level({0.05})});
    const CBarkLevels levels(tree);
    ASSERT_EQ(levels.count(), 3u);
    EXPECT_EQ(levels.thinness(0), 0);
    EXPECT_EQ(levels.thinness(1), 2 * VertexLook::kThinnessOfHalf);
    EXPECT_EQ(levels.thinness(2), 4 * VertexLook::kThinnessOfHalf);
    for (const std::size_t own : {0u, 1u, 2u}) {
        EXPECT_EQ(levels.levelOf(own, thinnessOf(0.5, 0.8)), 0u) << own;
        EXPECT_EQ(levels.levelOf(own, thinnessOf(0.3, 0.8)), 1u) << own;
        EXPECT_EQ(levels.levelOf(own, thinnessOf(0.11, 0.8)), 1u) << own;
        EXPECT_EQ(levels.levelOf(own, thinnessOf(0.09, 0.8)), 2u) << own;
    }
    const CBarkLevels even(CTree(10, {level({0.8}), level({0.8})}));
    EXPECT_EQ(even.levelOf(1, 0), 1u) << "none is thicker";
}

} // namespace
} // namespace stromar::test
