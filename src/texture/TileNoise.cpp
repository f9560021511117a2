#include "TileNoise.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace stromar {

namespace {
double smooth(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }
double mixed(double a, double b, double t) { return a + (b - a) * t; }
/// Directions all around: sines are slow.
constexpr std::size_t kDirections = 256;
const std::array<glm::dvec2, kDirections>& directions() {
    static const auto all = [] {
        std::array<glm::dvec2, kDirections> made;
        for (std::size_t i = 0; i < kDirections; ++i) {
            const double angle = kTurn * static_cast<double>(i) / static_cast<double>(kDirections);
            made[i] = {std::cos(angle), std::sin(angle)};
        }
        return made;
    }();
    return all;
}

int wrapped(int i, int n) {
    if (i >= 0 && i < n) return i; // nearly always: a division is slow
    return (i % n + n) % n;
}

/// From x to the cell that begins at i, if its centre keeps this far from its sides.
double apart(double x, int i, double margin) { return std::max({0.0, i + margin - x, x - (i + 1 - margin)}); }
} // namespace

std::uint64_t CTileNoise::column(int x, int columns) const {
    return hashCombine(m_seed, static_cast<std::uint64_t>(wrapped(x, columns)));
}

std::uint64_t CTileNoise::inColumn(std::uint64_t column, int y, int rows) {
    return hashCombine(column, static_cast<std::uint64_t>(wrapped(y, rows)));
}

double CTileNoise::uniform(std::uint64_t id, std::uint32_t purpose) const {
    return unitOf(hashCombine(id, purpose));
}

double CTileNoise::gradient(glm::dvec2 at, glm::ivec2 cells) const {
    const glm::ivec2 corner(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
    const glm::dvec2 inside = at - glm::dvec2(corner);
    const auto& around = directions();
    const std::uint64_t column[] = {this->column(corner.x, cells.x), this->column(corner.x + 1, cells.x)};
    const auto slope = [&](int dx, int dy) {
        const glm::dvec2& direction = around[inColumn(column[dx], corner.y + dy, cells.y) % kDirections];
        return direction.x * (inside.x - dx) + direction.y * (inside.y - dy);
    };
    const double u = smooth(inside.x), v = smooth(inside.y);
    return 1.4 * mixed(mixed(slope(0, 0), slope(1, 0), u), mixed(slope(0, 1), slope(1, 1), u), v);
}

double CTileNoise::octaves(glm::dvec2 at, glm::ivec2 cells, int count) const {
    double sum = 0, strength = 0.5;
    for (int i = 0; i < count; ++i) {
        sum += strength * gradient(at, cells);
        at *= 2.0;
        cells *= 2;
        strength /= 2;
    }
    return sum;
}

CTileNoise::Cell CTileNoise::cell(glm::dvec2 at, glm::ivec2 cells, double scatter) const {
    const glm::ivec2 corner(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const double margin = 0.5 - 0.5 * scatter;
    Cell found{kFar, kFar, 0, {}};
    for (const int dx : {0, -1, 1, -2, 2}) { // the near ones first: they tell that the others cannot be nearer
        const double asideX = apart(at.x, corner.x + dx, margin);
        if (asideX > found.second) continue;
        const std::uint64_t column = this->column(corner.x + dx, cells.x);
        for (const int dy : {0, -1, 1, -2, 2}) {
            const double asideY = apart(at.y, corner.y + dy, margin);
            if (asideX * asideX + asideY * asideY > found.second * found.second) continue;
            const std::uint64_t id = inColumn(column, corner.y + dy, cells.y);
            const glm::dvec2 centre = glm::dvec2(corner + glm::ivec2(dx, dy)) + 0.5 +
                                      scatter * (glm::dvec2(uniform(id, 1), uniform(id, 2)) - 0.5);
            const glm::dvec2 offset = at - centre;
            const double distance = glm::length(offset);
            if (distance < found.nearest)
                found = {distance, found.nearest, id, offset};
            else if (distance < found.second)
                found.second = distance;
        }
    }
    return found;
}

} // namespace stromar
