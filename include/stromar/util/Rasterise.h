#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

namespace stromar {

/// Narrows a row's cells x0..x1 to those where a value that is `start` at x0 and grows by `step`, 1/`inverse`, a cell may be 0 or more: rounding
/// may add one.
inline void clipRow(double start, double step, double inverse, int& x0, int& x1) {
    if (!std::isfinite(start * inverse)) return;
    const double zero = std::clamp(x0 - start * inverse, x0 - 2.0, x1 + 2.0);
    if (step > 0)
        x0 = std::max(x0, static_cast<int>(std::floor(zero)) - 1);
    else
        x1 = std::min(x1, static_cast<int>(std::ceil(zero)) + 1);
}

/// All cells of a grid are wanted.
struct AllCells {
    bool any(int, int, int) const { return true; }
    template <typename Look> void forEach(int, int x0, int x1, Look&& look) const {
        for (int x = x0; x <= x1; ++x) look(x);
    }
};

/// Calls visit(x, y, u, v) for the cells of a grid, 0..width−1 and 0..height−1, whose middles lie in the triangle a b c and that are wanted: of
/// the cells x0..x1 of a row wanted.any(y, x0, x1) is false if none is, and wanted.forEach(y, x0, x1, look) calls look(x) for those that are.
/// u and v are the weights of b and c there. A triangle without an area has none.
template <typename Visit, typename Wanted = AllCells>
void rasterise(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, int width, int height, Visit&& visit, const Wanted& wanted = {}) {
    const glm::dvec2 ab = b - a, ac = c - a;
    const double twice = ab.x * ac.y - ab.y * ac.x;
    if (!(std::abs(twice) >= 1e-9)) return;
    const auto range = [](double p, double q, double r, int size) { // of middles
        const auto [low, high] = std::minmax({p, q, r});
        const double from = std::clamp(low, 0.0, double(size));
        const int first = static_cast<int>(from + 0.5);
        return std::pair(first - (first - 0.5 >= from ? 1 : 0), static_cast<int>(std::clamp(high, -1.0, size - 0.5) + 0.5) - 1);
    };
    const auto [left, right] = range(a.x, b.x, c.x, width);
    if (left > right) return;
    auto [y0, y1] = range(a.y, b.y, c.y, height);
    while (y0 <= y1 && !wanted.any(y0, left, right)) ++y0; // most triangles of a crown lie behind others
    if (y0 > y1) return;
    constexpr int kFew = 4; // cells: to look at them is cheaper
    const bool clipped = right - left >= kFew;
    const double perTwice = 1 / twice;
    const auto weights = [&](int x, int y) {
        const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - a;
        return glm::dvec2((p.x * ac.y - p.y * ac.x) * perTwice, (ab.x * p.y - ab.y * p.x) * perTwice);
    };
    std::array<double, 3> steps{}, inverses{}; // of the three weights along a row
    if (clipped) {
        steps = {ac.y * perTwice, -ab.y * perTwice, (ab.y - ac.y) * perTwice};
        for (std::size_t i = 0; i < 3; ++i) inverses[i] = 1 / steps[i];
    }
    for (int y = y0; y <= y1; ++y) {
        int x0 = left, x1 = right;
        if (clipped) {
            if (!wanted.any(y, left, right)) continue;
            const glm::dvec2 start = weights(left, y);
            const std::array<double, 3> starts{start.x, start.y, 1 - start.x - start.y};
            for (std::size_t i = 0; i < 3; ++i) {
                int from = left, to = right;
                clipRow(starts[i], steps[i], inverses[i], from, to);
                x0 = std::max(x0, from);
                x1 = std::min(x1, to);
            }
        }
        wanted.forEach(y, x0, x1, [&](int x) {
            const glm::dvec2 at = weights(x, y);
            if (at.x >= 0 && at.y >= 0 && at.x + at.y <= 1) visit(x, y, at.x, at.y);
        });
    }
}

} // namespace stromar
