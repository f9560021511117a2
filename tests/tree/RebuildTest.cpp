#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "tree/Support.h"
#include <gtest/gtest.h>
#include <limits>

namespace stromar {
namespace {

using namespace test;

/// The first generation to grow again; none for changes that do not concern the structure.
int firstGeneration(const CParams& before, const CParams& after) {
    const Invalidation first = invalidationOf(before, after);
    return first.stage == Stage::Structure ? first.generation : std::numeric_limits<int>::max();
}

TreePtr regrow(const CParams& before, const CTree& tree, const CParams& after) {
    const CWeberPennBuilder builder;
    const auto stems = builder.build(after, &tree, firstGeneration(before, after), CProgress(1));
    OrganArrays organs;
    for (const Organ organ : kOrgans)
        organs[static_cast<std::size_t>(organ)] = builder.growOrgans(after, *stems, organ, {}, CProgress(1));
    return std::make_shared<const CTree>(stems->withOrgans(organs));
}

/// Grows the least and everything: the same to the last bit, and what is kept is shared, not copied.
void expectSameAsFull(const CParams& before, const CTree& tree, const CParams& after, const std::string& what) {
    const auto partial = regrow(before, tree, after);
    EXPECT_EQ(difference(*partial, *grow(after)), "") << what;
    const auto kept = static_cast<std::size_t>(firstGeneration(before, after));
    for (std::size_t g = 0; g < std::min({kept, tree.generationCount(), partial->generationCount()}); ++g)
        EXPECT_EQ(partial->generations()[g], tree.generations()[g]) << what << " copied generation " << g;
}

/// Neighbouring values: a step up and down, and one far away.
std::vector<double> changes(const ParamRef& ref, const CParams& params) {
    const double old = ref.get(params),
                 far = ref.info->useful.min + 0.7 * (ref.info->useful.max - ref.info->useful.min);
    std::vector<double> values;
    for (const double value : {old + ref.info->step, old - ref.info->step, far}) {
        CParams changed = params;
        ref.set(changed, value);
        const double allowed = ref.get(changed);
        const bool tooMany = allowed > old + 10 && ref.info->integer() && ref.info->key != "Seed";
        if (allowed != old && !tooMany) values.push_back(allowed);
    }
    return values;
}

std::vector<CParams> startingTrees() {
    return {richTree(), with(richTree(), {{"Levels", 2}, {"Leaves", -5}}),
            with(richTree(),
                 {{"Levels", 3}, {"PruneRatio", 0}, {"1CurveV", -20}, {"2DownAngleV", -20}, {"3BranchDistV", 1}}),
            with(richTree(), {{"Levels", 5}, {"2Branches", 3}, {"3Branches", 3}, {"Shape", 8}, {"Leaves", 2}})};
}

TEST(Rebuild, EveryRowGivesTheSameAsAFullBuild) {
    int tried = 0;
    for (const CParams& before : startingTrees()) {
        const auto tree = grow(before);
        for (const ParamRef& ref : numberParams())
            for (const double value : changes(ref, before)) {
                CParams after = before;
                ref.set(after, value);
                expectSameAsFull(before, *tree, after,
                                 ref.key() + " " + std::to_string(value) + ", levels " +
                                     std::to_string(weberPenn(before).levels));
                ++tried;
            }
    }
    EXPECT_GT(tried, 600);
}

TEST(Rebuild, WhatIsNoStructureChangesNone) {
    const CParams before = richTree();
    const auto tree = grow(before);
    int rows = 0;
    for (const ParamRef& ref : numberParams())
        for (const double value : changes(ref, before)) {
            CParams after = before;
            ref.set(after, value);
            if (invalidationOf(before, after).stage == Stage::Structure) continue;
            const std::string differs = difference(*tree, *grow(after)); // the base's form is drawn, not grown
            EXPECT_TRUE(differs.empty() || (differs == kBaseForm && invalidationOf(before, after).stage == Stage::Mesh))
                << ref.key() << " changes " << differs;
            ++rows;
        }
    EXPECT_GT(rows, 8);
}

TEST(Rebuild, EveryStructureRowHasAnEffect) {
    // the ground bears branches, and every level splits by more than it leans
    const CParams low =
        with(richTree(),
             {{"BaseSize", 0}, {"2SegSplits", 0.5}, {"1SplitAngle", 170}, {"2SplitAngle", 170}, {"3SplitAngle", 170}});
    const CParams flowering = with(richTree(), {{"Levels", 2}, {"Trunks", 2}, {"Blossoms", 4}, {"Fruits", 3}});
    const std::vector<CParams> trees{richTree(), with(richTree(), {{"Shape", 8}}), with(richTree(), {{"Levels", 3}}),
                                     low, flowering};
    for (const ParamRef& ref : numberParams()) {
        bool invalid = false, changed = false;
        for (const CParams& before : trees)
            for (const double value : changes(ref, before)) {
                CParams after = before;
                ref.set(after, value);
                if (invalidationOf(before, after).stage != Stage::Structure) continue;
                invalid = true;
                changed = changed || !difference(*grow(before), *grow(after)).empty();
            }
        EXPECT_EQ(invalid, changed) << ref.key() << " asks for a new structure that is the old one";
    }
}

TEST(Rebuild, TwoChangesAtOnce) {
    const CParams before = richTree();
    const auto tree = grow(before);
    const Values pairs[] = {{{"2Curve", 15}, {"Leaves", 9}},      {{"3Length", 0.4}, {"1DownAngle", 50}},
                            {{"Levels", 3}, {"2CurveRes", 4}},    {{"Levels", 5}, {"3Curve", 30}},
                            {{"Levels", 3}, {"3DownAngle", 70}},  {{"Levels", 2}, {"Seed", 14}},
                            {{"MinRadius", 0.01}, {"3Taper", 2}}, {{"Levels", 6}, {"3Branches", 3}, {"LeafBend", 0.9}}};
    for (const Values& values : pairs) {
        const CParams after = with(before, values);
        expectSameAsFull(before, *tree, after, std::string(values.begin()->first));
    }
}

TEST(Rebuild, AChainOfChangesEndsWhereAFullBuildDoes) {
    CParams params = richTree();
    TreePtr tree = grow(params);
    std::mt19937 random(5);
    for (int i = 0; i < 60; ++i) {
        const ParamRef ref = numberParams()[random() % numberParams().size()];
        const std::vector<double> values = changes(ref, params);
        if (values.empty()) continue;
        CParams next = params;
        ref.set(next, values[0]);
        if (weberPenn(next).levels > 4) weberPenn(next).levels = 4;
        tree = regrow(params, *tree, next);
        params = next;
    }
    EXPECT_EQ(difference(*tree, *grow(params)), "");
}

TEST(Rebuild, WithoutAPreviousTreeAllIsGrown) {
    const auto tree = CWeberPennBuilder(true).build(richTree(), nullptr, 3, CProgress(1));
    EXPECT_EQ(difference(*tree, grow(richTree())->withOrgans({tree->organs(Organ::Leaf), tree->organs(Organ::Blossom),
                                                              tree->organs(Organ::Fruit)})),
              "");
}

TEST(Rebuild, StopsWhenCancelled) {
    const CProgress progress(2);
    progress.cancel();
    EXPECT_THROW(CWeberPennBuilder(true).build(richTree(), nullptr, 0, progress), CCancelled);
}

} // namespace
} // namespace stromar
