#include "stromar/mesh/StemChoice.h"
#include "stem/RingPlan.h"
#include "stromar/util/Random.h"
#include <algorithm>

namespace stromar {

namespace {
constexpr std::size_t kMaxStems = 64;  // of a subtree, a branch with all that grows on it, that may be left out
constexpr double kMaxRadius = 0.002;   // likewise, of the tree's height: a fifth of a pixel where the last level of detail is shown
// Likewise, of a bare tree of so many thin stems that this leaves too many triangles: more than kTooMany, and than kTooLarge of those at LOD 0.
// As many stay as make about kLarge of those, from the least to the largest share.
constexpr double kMaxRadiusOfMany = 0.00395, kTooMany = 2 * kFewWoodTriangles, kTooLarge = 0.055, kLarge = 0.0485;
constexpr double kLeastShareOfMany = 0.183, kLargestShareOfMany = 0.222;
constexpr double kOverlap = 1.025, kOverlapOfMany = 1.067; // of those few that are as thick as all: they hide more of one another
constexpr std::size_t kSampled = 2000; // stems of a generation that tell how many triangles all have at LOD 0
constexpr std::size_t kAllStems = ~std::size_t{0};

/// A number for every stem, by generation.
template <typename Number> using PerStem = std::vector<std::vector<Number>>;

template <typename Number> PerStem<Number> forStemsOf(const CTree& tree, Number value) {
    PerStem<Number> all;
    for (const auto& generation : tree.generations()) all.emplace_back(generation->stems.size(), value);
    return all;
}

/// Corners of its triangles.
PerStem<double> costs(const CTree& tree, const MeshParams& params, const Detail& detail, const StemSet& asCards, const CProgress& progress) {
    PerStem<double> all = forStemsOf(tree, 0.0);
    for (std::size_t g = 0; g < all.size(); ++g) {
        std::vector<bool> drawn(all[g].size());
        for (std::size_t s = 0; s < drawn.size(); ++s) drawn[s] = !asCards.has(g, s);
        for (const Tube& tube : planStems(tree, static_cast<int>(g), params, detail, {}, drawn, {}, nullptr, progress).tubes)
            all[g][tube.stem] += double(tube.indices);
    }
    return all;
}

/// Corners of triangles of all stems at LOD 0, by some of them.
struct FullCost {
    double stems = 0, collars = 0;
};

/// Two triangles for each point of each ring; about half of it, since some branches have none, and thin rings fewer points.
double cornersOfCollars(const MeshPlan& plan, const Detail& full) {
    double points = 0;
    for (std::size_t t = 0; t < plan.tubes.size(); ++t)
        if (t == 0 || plan.tubes[t].stem != plan.tubes[t - 1].stem) points += double(plan.tubes[t].points);
    return 3 * full.collarRings * points;
}

FullCost fullCost(const CTree& tree, const MeshParams& params, const Detail& full, std::size_t sampled, const CProgress& progress) {
    FullCost sum;
    for (std::size_t g = 0; g < tree.generationCount(); ++g) {
        const std::size_t stems = tree.generation(g).stems.size(), step = std::max<std::size_t>(1, stems / sampled);
        std::vector<bool> drawn(stems);
        for (std::size_t s = 0; s < stems; s += step) drawn[s] = true;
        const BranchesAbove above{std::vector<bool>(g + 1 < tree.generationCount() ? tree.generation(g + 1).stems.size() : 0, true), {}};
        const MeshPlan plan = planStems(tree, static_cast<int>(g), params, full, {}, drawn, {}, &above, progress);
        sum.stems += double(step) * double(plan.indexCount);
        if (g > 0) sum.collars += double(step) * cornersOfCollars(plan, full);
    }
    return sum;
}

/// How many stems grow on each, itself among them.
PerStem<std::size_t> stemsOn(const CTree& tree) {
    PerStem<std::size_t> all = forStemsOf<std::size_t>(tree, 1);
    for (std::size_t g = all.size(); g-- > 1;)
        for (std::size_t s = 0; s < all[g].size(); ++s) all[g - 1][static_cast<std::size_t>(tree.generation(g).stems[s].parent)] += all[g][s];
    return all;
}

/// The subtrees that may be left out, and which stems are a part of one.
struct Subtrees {
    struct Root {
        std::size_t generation, stem;
    };
    static constexpr std::size_t kNone = ~std::size_t{0};

    std::vector<Root> roots;
    PerStem<std::size_t> of; ///< which of them a stem belongs to
};

template <typename MayGo> Subtrees subtreesThatMayGo(const CTree& tree, MayGo&& mayGo) {
    Subtrees subtrees{{}, forStemsOf(tree, Subtrees::kNone)};
    for (std::size_t g = 2; g < subtrees.of.size(); ++g)
        for (std::size_t s = 0; s < subtrees.of[g].size(); ++s) {
            std::size_t& own = subtrees.of[g][s];
            own = subtrees.of[g - 1][static_cast<std::size_t>(tree.generation(g).stems[s].parent)];
            if (own != Subtrees::kNone || !mayGo(g, s)) continue;
            own = subtrees.roots.size();
            subtrees.roots.push_back({g, s});
        }
    return subtrees;
}

/// Corners of the triangles of those in subtrees, and of all others.
struct SplitCost {
    double subtrees = 0, others = 0;

    /// The part of the subtrees' that fills what the others leave of a budget.
    double shareIn(double budget) const { return (budget - others) / std::max(1.0, subtrees); }
};

SplitCost splitCost(const Subtrees& subtrees, const PerStem<double>& costs) {
    SplitCost split;
    for (std::size_t g = 0; g < costs.size(); ++g)
        for (std::size_t s = 0; s < costs[g].size(); ++s) (subtrees.of[g][s] == Subtrees::kNone ? split.others : split.subtrees) += costs[g][s];
    return split;
}

bool isKept(const CTree& tree, const Subtrees::Root& root, double share) {
    return share >= 1 || root.stem == 0 || unitOf(hashCombine(0, tree.generation(root.generation).stems[root.stem].id)) < share;
}

StemSet setOf(const Subtrees& subtrees, const std::vector<bool>& chosen) {
    StemSet set;
    for (const std::vector<std::size_t>& generation : subtrees.of) {
        std::vector<bool>& own = set.stems.emplace_back(generation.size());
        for (std::size_t s = 0; s < own.size(); ++s) own[s] = generation[s] != Subtrees::kNone && chosen[generation[s]];
    }
    return set;
}

/// How much thicker those that stay have to be to cover as much as all do.
double growthOf(const CTree& tree, const Subtrees& subtrees, const std::vector<bool>& stay, const StemSet& asCards, double max) {
    double all = 0, kept = 0;
    for (std::size_t g = 0; g < subtrees.of.size(); ++g)
        for (std::size_t s = 0; s < subtrees.of[g].size(); ++s) {
            if (subtrees.of[g][s] == Subtrees::kNone || asCards.has(g, s)) continue;
            const CStem& stem = tree.generation(g).stems[s];
            all += stem.length * stem.radius;
            if (stay[subtrees.of[g][s]]) kept += stem.length * stem.radius;
        }
    return kept > 0 ? std::min(max, all / kept) : 1;
}
} // namespace

std::vector<bool> StemChoice::drawn(std::size_t generation, std::size_t stems) const {
    std::vector<bool> drawn(stems);
    for (std::size_t s = 0; s < stems; ++s) drawn[s] = draws(generation, s);
    return drawn;
}

Thickening StemChoice::thickening(std::size_t generation) const {
    if (growth == 1 || generation >= thicker.stems.size() || std::ranges::find(thicker.stems[generation], true) == thicker.stems[generation].end()) return {};
    return {thicker.stems[generation], growth};
}

StemChoice chooseStems(const CTree& tree, const MeshParams& params, const Detail& detail, StemSet asCards, const CProgress& progress) {
    StemChoice choice;
    choice.asCards = std::move(asCards);
    const bool joined = detail.collarRings > 0; // each stem is seen where it grows out of another
    if (detail.woodShare >= 1 || tree.generationCount() < 3 || (joined && !choice.asCards.empty())) return choice;
    const std::size_t last = tree.generationCount() - 1;
    const PerStem<double> own = costs(tree, params, detail, choice.asCards, progress);
    const FullCost full = fullCost(tree, params, detailOf(detail.model, 0), joined ? kAllStems : kSampled, progress);
    const double wanted = detail.woodShare * full.stems;
    choice.fullTriangles = (full.stems + full.collars) / 3;
    double budget = joined ? wanted : std::max(wanted, 3.0 * kFewWoodTriangles);
    const PerStem<std::size_t> sizes = joined ? PerStem<std::size_t>() : stemsOn(tree);
    Subtrees subtrees;
    double share = 0, overlap = joined ? 1 : kOverlap, least = joined ? detail.share : kLeastShareOfThinBranches;
    const auto look = [&](std::size_t most, double thin) {
        subtrees = subtreesThatMayGo(tree, [&](std::size_t g, std::size_t s) {
            return g == last || (!joined && sizes[g][s] <= most && tree.generation(g).stems[s].radius <= thin * tree.height());
        });
        const SplitCost split = splitCost(subtrees, own);
        share = split.shareIn(budget);
        return split.others + std::max(share, least) * split.subtrees;
    };
    double kept = look(1, kMaxRadius);
    for (std::size_t most = 2; !joined && most <= kMaxStems && share < least; most *= 2) kept = look(most, kMaxRadius);
    if (!joined && kept > std::max(3 * kTooMany, kTooLarge * (full.stems + full.collars))) {
        budget = std::max(3 * kTooMany, kLarge * (full.stems + full.collars));
        least = kLeastShareOfMany;
        overlap = kOverlapOfMany;
        look(kMaxStems, kMaxRadiusOfMany);
        share = std::min(share, kLargestShareOfMany);
    }
    if (share >= 1) return choice;
    std::vector<bool> stay, go;
    for (const Subtrees::Root& root : subtrees.roots) {
        stay.push_back(isKept(tree, root, std::max(share, least)));
        go.push_back(!stay.back());
    }
    choice.leftOut = setOf(subtrees, go);
    choice.thicker = setOf(subtrees, stay);
    choice.growth = overlap * growthOf(tree, subtrees, stay, choice.asCards, 1 / least);
    choice.organsStay = !joined;
    return choice;
}

} // namespace stromar
