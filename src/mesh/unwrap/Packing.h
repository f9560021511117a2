#pragma once
#include <glm/vec2.hpp>
#include <vector>

namespace stromar {

/// Where rectangles lie in a square of side 1.
struct Packing {
    glm::dvec2 corner{0};
    glm::dvec2 scale{0}; ///< of its sides
    bool turned = false; ///< its x lies along the square's y
};
/// All by the same scale, but for those that are pressed to fit in, and with half of `gap` around each.
std::vector<Packing> packed(const std::vector<glm::dvec2>& sizes, double gap);

} // namespace stromar
