#include "foliage/Foliage.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::uint64_t kFallOrder = 0x6c656166;
} // namespace

bool hasFallen(const CStem& stem, std::uint32_t n, double share) {
    return unitOf(hashCombine(hashCombine(kFallOrder, stem.id), n)) >= share;
}

Rounding roundingOf(const LeafArray& leaves, const LeafForm& form) {
    const double steepest = std::atan(std::tan(std::abs(form.fold)) * std::max(1.0, form.aspect)); // of any leaflet
    Rounding rounding{glm::dvec3(0), form.rounding, std::min(0.99, 0.05 + std::sin(steepest))};
    if (form.rounding <= 0 || leaves.empty()) return rounding;
    glm::dvec3 low = leaves[0].position, high = low;
    for (const CLeaf& leaf : leaves) {
        low = glm::min(low, leaf.position);
        high = glm::max(high, leaf.position);
    }
    rounding.centre = (low + high) / 2.0;
    return rounding;
}

glm::dvec3 Rounding::turned(const glm::dvec3& normal, const glm::dvec3& place) const {
    const glm::dvec3 away = place - centre;
    const double distance = glm::length(away);
    if (share <= 0 || distance < 1e-9) return normal;
    const glm::dvec3 sum = (1 - share) * normal + share / distance * away;
    const double length = glm::length(sum), front = glm::dot(sum, normal);
    if (length > 1e-9 && front >= least * length) return sum / length;
    const glm::dvec3 across = sum - front * normal;
    const double side = glm::length(across);
    if (side < 1e-9) return normal;
    return least * normal + std::sqrt(1 - least * least) / side * across;
}

} // namespace stromar
