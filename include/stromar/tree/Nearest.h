#pragma once
#include "stromar/tree/Tree.h"
#include <optional>

namespace stromar {

/// The stem of a generation whose wood is nearest to a point, by the distance from its segments' axes less their
/// radius. Nothing when the generation is empty. Cost: one pass over the generation's segments.
std::optional<std::uint32_t> nearestStem(const CTree& tree, std::size_t generation, const glm::dvec3& point);

/// The segment of a stem that is nearest to a point, likewise; in the generation.
std::uint32_t nearestSegment(const CTree& tree, std::size_t generation, std::uint32_t stem, const glm::dvec3& point);

/// The leaf whose middle is nearest to a point. Cost: one pass over the leaves.
std::optional<std::uint32_t> nearestLeaf(const CTree& tree, const glm::dvec3& point);

} // namespace stromar
