#pragma once
#include "join/WoodPatch.h"
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

namespace stromar::test {

struct Box {
    glm::vec3 low, high;
};
constexpr std::size_t kBoxTriangles = 12; ///< the first two are its top, the next two its bottom

/// A patch of boxes, each a generation of its own.
inline CWoodPatch patchOf(const std::vector<Box>& boxes) {
    constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
        {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    std::vector<CWoodPatch::Vertex> vertices;
    std::vector<CWoodPatch::Index> points;
    std::vector<CWoodPatch::Triangle> triangles;
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
        const auto& [low, high] = boxes[b];
        for (std::uint32_t v = 0; v < 8; ++v) {
            const glm::vec3 at(v & 1 ? high.x : low.x, v & 2 ? high.y : low.y, v & 4 ? high.z : low.z);
            vertices.push_back({{{b, v}, at, glm::normalize(at - (low + high) / 2.0f), {}, {}}, b, v});
            points.push_back(8 * b + v);
        }
        for (auto face : faces) {
            for (std::uint32_t& v : face) v += 8 * b;
            triangles.push_back({.vertices = {face[0], face[1], face[2]},
                                 .points = {},
                                 .generation = b,
                                 .first = 6 * triangles.size()});
            triangles.push_back({.vertices = {face[0], face[2], face[3]},
                                 .points = {},
                                 .generation = b,
                                 .first = 6 * triangles.size()});
        }
    }
    CWoodPatch patch(vertices, points, triangles);
    std::vector<CWoodPatch::Index> all(triangles.size());
    for (CWoodPatch::Index t = 0; t < all.size(); ++t) all[t] = t;
    patch.select(all);
    return patch;
}

inline std::size_t left(const CWoodPatch& patch) {
    return static_cast<std::size_t>(std::ranges::count(patch.triangles(), false, &CWoodPatch::Triangle::removed));
}

/// Of what is closed.
inline double volumeOf(const CWoodPatch& patch) {
    double volume = 0;
    for (const CWoodPatch::Triangle& own : patch.triangles())
        if (!own.removed)
            volume += glm::dot(patch.place(own.points[0]),
                               glm::cross(patch.place(own.points[1]), patch.place(own.points[2]))) /
                      6;
    return volume;
}

} // namespace stromar::test
