#pragma once
#include "Checkout.h"
#include "stromar/params/TreeFile.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include "weberpenn/Grown.h"
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <initializer_list>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <utility>

namespace stromar::test {

using TreePtr = std::shared_ptr<const CTree>;
using Values = std::initializer_list<std::pair<std::string_view, double>>;

inline TreePtr grow(const CParams& params, bool varied = true, int threads = 1) {
    return growTree(CWeberPennBuilder(varied), params, CProgress(threads));
}

/// Every random draw in the middle.
inline TreePtr growNeutral(const CParams& params) { return grow(params, false); }

inline ParamRef param(std::string_view key) { return findParam(key).value(); }

inline CParams with(CParams params, Values values) {
    for (const auto& [key, value] : values) param(key).set(params, value);
    return params;
}

inline CParams preset(const std::string& name) {
    return CTreeFile::read(inSource("presets/" + name + ".tree")).params();
}

inline double degrees(double radians) { return radians * 180 / std::numbers::pi; }
inline double declinationOf(const CSegment& segment) { return degrees(declination(segment.frame)); }
/// Of a horizontal part, counterclockwise from x, degrees.
inline double azimuthOf(const glm::dvec3& v) { return degrees(std::atan2(v.y, v.x)); }
inline double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}
/// The difference of two directions, −180..180.
inline double turnFrom(double from, double to) { return std::remainder(to - from, 360); }

inline const CSegment& segmentOf(const CGeneration& generation, const CStem& stem, std::uint32_t path,
                                 std::uint32_t position) {
    return generation.segmentAt(stem, path, position);
}
/// How many segments the builder gives a stem of a generation from base to tip.
inline std::uint32_t curveRes(const CGeneration& generation) {
    return static_cast<const CGrownGeneration&>(generation).curveRes;
}
/// What the builder keeps of a stem.
inline const StemScratch& scratchOf(const CGeneration& generation, const CStem& stem) {
    const auto& grown = static_cast<const CGrownGeneration&>(generation);
    return grown.scratch.at(static_cast<std::size_t>(&stem - grown.stems.data()));
}

inline const CSegment& firstSegment(const CGeneration& generation, const CStem& stem) {
    return generation.segments.at(stem.firstSegment);
}

// Equal to the last bit; structs are compared by fields because of their padding.
template <typename T>
bool sameBits(const T& a, const T& b) {
    static_assert(std::is_trivially_copyable_v<T>);
    return std::memcmp(&a, &b, sizeof a) == 0;
}
inline bool same(const CStem& a, const CStem& b) {
    return a.id == b.id && sameBits(a.length, b.length) && sameBits(a.radius, b.radius) &&
           sameBits(a.offset, b.offset) && sameBits(a.parentRadius, b.parentRadius) && sameBits(a.birth, b.birth) &&
           sameBits(a.profile.narrowing, b.profile.narrowing) && sameBits(a.profile.depth, b.profile.depth) &&
           a.profile.form == b.profile.form && a.parent == b.parent && a.path == b.path && a.position == b.position &&
           a.firstPath == b.firstPath && a.pathCount == b.pathCount && a.firstSegment == b.firstSegment &&
           a.segmentCount == b.segmentCount;
}
inline bool same(const CPath& a, const CPath& b) {
    return a.id == b.id && a.firstSegment == b.firstSegment && a.segmentCount == b.segmentCount &&
           a.firstPosition == b.firstPosition && a.source == b.source;
}
inline bool same(const CSegment& a, const CSegment& b) {
    return sameBits(a.position, b.position) && sameBits(a.frame, b.frame) && sameBits(a.start, b.start) && sameBits(a.length, b.length) &&
           sameBits(a.radiusBase, b.radiusBase) && sameBits(a.radiusEnd, b.radiusEnd) &&
           sameBits(a.helixRadius, b.helixRadius) && a.forks == b.forks;
}
inline bool same(const CLeaf& a, const CLeaf& b) {
    return sameBits(a.position, b.position) && sameBits(a.axis, b.axis) && sameBits(a.normal, b.normal) &&
           sameBits(a.length, b.length) && sameBits(a.width, b.width) && a.stem == b.stem && a.generation == b.generation;
}
template <typename Array>
bool sameArrays(const Array& a, const Array& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return same(x, y); });
}
inline bool same(const CGeneration& a, const CGeneration& b) {
    return sameArrays(a.stems, b.stems) && sameArrays(a.paths, b.paths) && sameArrays(a.segments, b.segments);
}
inline const std::string kBaseForm = "the trunks' base";
/// What differs first, or nothing.
inline std::string difference(const CTree& a, const CTree& b) {
    if (!sameBits(a.height(), b.height())) return "the height";
    if (a.generationCount() != b.generationCount()) return "the number of generations";
    for (std::size_t g = 0; g < a.generationCount(); ++g)
        if (!same(a.generation(g), b.generation(g))) return "generation " + std::to_string(g);
    for (const Organ organ : kOrgans)
        if (!sameArrays(a.grown(organ), b.grown(organ)))
            return "organ " + std::to_string(static_cast<int>(organ)); // 0 the leaves
    return a.base() == b.base() ? "" : kBaseForm;
}

/// A small tree with some of everything: splits, a helix, graded angles, alternating branches, pruning, leaves.
inline CParams richTree() {
    return with(
        {}, {{"Levels", 4},       {"Scale", 9},         {"ScaleV", 2},       {"BaseSize", 0.2},    {"Shape", 7},
             {"Ratio", 0.03},     {"RatioPower", 1.2},  {"Flare", 0.8},      {"0BaseSplits", 1},   {"0ScaleV", 0.1},
             {"0SegSplits", 0.3}, {"0SplitAngle", 20},  {"0SplitAngleV", 5}, {"0CurveRes", 6},     {"0CurveV", 30},
             {"0LengthV", 0.1},   {"1Branches", 12},    {"1DownAngle", 60},  {"1DownAngleV", -30}, {"1Rotate", 140},
             {"1RotateV", 20},    {"1LengthV", 0.1},    {"1CurveRes", 4},    {"1Curve", 20},       {"1CurveBack", -30},
             {"1CurveV", 40},     {"1SegSplits", 0.2},  {"1SplitAngle", 30}, {"1SplitAngleV", 10}, {"2Branches", 6},
             {"2DownAngleV", 10}, {"2Rotate", -120},    {"2RotateV", 15},    {"2CurveRes", 3},     {"2CurveV", -25},
             {"2LengthV", 0.05},  {"3Branches", 4},     {"3Length", 0.3},    {"3CurveRes", 2},     {"3Curve", 10},
             {"3SegSplits", 0.1}, {"3SplitAngle", 20},  {"AttractionUp", 1}, {"Leaves", 7},        {"PruneRatio", 0.7},
             {"PruneWidth", 0.4}, {"3BranchDist", 0.5}, {"1BranchDist", 0.8}});
}

/// Legal but moderate: values from the sliders' ranges, counts drawn from smaller ones.
inline CParams randomTree(unsigned seed) {
    static const std::map<std::string, Range> counts{
        {"1Branches", {5, 40}},   {"2Branches", {3, 14}},   {"3Branches", {2, 8}},    {"Leaves", {-12, 12}},
        {"0BaseSplits", {0, 3}},  {"0SegSplits", {0, 0.6}}, {"1SegSplits", {0, 0.5}}, {"2SegSplits", {0, 0.4}},
        {"3SegSplits", {0, 0.4}}, {"0CurveRes", {1, 9}},    {"1CurveRes", {1, 7}},    {"2CurveRes", {1, 5}},
        {"3CurveRes", {1, 4}},    {"LeafQuality", {0.1, 2}}};
    std::mt19937 random(seed);
    CParams params;
    for (const ParamRef& ref : numberParams()) {
        const auto capped = counts.find(ref.key());
        const Range range = capped == counts.end() ? ref.info->useful : capped->second;
        ref.set(params, std::uniform_real_distribution<double>(range.min, range.max)(random));
    }
    weberPenn(params).trunkScaleV = std::min(weberPenn(params).trunkScaleV, 0.9 * weberPenn(params).trunkScale);
    if (seed % 2) weberPenn(params).pruneRatio = 0;
    return params;
}

} // namespace stromar::test
