#include "mesh/SampleTrees.h"
#include "stromar/model/ExportModel.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace stromar::test {

namespace {
struct Limits {
    std::size_t vertices, triangles;
};
constexpr Limits kLimits[] = {{3, 1},    {3, 1000},      {1000, 1},      {4, 2},
                              {100, 70}, {1000, 100000}, {65535, 65535}, {10'000'000, 10'000'000}};

void expectSound(const MeshChunk& chunk, const Limits& limits) {
    EXPECT_LE(chunk.vertices.size(), limits.vertices);
    EXPECT_LE(chunk.indices.size(), 3 * limits.triangles);
    EXPECT_EQ(chunk.indices.size() % 3, 0u);
    ASSERT_FALSE(chunk.indices.empty());
    const std::set<std::uint32_t> vertices(chunk.vertices.begin(), chunk.vertices.end());
    EXPECT_EQ(vertices.size(), chunk.vertices.size()) << "a vertex twice";
    const std::set<std::uint32_t> used(chunk.indices.begin(), chunk.indices.end());
    EXPECT_EQ(used.size(), chunk.vertices.size()) << "a vertex without a triangle";
    EXPECT_LT(*used.rbegin(), chunk.vertices.size());
}

void expectCutWell(const CMesh& mesh, const Limits& limits) {
    const auto chunks = cutIntoChunks(mesh, limits.vertices, limits.triangles);
    std::vector<std::uint32_t> joined;
    for (const MeshChunk& chunk : chunks) {
        expectSound(chunk, limits);
        for (const std::uint32_t i : chunk.indices) joined.push_back(chunk.vertices.at(i));
        const bool full = chunk.vertices.size() + 3 > limits.vertices || chunk.indices.size() == 3 * limits.triangles;
        EXPECT_TRUE(full || &chunk == &chunks.back()) << "a part is smaller than it might be";
    }
    EXPECT_TRUE(std::ranges::equal(joined, mesh.indices));
}
} // namespace

TEST(Chunks, KeepLimitsAndOrder) {
    const CParams params = preset("quaking_aspen");
    const auto tree = grow(params);
    for (const auto& mesh : meshesOf(*tree, params, detailOf(Model::Full)))
        for (const Limits& limits : kLimits) {
            SCOPED_TRACE(mesh->name + ", " + std::to_string(limits.vertices) + " vertices, " +
                         std::to_string(limits.triangles) + " triangles");
            expectCutWell(*mesh, limits);
        }
}

TEST(Chunks, AMeshWithinTheLimitsStaysWhole) {
    const CParams params = plainTrunk();
    const auto mesh = meshesOf(*grow(params), params, detailOf(Model::Full)).front();
    EXPECT_EQ(cutIntoChunks(*mesh, mesh->vertexCount() + 3, mesh->triangleCount()).size(), 1u);
}

TEST(Chunks, AnEmptyMeshHasNone) { EXPECT_TRUE(cutIntoChunks(CMesh(), 3, 1).empty()); }

} // namespace stromar::test
