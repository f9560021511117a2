#include "foliage/Foliage.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace stromar {

namespace {
constexpr std::uint64_t kFallOrder = 0x6c656166;
constexpr double kLeastCrown = 0.01;  // metres
constexpr double kShadeGrowth = 0.6;  // of length and width: shade leaves have up to two and a half times the area

/// A box of the stems that bear organs; empty: there are none.
struct Crown {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    bool empty() const { return low.x > high.x; }
    glm::dvec3 middle() const { return empty() ? glm::dvec3(0) : (low + high) / 2.0; }
    glm::dvec3 half() const { return empty() ? glm::dvec3(0) : (high - low) / 2.0; }
};

Crown crownOf(const CTree& tree, const COrgans& organs) {
    Crown crown;
    for (std::size_t g = 0; g < organs.counts.size(); ++g)
        for (std::size_t s = 0; s < organs.counts[g].size(); ++s) {
            if (organs.counts[g][s] == 0) continue;
            const CGeneration& all = tree.generation(g);
            const auto path = all.segmentsOf(all.paths[all.stems[s].firstPath]);
            for (const glm::dvec3& end : {path.front().position, path.back().axisPoint(1)}) {
                crown.low = glm::min(crown.low, end);
                crown.high = glm::max(crown.high, end);
            }
        }
    return crown;
}
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
    if (form.rounding > 0) rounding.centre = crownOf(tree, organs).middle();
    return rounding;
}

CrownShade shadeOf(const CTree& tree, const COrgans& organs, double sunAndShade) {
    if (sunAndShade <= 0) return {};
    const Crown crown = crownOf(tree, organs);
    CrownShade shade{crown.middle(), glm::max(crown.half(), glm::dvec3(kLeastCrown)), kShadeGrowth * sunAndShade};
    double area = 0;
    for (const CLeaf& leaf : organs.grown) area += std::pow(shade.sizeAt(leaf.position), 2);
    if (area > 0) shade.sunlit = std::sqrt(double(organs.grown.size()) / area);
    return shade;
}

double CrownShade::sizeAt(const glm::dvec3& place) const {
    if (most <= 0) return 1;
    const glm::dvec3 out = (place - centre) / half;
    const double lit = std::clamp((0.8 * glm::length(out) + 0.25 * out.z - 0.05) / 0.95, 0.0, 1.0);
    return sunlit * (1 + most * (1 - lit * lit * (3 - 2 * lit)));
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
