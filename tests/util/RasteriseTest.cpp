#include "stromar/util/Rasterise.h"
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace stromar {
namespace {

constexpr int kWidth = 20, kHeight = 14;
using Cells = std::set<std::pair<int, int>>;
using Corners = std::array<glm::dvec2, 3>;

/// Corners that may lie outside and, if asked for, on middles and edges of cells.
Corners randomCorners(std::mt19937& random, bool onHalves) {
    std::uniform_real_distribution<double> across(-8, kWidth + 8), up(-8, kHeight + 8);
    Corners corners;
    for (glm::dvec2& corner : corners) {
        corner = {across(random), up(random)};
        if (onHalves) corner = glm::dvec2(std::round(2 * corner.x), std::round(2 * corner.y)) / 2.0;
    }
    return corners;
}

/// How far inside a triangle, in cells; less than nothing outside.
double depthIn(const Corners& c, const glm::dvec2& p) {
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    const double side = cross(c[1] - c[0], c[2] - c[0]) < 0 ? -1 : 1;
    double depth = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 edge = c[(i + 1) % 3] - c[i];
        depth = std::min(depth, side * cross(edge, p - c[i]) / std::max(1e-12, std::hypot(edge.x, edge.y)));
    }
    return depth;
}

Cells rasterised(const Corners& c) {
    Cells cells;
    rasterise(c[0], c[1], c[2], kWidth, kHeight, [&](int x, int y, double u, double v) {
        EXPECT_TRUE(cells.emplace(x, y).second) << "twice";
        const glm::dvec2 place = (1 - u - v) * c[0] + u * c[1] + v * c[2];
        EXPECT_NEAR(place.x, x + 0.5, 1e-6);
        EXPECT_NEAR(place.y, y + 0.5, 1e-6);
    });
    return cells;
}

double twiceArea(const Corners& c) { return (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x); }

TEST(Rasterise, VisitsTheCellsWhoseMiddlesLieInTheTriangle) {
    std::mt19937 random(3);
    for (int i = 0; i < 4000; ++i) {
        const Corners corners = randomCorners(random, i % 2);
        if (std::abs(twiceArea(corners)) < 1e-3) continue;
        const Cells cells = rasterised(corners);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const double depth = depthIn(corners, {x + 0.5, y + 0.5});
                EXPECT_TRUE(std::abs(depth) < 1e-9 || cells.contains({x, y}) == (depth > 0)) << "triangle " << i << ", cell " << x << ' ' << y;
            }
    }
}

TEST(Rasterise, TrianglesWithoutAnAreaOrAPlaceHaveNoCells) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kFar = 1e300, kEndless = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(rasterised({{{1, 1}, {5, 5}, {9, 9}}}).empty());
    for (const double bad : {kNan, kEndless, -kEndless})
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Corners corners{{{1, 1}, {9, 1}, {1, 9}}};
            corners[corner].x = bad;
            EXPECT_TRUE(rasterised(corners).empty());
        }
    EXPECT_TRUE(rasterised({{{-kFar, -kFar}, {-kFar, 1 - kFar}, {1 - kFar, -kFar}}}).empty());
}

/// Cells of which x is twice y, but for the first rows.
struct Diagonal {
    bool any(int y, int x0, int x1) const { return y >= kFirst && 2 * y >= x0 && 2 * y <= x1; }
    template <typename Look> void forEach(int y, int x0, int x1, Look&& look) const {
        if (any(y, x0, x1)) look(2 * y);
    }
    static constexpr int kFirst = 3;
};

TEST(Rasterise, LooksAtWantedCellsAlone) {
    Cells cells;
    rasterise({0, 0}, {100, 0}, {0, 100}, kWidth, kHeight, [&](int x, int y, double, double) { cells.emplace(x, y); }, Diagonal{});
    EXPECT_EQ(cells.size(), std::size_t(kWidth / 2 - Diagonal::kFirst));
    for (const auto& [x, y] : cells) EXPECT_EQ(x, 2 * y);
}

} // namespace
} // namespace stromar
