#include "foliage/Foliage.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace stromar {

namespace {
constexpr std::uint64_t kFallOrder = 0x6c656166;
} // namespace

bool hasFallen(const CStem& stem, std::uint32_t n, double share) {
    return share < 1 && unitOf(hashCombine(hashCombine(kFallOrder, stem.id), n)) >= share;
}

std::uint32_t presentOn(const CStem& stem, std::uint32_t count, double share) {
    if (share >= 1) return count;
    std::uint32_t present = 0;
    for (std::uint32_t n = 0; n < count; ++n) present += !hasFallen(stem, n, share);
    return present;
}

Rounding roundingOf(const CTree& tree, const COrgans& organs, const LeafForm& form) {
    const double steepest = std::atan(std::tan(std::abs(form.fold)) * std::max(1.0, form.aspect)); // of any leaflet
    Rounding rounding{glm::dvec3(0), form.rounding, std::min(0.99, 0.05 + std::sin(steepest))};
    if (form.rounding <= 0) return rounding;
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (std::size_t g = 0; g < organs.counts.size(); ++g)
        for (std::size_t s = 0; s < organs.counts[g].size(); ++s) {
            if (organs.counts[g][s] == 0) continue;
            const CGeneration& all = tree.generation(g);
            const auto path = all.segmentsOf(all.paths[all.stems[s].firstPath]);
            for (const glm::dvec3& end : {path.front().position, path.back().axisPoint(1)}) {
                low = glm::min(low, end);
                high = glm::max(high, end);
            }
        }
    if (low.x <= high.x) rounding.centre = (low + high) / 2.0;
    return rounding;
}

glm::dvec3 Rounding::turned(const glm::dvec3& normal, const glm::dvec3& place) const {
    const glm::dvec3 away = place - centre;
    const double distance = glm::length(away);
    if (share <= 0 || distance < 1e-9) return normal;
    const glm::dvec3 sum = (1 - share) * normal + share / distance * away;
    const double length = glm::length(sum), front = glm::dot(sum, normal);
    if (length > 1e-9 && front >= minCosine * length) return sum / length;
    const glm::dvec3 across = sum - front * normal;
    const double side = glm::length(across);
    if (side < 1e-9) return normal;
    return minCosine * normal + std::sqrt(1 - minCosine * minCosine) / side * across;
}

} // namespace stromar
