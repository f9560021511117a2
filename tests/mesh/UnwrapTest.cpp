#include "stromar/mesh/Unwrap.h"
#include "mesh/SampleTrees.h"
#include "stromar/mesh/Detail.h"
#include "stromar/util/Rasterise.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>

namespace stromar::test {
namespace {

using Place = glm::vec2;

double areaOf(const Unwrapped& all, std::size_t triangle) {
    const Place a = all.texCoords[all.indices[3 * triangle]], b = all.texCoords[all.indices[3 * triangle + 1]], c = all.texCoords[all.indices[3 * triangle + 2]];
    return std::abs(double(b.x - a.x) * (c.y - a.y) - double(c.x - a.x) * (b.y - a.y)) / 2;
}

double areaOf(const CMesh& mesh, std::size_t triangle) {
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + i]]); };
    return glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
}

/// How many places two triangles share, of those that are looked at, and how many are taken.
std::pair<int, int> sharedAndTaken(const std::vector<Unwrapped>& all, int side) {
    std::vector<int> owners(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (const Unwrapped& one : all)
        for (std::size_t i = 0; i < one.indices.size(); i += 3) {
            const auto at = [&](std::size_t k) { return double(side) * glm::dvec2(one.texCoords[one.indices[i + k]]); };
            rasterise(at(0), at(1), at(2), side, side, [&](int x, int y, double u, double v) {
                constexpr double kInside = 1e-3;
                if (u > kInside && v > kInside && u + v < 1 - kInside) ++owners[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)];
            });
        }
    return {static_cast<int>(std::ranges::count_if(owners, [](int count) { return count > 1; })),
            static_cast<int>(std::ranges::count_if(owners, [](int count) { return count > 0; }))};
}

void expectUnwrapped(const Meshes& meshes, const std::string& what, int minTaken) {
    constexpr int kSide = 4096;
    const std::vector<Unwrapped> all = unwrap(meshes, CProgress(2));
    ASSERT_EQ(all.size(), meshes.size()) << what;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        ASSERT_EQ(all[m].indices.size(), meshes[m]->indices.size()) << what;
        ASSERT_EQ(all[m].sources.size(), all[m].texCoords.size()) << what;
        for (std::size_t i = 0; i < all[m].indices.size(); ++i) ASSERT_EQ(all[m].sources[all[m].indices[i]], meshes[m]->indices[i]) << what;
        for (const Place& place : all[m].texCoords) ASSERT_TRUE(place.x > 0 && place.x < 1 && place.y > 0 && place.y < 1) << what << ' ' << place.x << ' ' << place.y;
    }
    const auto [shared, taken] = sharedAndTaken(all, kSide);
    EXPECT_EQ(shared, 0) << what;
    EXPECT_GT(100.0 * taken / (double(kSide) * kSide), minTaken) << what << ": % of the square";
}

/// Two quads side by side that show the same picture, and one with none.
std::shared_ptr<const CMesh> repeating() {
    auto mesh = std::make_shared<CMesh>();
    mesh->name = "quads";
    for (const float x : {0.0f, 1.0f, 2.0f, 3.0f})
        for (const float y : {0.0f, 1.0f}) {
            mesh->positions.emplace_back(x, y, 0);
            mesh->normals.emplace_back(0, 0, 1);
            mesh->texCoords.emplace_back(x > 2 ? 1 : x == 1 ? 1 : 0, x > 2 ? 0 : y);
            mesh->looks.emplace_back();
        }
    for (const std::uint32_t left : {0u, 2u, 4u})
        for (const std::uint32_t i : {0u, 2u, 1u, 1u, 2u, 3u}) mesh->indices.push_back(left + i);
    return mesh;
}
} // namespace

TEST(Unwrap, LetsNoTwoTrianglesShareAPlace) {
    for (const char* name : {"apple", "coconut_palm", "weeping_willow", "strand_bonsai"})
        expectUnwrapped(meshesOf(*grow(preset(name)), preset(name), detailOf(Model::Full, 2)), name, 25);
}

TEST(Unwrap, CutsWherePicturesRepeat) { expectUnwrapped({repeating()}, "quads", 30); }

TEST(Unwrap, IsAsLargeAsTheSurface) {
    const Meshes meshes = meshesOf(*grow(preset("apple")), preset("apple"), detailOf(Model::Full, 2));
    const std::vector<Unwrapped> all = unwrap(meshes, CProgress(2));
    double surface = 0, flat = 0;
    for (std::size_t m = 0; m < all.size(); ++m)
        for (std::size_t t = 0; t < meshes[m]->triangleCount(); ++t) {
            surface += areaOf(*meshes[m], t);
            flat += areaOf(all[m], t);
        }
    double near = 0;
    for (std::size_t m = 0; m < all.size(); ++m)
        for (std::size_t t = 0; t < meshes[m]->triangleCount(); ++t) {
            const double ratio = areaOf(all[m], t) / flat / (areaOf(*meshes[m], t) / surface);
            if (ratio > 0.5 && ratio < 2) near += areaOf(*meshes[m], t);
        }
    EXPECT_GT(near, 0.9 * surface);
}

TEST(Unwrap, IsTheSameEveryTime) {
    const Meshes meshes = meshesOf(*grow(preset("apple")), preset("apple"), detailOf(Model::Full, 3));
    const std::vector<Unwrapped> one = unwrap(meshes, CProgress(1)), other = unwrap(meshes, CProgress(3));
    for (std::size_t m = 0; m < one.size(); ++m) {
        EXPECT_EQ(one[m].texCoords, other[m].texCoords);
        EXPECT_EQ(one[m].indices, other[m].indices);
    }
}

TEST(Unwrap, OfNothingIsNothing) {
    EXPECT_TRUE(unwrap({}, CProgress(2)).empty());
    const std::vector<Unwrapped> all = unwrap(Meshes{std::make_shared<CMesh>()}, CProgress(2));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_TRUE(all[0].indices.empty());
}

} // namespace stromar::test
