#include "mesh/BoxPatch.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
using Index = CWoodPatch::Index;

/// A cube, two metres wide, about the origin.
CWoodPatch cube() {
    CWoodPatch patch = patchOf({{{-1, -1, -1}, {1, 1, 1}}});
    patch.flood(std::array<Index, 1>{0});
    return patch;
}

/// A triangle in the middle of the top, counter-clockwise.
std::vector<Index> loopOnTop(CWoodPatch& patch) {
    std::vector<Index> corners, loop;
    for (const glm::dvec3& at : {glm::dvec3(-0.5, -0.4, 1), glm::dvec3(0.6, -0.3, 1), glm::dvec3(0.1, 0.5, 1)}) corners.push_back(patch.pointNear(at, 1e-3));
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<Index> way;
        const Index from = corners[i], to = corners[(i + 1) % 3];
        const glm::dvec3 across = glm::cross(patch.place(to) - patch.place(from), glm::dvec3(0, 0, 1));
        EXPECT_TRUE(patch.cut(from, to, glm::normalize(across), 1e-3, {}, way));
        loop.push_back(from);
        loop.insert(loop.end(), way.begin(), way.end() - 1);
    }
    return loop;
}
} // namespace

TEST(WoodPatch, FindsWhereALineComesOut) {
    CWoodPatch patch = cube();
    const auto all = patch.near({{0, 0, 0}, {0.2, 0.3, 3}, 0.1});
    const auto crossings = patch.crossings({0, 0, 0}, {0.2, 0.3, 3}, all);
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_TRUE(crossings[0].leaves);
    EXPECT_NEAR(crossings[0].share, 1.0 / 3, 1e-9);
    EXPECT_TRUE(patch.crossings({0.2, 0.3, 3}, {0.2, 0.3, 4}, all).empty());
}

TEST(WoodPatch, ALoopCanBeCutOutAndFilled) {
    CWoodPatch patch = cube();
    patch.mark();
    const std::vector<Index> loop = loopOnTop(patch);
    EXPECT_TRUE(patch.finish()) << "cutting leaves it closed";
    const std::size_t before = left(patch);
    ASSERT_TRUE(patch.removeLeftOf(loop, 0, true));
    EXPECT_LT(left(patch), before);
    EXPECT_FALSE(patch.finish()) << "open";
    std::vector<Index> vertices;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index next = loop[(i + 1) % loop.size()];
        vertices.push_back(patch.vertexAt(next, loop[i], true)); // outside of the loop
    }
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i) patch.addTriangle({vertices[0], vertices[i], vertices[i + 1]}, 0);
    EXPECT_TRUE(patch.finish());
}

TEST(WoodPatch, WhatLiesFarFromTheLoopStays) {
    CWoodPatch patch = cube();
    patch.mark();
    std::vector<Index> loop = loopOnTop(patch);
    std::ranges::reverse(loop);
    const std::size_t before = left(patch);
    EXPECT_FALSE(patch.removeLeftOf(loop, 0, true)) << "all but the loop's inside";
    EXPECT_EQ(left(patch), before);
}

TEST(WoodPatch, CanBeUndone) {
    CWoodPatch patch = cube();
    patch.mark();
    const std::vector<Index> loop = loopOnTop(patch);
    ASSERT_TRUE(patch.removeLeftOf(loop, 0, true));
    patch.undo();
    EXPECT_EQ(patch.triangles().size(), 12u);
    EXPECT_EQ(left(patch), 12u);
    EXPECT_EQ(patch.vertices().size(), 8u);
    patch.mark();
    EXPECT_EQ(loopOnTop(patch), loop) << "as if nothing had been";
}

TEST(WoodPatch, PointsThatAreNearAreOne) {
    CWoodPatch patch = cube();
    EXPECT_EQ(patch.pointNear({0.9995, 0.9995, 1}, 0.01), 7u);
    const Index onEdge = patch.pointNear({0.2, 0.995, 1}, 0.01);
    EXPECT_EQ(patch.place(onEdge).y, 1) << "of the edge";
    EXPECT_EQ(patch.pointNear({0.2, 1, 0.995}, 0.01), onEdge);
}

} // namespace stromar::test
