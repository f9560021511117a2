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

/// A segment, and how far off it is.
struct NearSegment {
    std::uint32_t segment = 0;
    double distance = std::numeric_limits<double>::infinity();
};

NearSegment nearestOf(const CGeneration& all, const CStem& stem, const glm::dvec3& point) {
    NearSegment nearest;
    for (std::uint32_t s = stem.firstSegment; s < stem.firstSegment + stem.segmentCount; ++s)
        if (const double distance = distanceTo(all.segments[s], point); distance < nearest.distance) nearest = {s, distance};
    return nearest;
}
} // namespace

std::optional<std::uint32_t> nearestStem(const CTree& tree, std::size_t generation, const glm::dvec3& point) {
    if (generation >= tree.generationCount()) return {};
    const CGeneration& all = tree.generation(generation);
    std::optional<std::uint32_t> nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < all.stems.size(); ++i)
        if (const double distance = nearestOf(all, all.stems[i], point).distance; distance < smallest) {
            smallest = distance;
            nearest = i;
        }
    return nearest;
}

std::uint32_t nearestSegment(const CTree& tree, std::size_t generation, std::uint32_t stem, const glm::dvec3& point) {
    return nearestOf(tree.generation(generation), tree.generation(generation).stems[stem], point).segment;
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
