#include "MeasuredBound.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace stromar {

namespace {
constexpr double kMargin = 1 + 1e-9;    // of sums
constexpr std::size_t kThicknesses = 8; // classes of one generation

/// At its base, or its parent's wood there where both may be limbs of one fork.
double radiusOf(const CStem& stem) { return stem.mayPart() ? std::max(stem.radius, stem.parentRadius) : stem.radius; }

/// How thick stems are, in classes of equally many.
std::vector<ThicknessShare> thicknessOf(const std::vector<const CStem*>& stems, double trunkRadius) {
    std::vector<double> radii;
    for (const CStem* stem : stems) radii.push_back(trunkRadius > 0 ? radiusOf(*stem) / trunkRadius : 1);
    std::ranges::sort(radii);
    std::vector<ThicknessShare> shares;
    const std::size_t classes = std::min(kThicknesses, radii.size());
    for (std::size_t c = 0; c < classes; ++c) {
        const std::size_t first = c * radii.size() / classes, end = (c + 1) * radii.size() / classes;
        shares.push_back({double(end - first) / double(radii.size()), radii[end - 1]});
    }
    return shares;
}

GenerationBound boundOf(const CGeneration& generation, const std::vector<const CStem*>& stems, double trunkRadius) {
    GenerationBound bound;
    bound.stems = double(stems.size());
    double segments = 0, along = std::numeric_limits<double>::infinity(), cosine = 1;
    for (const CStem* stem : stems) {
        segments += stem->segmentCount;
        along = std::min(along, double(stem->segmentCount));
        for (std::uint32_t s = 1; s < stem->segmentCount; ++s) {
            const CSegment* segment = &generation.segments[stem->firstSegment + s];
            cosine = std::min(cosine, glm::dot(segment[-1].frame[2], segment->frame[2]));
        }
    }
    if (stems.empty()) return bound;
    bound.segments = segments / bound.stems * kMargin;
    bound.along = std::max(1.0, along);
    bound.thickness = thicknessOf(stems, trunkRadius);
    bound.turn = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    return bound;
}

/// From the stems of the generation before: those of one place follow each other.
void countParting(const CGeneration& generation, std::size_t g, const StemSet& without, std::vector<GenerationBound>& bounds) {
    std::vector<const CStem*> parting;
    for (std::size_t s = 0; s < generation.stems.size(); ++s)
        if (generation.stems[s].mayPart() && !without.has(g, s)) parting.push_back(&generation.stems[s]);
    for (std::size_t first = 0, end = 1; first < parting.size(); first = end++) {
        const auto isBeside = [&](const CStem* stem) { return stem->parent == parting[first]->parent && stem->position == parting[first]->position; };
        while (end < parting.size() && isBeside(parting[end])) ++end;
        const auto member = end - first > 1 ? &GenerationBound::several : &GenerationBound::single;
        Parting &below = bounds[g - 1].*member, &own = bounds[g].*member;
        below.branches += double(end - first) / bounds[g - 1].stems * kMargin;
        own.branched += double(end - first) / bounds[g].stems * kMargin;
    }
}
} // namespace

std::vector<GenerationBound> boundsOf(const CTree& tree, const StemSet& without) {
    const double trunkRadius = tree.generation(0).stems[0].radius;
    std::vector<GenerationBound> bounds;
    for (std::size_t g = 0; g < tree.generationCount(); ++g) {
        std::vector<const CStem*> stems;
        for (std::size_t s = 0; s < tree.generation(g).stems.size(); ++s)
            if (!without.has(g, s)) stems.push_back(&tree.generation(g).stems[s]);
        bounds.push_back(boundOf(tree.generation(g), stems, trunkRadius));
    }
    for (std::size_t g = 1; g < bounds.size(); ++g) countParting(tree.generation(g), g, without, bounds);
    return bounds;
}

TwigBound twigBoundOf(const CTree& tree, const COrgans& leaves, double leafLength) {
    const StemSet twigs = twigsOf(tree, leaves);
    TwigBound bound{.leafLength = leafLength, .wood = boundsOf(tree, twigs)};
    for (std::size_t g = 0; g < twigs.stems.size(); ++g)
        for (std::size_t s = 0; s < twigs.stems[g].size(); ++s) {
            if (!twigs.stems[g][s]) continue;
            ++bound.stems;
            bound.leaves += leaves.countOn(g, s);
            bound.length += tree.generation(g).stems[s].length;
        }
    bound.otherLeaves = double(leaves.total) - bound.leaves;
    bound.leaves *= 2 / std::max(1.0, bound.stems);
    bound.length *= 2 / std::max(1.0, bound.stems);
    return bound;
}

} // namespace stromar
