#pragma once
#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace stromar {

/// Calls visit(x, y, u, v) for the cells of a grid, 0..width−1 and 0..height−1, whose middles lie in the triangle a b c;
/// u and v are the weights of b and c there. A triangle without an area has none.
template <typename Visit>
void rasterise(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, int width, int height, Visit&& visit) {
    const glm::dvec2 ab = b - a, ac = c - a;
    const double twice = ab.x * ac.y - ab.y * ac.x;
    if (std::abs(twice) < 1e-9) return;
    const auto range = [](double p, double q, double r, int size) {
        const auto [low, high] = std::minmax({p, q, r});
        return std::pair(static_cast<int>(std::max(0.0, low)), static_cast<int>(std::min(size - 1.0, high)));
    };
    const auto [x0, x1] = range(a.x, b.x, c.x, width);
    const auto [y0, y1] = range(a.y, b.y, c.y, height);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - a;
            const double u = (p.x * ac.y - p.y * ac.x) / twice, v = (ab.x * p.y - ab.y * p.x) / twice;
            if (u >= 0 && v >= 0 && u + v <= 1) visit(x, y, u, v);
        }
}

} // namespace stromar
