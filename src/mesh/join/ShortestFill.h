#pragma once
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace stromar {

/// Fills a polygon of n corners, counter-clockwise, with the triangles that cost least together (Klincsek 1980):
/// `costOf(a, b, c)` of three corners, infinity for none that may be; calls `add(a, b, c)` for each. False where there
/// are none. Time n cubed.
template <typename CostOf, typename Add>
bool fillPolygon(std::size_t n, CostOf&& costOf, Add&& add) {
    std::vector<std::vector<double>> cost(n, std::vector<double>(n, 0));
    std::vector<std::vector<std::size_t>> third(n, std::vector<std::size_t>(n, 0));
    for (std::size_t span = 2; span < n; ++span)
        for (std::size_t a = 0; a + span < n; ++a) {
            const std::size_t b = a + span;
            cost[a][b] = std::numeric_limits<double>::infinity();
            for (std::size_t m = a + 1; m < b; ++m) {
                const double own = cost[a][m] + cost[m][b] + costOf(a, m, b);
                if (own < cost[a][b]) cost[a][b] = own, third[a][b] = m;
            }
        }
    if (!std::isfinite(cost[0][n - 1])) return false;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        if (b < a + 2) continue;
        const std::size_t m = third[a][b];
        add(a, m, b);
        open.push_back({a, m});
        open.push_back({m, b});
    }
    return true;
}

} // namespace stromar
