#include "Checkout.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Randomise.h"
#include "stromar/app/Demonstration.h"
#include "stromar/app/Prediction.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/params/ParamText.h"
#include "stromar/params/TreeFile.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace stromar {
namespace {

CParams aspen() { return CTreeFile::read(test::inSource("presets/quaking_aspen.tree")).params(); }
ParamRef param(const char* key) { return *findParam(key); }

TEST(Randomise, MovesNumbersWithinTheAmountAndTheUsefulRange) {
    const CParams params = aspen();
    for (const double amount : {0.1, 1.0}) {
        const auto values = randomised(params, numberParams(), amount, 7);
        EXPECT_GT(values.size(), 30u);
        for (const auto& [ref, moved] : values) {
            const double value = std::get<double>(moved);
            const Range& useful = ref.info->useful;
            const double half = (useful.max - useful.min) / 2, digits = 0.5 * std::pow(10, -ref.info->decimals);
            EXPECT_LE(std::abs(value - ref.get(params)), amount * half + digits + 1e-9) << ref.key();
            EXPECT_GE(value, std::min(useful.min, ref.get(params))) << ref.key();
            EXPECT_LE(value, std::max(useful.max, ref.get(params))) << ref.key();
            if (ref.info->integer()) {
                EXPECT_EQ(value, std::round(value)) << ref.key();
            }
        }
    }
}

TEST(Randomise, LeavesChoicesTheSeedAndWhatDoesNothingAlone) {
    const auto values = randomised(aspen(), numberParams(), 1, 7);
    for (const auto& [ref, value] : values) {
        EXPECT_TRUE(ref.info->words.empty()) << ref.key();
        EXPECT_NE(ref.key(), "Seed");
        EXPECT_EQ(inactiveReason(ref, aspen()), "") << ref.key();
    }
}

TEST(Randomise, OneValueLessMovesNoOther) {
    const auto all = randomised(aspen(), numberParams(), 0.5, 7);
    std::vector<ParamRef> fewer(numberParams().begin(), numberParams().end());
    std::erase(fewer, param("Scale"));
    auto expected = all;
    std::erase_if(expected, [](const auto& v) { return v.first.key() == "Scale"; });
    EXPECT_EQ(randomised(aspen(), fewer, 0.5, 7), expected);
    EXPECT_NE(randomised(aspen(), numberParams(), 0.5, 8), all);
}

TEST(Randomise, EverythingByMuchIsStillATree) {
    const auto grown = [](const CParams& params) { return CTreeCreator().create(params, detailOf(Model::Simple), CProgress(2)); };
    int changed = 0;
    for (const char* name : {"quaking_aspen", "apple", "coconut_palm"}) {
        const CParams params = CTreeFile::read(test::inSource("presets/") + name + ".tree").params();
        const auto before = grown(params);
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const ParamValues values = randomisedTree(params, numberParams(), 0.4, seed, SizeLimits());
            EXPECT_EQ(values, randomisedTree(params, numberParams(), 0.4, seed, SizeLimits()));
            changed += values != randomised(params, numberParams(), 0.4, seed);
            CParams moved = params;
            for (const auto& [ref, value] : values) ref.setValue(moved, value);
            const auto tree = grown(moved);
            EXPECT_GE(5 * tree->tree->stemCount(), before->tree->stemCount()) << name << ", seed " << seed;
            EXPECT_GE(5 * tree->tree->organs(Organ::Leaf)->total, before->tree->organs(Organ::Leaf)->total) << name << ", seed " << seed;
            EXPECT_GE(3 * tree->bounds()->max.z, before->bounds()->max.z) << name << ", seed " << seed;
        }
    }
    EXPECT_GT(changed, 3) << "some throws are no trees";
}

TEST(NearestThatFits, IsTheLastThatIsNotTooLarge) {
    const Detail& full = detailOf(Model::Full);
    for (const char* key : {"1Branches", "2Branches", "Leaves", "1CurveRes", "LeafQuality", "2SegSplits"}) {
        CParams params = aspen();
        const ParamRef ref = param(key);
        const double fits = ref.get(params);
        ref.set(params, ref.info->range.max);
        if (predictSize(params, full).vertices <= 2e6) continue;
        const double found = nearestThatFits(params, ref, fits, full, {2e6, 1e12});
        EXPECT_GE(found, fits) << key;
        ref.set(params, found);
        EXPECT_LE(predictSize(params, full).vertices, 2e6) << key;
        ref.set(params, found + 1.01 * (ref.info->integer() ? 1 : std::pow(10, -ref.info->decimals)));
        EXPECT_GT(predictSize(params, full).vertices, 2e6) << key;
    }
}

TEST(Demonstration, DiffersInItsOwnValueAlone) {
    for (const ParamRef& ref : numberParams()) {
        const auto shown = demonstrationsOf(ref);
        EXPECT_EQ(shown.empty(), ref.info->unused() || ref.info->group == Group::Textures) << ref.key();
        const ParamRef own{ref.info, std::min(ref.level, 1)};
        for (const Demonstration& one : shown) {
            CParams same = one.params;
            own.set(same, own.get(shown.front().params));
            EXPECT_TRUE(same == shown.front().params) << ref.key();
            EXPECT_EQ(own.get(one.params), one.value) << ref.key();
            EXPECT_EQ(inactiveReason(own, one.params), "") << ref.key() << ": what is shown must act";
        }
    }
}

TEST(Demonstration, ItsTreesDifferAndAreSmall) {
    for (const ParamRef& ref : numberParams()) {
        if (ref.level > 1) continue;
        for (const Demonstration& one : demonstrationsOf(ref))
            EXPECT_LT(predictSize(one.params, detailOf(Model::Full)).vertices, 3e5) << ref.key();
    }
}

/// All that one sees of a tree.
bool sameMeshes(const TreeModel& a, const TreeModel& b) {
    const auto x = a.meshes(), y = b.meshes();
    return std::ranges::equal(x, y, [](const auto& p, const auto& q) {
        return std::ranges::equal(p->positions, q->positions) && std::ranges::equal(p->texCoords, q->texCoords) &&
               std::ranges::equal(p->indices, q->indices) && std::ranges::equal(p->normals, q->normals);
    });
}

TEST(WhyIdle, WhatIsGreyedChangesNothing) {
    std::vector<CParams> trees(6);
    weberPenn(trees[0]).levels = 1;
    weberPenn(trees[1]).levels = 2;
    weberPenn(trees[1]).leaves = 5;
    weberPenn(trees[2]).level[1].curveV = -30;
    weberPenn(trees[2]).level[1].curveRes = 4;
    weberPenn(trees[3]).level[2].branches = 0;
    weberPenn(trees[4]).shape = 8;
    weberPenn(trees[4]).leaves = 3;
    weberPenn(trees[5]).levels = 4;
    weberPenn(trees[5]).level[3].branches = 2;
    for (CParams& tree : trees) weberPenn(tree).level[1].branches = 4;
    int greyed = 0;
    for (const CParams& tree : trees) {
        const auto before = CTreeCreator().create(tree, detailOf(Model::Full), CProgress(1));
        for (const ParamRef& ref : numberParams()) {
            if (ref.info->unused() || inactiveReason(ref, tree).empty()) continue;
            CParams other = tree;
            const Range& useful = ref.info->useful;
            ref.set(other, ref.get(tree) == useful.max ? useful.min : useful.max);
            EXPECT_TRUE(sameMeshes(*before, *CTreeCreator().create(other, detailOf(Model::Full), CProgress(1))))
                << ref.key() << ": " << inactiveReason(ref, tree);
            ++greyed;
        }
    }
    EXPECT_GT(greyed, 100);
}

} // namespace
} // namespace stromar
