#include "SameModel.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/app/Pictures.h"
#include "stromar/app/Prediction.h"
#include "stromar/mesh/LeafMeshes.h"
#include "stromar/model/Material.h"
#include "stromar/model/ModelSway.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>
#include <set>

namespace stromar::test {
namespace {

class LeafKinds : public testing::Test {
protected:
    std::shared_ptr<const TreeModel> model(int lod = 0) const { return createAnew(m_params, detailOf(Model::Full, lod)); }
    /// Which leaves are of which kind.
    std::vector<std::set<std::pair<std::uint64_t, std::uint32_t>>> kindsIn(const TreeModel& model) const {
        std::vector<std::set<std::pair<std::uint64_t, std::uint32_t>>> all(kLeafKinds);
        for (std::size_t kind = 0; kind < kLeafKinds; ++kind)
            for (std::size_t i = 0; i < model.leaves(kind)->count(); ++i) {
                const CLeaf& leaf = model.leaves(kind)->leaf(i);
                all[kind].emplace(model.tree->generation(leaf.generation).stems[leaf.stem].id, leaf.number);
            }
        return all;
    }

    CParams m_params = [] {
        CParams params = preset("quaking_aspen");
        params.common.leafShare2 = 0.3;
        params.common.leafShare3 = 0.1;
        params.text.leaf2Texture = "leaf:oak";
        params.text.leaf3Mesh = "mesh:curved";
        return params;
    }();
};

TEST_F(LeafKinds, HaveTheirShares) {
    const auto tree = model();
    const double all = double(tree->tree->leaves().size());
    ASSERT_GT(all, 5000);
    EXPECT_EQ(double(tree->leafCount()), all) << "each leaf is of one kind";
    for (const auto& [kind, share] : {std::pair{0, 0.6}, {1, 0.3}, {2, 0.1}, {3, 0.0}})
        EXPECT_NEAR(double(tree->leaves(std::size_t(kind))->count()) / all, share, 4 * std::sqrt(0.25 / all)) << kind;
    EXPECT_EQ(tree->leaves(2)->blade().points.size(), builtInLeaf("mesh:curved")->make(false).points.size());
    EXPECT_EQ(tree->leaves(1)->blade().points.size(), tree->leaves(0)->blade().points.size());
    EXPECT_LE(double(tree->vertexCount()), predictSize(m_params, detailOf(Model::Full)).vertices);
}

TEST_F(LeafKinds, SharesBeyondOneLeaveNothingForTheLast) {
    m_params.common.leafShare2 = 0.8;
    m_params.common.leafShare3 = 0.5;
    m_params.common.leafShare4 = 1;
    const auto tree = model();
    EXPECT_EQ(tree->leaves(0)->count(), 0u);
    EXPECT_EQ(tree->leaves(3)->count(), 0u);
    EXPECT_NEAR(double(tree->leaves(2)->count()) / double(tree->leafCount()), 0.2, 0.02);
}

TEST_F(LeafKinds, AreTheSameAtEveryLevelOfDetail) {
    const auto near = kindsIn(*model(0)), far = kindsIn(*model(1));
    std::size_t compared = 0;
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind)
        for (const auto& leaf : far[kind]) {
            EXPECT_TRUE(near[kind].contains(leaf));
            ++compared;
        }
    EXPECT_GT(compared, 1000u);
}

TEST_F(LeafKinds, ATreeWithoutThemStaysAsItWas) {
    CParams plain = m_params;
    plain.common.leafShare2 = plain.common.leafShare3 = 0;
    const auto with = model(), without = createAnew(plain, detailOf(Model::Full));
    EXPECT_EQ(without->leaves()->count(), with->leafCount());
    EXPECT_EQ(without->tree->leaves().size(), with->tree->leaves().size());
    plain.text.leaf2Texture = plain.text.leaf3Mesh = "";
    EXPECT_EQ(modelDifference(*without, *createAnew(plain, detailOf(Model::Full))), "");
}

TEST_F(LeafKinds, OnlyThoseWithATextureAreMaterials) {
    EXPECT_EQ(shownSurface(m_params, Surface::Leaf2), Surface::Leaf2);
    EXPECT_EQ(shownSurface(m_params, Surface::Leaf3), Surface::Leaf) << "it has a mesh alone";
    m_params.common.leafShare2 = 0;
    EXPECT_EQ(shownSurface(m_params, Surface::Leaf2), Surface::Leaf) << "there are none";
    m_params.common.leafShare2 = 0.3;
    const CTemporaryFolder folder;
    exportModel(*model(), {}, folder / "tree.obj", CProgress(2));
    const std::string obj = readFile(folder / "tree.obj");
    EXPECT_NE(obj.find("o leaves 2\nusemtl leaf_2\n"), std::string::npos);
    EXPECT_NE(obj.find("o leaves 3\nusemtl leaf\n"), std::string::npos);
    EXPECT_EQ(readFile(folder / "tree_leaf_2.png"), readFile(textureOf(m_params, Surface::Leaf2, {})));
}

TEST_F(LeafKinds, AreSeenOnCards) {
    const auto cards = model(2);
    ASSERT_TRUE(cards->twig);
    const auto& kinds = cards->twig->kinds;
    EXPECT_EQ(kinds.front(), 0u);
    EXPECT_EQ(kinds.back(), cards->twig->leaves->indices.size());
    EXPECT_LT(kinds[0], kinds[1]);
    EXPECT_LT(kinds[1], kinds[2]) << "the twig bears some of the second kind";
    makePictures(*cards, {}, CProgress());
    const auto before = textureOf(*cards, Surface::Twig, {});
    m_params.text.leaf2Texture = "leaf:oak seed=3";
    makePictures(m_params, CProgress());
    EXPECT_NE(textureOf(*model(2), Surface::Twig, {}), before) << "another picture";
    m_params.text.leaf2Texture = "leaf.jpg";
    EXPECT_FALSE(isBakeable(m_params));
}

TEST_F(LeafKinds, SwayLikeOthers) {
    const auto tree = model();
    const auto sway = swayOf(tree, nullptr, CProgress(2));
    std::size_t kinds = 0;
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) {
        EXPECT_EQ(sway->placesOf(*tree->leaves(kind))->size(), tree->leaves(kind)->count());
        kinds += tree->leaves(kind)->count() > 0;
    }
    EXPECT_EQ(kinds, 3u);
}

} // namespace
} // namespace stromar::test
