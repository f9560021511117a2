#include "app/SameModel.h"
#include "mesh/SampleTrees.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/params/ParamTable.h"
#include <gtest/gtest.h>
#include <random>

namespace stromar::test {

namespace {
/// Of four levels, with leaves, quickly made; every kind of parameter changes something.
CParams smallTree() {
    CParams params = preset("ca_black_oak");
    WeberPennParams& g = weberPenn(params);
    g.levels = 4;
    g.leaves = 6;
    params.common.lobes = 3;
    params.common.lobeDepth = 0.2;
    g.pruneRatio = 0.4;
    weberPenn(params).level[1].branches = 8;
    weberPenn(params).level[2].branches = 6;
    weberPenn(params).level[3].branches = 3;
    return params;
}

/// Another value of the row, inside its useful range.
double otherValue(const ParamRef& ref, const CParams& params) {
    const Range& useful = ref.info->useful;
    const double now = ref.get(params), step = ref.info->step;
    if (ref.info->key == "Levels") return 3;
    if (ref.info->key == "Branches") return now + 1;
    return now + step <= useful.max ? now + step : now - step;
}

int sharedStems(const TreeModel& a, const TreeModel& b) {
    int count = 0;
    for (std::size_t g = 0; g < std::min(a.stems.size(), b.stems.size()); ++g) count += a.stems[g] == b.stems[g];
    return count;
}
} // namespace

TEST(TreeCreator, GivesTheSameModelAgain) {
    for (const Detail& detail : detailTable()) {
        CTreeCreator creator;
        const auto first = creator.create(smallTree(), detail, CProgress(2));
        const auto second = creator.create(smallTree(), detail, CProgress(2));
        EXPECT_EQ(first->tree, second->tree);
        EXPECT_EQ(first->stems, second->stems);
        EXPECT_EQ(first->leaves(), second->leaves());
        EXPECT_EQ(first->detail, &detail);
    }
}

TEST(TreeCreator, SharesTheGenerationsBeforeAnEditedLevel) {
    for (int level = 0; level < kParamLevels; ++level) {
        CTreeCreator creator;
        CParams params = smallTree();
        const auto before = creator.create(params, detailOf(Model::Full), CProgress(2));
        weberPenn(params).level[static_cast<std::size_t>(level)].curve.value += 5;
        const auto after = creator.create(params, detailOf(Model::Full), CProgress(2));
        EXPECT_EQ(sharedStems(*before, *after), level);
        for (int g = 0; g < 4; ++g) {
            const auto i = static_cast<std::size_t>(g);
            EXPECT_EQ(before->stems[i] == after->stems[i], g < level) << "level " << level << ", generation " << g;
            EXPECT_EQ(before->tree->generations()[i] == after->tree->generations()[i], g < level);
        }
        EXPECT_NE(before->leaves(), after->leaves());
    }
}

TEST(TreeCreator, KeepsStemsWhenOnlyLeavesChange) {
    CTreeCreator creator;
    CParams params = smallTree();
    const auto before = creator.create(params, detailOf(Model::Full), CProgress(2));
    params.common.leafScale *= 2;
    const auto after = creator.create(params, detailOf(Model::Full), CProgress(2));
    EXPECT_EQ(before->stems, after->stems);
    EXPECT_NE(before->leaves(), after->leaves());
    EXPECT_EQ(modelDifference(*after, *createAnew(params, detailOf(Model::Full))), "");
}

TEST(TreeCreator, KeepsEverythingWhenOnlyTextsChange) {
    for (const ParamRef& text : allParams()) {
        if (text.info->kind() != ParamKind::Text || text.info->recipes == "mesh") continue;
        CTreeCreator creator;
        CParams params = smallTree();
        const auto before = creator.create(params, detailOf(Model::Simple), CProgress(2));
        text.setValue(params, std::string("other.png"));
        const auto after = creator.create(params, detailOf(Model::Simple), CProgress(2));
        EXPECT_EQ(before->tree, after->tree) << text.key();
        EXPECT_EQ(before->stems, after->stems) << text.key();
        EXPECT_EQ(before->leaves(), after->leaves()) << text.key();
        EXPECT_EQ(after->params, params) << text.key();
    }
}

TEST(TreeCreator, KeepsTheTreeWhenOnlyTheMeshChanges) {
    CTreeCreator creator;
    CParams params = smallTree();
    const auto before = creator.create(params, detailOf(Model::Full), CProgress(2));
    params.common.textureWrapX += 1;
    const auto after = creator.create(params, detailOf(Model::Full), CProgress(2));
    EXPECT_EQ(before->tree, after->tree);
    EXPECT_EQ(sharedStems(*before, *after), 0);
}

TEST(TreeCreator, LevelsOfDetailShareTheTwigThatCardsShow) {
    CTreeCreator creator;
    CParams params = preset("quaking_aspen");
    const auto near = creator.create(params, detailOf(Model::Full, 2), CProgress(2));
    ASSERT_TRUE(near->twig && near->cards);
    const auto far = creator.create(params, detailOf(Model::Full, 3), CProgress(2));
    EXPECT_EQ(far->twig, near->twig);
    EXPECT_EQ(modelDifference(*far, *createAnew(params, detailOf(Model::Full, 3))), "");
    params.common.leafScale *= 1.5;
    const auto larger = creator.create(params, detailOf(Model::Full, 3), CProgress(2));
    EXPECT_NE(larger->twig, near->twig);
    EXPECT_EQ(modelDifference(*larger, *createAnew(params, detailOf(Model::Full, 3))), "");
}

/// Thinned organs are as large as their pictures want.
TEST(TreeCreator, AnotherPictureGivesWhatANewCreatorGives) {
    const auto expectSame = [](const CParams& before, const CParams& after, int lod) {
        CTreeCreator creator;
        const Detail& detail = detailOf(Model::Full, lod);
        const auto old = creator.create(before, detail, CProgress(2)), now = creator.create(after, detail, CProgress(2));
        EXPECT_NE(modelDifference(*now, *old), "");
        EXPECT_EQ(modelDifference(*now, *createAnew(after, detail)), "");
    };
    CParams leafy = preset("quaking_aspen"), blooming = preset("rowan");
    blooming.common.season = 5.5;
    CParams otherLeaf = leafy, otherBlossom = blooming, otherLeaves = blooming;
    otherLeaf.text.leafTexture = otherLeaves.text.leafTexture = "leaf:spruce";
    otherBlossom.text.blossomTexture = "leaf:candle";
    expectSame(leafy, otherLeaf, 1);
    expectSame(blooming, otherBlossom, 1);
    expectSame(blooming, otherLeaves, 2); // which hide blossoms
}

TEST(SlowTreeCreator, AnEditOfAnyParameterGivesWhatANewCreatorGives) {
    for (const ParamRef& ref : numberParams())
        for (const Detail* detail : {&detailOf(Model::Simple), &detailOf(Model::Full, 1)}) {
            CTreeCreator creator;
            CParams params = smallTree();
            const auto before = creator.create(params, *detail, CProgress(2));
            ref.set(params, otherValue(ref, params));
            ASSERT_NE(ref.get(params), ref.get(before->params)) << ref.key();
            const Invalidation invalid = invalidationOf(before->params, params);
            const auto after = creator.create(params, *detail, CProgress(2));
            EXPECT_EQ(modelDifference(*after, *createAnew(params, *detail)), "") << ref.key() << ", " << detail->name;
            int kept =
                invalid.stage > Stage::Mesh ? 4 : std::min(invalid.generation, static_cast<int>(after->stems.size()));
            // What becomes or was the last level is drawn in part: other stems than before.
            if (before->stems.size() != after->stems.size() && detail->share < 1) --kept;
            EXPECT_GE(sharedStems(*before, *after), kept) << ref.key() << ", " << detail->name;
        }
}

TEST(TreeCreator, ManyEditsGiveWhatANewCreatorGives) {
    std::mt19937 random(5);
    CTreeCreator creator;
    CParams params = smallTree();
    for (int edit = 0; edit < 150; ++edit) {
        const auto refs = numberParams();
        const ParamRef& ref = refs[random() % refs.size()];
        ref.set(params, otherValue(ref, params));
        if (edit % 10 == 9) params = smallTree();
        const Detail& detail = detailTable()[random() % detailTable().size()];
        const auto model = creator.create(params, detail, CProgress(2));
        ASSERT_EQ(modelDifference(*model, *createAnew(params, detail)), "")
            << "edit " << edit << ", " << ref.key() << ", " << detail.name;
        ASSERT_EQ(model->params, params);
    }
}

TEST(TreeCreator, OlderModelsStayAsTheyWere) {
    CTreeCreator creator;
    CParams params = smallTree();
    const auto first = creator.create(params, detailOf(Model::Full), CProgress(2));
    const auto copy = createAnew(params, detailOf(Model::Full));
    params.common.seed += 1;
    EXPECT_NE(modelDifference(*creator.create(params, detailOf(Model::Full), CProgress(2)), *first), "");
    EXPECT_EQ(modelDifference(*first, *copy), "");
}

TEST(TreeCreator, ForgettingStartsAnew) {
    CTreeCreator creator;
    const auto before = creator.create(smallTree(), detailOf(Model::Full), CProgress(2));
    creator.forget();
    const auto after = creator.create(smallTree(), detailOf(Model::Full), CProgress(2));
    EXPECT_NE(before->tree, after->tree);
    EXPECT_EQ(sharedStems(*before, *after), 0);
    EXPECT_NE(before->leaves(), after->leaves());
    EXPECT_EQ(modelDifference(*before, *after), "");
}

TEST(TreeCreator, TheNeutralSourceIgnoresTheSeed) {
    CParams params = smallTree();
    CTreeCreator creator(false);
    const auto before = creator.create(params, detailOf(Model::Full), CProgress(2));
    params.common.seed += 1;
    EXPECT_EQ(modelDifference(*before, *creator.create(params, detailOf(Model::Full), CProgress(2))), "");
    EXPECT_NE(modelDifference(*before, *createAnew(params, detailOf(Model::Full))), "");
}

TEST(TreeCreator, CountsAndMeshesAgree) {
    for (const Sample& sample : presets()) {
        const auto model = createAnew(sample.params, detailOf(Model::Simple));
        std::size_t vertices = 0, triangles = 0;
        for (const auto& mesh : model->meshes()) {
            EXPECT_GT(mesh->vertexCount(), 0u);
            vertices += mesh->vertexCount();
            triangles += mesh->triangleCount();
        }
        EXPECT_EQ(model->vertexCount(), vertices);
        EXPECT_EQ(model->triangleCount(), triangles);
        const auto& ms = model->milliseconds;
        EXPECT_GT(ms.total, 0);
        EXPECT_NEAR(ms.total, ms.structure + ms.smooth + ms.mesh, 0.01 * ms.total + 0.1);
    }
}

} // namespace stromar::test
