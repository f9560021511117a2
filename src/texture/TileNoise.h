#pragma once
#include "stromar/util/Random.h"
#include <cstdint>
#include <glm/vec2.hpp>

namespace stromar {

/// Noise that repeats after a whole number of cells in both directions. Every value is a function of seed and place.
class CTileNoise {
public:
    /// Where a point lies among scattered cell centres.
    struct Cell {
        double nearest, second; ///< distances in cells
        std::uint64_t id;       ///< of the nearest
        glm::dvec2 offset;      ///< from its centre
    };

    CTileNoise(std::uint64_t seed, std::uint64_t layer) : m_seed(hashCombine(seed, layer)) {}

    /// Gradient noise, about −1..1, for x in cells of a tile with so many.
    double gradient(glm::dvec2 at, glm::ivec2 cells) const;
    /// Octaves of it, each twice as fine and half as strong: about −1..1.
    double octaves(glm::dvec2 at, glm::ivec2 cells, int count) const;
    /// Scattered centres; `scatter` 0 is a grid of bricks, 1 all chance.
    Cell cell(glm::dvec2 at, glm::ivec2 cells, double scatter) const;
    /// Uniform in [0, 1) by cell.
    double uniform(std::uint64_t id, std::uint32_t purpose) const;

private:
    std::uint64_t column(int x, int columns) const;
    static std::uint64_t inColumn(std::uint64_t column, int y, int rows);

    std::uint64_t m_seed;
};

} // namespace stromar
