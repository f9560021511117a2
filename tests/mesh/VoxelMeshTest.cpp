#include "stromar/mesh/VoxelMesh.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/Error.h"
#include <gtest/gtest.h>
#include <map>

namespace stromar::test {

namespace {
CParams smallTree(const char* name) {
    CParams params = preset(name);
    weberPenn(params).levels = 2;
    weberPenn(params).level[1].branches = 12;
    return params;
}

/// How many pieces hang together by their triangles.
std::size_t piecesOf(const CMesh& mesh) {
    std::vector<std::uint32_t> root(mesh.vertexCount());
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = v;
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (const std::size_t c : {1u, 2u}) root[find(mesh.indices[i + c])] = find(mesh.indices[i]);
    std::size_t pieces = 0;
    for (std::uint32_t v = 0; v < root.size(); ++v) pieces += find(v) == v;
    return pieces;
}
} // namespace

class VoxelMesh : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Trees, VoxelMesh, testing::Values("quaking_aspen", "english_oak", "umbrella_acacia"));

TEST_P(VoxelMesh, IsOneClosedSurfaceAroundTheWood) {
    const CParams params = smallTree(GetParam());
    const auto tree = grow(params);
    const auto solid = voxelMesh(*tree, meshParamsOf(params), 0.06, CProgress(2));
    const MeshFaults faults = checkSolid(*solid);
    EXPECT_TRUE(faults.sound()) << inWords(faults);
    EXPECT_EQ(piecesOf(*solid), 1u);
    EXPECT_GT(signedVolume(*solid), 0);
}

TEST(VoxelSolid, HasTheVolumeOfTheWoodAndEndsFlat) {
    CParams params = smallTree("quaking_aspen");
    weberPenn(params).levels = 1;
    const auto tree = grow(params);
    const auto tubes = meshAllStems(*tree, meshParamsOf(params), detailOf(Model::Full), CProgress(2));
    const auto solid = voxelMesh(*tree, meshParamsOf(params), 0.02, CProgress(2));
    EXPECT_NEAR(signedVolume(*solid) / signedVolume(*tubes[0].mesh), 1, 0.05);
    EXPECT_NEAR(solid->bounds().min.z, 0, 0.01);
    EXPECT_NEAR(solid->bounds().max.z, tubes[0].mesh->bounds().max.z, 0.05);
}

TEST(VoxelSolid, WhatIsTooMuchIsRefusedInWords) {
    const CParams whole = preset("weeping_willow"), small = smallTree("quaking_aspen");
    const auto refusal = [](const CParams& params, double size) -> std::string {
        try {
            voxelMesh(*grow(params), meshParamsOf(params), size, CProgress(2));
        } catch (const CError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(refusal(whole, 0.1).find("stems"), std::string::npos);
    EXPECT_NE(refusal(small, 1e-4).find("million voxels"), std::string::npos);
}

} // namespace stromar::test
