#include "CommonValues.h"
#include "Grown.h"
#include "stromar/params/methods/weberpenn/Calculations.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace stromar {

namespace {
constexpr double kDeviations = 4; // of a mean from what is expected

/// Error diffusion makes at most one clone more than the sum of what is wanted; as it starts anywhere, the mean of many
/// stems is what is wanted. So the paths after joint k are at most 2 + W(k), of many stems 1 + W(k), W the sum wanted so
/// far; W grows by n per path, by n/2 for paths that already split.
void boundPaths(const CParams& params, int generation, double stems, GenerationBound& bound) {
    const LevelParams& level = levelOf(params, generation);
    const WeberPennParams& w = weberPenn(params);
    const double base = generation == 0 && level.curveRes > 1 ? w.baseSplits : 0;
    const double often = w.cloneHalving ? level.segSplits / 2 : level.segSplits;
    const double extra = level.segSplits > 0 ? std::min(1.0, kDeviations / std::sqrt(std::max(1.0, stems))) : 0;
    double wanted = 0;
    for (int joint = 0; joint + 1 < level.curveRes; ++joint) {
        if (joint > 0 || base == 0) wanted += often * bound.paths + (level.segSplits - often) * (1 + base);
        bound.paths = 1 + base + extra + wanted;
        bound.segments += bound.paths;
    }
}

constexpr int kPlaces = 16;
using Along = std::array<double, kPlaces>; ///< a value at places spread evenly along a parent, from its bare part to its tip

/// At most the mean of a value over children that error diffusion spreads evenly along `runs` paths (Koksma's
/// inequality: the mean over all places, and its variation for each run).
double meanBound(const Along& value, double runs, double children) {
    double sum = 0, variation = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        sum += value[i];
        if (i > 0) variation += std::abs(value[i] - value[i - 1]);
    }
    return std::min(std::ranges::max(value), sum / kPlaces + variation * runs / std::max(1.0, children));
}

/// What children are like along their parents (Weber & Penn §4.3, §4.4). 0..1 of the length that bears.
class CAlongParent {
public:
    CAlongParent(const CParams& params, int generation) : m_params(params), m_generation(generation) {}

    /// Their radius over the parent's: by the power of the lengths' ratio, never thicker. `variation` −1..1 is a part of
    /// nLengthV.
    Along thinning(double variation) const {
        const LevelParams& level = levelOf(m_params, m_generation);
        const double own = level.length + variation * std::abs(level.lengthV), power = weberPenn(m_params).ratioPower;
        return each([&](double z) {
            const double length = std::max(0.0, own) * (m_generation == 1 ? crownAt(z) : 1 - 0.6 * z);
            return power > 0 ? std::min(1.0, std::pow(length, power)) : 1;
        });
    }
    /// How many children of their own they have, over the most.
    Along fertility() const {
        return each([&](double z) { return m_generation == 1 ? 0.2 + 0.8 * crownAt(z) : 1 - 0.5 * z; });
    }
    /// The same of leaves.
    Along leafiness() const {
        const double bare = m_generation == 1 ? weberPenn(m_params).baseSize : 0;
        return each([&](double z) { return shapeRatio(4, bare + (1 - bare) * z, weberPenn(m_params)); });
    }

private:
    double crownAt(double z) const { return shapeRatio(weberPenn(m_params).shape, 1 - z, weberPenn(m_params)); }

    template <typename Value>
    Along each(Value&& value) const {
        Along all{};
        // nBranchDist draws the children of a segment together at its base.
        const double segments = levelOf(m_params, m_generation - 1).curveRes,
                     spread = levelOf(m_params, m_generation).branchDist;
        for (int i = 0; i < kPlaces; ++i) {
            const double even = (i + 0.5) / kPlaces, base = std::floor(even * segments) / segments;
            all[static_cast<std::size_t>(i)] = value(base + (even - base) * std::min(1.0, spread));
        }
        return all;
    }

    const CParams& m_params;
    int m_generation;
};

/// Stems by their thickness, and how many children each has over the most. Rounded up to steps, so that the list stays
/// short.
class CThicknesses {
public:
    void add(double stems, double thickness, double fertility) {
        const double step = -std::log(std::clamp(thickness, kThinnest, 1.0)) / kLogStep;
        Bin& bin = m_bins[static_cast<std::size_t>(step + 1e-9)];
        bin.fertility += stems * fertility;
        bin.stems += stems;
    }
    /// visit(stems, thickness, fertility)
    template <typename Visit>
    void visit(Visit&& visit) const {
        for (std::size_t step = m_bins.size(); step-- > 0;)
            if (const Bin& bin = m_bins[step]; bin.stems > 0)
                visit(bin.stems, std::exp(-kLogStep * double(step)), bin.fertility / bin.stems);
    }
    /// Their shares, a part of them as thick as the thickest.
    std::vector<ThicknessShare> shares(double thickest) const {
        double all = 0;
        visit([&](double stems, double, double) { all += stems; });
        std::vector<ThicknessShare> shares;
        visit([&](double stems, double thickness, double) { shares.push_back({(1 - thickest) * stems / all, thickness}); });
        if (shares.empty()) return {{1, 1}};
        shares.back().share += thickest;
        return shares;
    }

private:
    static constexpr double kLogStep = 0.15, kThinnest = 1e-6;
    struct Bin {
        double stems = 0, fertility = 0;
    };
    std::array<Bin, 94> m_bins{}; ///< the thickest first
};

/// Generation by generation: how many stems there are and how thick they are.
class CStemsBound {
public:
    explicit CStemsBound(const CParams& params)
        : m_params(params), m_stems(weberPenn(params).trunks), m_runs(m_stems) {
        m_thicknesses.add(m_stems, 1, 1);
    }

    /// Goes on to a generation whose parents have so many paths each.
    void grow(int generation, double parentPaths) {
        const LevelParams& level = levelOf(m_params, generation);
        const CAlongParent along(m_params, generation);
        const double parents = m_stems;
        m_stems = level.branches > 0 ? parents * (level.branches * m_fertility + level.whorl) : 0; // whole whorls
        m_runs = parents * parentPaths * level.whorl;
        m_fertility = meanBound(along.fertility(), m_runs, m_stems);
        const Along fertility = along.fertility();
        CThicknesses grown;
        const double chance = kDeviations / std::sqrt(3 * std::max(1.0, m_stems)); // of their mean: few may all be long
        constexpr int kSteps = 8; // of nLengthV: a part of them each, no longer than at its end
        for (int step = 1; step <= kSteps; ++step) {
            const Along thinning = along.thinning(std::min(1.0, 2.0 * step / kSteps - 1 + chance));
            m_thicknesses.visit([&](double stems, double thickness, double fertile) {
                const double children = stems * (level.branches * fertile + level.whorl) / (kSteps * kPlaces);
                for (std::size_t i = 0; i < thinning.size(); ++i)
                    grown.add(children, thickness * thinning[i], fertility[i]);
            });
        }
        m_thicknesses = std::move(grown);
    }

    double stems() const { return m_stems; }
    double runs() const { return m_runs; }
    std::vector<ThicknessShare> thickness() const {
        return m_thicknesses.shares(std::min(1.0, m_runs / std::max(1.0, m_stems)));
    }

private:
    const CParams& m_params;
    double m_stems, m_runs;  ///< paths that they are spread along
    double m_fertility = 1;  ///< on the average
    CThicknesses m_thicknesses;
};

double turnBound(const CParams& params, int generation) {
    constexpr double kSteepest = 104.3; // of declination × sine of it, degrees
    const LevelParams& level = levelOf(params, generation);
    const double forth = std::abs(level.curve.value), back = std::abs(level.curveBack.value);
    const double up = generation >= 2 ? std::abs(weberPenn(params).attractionUp) * kSteepest : 0;
    return ((back == 0 ? forth : 2 * std::max(forth, back)) + std::abs(level.curveV.value) + up) / level.curveRes;
}

GenerationBound boundOf(const CParams& params, int generation, double stems) {
    const LevelParams& level = levelOf(params, generation);
    GenerationBound bound;
    bound.stems = stems;
    boundPaths(params, generation, stems, bound);
    bound.forkTurn = std::abs(level.splitAngle.value) + std::abs(level.splitAngleV.value);
    bound.along = level.curveRes;
    bound.turn = turnBound(params, generation);
    bound.forks = level.segSplits > 0 || (generation == 0 && weberPenn(params).baseSplits > 0);
    bound.helix = level.curveV.value < 0;
    bound.roundEnds = level.taper > 1;
    bound.spheres = level.taper > 2;
    return bound;
}

TwigBound twigsOf(const CParams& params, const SizeBound& bound) {
    const WeberPennParams& w = weberPenn(params);
    const CommonParams& c = params.common;
    if (w.levels < 2) return {};
    double length = w.scale;
    for (int g = 0; g < w.levels; ++g) length *= levelOf(params, g).length;
    std::vector<GenerationBound> wood = bound.generations;
    const double number = std::abs(w.leaves) * c.leafQuality, fewest = number / 2; // by the shape ratio along the parent
    const double rounded = w.leaves > 0 ? c.leafWhorl : wood.back().paths;
    if (fewest >= rounded) wood.pop_back(); // else some stems may have none
    return {bound.generations.back().stems, number, length, c.leafScale / std::sqrt(c.leafQuality), wood, 0};
}
} // namespace

SizeBound weberPennBound(const CParams& params, const CProgress&) {
    const WeberPennParams& w = weberPenn(params);
    const CommonParams& c = params.common;
    SizeBound bound;
    bound.base = baseFormOf(c);
    bound.scratchPerStem = sizeof(StemScratch);
    bound.scratchPerSegment = sizeof(double);
    CStemsBound stems(params);
    for (int g = 0; g < w.levels; ++g) {
        if (g > 0) stems.grow(g, bound.generations.back().paths);
        GenerationBound own = boundOf(params, g, stems.stems());
        own.thickness = stems.thickness();
        bound.generations.push_back(own);
    }
    if (w.levels < 2) return bound;
    const double leafiness = meanBound(CAlongParent(params, w.levels - 1).leafiness(), stems.runs(), stems.stems());
    const auto organs = [&](double number, double whorl) {
        const double rounded = number > 0 ? whorl : bound.generations.back().paths;
        return number == 0 ? 0 : stems.stems() * (std::abs(number) * leafiness + rounded);
    };
    bound.organs = {organs(w.leaves * c.leafQuality, c.leafWhorl), organs(c.blossoms, 1), organs(c.fruits, 1)};
    bound.twigs = twigsOf(params, bound);
    return bound;
}

} // namespace stromar
