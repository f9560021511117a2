#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace stromar {

/// Numbers vertices from 0 so that those of the same surface that lie at the very same place have the same number. `surfaces`: of each
/// vertex, numbers from 0. Time n log n.
std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions, const std::vector<std::uint32_t>& surfaces);

} // namespace stromar
