#include "SampleTrees.h"
#include "stromar/mesh/StemChoice.h"
#include "stromar/model/MeshValues.h"
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

/// A tree of thin wood, and which of it a level of detail draws.
struct Chosen {
    explicit Chosen(const std::string& name, int lod, int threads = 2)
        : tree(grow(preset(name))),
          choice(chooseStems(*tree, meshParamsOf(preset(name)), detailOf(Model::Full, lod), {}, CProgress(threads))) {}

    template <typename Visit> void forEachStem(Visit&& visit) const {
        for (std::size_t g = 0; g < tree->generationCount(); ++g)
            for (std::size_t s = 0; s < tree->generation(g).stems.size(); ++s) visit(g, s, tree->generation(g).stems[s]);
    }

    /// What is drawn of all stems covers, over what they do.
    double cover() const {
        double all = 0, drawn = 0;
        forEachStem([&](std::size_t g, std::size_t s, const CStem& stem) {
            const double own = stem.length * stem.radius;
            all += own;
            if (choice.draws(g, s)) drawn += own * (choice.thicker.has(g, s) ? choice.growth : 1);
        });
        return drawn / all;
    }

    std::shared_ptr<const CTree> tree;
    StemChoice choice;
};

class StemChoiceTest : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Trees, StemChoiceTest, ::testing::Values("strand_winter", "winter_oak", "abop_2_8c"));

TEST_P(StemChoiceTest, WholeTwigsGoAndWhatStaysCoversAsMuch) {
    const Chosen far(GetParam(), 3);
    std::size_t leftOut = 0;
    far.forEachStem([&](std::size_t g, std::size_t s, const CStem& stem) {
        const bool gone = far.choice.leftOut.has(g, s), thicker = far.choice.thicker.has(g, s);
        ASSERT_FALSE(gone && thicker);
        ASSERT_TRUE(far.choice.bears(g, s)) << "leaves stay where their twig goes";
        if (stem.parent >= 0) {
            const auto parent = static_cast<std::size_t>(stem.parent);
            ASSERT_TRUE(gone || !far.choice.leftOut.has(g - 1, parent)) << "nothing grows on what is left out";
            ASSERT_TRUE(thicker || !far.choice.thicker.has(g - 1, parent)) << "a twig is thicker as a whole";
        }
        leftOut += gone ? 1 : 0;
    });
    EXPECT_GT(leftOut, far.tree->stemCount() / 4);
    EXPECT_GT(far.choice.growth, 1.1);
    EXPECT_NEAR(far.cover(), 1, 0.03);
}

TEST_P(StemChoiceTest, NearerOnlyStemsOfTheLastGenerationGo) {
    const Chosen near(GetParam(), 1);
    const std::size_t last = near.tree->generationCount() - 1;
    near.forEachStem([&](std::size_t g, std::size_t s, const CStem&) {
        ASSERT_TRUE(g == last || near.choice.draws(g, s));
        ASSERT_EQ(near.choice.bears(g, s), near.choice.draws(g, s)) << "leaves go with their stem";
    });
    EXPECT_NEAR(near.cover(), 1, 0.03);
    EXPECT_EQ(Chosen(GetParam(), 0).choice, StemChoice());
}

TEST_P(StemChoiceTest, IsTheSameForEveryNumberOfThreads) { EXPECT_EQ(Chosen(GetParam(), 3, 1).choice, Chosen(GetParam(), 3, 4).choice); }

TEST(StemChoice, SmallTreesKeepTheirWood) {
    const Chosen small("lady_fern", 3);
    small.forEachStem([&](std::size_t g, std::size_t s, const CStem&) { ASSERT_TRUE(small.choice.draws(g, s)); });
}

} // namespace
} // namespace stromar::test
