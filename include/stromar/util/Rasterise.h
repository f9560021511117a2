#pragma once
#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

namespace stromar {

/// Narrows a row's cells x0..x1 to those where a value that is `start` at x0 and grows by `step` a cell may be 0 or more: rounding may add one.
inline void clipRow(double start, double step, int& x0, int& x1) {
    if (!std::isfinite(start / step)) return;
    const double zero = std::clamp(x0 - start / step, x0 - 2.0, x1 + 2.0);
    if (step > 0)
        x0 = std::max(x0, static_cast<int>(std::floor(zero)) - 1);
    else
        x1 = std::min(x1, static_cast<int>(std::ceil(zero)) + 1);
}

/// Calls visit(x, y, u, v) for the cells of a grid, 0..width−1 and 0..height−1, whose middles lie in the triangle a b c and that are
/// wanted(x, y); u and v are the weights of b and c there. A triangle without an area has none.
template <typename Visit, typename Wanted>
void rasterise(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, int width, int height, Visit&& visit, Wanted&& wanted) {
    const glm::dvec2 ab = b - a, ac = c - a;
    const double twice = ab.x * ac.y - ab.y * ac.x;
    if (std::abs(twice) < 1e-9) return;
    const auto range = [](double p, double q, double r, int size) {
        const auto [low, high] = std::minmax({p, q, r});
        return std::pair(static_cast<int>(std::max(0.0, low)), static_cast<int>(std::min(size - 1.0, high)));
    };
    const auto [left, right] = range(a.x, b.x, c.x, width);
    const auto [y0, y1] = range(a.y, b.y, c.y, height);
    constexpr int kFew = 4; // cells: to look at them is cheaper
    for (int y = y0; y <= y1; ++y) {
        const auto weights = [&](int x) {
            const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - a;
            return glm::dvec2((p.x * ac.y - p.y * ac.x) / twice, (ab.x * p.y - ab.y * p.x) / twice);
        };
        int x0 = left, x1 = right;
        if (x1 - x0 >= kFew) {
            const glm::dvec2 start = weights(left), step(ac.y / twice, -ab.y / twice);
            int low = x0, high = x1;
            for (const auto& [value, growth] : {std::pair(start.x, step.x), std::pair(start.y, step.y), std::pair(1 - start.x - start.y, -step.x - step.y)}) {
                int from = left, to = right;
                clipRow(value, growth, from, to);
                low = std::max(low, from);
                high = std::min(high, to);
            }
            x0 = low, x1 = high;
        }
        for (int x = x0; x <= x1; ++x) {
            if (!wanted(x, y)) continue;
            const glm::dvec2 at = weights(x);
            if (at.x >= 0 && at.y >= 0 && at.x + at.y <= 1) visit(x, y, at.x, at.y);
        }
    }
}

/// All of them.
template <typename Visit>
void rasterise(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, int width, int height, Visit&& visit) {
    rasterise(a, b, c, width, height, std::forward<Visit>(visit), [](int, int) { return true; });
}

} // namespace stromar
