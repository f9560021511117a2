#include "join/SurfaceUnion.h"
#include "mesh/BoxPatch.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace stromar::test {

namespace {
using Index = CWoodPatch::Index;
constexpr Box kWood{{-1, -1, -1}, {1, 1, 1}};

std::vector<Index> trianglesOf(std::size_t box) {
    std::vector<Index> own(kBoxTriangles);
    std::iota(own.begin(), own.end(), static_cast<Index>(box * kBoxTriangles));
    return own;
}

/// The first box is the wood, the second the branch: its bottom is its base.
std::optional<double> unite(CWoodPatch& patch, std::size_t most = 1000, std::optional<glm::dvec3> start = {}) {
    const std::vector<Index> wood = trianglesOf(0), branch = trianglesOf(1), base{branch[2], branch[3]};
    patch.mark();
    const std::optional<double> turn = uniteSurfaces({wood, branch, branch, base, 0, 1e-5, start}, most, patch);
    return turn && patch.finish() ? turn : std::nullopt;
}
} // namespace

TEST(SurfaceUnion, ABranchThatComesOutIsOneSolidWithTheWood) {
    CWoodPatch patch = patchOf({kWood, {{-0.21f, -0.32f, 0.1f}, {0.23f, 0.34f, 3}}});
    EXPECT_TRUE(unite(patch));
    EXPECT_NEAR(volumeOf(patch), 8 + 2 * 0.44 * 0.66, 1e-3);
    patch.flood(std::array<Index, 1>{2}); // of the bottom
    for (Index t = 0; t < patch.triangles().size(); ++t)
        EXPECT_TRUE(patch.triangles()[t].removed || patch.isMarked(t)) << "it hangs together";
}

TEST(SurfaceUnion, ABranchMayComeOutAsSeveral) {
    CWoodPatch patch = patchOf({kWood, {{-3, -0.32f, -0.21f}, {3, 0.34f, 0.23f}}});
    const std::vector<Index> wood = trianglesOf(0), branch = trianglesOf(1);
    patch.mark();
    std::size_t work = 1000;
    // No triangle lies inside as a whole, but those in the middle are parted: where a curve crosses the base.
    EXPECT_TRUE(uniteSurfaces({wood, branch, branch, branch, 0, 1e-5, {}}, work, patch) && patch.finish());
    EXPECT_NEAR(volumeOf(patch), 8 + 4 * 0.44 * 0.66, 1e-3);
    EXPECT_LT(work, 1000u);
}

TEST(SurfaceUnion, ABaseThatIsThickerThanTheWoodIsJoinedWhereTheWoodEnters) {
    CWoodPatch patch = patchOf({{{-0.1f, -0.12f, -3}, {0.11f, 0.13f, 0.5f}}, {{-1, -1, 0}, {1, 1, 1}}});
    EXPECT_TRUE(unite(patch));
    EXPECT_NEAR(volumeOf(patch), 4 + 3 * 0.21 * 0.25, 1e-3);
}

TEST(SurfaceUnion, ABaseThatComesOutOfTheWoodStays) {
    CWoodPatch patch = patchOf({kWood, {{-0.21f, -0.32f, -3}, {0.23f, 0.34f, 3}}});
    EXPECT_TRUE(unite(patch));
    EXPECT_NEAR(volumeOf(patch), 8 + 4 * 0.44 * 0.66, 1e-3);
}

TEST(SurfaceUnion, ABranchWithinTheWoodIsLeftOut) {
    CWoodPatch patch = patchOf({kWood, {{-0.21f, -0.32f, 0.1f}, {0.23f, 0.34f, 0.9f}}});
    EXPECT_TRUE(unite(patch));
    EXPECT_EQ(left(patch), kBoxTriangles);
}

TEST(SurfaceUnion, TellsHowFarTheSeamTurns) {
    CWoodPatch corner = patchOf({kWood, {{-0.21f, -0.32f, 0.1f}, {0.23f, 0.34f, 3}}});
    EXPECT_NEAR(unite(corner).value(), 360, 0.05);
    CWoodPatch several = patchOf({kWood, {{-3, -0.32f, -0.21f}, {3, 0.34f, 0.23f}}});
    EXPECT_NEAR(unite(several).value(), 720, 0.05) << "of both";
    CWoodPatch edge = patchOf({kWood, {{-0.21f, 0.5f, 0.1f}, {0.23f, 1.5f, 3}}});
    EXPECT_NEAR(unite(edge).value(), 540, 0.05) << "over an edge of the wood";
    CWoodPatch none = patchOf({kWood, {{-0.21f, -0.32f, 0.1f}, {0.23f, 0.34f, 0.9f}}});
    EXPECT_EQ(unite(none), 0);
}

TEST(SurfaceUnion, ABranchBesideTheWoodStays) {
    CWoodPatch patch = patchOf({kWood, {{1.2f, -0.32f, 0.1f}, {1.5f, 0.34f, 0.9f}}});
    EXPECT_FALSE(unite(patch));
    patch.undo();
    EXPECT_EQ(left(patch), 2 * kBoxTriangles);
}

TEST(SurfaceUnion, AFootBesideTheWoodIsMovedIntoIt) {
    CWoodPatch patch = patchOf({kWood, {{-0.2f, -0.3f, 1.1f}, {0.2f, 0.3f, 3}}});
    EXPECT_FALSE(unite(patch));
    patch.undo();
    EXPECT_TRUE(unite(patch, 1000, glm::dvec3(0.05, 0.06, 0.3)));
    constexpr double kTop = 0.4 * 0.6, kFoot = (0.25 + 0.75 * 0.7 / 2.7) * (0.25 + 0.75 * 0.7 / 2.7) *
                                               kTop; // the base is a quarter as wide
    EXPECT_NEAR(volumeOf(patch), 8 + 2.0 / 3 * (kTop + kFoot + std::sqrt(kTop * kFoot)), 0.03);
}

TEST(SurfaceUnion, NoMoreIsCutThanMayBe) {
    CWoodPatch patch = patchOf({kWood, {{-0.21f, -0.32f, 0.1f}, {0.23f, 0.34f, 3}}});
    EXPECT_FALSE(unite(patch, 5));
    patch.undo();
    EXPECT_EQ(left(patch), 2 * kBoxTriangles);
}

} // namespace stromar::test
