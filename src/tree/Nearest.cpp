#include "stromar/tree/Nearest.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace stromar {

namespace {
double distanceTo(const CSegment& segment, const glm::dvec3& point) {
    const double along = segment.length > 0 ? glm::dot(point - segment.position, segment.frame[2]) / segment.length : 0;
    const double t = std::clamp(along, 0.0, 1.0);
    const double radius = segment.radiusBase + t * (segment.radiusEnd - segment.radiusBase);
    return glm::distance(point, segment.centre(t)) - radius;
}
} // namespace

std::optional<std::uint32_t> nearestStem(const CTree& tree, std::size_t generation, const glm::dvec3& point) {
    if (generation >= tree.generationCount()) return {};
    const CGeneration& all = tree.generation(generation);
    std::optional<std::uint32_t> nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < all.stems.size(); ++i) {
        const CStem& stem = all.stems[i];
        for (std::uint32_t s = stem.firstSegment; s < stem.firstSegment + stem.segmentCount; ++s)
            if (const double distance = distanceTo(all.segments[s], point); distance < smallest) {
                smallest = distance;
                nearest = i;
            }
    }
    return nearest;
}

std::optional<std::uint32_t> nearestLeaf(const CTree& tree, const glm::dvec3& point) {
    std::optional<std::uint32_t> nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < tree.leaves().size(); ++i) {
        const CLeaf& leaf = tree.leaves()[i];
        if (const double d = glm::distance(point, glm::dvec3(leaf.position + 0.5f * leaf.length * leaf.axis)); d < smallest) {
            smallest = d;
            nearest = i;
        }
    }
    return nearest;
}

} // namespace stromar
