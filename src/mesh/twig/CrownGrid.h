#pragma once
#include "stromar/util/Parallel.h"
#include "twig/CrownView.h"
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <vector>

namespace stromar {

constexpr int kViewCells = 512; ///< of a side of a usual view

/// Unit; radians from x and from the ground.
inline glm::dvec3 directionTo(double turn, double height) {
    return {std::cos(height) * std::cos(turn), std::cos(height) * std::sin(turn), std::sin(height)};
}

/// Across, up, to the viewer.
inline glm::dmat3 frameTo(const glm::dvec3& viewer) {
    const glm::dvec3 across = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), viewer));
    return {across, glm::cross(viewer, across), viewer};
}

/// To the viewers of so many sides.
inline glm::dvec3 sideOf(std::size_t i, std::size_t count) {
    constexpr double kHeight = 5 * std::numbers::pi / 180;
    return directionTo(2 * std::numbers::pi * (double(i) + 0.5) / double(count), kHeight);
}

/// work(i) for each, in parallel.
template <typename Work> void forEachOf(std::size_t count, const CProgress& progress, Work&& work) {
    parallelFor(
        count, 1,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) work(i);
        },
        progress);
}

/// How a crown lies on the square grid of a view.
class CCrownGrid {
public:
    CCrownGrid(const CrownFrame& crown, const glm::dvec3& viewer, int cells)
        : m_middle(crown.middle), m_toView(glm::transpose(frameTo(viewer))), m_viewer(viewer), m_perMetre(cells / (2 * crown.radius)), m_side(cells) {}

protected:
    /// On the grid; z, metres towards the viewer.
    glm::dvec3 seen(const glm::vec3& place) const {
        const glm::dvec3 p = m_toView * (glm::dvec3(place) - m_middle);
        return {glm::dvec2(p) * m_perMetre + m_side / 2.0, p.z};
    }
    std::size_t cellAt(int x, int y) const { return static_cast<std::size_t>(y * m_side + x); }
    std::size_t cellCount() const { return static_cast<std::size_t>(m_side) * static_cast<std::size_t>(m_side); }

    template <typename Draw> static void forEachTriangle(const std::vector<CrownPart>& parts, const CProgress& progress, Draw&& draw) {
        constexpr std::size_t kBetweenPolls = 30'000;
        for (const CrownPart& part : parts)
            for (std::size_t t = 0; t + 2 < part.mesh->indices.size(); t += 3) {
                if (t % kBetweenPolls == 0) progress.poll();
                draw(part, &part.mesh->indices[t]);
            }
    }

    glm::dvec3 m_middle;
    glm::dmat3 m_toView;
    glm::dvec3 m_viewer;
    double m_perMetre;
    int m_side;
};

/// The mean of a triangle's values by the weights of its second and third corner.
template <typename Values> auto mixed(const Values& values, const std::uint32_t* corners, double u, double v) {
    return float(1 - u - v) * values[corners[0]] + float(u) * values[corners[1]] + float(v) * values[corners[2]];
}

} // namespace stromar
