#include "TileNoise.h"
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
            const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(kDirections);
            made[i] = {std::cos(angle), std::sin(angle)};
        }
        return made;
    }();
    return all;
}

int wrapped(int i, int n) { return (i % n + n) % n; }
} // namespace

std::uint64_t CTileNoise::hash(glm::ivec2 cell, glm::ivec2 cells) const {
    return hashCombine(hashCombine(m_seed, static_cast<std::uint64_t>(wrapped(cell.x, cells.x))),
                       static_cast<std::uint64_t>(wrapped(cell.y, cells.y)));
}

double CTileNoise::uniform(std::uint64_t id, std::uint32_t purpose) const {
    return unitOf(hashCombine(id, purpose));
}

double CTileNoise::gradient(glm::dvec2 at, glm::ivec2 cells) const {
    const glm::ivec2 corner(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
    const glm::dvec2 inside = at - glm::dvec2(corner);
    const auto& around = directions();
    const auto slope = [&](int dx, int dy) {
        const glm::dvec2& direction = around[hash(corner + glm::ivec2(dx, dy), cells) % kDirections];
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
    Cell found{kFar, kFar, 0, {}};
    for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
            const glm::ivec2 there = corner + glm::ivec2(dx, dy);
            const std::uint64_t id = hash(there, cells);
            const glm::dvec2 centre =
                glm::dvec2(there) + 0.5 + scatter * (glm::dvec2(uniform(id, 1), uniform(id, 2)) - 0.5);
            const glm::dvec2 offset = at - centre;
            const double distance = glm::length(offset);
            if (distance < found.nearest)
                found = {distance, found.nearest, id, offset};
            else if (distance < found.second)
                found.second = distance;
        }
    return found;
}

} // namespace stromar
