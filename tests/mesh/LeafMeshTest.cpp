#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
double areaOf(const CMesh& mesh) {
    double area = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[t]]), b(mesh.positions[mesh.indices[t + 1]]),
            c(mesh.positions[mesh.indices[t + 2]]);
        area += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return area;
}

std::shared_ptr<const CMesh> leavesOf(const CTree& tree, const CParams& params, const Detail& detail) {
    return meshesOf(tree, params, detail).back();
}

double areaOf(const LeafArray& leaves) {
    double area = 0;
    for (const CLeaf& leaf : leaves) area += leaf.length * leaf.width;
    return area;
}
} // namespace

TEST(LeafMesh, EachLeafIsARectangleInItsPlace) {
    const CParams params = preset("quaking_aspen");
    const auto tree = grow(params);
    const auto mesh = leavesOf(*tree, params, detailOf(Model::Full));
    const LeafArray& leaves = tree->leaves();
    ASSERT_FALSE(leaves.empty());
    ASSERT_EQ(mesh->triangleCount(), 2 * leaves.size());
    ASSERT_EQ(mesh->vertexCount(), 4 * leaves.size());
    EXPECT_EQ(mesh->surface, Surface::Leaf);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const CLeaf& leaf = leaves[i];
        for (std::size_t corner = 0; corner < 6; ++corner) {
            const std::uint32_t v = mesh->indices[6 * i + corner];
            const glm::dvec3 from = glm::dvec3(mesh->positions[v]) - leaf.position;
            const glm::vec2 t = mesh->texCoords[v];
            ASSERT_NEAR(glm::dot(from, leaf.axis), t.y * leaf.length, 1e-5) << "leaf " << i;
            ASSERT_NEAR(std::abs(glm::dot(from, glm::cross(leaf.normal, leaf.axis))), leaf.width / 2, 1e-5)
                << "leaf " << i;
            ASSERT_NEAR(glm::dot(from, leaf.normal), 0, 1e-5) << "leaf " << i;
            ASSERT_NEAR(glm::distance(glm::dvec3(mesh->normals[v]), leaf.normal), 0, 1e-5) << "leaf " << i;
            ASSERT_TRUE((t.x == 0 || t.x == 1) && (t.y == 0 || t.y == 1)) << "leaf " << i;
        }
    }
    EXPECT_EQ(inWords(checkLeaves(*mesh)), "");
}

TEST(LeafMesh, ThePictureIsNotMirrored) {
    const CParams params = preset("quaking_aspen");
    const auto mesh = leavesOf(*grow(params), params, detailOf(Model::Full));
    for (std::size_t t = 0; t < mesh->indices.size(); t += 3) {
        const glm::vec2 a = mesh->texCoords[mesh->indices[t]], b = mesh->texCoords[mesh->indices[t + 1]] - a,
                        c = mesh->texCoords[mesh->indices[t + 2]] - a;
        ASSERT_GT(b.x * c.y - b.y * c.x, 0) << "triangle " << t / 3;
    }
}

TEST(LeafMesh, ThinningKeepsTheAreaAndTheCrown) {
    for (const Sample& sample : presets()) {
        const auto tree = grow(sample.params);
        const Bounds all = leavesOf(*tree, sample.params, detailOf(Model::Full))->bounds();
        for (const Detail& detail : detailTable()) {
            const auto mesh = leavesOf(*tree, sample.params, detail);
            const std::size_t drawn = mesh->vertexCount() / 4;
            EXPECT_LE(drawn, detail.leafBudget);
            EXPECT_LE(double(drawn), std::ceil(detail.share * double(tree->leaves().size())));
            const double growth = std::sqrt(double(tree->leaves().size()) / double(drawn));
            const double kept = growth <= kMostLeafGrowth ? 1 : std::pow(kMostLeafGrowth / growth, 2);
            EXPECT_NEAR(areaOf(*mesh) / areaOf(tree->leaves()), kept, 0.05 * kept)
                << sample.name << ", " << detail.name;
            const Bounds box = mesh->bounds();
            for (int i = 0; i < 3; ++i)
                EXPECT_GT(box.max[i] - box.min[i], 0.85f * (all.max[i] - all.min[i]))
                    << sample.name << ", " << detail.name;
        }
    }
}

TEST(LeafMesh, ATreeWithoutLeavesHasAnEmptyMesh) {
    CParams params = preset("quaking_aspen");
    params.global.leaves = 0;
    for (const Detail& detail : detailTable()) EXPECT_EQ(leavesOf(*grow(params), params, detail)->vertexCount(), 0u);
}

TEST(LeafMesh, FewLeavesAreNeverThinnedToNone) {
    CParams params;
    params.global.levels = 2;
    params.global.leaves = 1;
    params.level[1].branches = 1;
    params.level[1].branchDistV = 0;
    const auto tree = grow(params);
    ASSERT_GT(tree->leaves().size(), 0u);
    for (const Detail& detail : detailTable())
        EXPECT_GE(leavesOf(*tree, params, detail)->vertexCount(), 4u) << detail.name;
}

} // namespace stromar::test
