#include "mesh/MeshMeasures.h"
#include "mesh/Cards.h"
#include "mesh/SampleTrees.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/mesh/twig/Twig.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
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
        const glm::dvec3 foot = leaf.position, axis = leaf.axis, normal = leaf.normal;
        for (std::size_t corner = 0; corner < 6; ++corner) {
            const std::uint32_t v = mesh->indices[6 * i + corner];
            const glm::dvec3 from = glm::dvec3(mesh->positions[v]) - foot;
            const glm::vec2 t = mesh->texCoords[v];
            ASSERT_NEAR(glm::dot(from, axis), t.y * leaf.length, 1e-5) << "leaf " << i;
            ASSERT_NEAR(std::abs(glm::dot(from, glm::cross(normal, axis))), leaf.width / 2, 1e-5)
                << "leaf " << i;
            ASSERT_NEAR(glm::dot(from, normal), 0, 1e-5) << "leaf " << i;
            ASSERT_NEAR(glm::distance(glm::dvec3(mesh->normals[v]), normal), 0, 1e-5) << "leaf " << i;
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

TEST(SlowLeafMesh, ThinningKeepsTheAreaAndTheCrown) {
    for (Sample sample : weberPennPresets()) {
        sample.params.common.season = 7;
        sample.params.common.leafPlanes = 1;
        sample.params.common.leafStalk = 0;
        const auto tree = grow(sample.params);
        const Bounds all = leavesOf(*tree, sample.params, detailOf(Model::Full))->bounds();
        const float least = weberPenn(sample.params).trunks > 1 ? 0.75f : 0.85f; // of many trunks one is the tallest
        const bool onCards = twigOf(*tree, sample.params) != nullptr;
        for (const Detail& detail : detailTable()) {
            if (onCards && detail.twigPlanes > 0) continue;
            const auto mesh = leavesOf(*tree, sample.params, detail);
            const std::size_t drawn = mesh->vertexCount() / bladeOf(meshParamsOf(sample.params), Organ::Leaf, detail).points.size();
            EXPECT_LE(double(drawn), demandOf(detail, {}).bound(double(tree->leaves().size())));
            const double growth = std::sqrt(double(tree->leaves().size()) / double(drawn));
            const double kept = growth <= detail.maxLeafGrowth ? 1 : std::pow(detail.maxLeafGrowth / growth, 2);
            EXPECT_NEAR(mesh->area() / areaOf(tree->leaves()), kept, 0.05 * kept) << sample.name << ", " << detail.name;
            const Bounds box = mesh->bounds();
            for (int i = 0; i < 3; ++i)
                EXPECT_GT(box.max[i] - box.min[i], least * (all.max[i] - all.min[i]))
                    << sample.name << ", " << detail.name;
        }
    }
}

TEST(LeafMesh, ATreeWithoutLeavesHasAnEmptyMesh) {
    CParams params = preset("quaking_aspen");
    weberPenn(params).leaves = 0;
    for (const Detail& detail : detailTable()) EXPECT_EQ(leavesOf(*grow(params), params, detail)->vertexCount(), 0u);
}

TEST(LeafMesh, FewLeavesAreNeverThinnedToNone) {
    CParams params;
    weberPenn(params).levels = 2;
    weberPenn(params).leaves = 1;
    weberPenn(params).level[1].branches = 1;
    weberPenn(params).level[1].branchDistV = 0;
    const auto tree = grow(params);
    ASSERT_GT(tree->leaves().size(), 0u);
    for (const Detail& detail : detailTable())
        EXPECT_GE(leavesOf(*tree, params, detail)->vertexCount(), 4u) << detail.name;
}

TEST(LeafMesh, EveryShapeIsSoundAndAboutAsLargeAsItsCard) {
    CParams params = preset("quaking_aspen");
    weberPenn(params).level[1].branches = 10;
    const auto tree = grow(params);
    const double cards = leavesOf(*tree, params, detailOf(Model::Full))->area();
    params.common.leafForm = 1;
    for (int shape = 0; shape <= 7; ++shape)
        for (const double fold : {0.0, 25.0, -40.0})
            for (const double rounding : {0.0, 0.7, 1.0}) {
                params.common.leafShape = shape;
                params.common.leafFold = fold;
                params.common.leafRounding = rounding;
                const auto mesh = leavesOf(*tree, params, detailOf(Model::Full));
                SCOPED_TRACE("shape " + std::to_string(shape) + ", fold " + std::to_string(fold));
                EXPECT_EQ(inWords(checkLeaves(*mesh)), "");
                EXPECT_EQ(mesh->vertexCount(),
                          tree->leaves().size() * bladeOf(meshParamsOf(params), Organ::Leaf, detailOf(Model::Full)).points.size());
                EXPECT_LT(mesh->area(), 1.01 * cards);
                EXPECT_GT(mesh->area(), (shape == 7 ? 0.1 : 0.3) * cards);
                for (const glm::vec2& at : mesh->texCoords) {
                    ASSERT_GE(std::min(at.x, at.y), -1e-6f);
                    ASSERT_LE(std::max(at.x, at.y), 1 + 1e-6f);
                }
            }
}

TEST(LeafMesh, AStalkHoldsTheBladeAway) {
    CParams params = preset("quaking_aspen");
    const auto tree = grow(params);
    params.common.leafStalk = 0.5;
    const auto mesh = leavesOf(*tree, params, detailOf(Model::Full));
    const LeafArray& leaves = tree->leaves();
    ASSERT_EQ(mesh->vertexCount(), 8 * leaves.size());
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const glm::dvec3 foot = 0.5 * (glm::dvec3(mesh->positions[8 * i]) + glm::dvec3(mesh->positions[8 * i + 1]));
        ASSERT_NEAR(glm::distance(foot, glm::dvec3(leaves[i].position)), 0.5 * leaves[i].length, 1e-4);
        ASSERT_LT(glm::distance(mesh->positions[8 * i + 4], leaves[i].position), 0.05 * leaves[i].length);
    }
}

TEST(LeafMesh, RoundingTurnsNormalsOutwards) {
    CParams params = preset("quaking_aspen");
    const auto tree = grow(params);
    const auto outwards = [&] {
        const auto mesh = leavesOf(*tree, params, detailOf(Model::Full));
        const Bounds box = mesh->bounds();
        double sum = 0;
        for (std::size_t v = 0; v < mesh->vertexCount(); ++v)
            sum += glm::dot(glm::normalize(mesh->positions[v] - (box.min + box.max) / 2.0f), mesh->normals[v]);
        return sum / double(mesh->vertexCount());
    };
    const double flat = outwards();
    params.common.leafRounding = 1;
    EXPECT_GT(outwards(), flat + 0.2);
}

} // namespace stromar::test
