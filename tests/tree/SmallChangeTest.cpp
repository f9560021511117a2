#include "tree/Support.h"
#include <functional>
#include <gtest/gtest.h>
#include <map>

namespace stromar {
namespace {

using namespace test;

/// What may be asked of a stem that sits in the same place of two trees.
struct Aspect {
    const char* name;
    std::function<bool(const CGeneration&, const CStem&, const CGeneration&, const CStem&)> same;
};

const Aspect kLength{"length", [](const auto&, const CStem& s, const auto&, const CStem& t) {
                         return sameBits(s.length, t.length);
                     }};
const Aspect kLengthMax{"drawn length", [](const CGeneration& a, const CStem& s, const CGeneration& b, const CStem& t) {
                            return sameBits(scratchOf(a, s).lengthMax, scratchOf(b, t).lengthMax);
                        }};
const Aspect kOffset{"offset", [](const auto&, const CStem& s, const auto&, const CStem& t) {
                         return sameBits(s.offset, t.offset);
                     }};
const Aspect kRadius{"radius", [](const auto&, const CStem& s, const auto&, const CStem& t) {
                         return sameBits(s.radius, t.radius);
                     }};
const Aspect kBase{"base", [](const CGeneration& a, const CStem& s, const CGeneration& b, const CStem& t) {
                       return sameBits(firstSegment(a, s).position, firstSegment(b, t).position);
                   }};
const Aspect kFrame{"frame", [](const CGeneration& a, const CStem& s, const CGeneration& b, const CStem& t) {
                        return sameBits(firstSegment(a, s).frame, firstSegment(b, t).frame);
                    }};
const Aspect kClones{"clones", [](const CGeneration& a, const CStem& s, const CGeneration& b, const CStem& t) {
                         if (s.pathCount != t.pathCount) return false;
                         for (std::uint32_t p = 0; p < s.pathCount; ++p)
                             if (a.paths[s.firstPath + p].id != b.paths[t.firstPath + p].id) return false;
                         return true;
                     }};

/// A change, and what it leaves alone in one generation. `share` of the stems has to be in both trees.
struct Case {
    const char* key;
    double by;
    std::size_t generation;
    double share;
    std::vector<Aspect> stays;
    std::vector<Aspect> moves; ///< for some stem at least: the change did something
};

/// No pruning: it shortens by where a stem is, so that a bend anywhere changes lengths.
CParams tree() {
    return with(richTree(), {{"PruneRatio", 0}, {"2RotateV", 30}, {"1SplitAngle", 150}, {"1SegSplits", 0.4}});
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"2CurveV", 60, 2, 1, {kLength, kOffset, kRadius, kBase, kFrame, kClones}, {}},
        {"2Curve", 5, 2, 1, {kLength, kOffset, kRadius, kBase, kFrame}, {}},
        {"1DownAngle", 1, 1, 1, {kLength, kOffset, kRadius, kBase, kClones}, {kFrame}},
        {"1DownAngle", 1, 2, 1, {kLength, kOffset, kRadius}, {kBase, kFrame}},
        {"1Rotate", 3, 1, 1, {kLength, kOffset, kRadius, kBase}, {kFrame}},
        {"1LengthV", 0.05, 1, 1, {kOffset, kBase, kFrame, kClones}, {kLength}},
        {"1Length", 0.02, 1, 1, {kOffset, kBase, kFrame, kClones}, {kLength}},
        {"2DownAngleV", 5, 2, 1, {kLength, kOffset, kRadius, kBase}, {kFrame}},
        {"2RotateV", 5, 2, 1, {kLength, kOffset, kRadius, kBase}, {kFrame}},
        {"2LengthV", 0.02, 2, 1, {kOffset, kBase, kFrame}, {kLength}},
        {"1CurveV", 5, 1, 1, {kLength, kOffset, kRadius, kBase, kFrame, kClones}, {}},
        {"1CurveV", 5, 2, 1, {kLength, kOffset, kRadius}, {kBase}},
        {"0CurveV", 5, 1, 1, {kLength, kOffset, kRadius, kClones}, {kBase}},
        {"0Curve", 5, 2, 1, {kLength, kOffset, kRadius}, {kBase}},
        {"0SplitAngle", 5, 1, 1, {kLength, kOffset, kRadius}, {kBase}},
        {"1SplitAngle", 5, 2, 1, {kLength, kOffset, kRadius}, {kBase}},
        {"1SplitAngleV", 5, 1, 1, {kLength, kOffset, kRadius, kBase, kFrame, kClones}, {}},
        {"1BranchDistV", 0.1, 1, 1, {kLengthMax, kClones}, {kOffset}},
        {"AttractionUp", 0.5, 2, 1, {kLength, kOffset, kRadius, kBase, kFrame}, {}},
        {"AttractionUp", 0.5, 1, 1, {kLength, kOffset, kRadius, kBase, kFrame, kClones}, {}},
        {"RatioPower", 0.1, 1, 1, {kLength, kOffset, kBase, kFrame, kClones}, {kRadius}},
        {"Shape", 1, 1, 1, {kLengthMax, kOffset, kBase, kClones}, {}},
        {"1Branches", 1, 1, 0.5, {kLengthMax, kClones}, {}},
        {"2Branches", 1, 2, 0.5, {kLengthMax}, {}},
        {"3Branches", 1, 3, 0.5, {kLengthMax}, {}},
        {"0BaseSplits", 1, 1, 0.25, {kLengthMax}, {}},
    };
    return all;
}

bool all(const Aspect& aspect, const CGeneration& a, const CGeneration& b, std::size_t& shared) {
    std::map<std::uint64_t, const CStem*> other;
    for (const CStem& stem : b.stems) other.emplace(stem.id, &stem);
    shared = 0;
    bool same = true;
    for (const CStem& stem : a.stems)
        if (const auto twin = other.find(stem.id); twin != other.end()) {
            ++shared;
            same = same && aspect.same(a, stem, b, *twin->second);
        }
    return same;
}

TEST(SmallChange, LeavesAloneWhatItDoesNotConcern) {
    for (int seed = 1; seed <= 5; ++seed)
        for (const auto& [key, by, generation, share, stays, moves] : cases()) {
            const CParams before = with(tree(), {{"Seed", double(seed)}});
            const CParams after = with(before, {{key, param(key).get(before) + by}});
            ASSERT_NE(before, after) << key;
            const auto old = grow(before), now = grow(after);
            const CGeneration &a = old->generation(generation), &b = now->generation(generation);
            std::size_t shared = 0;
            for (const Aspect& aspect : stays)
                EXPECT_TRUE(all(aspect, a, b, shared))
                    << key << " changes the " << aspect.name << " in generation " << generation;
            EXPECT_GE(double(shared), share * double(a.stems.size()))
                << key << ", generation " << generation << ", seed " << seed;
            if (share == 1) {
                EXPECT_EQ(a.stems.size(), b.stems.size()) << key;
            }
            for (const Aspect& aspect : moves)
                EXPECT_FALSE(all(aspect, a, b, shared))
                    << key << " leaves the " << aspect.name << " in generation " << generation;
        }
}

TEST(SmallChange, LowerGenerationsNeverNotice) {
    const CParams before = tree();
    const auto old = grow(before);
    for (const ParamRef& ref : numberParams()) {
        if (!ref.info->perLevel() || ref.level == 0) continue;
        const CParams after = with(before, {{ref.key(), ref.get(before) + ref.info->step}});
        const auto now = grow(after);
        for (std::size_t g = 0; g < static_cast<std::size_t>(ref.level); ++g)
            EXPECT_TRUE(same(old->generation(g), now->generation(g))) << ref.key() << " changes generation " << g;
    }
}

TEST(SmallChange, LeafValuesKeepEveryStem) {
    const auto old = grow(tree());
    for (const char* key : {"Leaves", "LeafScale", "LeafScaleX", "LeafBend", "LeafQuality"}) {
        const auto now = grow(with(tree(), {{key, param(key).get(tree()) * 1.5}}));
        for (std::size_t g = 0; g < 4; ++g) EXPECT_TRUE(same(old->generation(g), now->generation(g))) << key;
        EXPECT_FALSE(sameArrays(old->leaves(), now->leaves())) << key;
    }
}

TEST(SmallChange, AnotherSeedIsAnotherTree) {
    const auto old = grow(tree()), now = grow(with(tree(), {{"Seed", 14}}));
    for (std::size_t g = 0; g < 4; ++g) EXPECT_FALSE(same(old->generation(g), now->generation(g))) << g;
    EXPECT_FALSE(sameArrays(old->leaves(), now->leaves()));
    EXPECT_NE(old->height(), now->height());
}

TEST(SmallChange, OneLevelMoreKeepsTheOthers) {
    const CParams before = with(tree(), {{"Levels", 3}});
    const auto old = grow(before), now = grow(with(before, {{"Levels", 4}}));
    for (std::size_t g = 0; g < 3; ++g) EXPECT_TRUE(same(old->generation(g), now->generation(g))) << g;
}

} // namespace
} // namespace stromar
