#pragma once
#include "stromar/texture/Recipe.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace stromar {

constexpr std::size_t kRowsAtATime = 8;

inline std::uint8_t toByte(double v) { return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0, 255.0))); }

inline glm::dvec3 rgb(const Colour& c) { return {c[0], c[1], c[2]}; }
inline glm::dvec3 mixed(const glm::dvec3& a, const glm::dvec3& b, double t) { return a + (b - a) * std::clamp(t, 0.0, 1.0); }

inline double smoothStep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Calls draw(x, y) for every pixel of a square, on progress.threads() threads. Throws CCancelled.
template <typename Draw>
void forEachPixel(int size, const CProgress& progress, Draw&& draw) {
    parallelFor(
        static_cast<std::size_t>(size), kRowsAtATime,
        [&](std::size_t first, std::size_t last) {
            for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y)
                for (int x = 0; x < size; ++x) draw(x, y);
        },
        progress);
}

/// Makes all maps as large as `size` squared says; heights are kept apart with all their digits.
TextureMaps squareMaps(int size);

/// Normals from neighbouring heights, which stand `relief` sides of the picture high; the tile goes on at its edges.
void addNormals(TextureMaps& maps, const std::vector<double>& heights, double relief, const CProgress& progress);

} // namespace stromar
