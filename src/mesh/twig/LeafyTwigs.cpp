#include "twig/LeafyTwigs.h"
#include "foliage/Foliage.h"
#include "stromar/mesh/Detail.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
constexpr std::size_t kMaxPrisms = 100'000; // as many paths' or segments'

/// From the base of one segment to the end of another, so many times as wide.
void addPrism(const CSegment& first, const CSegment& last, double minRadius, double wider, CMesh& mesh) {
    constexpr int kSides = 3;
    const auto start = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t side = 0; side < kSides; ++side) {
        const double angle = 2 * std::numbers::pi * side / kSides;
        const auto add = [&](const CSegment& segment, double along, double radius) {
            const glm::dvec3 out = std::cos(angle) * segment.frame[0] + std::sin(angle) * segment.frame[1];
            mesh.normals.push_back(glm::vec3(out));
            mesh.positions.push_back(glm::vec3(segment.axisPoint(along) + wider * std::max(radius, minRadius) / outlineShare(kSides) * out));
        };
        add(first, 0, first.radiusBase);
        add(last, 1, last.radiusEnd);
        const std::uint32_t own = start + 2 * side, next = start + 2 * ((side + 1) % kSides);
        for (const std::uint32_t corner : {own, next, own + 1, next, next + 1, own + 1}) mesh.indices.push_back(corner);
    }
}
} // namespace

std::vector<LeafyTwig> leafyTwigs(const StemSet& twigs, const CTree& tree, const COrgans& leaves, double share) {
    std::vector<LeafyTwig> leafy;
    for (std::uint32_t g = 0; g < twigs.stems.size(); ++g)
        for (std::uint32_t s = 0; s < twigs.stems[g].size(); ++s) {
            if (!twigs.stems[g][s]) continue;
            const std::uint32_t present = presentOn(tree.generation(g).stems[s], leaves.countOn(g, s), share);
            if (present > 0) leafy.push_back({g, s, present});
        }
    return leafy;
}

double leavesOn(const std::vector<LeafyTwig>& twigs) {
    double total = 0;
    for (const LeafyTwig& twig : twigs) total += twig.leaves;
    return total;
}

std::shared_ptr<const CMesh> woodOfTwigs(const std::vector<LeafyTwig>& twigs, const CTree& tree, double minRadius) {
    std::size_t total = 0;
    for (const LeafyTwig& twig : twigs) total += twig.of(tree).pathCount;
    const std::size_t count = std::min(total, kMaxPrisms);
    const double wider = double(total) / double(std::max<std::size_t>(1, count));
    const auto mesh = allocateMesh("wood", Surface::Bark, 0, 0);
    std::size_t path = 0, chosen = 0;
    for (const LeafyTwig& twig : twigs) {
        const CGeneration& generation = tree.generation(twig.generation);
        const CStem& stem = twig.of(tree);
        for (std::size_t i = 0; i < stem.pathCount; ++i, ++path) {
            if (chosen == count || path != evenly(chosen, count, total)) continue;
            ++chosen;
            const auto segments = generation.segmentsOf(generation.paths[stem.firstPath + i]);
            const std::size_t middle = segments.size() / 2;
            if (middle > 0) addPrism(segments.front(), segments[middle - 1], minRadius, wider, *mesh);
            addPrism(segments[middle], segments.back(), minRadius, wider, *mesh);
        }
    }
    return mesh;
}

namespace {
template <typename Visit> void forEachSegmentBeside(const StemSet& twigs, const CTree& tree, Visit&& visit) {
    for (std::uint32_t g = 0; g < tree.generationCount(); ++g) {
        const CGeneration& generation = tree.generation(g);
        for (std::uint32_t s = 0; s < generation.stems.size(); ++s) {
            if (twigs.has(g, s)) continue;
            const CStem& stem = generation.stems[s];
            for (std::size_t path = stem.firstPath; path < stem.firstPath + stem.pathCount; ++path)
                for (const CSegment& segment : generation.segmentsOf(generation.paths[path])) visit(segment);
        }
    }
}
} // namespace

std::shared_ptr<const CMesh> woodBeside(const StemSet& twigs, const CTree& tree, double minRadius) {
    std::size_t total = 0;
    forEachSegmentBeside(twigs, tree, [&](const CSegment&) { ++total; });
    const std::size_t count = std::min(total, kMaxPrisms);
    const double wider = double(total) / double(std::max<std::size_t>(1, count));
    const auto mesh = allocateMesh("wood", Surface::Bark, 0, 0);
    std::size_t next = 0, chosen = 0;
    forEachSegmentBeside(twigs, tree, [&](const CSegment& segment) {
        if (chosen == count || next++ != evenly(chosen, count, total)) return;
        addPrism(segment, segment, minRadius, wider, *mesh);
        ++chosen;
    });
    return mesh;
}

} // namespace stromar
