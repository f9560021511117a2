#include "Grown.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
/// Error diffusion makes at most one clone more than the sum of what is wanted, so the paths after joint k are at most
/// 2 + W(k), W the sum wanted so far; W grows by n per path, by n/2 for paths that already split.
void boundPaths(const CParams& params, int generation, GenerationBound& bound) {
    const LevelParams& level = levelOf(params, generation);
    const WeberPennParams& w = weberPenn(params);
    const double base = generation == 0 && level.curveRes > 1 ? w.baseSplits : 0;
    const double often = w.cloneHalving ? level.segSplits / 2 : level.segSplits;
    const double extra = level.segSplits > 0 ? 1 : 0;
    double wanted = 0;
    for (int joint = 0; joint + 1 < level.curveRes; ++joint) {
        if (joint > 0 || base == 0) wanted += often * bound.paths + (level.segSplits - often) * (1 + base);
        bound.paths = 1 + base + extra + wanted;
        bound.segments += bound.paths;
    }
}

/// Of a stem's radius over its parent's (Weber & Penn §4.4: by the power of the lengths' ratio, never thicker).
double thinningBound(const CParams& params, int generation) {
    const LevelParams& level = levelOf(params, generation);
    const double longest = level.length + std::abs(level.lengthV), power = weberPenn(params).ratioPower;
    return power > 0 ? std::min(1.0, std::pow(longest, power)) : 1;
}

double turnBound(const CParams& params, int generation) {
    constexpr double kSteepest = 104.3; // of declination × sine of it, degrees
    const LevelParams& level = levelOf(params, generation);
    const double forth = std::abs(level.curve.value), back = std::abs(level.curveBack.value);
    const double up = generation >= 2 ? std::abs(weberPenn(params).attractionUp) * kSteepest : 0;
    return ((back == 0 ? forth : 2 * std::max(forth, back)) + std::abs(level.curveV.value) + up) / level.curveRes;
}

GenerationBound boundOf(const CParams& params, int generation) {
    const LevelParams& level = levelOf(params, generation);
    GenerationBound bound;
    boundPaths(params, generation, bound);
    bound.along = level.curveRes;
    bound.turn = turnBound(params, generation);
    bound.forks = level.segSplits > 0 || (generation == 0 && weberPenn(params).baseSplits > 0);
    bound.helix = level.curveV.value < 0;
    bound.roundEnds = level.taper > 1;
    bound.spheres = level.taper > 2;
    return bound;
}

BearerBound bearersOf(const CParams& params) {
    const WeberPennParams& w = weberPenn(params);
    const CommonParams& c = params.common;
    if (w.levels < 2) return {};
    double length = w.scale;
    for (int g = 0; g < w.levels; ++g) length *= levelOf(params, g).length;
    return {std::abs(w.leaves) * c.leafQuality, length, c.leafScale / std::sqrt(c.leafQuality)};
}
} // namespace

SizeBound weberPennBound(const CParams& params) {
    const WeberPennParams& w = weberPenn(params);
    const CommonParams& c = params.common;
    SizeBound bound;
    bound.base = baseFormOf(c);
    bound.scratchPerStem = sizeof(StemScratch);
    bound.scratchPerSegment = sizeof(double);
    double stems = w.trunks, thickness = 1;
    for (int g = 0; g < w.levels; ++g) {
        const LevelParams& level = levelOf(params, g);
        if (g > 0) {
            stems *= level.branches > 0 ? level.branches + level.whorl : 0; // whole whorls
            thickness *= thinningBound(params, g);
        }
        GenerationBound own = boundOf(params, g);
        own.stems = stems;
        own.thickness = thickness;
        bound.generations.push_back(own);
    }
    if (w.levels < 2) return bound;
    const auto organs = [&](double number, double whorl) {
        return number == 0 ? 0 : stems * (std::abs(number) + (number > 0 ? whorl : bound.generations.back().paths));
    };
    bound.organs = {organs(w.leaves * c.leafQuality, c.leafWhorl), organs(c.blossoms, 1), organs(c.fruits, 1)};
    bound.bearers = bearersOf(params);
    return bound;
}

} // namespace stromar
