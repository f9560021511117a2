// The method row of the strand model: meshes, bounds, cards, and what it says of every branch.
#include "app/SameModel.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Prediction.h"
#include "stromar/mesh/check/MeshCheck.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/ParamText.h"
#include "stromar/tree/strands/StrandsBuilder.h"
#include "tree/RandomStrands.h"
#include <gtest/gtest.h>

namespace stromar::test {
TEST(SlowStrandsMethod, MeshesOfRandomTreesAreSound) {
    for (unsigned number = 1; number <= 500; ++number) {
        const CParams params = randomStrands(number, 250);
        const auto tree = methodOf(params).makeBuilder(true)->build(params, nullptr, 0, CProgress(2));
        for (const Detail& detail : detailTable()) {
            const auto stems = meshAllStems(*tree, meshParamsOf(params), detail, CProgress(2));
            for (std::size_t g = 0; g < stems.size(); ++g) {
                const MeshFaults faults = checkStems(*tree, static_cast<int>(g), stems[g], stems);
                EXPECT_TRUE(faults.sound()) << number << ", " << detail.name << ", generation " << g << ": " << inWords(faults);
            }
        }
    }
}

TEST(SlowStrandsMethod, NeverTakesMoreThanPredicted) {
    for (unsigned number = 1; number <= 60; ++number) {
        const CParams params = randomStrands(number, 1500);
        CTreeCreator creator(true, SizeLimits::none());
        for (const Detail& detail : detailTable()) {
            const auto model = creator.create(params, detail, CProgress(2));
            const Prediction size = predictSize(params, detail);
            EXPECT_EQ(size.stems, double(model->tree->stemCount())) << number;
            EXPECT_EQ(size.leaves, double(model->tree->organs(Organ::Leaf)->total)) << number;
            EXPECT_GE(size.vertices, double(model->vertexCount())) << number << ", " << detail.name;
        }
    }
}

TEST(StrandsMethod, GrowsTheSameForAnyNumberOfThreads) {
    for (const char* name : {"strand_bonsai", "strand_birch"})
        EXPECT_EQ(modelDifference(*created(preset(name), detailOf(Model::Full), 1), *created(preset(name), detailOf(Model::Full), 4)), "") << name;
}

TEST(StrandsMethod, EveryPresetHasCardsButTheBareOne) {
    std::size_t looked = 0;
    for (const Sample& sample : presets()) {
        if (&sample.params.block() != &strandsBlock()) continue;
        ++looked;
        const auto fine = created(sample.params, detailOf(Model::Full)), coarse = created(sample.params, detailOf(Model::Full, 3));
        EXPECT_LT(double(coarse->triangleCount()), 0.25 * double(fine->triangleCount())) << sample.name;
        if (strands(sample.params).stemLeaves >= 3) {
            EXPECT_TRUE(coarse->cards) << sample.name;
        }
    }
    EXPECT_GE(looked, 8u);
}

TEST(StrandsMethod, SaysWhereBranchesStandOnCurves) {
    CParams params(strandsBlock());
    strands(params).splitAngleOver = static_cast<int>(CurveOver::Thickness);
    const auto tree = growTree(CStrandsBuilder(), params, CProgress());
    const TreeMethod& method = methodOf(params);
    const auto places = [&](const char* key) { return method.curvePlaces(*findParam(key, strandsBlock())->info, params, *tree); };
    for (std::size_t g = 0; g < tree->generationCount(); ++g)
        for (std::size_t s = 0; s < tree->generation(g).segments.size(); ++s) {
            EXPECT_EQ(places("StrandShareG")[g][s], double(g)) << "a generation is an order";
            EXPECT_NEAR(places("SplitAngleG")[g][s], 200 * tree->generation(g).segments[s].radiusBase, 1e-9);
            if (g > 1) break;
        }
    EXPECT_EQ(places("PlaneTurnW")[0][3], 3);
    EXPECT_EQ(axisOf(*findParam("SplitAngleG", strandsBlock())->info, params).label, "thickness, cm");
    EXPECT_EQ(axisOf(*findParam("PlaneTurnG", strandsBlock())->info, params).step, 1);
}

} // namespace stromar::test
