#pragma once
#include <glm/vec3.hpp>

namespace stromar {

/// From our axes, z up, to those of most formats.
inline glm::vec3 yUp(const glm::vec3& v) { return {v.x, v.z, -v.y}; }

} // namespace stromar
