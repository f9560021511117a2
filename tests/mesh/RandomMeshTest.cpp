#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/params/methods/weberpenn/TreeParams.h"
#include <gtest/gtest.h>
#include <utility>

namespace stromar::test {

namespace {
constexpr std::uint64_t kSamples = 60;

/// Calls `look(tree, params, generation, plan, mesh, label)` for every mesh of stems of every sample in every detail.
template <typename Look>
void forEachStemMesh(Look&& look) {
    for (std::uint64_t number = 0; number < kSamples; ++number) {
        const CParams params = randomParams(number);
        const auto tree = grow(params);
        for (const Detail& detail : detailTable())
            for (int g = 0; const auto& [plan, mesh] : meshAllStems(*tree, meshParamsOf(params), detail, CProgress(2))) {
                const std::string label =
                    "sample " + std::to_string(number) + ", " + std::string(detail.name) + ", " + mesh->name;
                look(*tree, params, g++, plan, *mesh, label);
            }
    }
}
} // namespace

/// The faults of all meshes of a tree, level of detail after level of detail.
template <typename Report>
void checkAll(const CParams& params, Report&& report) {
    const auto tree = grow(params);
    for (const Detail& detail : detailTable()) {
        const auto all = meshAllStems(*tree, meshParamsOf(params), detail, CProgress(2));
        for (std::size_t g = 0; g < all.size(); ++g)
            report(checkStems(*tree, static_cast<int>(g), all[g], all),
                   std::string(detail.name) + ", " + all[g].mesh->name);
        if (detail.lod % 2 == 0) // the others differ little
            report(checkJoined(joinStems(*tree, all, CProgress(2)), all), std::string(detail.name) + ", joined");
        report(checkLeaves(*organsOf(*tree, params, Organ::Leaf, all, detail)),
               std::string(detail.name) + ", leaves");
    }
}

/// Where a stem turns back more tightly than it is thick, it reaches through itself, and normals may be tilted there:
/// the share says how often. All else has to be sound.
void expectSound(std::uint64_t first, std::uint64_t end, CParams (*make)(std::uint64_t, const Caps&), double maxTilted) {
    std::size_t triangles = 0, tilted = 0;
    for (std::uint64_t number = first; number < end; ++number)
        checkAll(make(number, kMeshCaps), [&](MeshFaults faults, const std::string& label) {
            triangles += faults.triangles;
            if (!label.ends_with("leaves")) tilted += std::exchange(faults.tilted, 0);
            EXPECT_EQ(inWords(faults), "") << "of " << faults.triangles << ", sample " << number << ", " << label;
        });
    EXPECT_GT(triangles, 1'000'000u) << "the samples show too little";
    EXPECT_LE(double(tilted), maxTilted * double(triangles)) << tilted << " of " << triangles;
}

/// From the sample on that is the parameter.
constexpr std::uint64_t kGentleOfATest = 50, kWildOfATest = 30;
class GentleTrees : public ::testing::TestWithParam<std::uint64_t> {};
class WildTrees : public ::testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Slow, GentleTrees, ::testing::Values<std::uint64_t>(0));
INSTANTIATE_TEST_SUITE_P(Exhaustive, GentleTrees, ::testing::Range<std::uint64_t>(kGentleOfATest, 300, kGentleOfATest));
INSTANTIATE_TEST_SUITE_P(Slow, WildTrees, ::testing::Values<std::uint64_t>(0));
INSTANTIATE_TEST_SUITE_P(Exhaustive, WildTrees, ::testing::Range<std::uint64_t>(kWildOfATest, 120, kWildOfATest));

TEST_P(GentleTrees, AreSound) { expectSound(GetParam(), GetParam() + kGentleOfATest, gentleParams, 0.002); }
TEST_P(WildTrees, AreSound) { expectSound(GetParam(), GetParam() + kWildOfATest, randomParams, 0.005); }

TEST(RandomMesh, NoStemHasANegativeRadius) {
    for (std::uint64_t number = 0; number < kSamples; ++number) {
        const auto tree = grow(randomParams(number));
        for (const auto& generation : tree->generations())
            for (const CStem& stem : generation->stems) ASSERT_GE(stem.radius, 0) << "sample " << number;
    }
}

TEST(SlowRandomMesh, StraightTubesFaceOutwards) {
    std::size_t looked = 0;
    for (std::uint64_t number = 0; number < kSamples; ++number) {
        CParams params = randomParams(number);
        for (LevelParams& level : weberPenn(params).level) {
            level.curve = level.curveBack = level.curveV = 0;
            level.segSplits = 0;
        }
        weberPenn(params).baseSplits = 0;
        weberPenn(params).attractionUp = 0;
        const auto tree = grow(params);
        for (const Detail& detail : detailTable())
            for (const auto& [plan, mesh] : meshAllStems(*tree, meshParamsOf(params), detail, CProgress(2))) {
                EXPECT_EQ(invertedSurfaces(plan, *mesh), 0u) << "of " << plan.tubes.size() << " tubes, sample " << number << ", "
                                        << detail.name << ", " << mesh->name;
                looked += plan.tubes.size();
            }
    }
    EXPECT_GT(looked, 1000u);
}

/// Stems wound up more narrowly than they are thick have no inside.
bool windsUp(const CTree& tree, const CParams& params, int generation) {
    const LevelParams& level = weberPenn(params).level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))];
    const double degrees = std::max(std::abs(level.curve.value), 2 * std::abs(level.curveBack.value)) + std::abs(level.curveV.value);
    const auto tight = [&](const CStem& stem) {
        const double radius = std::max(stem.radius * (1 + params.common.flare), params.common.minRadius);
        return radius * degrees * kRadiansPerDegree > 0.8 * stem.length;
    };
    return std::ranges::any_of(tree.generation(static_cast<std::size_t>(generation)).stems, tight);
}

TEST(SlowRandomMesh, WholeMeshesEncloseWood) {
    int looked = 0;
    forEachStemMesh([&](const CTree& tree, const CParams& params, int generation, const MeshPlan&, const CMesh& mesh,
                        const std::string& label) {
        if (mesh.vertexCount() == 0) return;
        const LevelParams& level = weberPenn(params).level[static_cast<std::size_t>(std::min(generation, kParamLevels - 1))];
        if (weberPenn(params).scale < 0.1 || params.common.minRadius * level.curveRes > 0.5 * weberPenn(params).scale) return;
        if (windsUp(tree, params, generation)) return;
        ++looked;
        EXPECT_GT(signedVolume(mesh), -1e-9) << label; // the smallest trees are all rounding
    });
    EXPECT_GT(looked, 250);
}

TEST(RandomMesh, IsTheSameForEveryNumberOfThreads) {
    for (std::uint64_t number = 0; number < kSamples; number += 3) {
        const CParams params = randomParams(number);
        const auto one = meshesOf(*grow(params, 1), params, detailOf(Model::Full), 1);
        const auto two = meshesOf(*grow(params, 2), params, detailOf(Model::Full), 2);
        ASSERT_EQ(one.size(), two.size());
        for (std::size_t m = 0; m < one.size(); ++m)
            EXPECT_TRUE(sameBytes(*one[m], *two[m])) << "sample " << number << ", " << one[m]->name;
    }
}

} // namespace stromar::test
