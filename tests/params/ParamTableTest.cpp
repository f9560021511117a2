#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/params/ParamTable.h"
#include "params/Support.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <map>

namespace stromar {
namespace {

using test::otherValue;
using test::param;
using test::valueOf;

/// The specification's table of parameters, copied by hand.
const std::map<std::string, double>& specified() {
    static const std::map<std::string, double> defaults = [] {
        std::map<std::string, double> all{{"Shape", 0},           {"BaseSize", 0.25},
                                          {"Scale", 10},          {"ScaleV", 0},
                                          {"ZScale", 1},          {"ZScaleV", 0},
                                          {"Levels", 3},          {"Ratio", 0.05},
                                          {"RatioPower", 1},      {"Lobes", 0},
                                          {"LobeDepth", 0},       {"Flare", 0.5},
                                          {"AttractionUp", 0},    {"AttractionAxis", 0}, {"0Scale", 1},
                                          {"0ScaleV", 0},         {"0BaseSplits", 0},
                                          {"Leaves", 0},          {"LeafShape", 0},
                                          {"LeafForm", 0},        {"LeafStalk", 0},
                                          {"LeafWhorl", 1},       {"LeafPlanes", 1},
                                          {"Season", 7},          {"Evergreen", 0},
                                          {"Flexibility", 1}, {"LeafColourV", 0.5},
                                          {"Leaf2Share", 0},      {"Leaf3Share", 0},
                                          {"Leaf4Share", 0},
                                          {"Trunks", 1},          {"TrunksSpread", 0.2},
                                          {"TrunksLean", 10},     {"Blossoms", 0},
                                          {"BlossomScale", 0.05}, {"BlossomMonth", 4.5},
                                          {"BlossomUp", 0},       {"BlossomPlanes", 1}, {"BlossomDome", 0}, {"LeafSunShade", 0},
                                          {"Fruits", 0},          {"FruitScale", 0.07},
                                          {"FruitScaleX", 1},     {"FruitStalk", 0.3},
                                          {"FruitMonth", 9},      {"LeafFold", 0},
                                          {"LeafRounding", 0},    {"LeafScale", 0.2},
                                          {"LeafScaleX", 0.5},    {"LeafBend", 0.3},
                                          {"LeafQuality", 1},     {"PruneRatio", 0},
                                          {"PruneWidth", 0.5},    {"PruneWidthPeak", 0.5},
                                          {"PrunePowerLow", 0.5}, {"PrunePowerHigh", 0.5},
                                          {"TextureWrapX", 1},    {"TextureWrapY", 1},
                                          {"MinRadius", 0.0005},  {"CloneHalving", 1},
                                          {"Seed", 13},           {"LobeFade", 1},
                                          {"Roots", 0},           {"RootReach", 1.2},
                                          {"RootHeight", 0.12},   {"0Length", 1},
                                          {"1Length", 0.5},       {"2Length", 0.5},
                                          {"3Length", 0.5},       {"0CurveRes", 3},
                                          {"1CurveRes", 3},       {"2CurveRes", 1},
                                          {"3CurveRes", 1},       {"1Branches", 10},
                                          {"2Branches", 5},       {"3Branches", 5}};
        for (const std::string n : {"0", "1", "2", "3"}) {
            for (const char* zero :
                 {"LengthV", "Curve", "CurveBack", "CurveV", "SegSplits", "SplitAngle", "SplitAngleV"})
                all[n + zero] = 0;
            all[n + "Taper"] = 1;
        }
        for (const std::string n : {"1", "2", "3"}) {
            all[n + "Whorl"] = 1;
            all[n + "BranchDist"] = 1;
            all[n + "BranchDistV"] = 0.25;
            all[n + "DownAngle"] = 30;
            all[n + "DownAngleV"] = 0;
            all[n + "Rotate"] = 120;
            all[n + "RotateV"] = 0;
        }
        return all;
    }();
    return defaults;
}

TEST(ParamTable, HoldsWhatTheSpecificationLists) {
    std::map<std::string, double> table;
    for (const ParamRef& ref : numberParams()) table[ref.key()] = std::get<double>(defaultOf(ref, weberPennBlock()));
    EXPECT_EQ(table, specified());
    EXPECT_EQ(numberParams().size(), specified().size()) << "a value is listed twice";
}

TEST(ParamTable, NewParamsHaveTheDefaults) {
    const CParams params;
    for (const auto& [key, value] : specified()) EXPECT_EQ(valueOf(params, key), value) << key;
    EXPECT_EQ(params.text.species, "default");
    EXPECT_EQ(params.block().method, "weber-penn");
    EXPECT_TRUE(params == CParams());
}

TEST(ParamTable, RangesOfTheSpecification) {
    const std::tuple<const char*, double, double> exact[] = {
        {"Shape", 0, 8},          {"BaseSize", 0, 1},     {"Levels", 1, 9},          {"LobeDepth", 0, 1},
        {"LobeFade", 0, 1},       {"0Taper", 0, 3},       {"1SplitAngle", 0, 180},   {"1SplitAngleV", 0, 180},
        {"1BranchDist", 0, 1},    {"1BranchDistV", 0, 1}, {"1DownAngle", -180, 180}, {"1Rotate", -360, 360},
        {"LeafShape", 0, 12},     {"LeafBend", 0, 1},     {"PruneRatio", 0, 1},      {"PruneWidth", 0, 1},
        {"PruneWidthPeak", 0, 1}, {"CloneHalving", 0, 1}};
    for (const auto& [key, least, most] : exact) {
        EXPECT_EQ(param(key).info->range.min, least) << key;
        EXPECT_EQ(param(key).info->range.max, most) << key;
    }
    for (const char* positive : {"Scale", "Ratio", "0Scale", "LeafScale", "LeafScaleX", "LeafQuality", "PrunePowerLow",
                                 "PrunePowerHigh", "TextureWrapX", "TextureWrapY"})
        EXPECT_GT(param(positive).info->range.min, 0) << positive;
    for (const char* fromZero :
         {"ScaleV", "0ScaleV", "Lobes", "0BaseSplits", "1Length", "1LengthV", "1SegSplits", "1Branches", "MinRadius"})
        EXPECT_EQ(param(fromZero).info->range.min, 0) << fromZero;
    EXPECT_EQ(param("Flare").info->range.min, -1);
    EXPECT_EQ(param("1CurveRes").info->range.min, 1);
    EXPECT_GT(param("1CurveV").info->range.min, -90);
    EXPECT_LT(param("1CurveV").info->range.min, -60);
    EXPECT_LT(param("Leaves").info->range.min, -100);
}

TEST(ParamTable, SetAndGetTouchOneValueOnly) {
    for (const ParamRef& ref : numberParams()) {
        CParams params;
        const double value = otherValue(*ref.info, ref.get(params));
        ASSERT_TRUE(ref.set(params, value)) << ref.key();
        EXPECT_EQ(ref.get(params), value) << ref.key();
        for (const ParamRef& other : numberParams())
            if (!(other == ref)) {
                EXPECT_EQ(other.get(params), other.get(CParams())) << ref.key() << " changed " << other.key();
            }
        EXPECT_NE(params, CParams()) << ref.key();
    }
}

TEST(ParamTable, SetClamps) {
    for (const ParamRef& ref : numberParams()) {
        const Range range = ref.info->range;
        CParams params;
        for (const double bound : {range.min, range.max}) {
            EXPECT_TRUE(ref.set(params, bound)) << ref.key();
            EXPECT_EQ(ref.get(params), bound) << ref.key();
        }
        EXPECT_FALSE(ref.set(params, range.max + 1)) << ref.key();
        EXPECT_EQ(ref.get(params), range.max) << ref.key();
        EXPECT_FALSE(ref.set(params, range.min - 1)) << ref.key();
        EXPECT_EQ(ref.get(params), range.min) << ref.key();
        EXPECT_FALSE(ref.set(params, 1e300)) << ref.key();
        EXPECT_EQ(ref.get(params), range.max) << ref.key();
        EXPECT_TRUE(range.contains(ref.info->useful.min) && range.contains(ref.info->useful.max)) << ref.key();
    }
}

TEST(ParamTable, IntegersAreRounded) {
    int integers = 0;
    for (const ParamRef& ref : numberParams()) {
        if (!ref.info->integer()) continue;
        ++integers;
        CParams params;
        EXPECT_FALSE(ref.set(params, ref.info->range.min + 0.7)) << ref.key();
        EXPECT_EQ(ref.get(params), ref.info->range.min + 1) << ref.key();
    }
    EXPECT_EQ(integers, 18 + 4 + 3 + 3); // whole tree, nCurveRes, nBranches, nWhorl
}

TEST(ParamTable, KeysAreFound) {
    for (const ParamRef& ref : allParams()) {
        const auto found = findParam(ref.key());
        ASSERT_TRUE(found) << ref.key();
        EXPECT_EQ(*found, ref);
    }
    for (const char* unknown : {"", "scale", "Length", "4Length", "0Branches", "0DownAngle", "Scale ", "00Scale"})
        EXPECT_FALSE(findParam(unknown)) << unknown;
}

CParams withLevels(int levels) {
    CParams params;
    weberPenn(params).levels = levels;
    return params;
}

Invalidation afterChangeOf(const ParamRef& ref, const CParams& before) {
    CParams after = before;
    ref.set(after, otherValue(*ref.info, ref.get(before)));
    return invalidationOf(before, after);
}

TEST(InvalidationOf, NothingForTheSameTree) { EXPECT_EQ(invalidationOf(CParams(), CParams()).stage, Stage::None); }

TEST(InvalidationOf, EveryRowNamesItsStage) {
    const std::vector<std::string> nothing{"ZScale", "ZScaleV"}, material{"Flexibility", "LeafColourV"};
    const std::vector<std::string> mesh{
        "MinRadius",  "Lobes",    "LobeDepth", "LobeFade",     "Roots",         "RootReach",    "RootHeight",
        "LeafShape",  "LeafForm", "LeafStalk", "LeafFold",     "LeafRounding",  "TextureWrapX", "TextureWrapY",
        "Leaf2Share", "Leaf3Share", "Leaf4Share",
        "LeafPlanes", "Season",   "Evergreen", "BlossomMonth", "BlossomPlanes", "BlossomDome", "LeafSunShade", "FruitStalk",   "FruitMonth"};
    const auto in = [](const std::vector<std::string>& list, const std::string& key) {
        return std::ranges::find(list, key) != list.end();
    };
    for (const ParamRef& ref : numberParams()) {
        const std::string key = ref.key();
        const Stage expected = in(nothing, key) ? Stage::None : in(mesh, key) ? Stage::Mesh : in(material, key) ? Stage::Material : Stage::Structure;
        EXPECT_EQ(afterChangeOf(ref, withLevels(4)).stage, expected) << key;
        EXPECT_EQ(ref.info->unused(), expected == Stage::None) << key;
    }
}

TEST(InvalidationOf, AValueOfALevelStartsAtItsGeneration) {
    for (const ParamRef& ref : numberParams())
        for (int levels = ref.info->perLevel() ? ref.level + 1 : 10; levels <= 9; ++levels)
            EXPECT_EQ(afterChangeOf(ref, withLevels(levels)), (Invalidation{Stage::Structure, ref.level})) << ref.key();
}

TEST(InvalidationOf, TheLevelBehindTheLastPlacesTheLeaves) {
    const std::vector<std::string> placing{"2DownAngle", "2DownAngleV", "2Rotate", "2RotateV", "2BranchDistV"};
    for (const ParamRef& ref : numberParams()) {
        if (!ref.info->perLevel() || ref.level < 2) continue;
        const bool places = std::ranges::find(placing, ref.key()) != placing.end();
        const Invalidation first = afterChangeOf(ref, withLevels(2));
        EXPECT_EQ(first.stage, places ? Stage::Structure : Stage::None) << ref.key();
        if (places) {
            EXPECT_EQ(first.generation, Invalidation::kLeaves) << ref.key();
        }
    }
}

TEST(InvalidationOf, LeavesAlone) {
    for (const char* key : {"Leaves", "LeafScale", "LeafScaleX", "LeafBend", "LeafQuality", "LeafWhorl", "Blossoms",
                            "BlossomScale", "BlossomUp", "Fruits", "FruitScale", "FruitScaleX"})
        EXPECT_EQ(afterChangeOf(param(key), CParams()), (Invalidation{Stage::Structure, Invalidation::kLeaves})) << key;
}

TEST(InvalidationOf, LevelsKeepsWhatBothTreesHave) {
    for (int from = 1; from <= 9; ++from)
        for (int to = 1; to <= 9; ++to) {
            const Invalidation expected = from == to ? Invalidation{} : Invalidation{Stage::Structure, std::min(from, to)};
            EXPECT_EQ(invalidationOf(withLevels(from), withLevels(to)), expected) << from << " to " << to;
        }
}

TEST(InvalidationOf, OfTwoChangesTheEarlierCounts) {
    for (const ParamRef& a : numberParams())
        for (const char* key : {"Seed", "1Curve", "2Curve", "Leaves", "MinRadius", "ZScale"}) {
            const ParamRef b = param(key);
            if (a == b || a.key() == "Levels") continue;
            const Invalidation alone = afterChangeOf(a, CParams()), other = afterChangeOf(b, CParams());
            CParams both;
            a.set(both, otherValue(*a.info, a.get(both)));
            b.set(both, otherValue(*b.info, b.get(both)));
            const Invalidation first = invalidationOf(CParams(), both);
            EXPECT_EQ(first.stage, std::min(alone.stage, other.stage)) << a.key() << " and " << key;
            for (const Invalidation& part : {alone, other}) {
                if (part.stage == Stage::None) continue;
                EXPECT_LE(first.generation, part.generation) << a.key() << " and " << key;
            }
        }
}

TEST(InvalidationOf, Texts) {
    CParams params;
    params.text.species = params.text.author = params.text.description = "other";
    EXPECT_EQ(invalidationOf(CParams(), params).stage, Stage::None);
    for (std::string TextParams::*picture : {&TextParams::barkTexture, &TextParams::leafTexture}) {
        CParams textured;
        textured.text.*picture = "bark.png";
        EXPECT_EQ(invalidationOf(CParams(), textured).stage, Stage::Material);
    }
}

TEST(ParamTable, WhatIsSaidToDoNothingDoesNothing) {
    CParams bare;
    weberPenn(bare).levels = 1;
    EXPECT_NE(inactiveReason(param("1Branches"), bare), "");
    EXPECT_NE(inactiveReason(param("LeafScale"), bare), "");
    EXPECT_NE(inactiveReason(param("Shape"), bare), "");
    EXPECT_EQ(inactiveReason(param("0Curve"), bare), "");
    EXPECT_NE(inactiveReason(param("0SplitAngle"), bare), "");
    weberPenn(bare).baseSplits = 2;
    EXPECT_EQ(inactiveReason(param("0SplitAngle"), bare), "") << "splits at the base use it";
    CParams without;
    weberPenn(without).level[1].branches = 0;
    EXPECT_EQ(inactiveReason(param("1Branches"), without), "") << "it is what brings them back";
    EXPECT_NE(inactiveReason(param("1Curve"), without), "");
    EXPECT_NE(inactiveReason(param("2Branches"), without), "");
    CParams envelope;
    weberPenn(envelope).shape = 8;
    EXPECT_EQ(inactiveReason(param("PrunePowerLow"), envelope), "") << "the crown's outline";
    EXPECT_NE(inactiveReason(param("PruneWidth"), envelope), "");
}

TEST(ParamTable, VariationsAreFoundByTheirKeys) {
    EXPECT_EQ(variationOf(*param("1DownAngle").info), param("1DownAngleV").info);
    EXPECT_EQ(variationOf(*param("Scale").info), param("ScaleV").info);
    EXPECT_EQ(variationOf(*param("Seed").info), nullptr);
    EXPECT_EQ(variationOf(*param("1DownAngleV").info), nullptr);
}

} // namespace
} // namespace stromar
