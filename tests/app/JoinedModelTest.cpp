// Wood in one piece, as files have it: closed at rest, in the wind, and through all that becomes of a model.
#include "app/SameModel.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/model/ModelSway.h"
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

std::vector<const CMesh*> wood(const Meshes& meshes) {
    std::vector<const CMesh*> all;
    for (const auto& mesh : meshes)
        if (isBark(mesh->surface)) all.push_back(mesh.get());
    return all;
}

std::shared_ptr<const TreeModel> model(const std::string& name, int lod = 0) {
    return CTreeCreator().create(preset(name), detailOf(Model::Full, lod), CProgress(2));
}

class JoinedModel : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Trees, JoinedModel, ::testing::Values("quaking_aspen", "english_oak", "strand_birch", "abop_2_6c", "abop_2_8a"));

TEST_P(JoinedModel, IsClosedOnlyAsAWhole) {
    const auto apart = model(GetParam()), whole = joined(apart, CProgress(2));
    EXPECT_EQ(openEdges(wood(whole->stems)), 0u);
    EXPECT_EQ(openEdges({apart->stems[0].get()}), 0u);
    EXPECT_GT(openEdges({whole->stems[0].get()}), 0u) << "there are holes where branches stand";
    EXPECT_EQ(joined(whole, CProgress(2)), whole) << "there is nothing more to join";
}

/// Whether the plans were kept from the start or are made for a model that was there before.
TEST_P(JoinedModel, IsTheSameOfPlansThatWereKept) {
    CTreeCreator creator;
    const auto create = [&](CTreeCreator::Plans plans) { return creator.create(preset(GetParam()), detailOf(Model::Full), CProgress(2), plans); };
    const auto plain = create(CTreeCreator::Plans::Drop), later = create(CTreeCreator::Plans::Keep);
    const auto kept = CTreeCreator().create(preset(GetParam()), detailOf(Model::Full), CProgress(1), CTreeCreator::Plans::Keep);
    ASSERT_FALSE(plain->planned);
    ASSERT_TRUE(later->planned && kept->planned);
    EXPECT_EQ(later->stems, plain->stems) << "no mesh is made anew";
    const auto expected = joined(plain, CProgress(2));
    EXPECT_EQ(modelDifference(*joined(later, CProgress(2)), *expected), "");
    EXPECT_EQ(modelDifference(*joined(kept, CProgress(1)), *expected), "");
    EXPECT_FALSE(create(CTreeCreator::Plans::Drop)->planned);
}

/// The edge of a hole moves just as the collar in it.
TEST_P(JoinedModel, StaysClosedInTheWind) {
    const auto whole = joined(model(GetParam()), CProgress(2));
    const auto sway = swayOf(whole, nullptr, CProgress(2));
    WindPose pose;
    sway->table->pose({.strength = 0.8}, 1.7, pose, CProgress(2));
    Meshes moved;
    for (const auto& mesh : whole->stems) moved.push_back(swayed(*mesh, *sway->placesOf(*mesh), *sway->table, pose, CProgress(2)));
    EXPECT_NE(moved[0]->bounds().max, whole->stems[0]->bounds().max);
    EXPECT_EQ(openEdges(wood(moved)), 0u);
}
} // namespace

TEST(JoinedModel, OfTheSimpleModelAndOfLod3IsTheModelItself) {
    const auto coarse = model("quaking_aspen", 3);
    EXPECT_EQ(joined(coarse, CProgress(2)), coarse);
    const auto simple = CTreeCreator().create(preset("quaking_aspen"), detailOf(Model::Simple), CProgress(2));
    EXPECT_EQ(joined(simple, CProgress(2)), simple);
}

/// Cards take the place of twigs: what bears them is planned without.
TEST(JoinedModel, OfCardsIsClosed) {
    const auto whole = joined(model("english_oak", 2), CProgress(2));
    ASSERT_TRUE(whole->cards);
    EXPECT_EQ(openEdges(wood(whole->stems)), 0u);
}

} // namespace stromar::test
