#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace stromar {

/// By how many degrees a closed line turns in all: 360 where it is flat and convex, the more the more ragged it is. Points may be equal to
/// the one before.
inline double turnOf(std::span<const glm::dvec3> line) {
    double turn = 0;
    glm::dvec3 in(0);
    const auto goTo = [&](const glm::dvec3& from, const glm::dvec3& to) {
        if (from == to) return;
        turn += std::atan2(glm::length(glm::cross(in, to - from)), glm::dot(in, to - from));
        in = to - from;
    };
    for (std::size_t i = 0; i < 2 * line.size(); ++i) {
        if (i == line.size()) turn = 0; // the first way follows on the last one
        goTo(line[i % line.size()], line[(i + 1) % line.size()]);
    }
    return glm::degrees(turn);
}

} // namespace stromar
