#include "stromar/app/Prediction.h"
#include "stromar/app/Pictures.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/mesh/Twig.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/Season.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace stromar {

namespace {
/// Paths and segments that a stem has at most.
struct StemBound {
    double paths, segments;
};

/// Error diffusion makes at most one clone more than the sum of what is wanted, so the paths after joint k are at most
/// 2 + W(k), W the sum wanted so far; W grows by n per path, by n/2 for paths that already split.
StemBound boundOfStem(const CParams& params, int generation) {
    const LevelParams& level = params.level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))];
    const GlobalParams& g = params.global;
    const double base = generation == 0 && level.curveRes > 1 ? g.baseSplits : 0;
    const double often = g.cloneHalving ? level.segSplits / 2 : level.segSplits;
    const double extra = level.segSplits > 0 ? 1 : 0;
    double wanted = 0, paths = 1, segments = 1;
    for (int joint = 0; joint + 1 < level.curveRes; ++joint) {
        if (joint > 0 || base == 0) wanted += often * paths + (level.segSplits - often) * (1 + base);
        paths = 1 + base + extra + wanted;
        segments += paths;
    }
    return {paths, segments};
}

/// How thick a stem of a generation is at most, as a part of the trunk's radius (Weber & Penn §4.4: by the power of the
/// lengths' ratio, never thicker than its parent).
double thicknessBound(const CParams& params, int generation) {
    double thickness = 1;
    for (int g = 1; g <= generation; ++g) {
        const LevelParams& level = params.level[static_cast<std::size_t>(std::min(g, kParamLevels - 1))];
        const double longest = level.length + std::abs(level.lengthV);
        thickness *= params.global.ratioPower > 0 ? std::min(1.0, std::pow(longest, params.global.ratioPower)) : 1;
    }
    return thickness;
}

double ringPoints(const CParams& params, const Detail& detail, int generation) {
    const int round = roundRingPoints(detail, std::sqrt(thicknessBound(params, generation)));
    return std::max(round,
                    generation == 0 ? detail.lobePoints * std::max(params.global.lobes, params.global.roots) : 0);
}

/// Degrees between two segments of a stem that does not split.
double turnBound(const CParams& params, int generation) {
    const LevelParams& level = params.level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))];
    const double curve =
        level.curveBack == 0 ? std::abs(level.curve) : 2 * std::max(std::abs(level.curve), std::abs(level.curveBack));
    const double steepest = 104.3; // of declination × sine of it
    const double up = generation >= 2 ? std::abs(params.global.attractionUp) * steepest : 0;
    return (curve + std::abs(level.curveV) + up) / level.curveRes;
}

/// Rings that CCentreLine makes of a corner.
double ringsPerBend(const CParams& params, const Detail& detail, int generation) {
    constexpr double kMost = 6;
    const LevelParams& level = params.level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))];
    if (detail.mostTurn <= 0 || ringPoints(params, detail, generation) <= 3) return 0;
    if (level.segSplits > 0 || (generation == 0 && params.global.baseSplits > 0)) return kMost;
    const double between = detail.mostTurn / std::sqrt(thicknessBound(params, generation));
    const double pieces = std::ceil(turnBound(params, generation) / std::min(between, kCoarsestTurn * detail.mostTurn));
    return pieces <= 1 ? 0 : std::min(kMost, 2 * std::floor((pieces + 1) / 2));
}

/// Rings that CSmoother may add between the ends of a stem's segments.
double addedRings(const CParams& params, const Detail& detail, int generation, const StemBound& bound) {
    if (generation >= detail.smoothGenerations) return 0;
    const double bends = ringsPerBend(params, detail, generation) * (bound.segments - 1);
    const LevelParams& level = params.level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))];
    const double helix = level.curveV < 0 ? (detail.helixRings - 1) * bound.segments : 0;
    const bool roots = generation == 0 && params.global.roots > 0;
    const bool flares = generation == 0 && params.global.flare != 0;
    const double most = std::max(9.0, std::floor(1024.0 / level.curveRes)) * bound.segments; // CSmoother's own limit
    if (level.taper > 2) return bends + std::max(helix, most);
    const double uneven = (level.taper > 1 ? 40 : 0) + (flares ? 60 : 0) + (roots ? 60 : 0);
    return bends + std::max(helix, std::min(most, uneven * bound.paths));
}
} // namespace

BearerBound bearerBound(const CParams& params) {
    const GlobalParams& g = params.global;
    if (g.levels < 2) return {};
    double length = g.scale;
    for (int level = 0; level < g.levels; ++level)
        length *= params.level[static_cast<std::size_t>(std::min(level, kParamLevels - 1))].length;
    return {std::abs(g.leaves) * g.leafQuality, length, g.leafScale / std::sqrt(g.leafQuality)};
}

bool mayShowCards(const CParams& params, const Detail& detail) {
    return detail.twigPlanes > 0 && isBakeable(params) &&
           suitsCards(bearerBound(params), meshParamsOf(params).seasonOf(Organ::Leaf));
}

Prediction predictSize(const CParams& params, const Detail& detail) {
    const GlobalParams& g = params.global;
    const Phenology season = phenologyOf(g);
    // Where some leaves have fallen, none may be left by chance.
    const bool onCards = season.leaves == 1 && mayShowCards(params, detail);
    const MeshParams mesh = meshParamsOf(params);
    Prediction size{0, 0, 0};
    double stems = g.trunks, lastPaths = 1;
    for (int generation = 0; generation < g.levels; ++generation) {
        if (generation > 0) {
            const LevelParams& level = params.level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))];
            stems *= level.branches > 0 ? level.branches + level.whorl : 0; // whole whorls
        }
        const StemBound bound = boundOfStem(params, generation);
        const double points = ringPoints(params, detail, generation);
        const double collars = generation == 0 ? 0 : points > 3 ? detail.collarRings : std::min(1, detail.collarRings);
        const double rings = bound.segments + 2 * bound.paths + collars + addedRings(params, detail, generation, bound);
        size.stems += stems;
        if (!onCards || generation + 1 < g.levels) size.vertices += stems * (rings + 2 * bound.paths) * (points + 1);
        lastPaths = bound.paths;
    }
    if (g.levels < 2) return size;
    const auto shareOf = [&](Organ organ) {
        return organ == Organ::Leaf ? season.leaves : organ == Organ::Blossom ? season.blossoms : season.fruits;
    };
    const auto add = [&](Organ organ, double number, double whorl) {
        if (number == 0) return;
        const double count = stems * (std::abs(number) + (number > 0 ? whorl : lastPaths));
        // Which leaves have fallen is chance: of none or all of them it is known.
        const double there = shareOf(organ) > 0 ? count : 0;
        const double share = std::max(double(kFewOrgans), std::ceil(there * detail.share));
        const double drawn = std::min({double(detail.leafBudget), share, there});
        if (organ == Organ::Leaf) size.leaves = count;
        size.vertices += organ == Organ::Leaf && onCards
                             ? std::min(4 * std::ceil(there * detail.share), stems * double(mostVerticesOfCard(detail)))
                             : double(verticesPerOrgan(mesh, organ, detail)) * drawn;
    };
    add(Organ::Leaf, g.leaves * g.leafQuality, g.leafWhorl);
    add(Organ::Blossom, g.blossoms, 1);
    add(Organ::Fruit, g.fruits, 1);
    return size;
}

double nearestThatFits(const CParams& params, const ParamRef& ref, double fits, const Detail& detail,
                       double mostVertices) {
    const double step = ref.info->integer() ? 1 : std::pow(10, -ref.info->decimals);
    double small = fits / step, large = ref.get(params) / step;
    CParams tried = params;
    while (std::abs(large - small) > 1) {
        const double middle = std::round((small + large) / 2);
        ref.set(tried, middle * step);
        (predictSize(tried, detail).vertices <= mostVertices ? small : large) = middle;
    }
    return small * step;
}

} // namespace stromar
