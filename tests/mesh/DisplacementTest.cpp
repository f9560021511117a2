#include "stromar/mesh/Displacement.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/util/Error.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <set>

namespace stromar::test {
namespace {

constexpr double kCell = 0.04;
constexpr DisplacementLimit kEnough{10'000'000};

struct Wood {
    explicit Wood(const std::string& name)
        : tree(grow(preset(name))), stems(meshAllStems(*tree, meshParamsOf(preset(name)), detailOf(Model::Full), CProgress(2))),
          joined(joinStems(*tree, stems, CProgress(2))) {}

    DisplacedStems displaced(const std::shared_ptr<const CBarkRelief>& relief, double cell = kCell, DisplacementLimit limit = kEnough) const {
        return displaceStems(joined.meshes, joined.sources, BarkReliefs(joined.meshes.size(), relief), cell, limit, CProgress(2));
    }

    std::shared_ptr<const CTree> tree;
    std::vector<StemMesh> stems;
    JoinedStems joined;
};

/// Ridges that run along the stem.
std::shared_ptr<const CBarkRelief> ridges(double depth) {
    constexpr int kSize = 64;
    std::vector<std::uint8_t> heights;
    for (int i = 0; i < kSize * kSize; ++i) heights.push_back(static_cast<std::uint8_t>(127.5 + 127.5 * std::sin(i % kSize * 6.2831853 / 16)));
    return std::make_shared<const CBarkRelief>(heights, kSize, kSize, depth);
}

std::shared_ptr<const CBarkRelief> flat() { return std::make_shared<const CBarkRelief>(std::vector<std::uint8_t>{90}, 1, 1, 1.0); }

class Displacement : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Trees, Displacement, ::testing::Values("quaking_aspen", "scots_pine", "strand_birch", "coconut_palm", "hazel"));

TEST_P(Displacement, KeepsTheWoodClosed) {
    const Wood wood(GetParam());
    DisplacedStems rough = wood.displaced(ridges(0.03));
    std::size_t before = 0, after = 0;
    for (std::size_t g = 0; g < rough.meshes.size(); ++g) {
        before += wood.joined.meshes[g]->triangleCount();
        after += rough.meshes[g]->triangleCount();
    }
    EXPECT_GT(after, before);
    MeshFaults faults = checkJoined({rough.meshes, rough.sources, 0, 0}, wood.stems);
    faults.tilted = 0; // normals are those of smooth wood
    EXPECT_EQ(inWords(faults), "");
}

TEST_P(Displacement, HasNoLongEdgesOnTheTrunk) {
    const Wood wood(GetParam());
    const DisplacedStems rough = wood.displaced(flat());
    const CMesh& trunk = *rough.meshes[0];
    double longest = 0;
    for (std::size_t t = 0; t < trunk.indices.size(); t += 3)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = trunk.indices[t + i], b = trunk.indices[t + (i + 1) % 3];
            if (std::max(trunk.looks[a].thinness, trunk.looks[b].thinness) < VertexLook::kThinnessOfHalf)
                longest = std::max<double>(longest, glm::distance(trunk.positions[a], trunk.positions[b]));
        }
    EXPECT_GT(longest, kCell / 2);
    EXPECT_LE(longest, kCell);
}

TEST_P(Displacement, OfAFlatBarkChangesNoShape) {
    const Wood wood(GetParam());
    EXPECT_NEAR(signedVolume(wood.displaced(flat()).meshes) / signedVolume(wood.joined.meshes), 1, 1e-4);
}

TEST_P(Displacement, LeavesThinWoodAlone) {
    const Wood wood(GetParam());
    const DisplacedStems rough = wood.displaced(ridges(0.03));
    using Places = std::set<std::tuple<float, float, float>>;
    const auto add = [](Places& places, const CMesh& mesh) {
        for (const glm::vec3& p : mesh.positions) places.emplace(p.x, p.y, p.z);
    };
    Places places, feet; // the latter of branches, on thicker wood
    add(places, *rough.meshes.back());
    for (std::size_t g = 0; g + 1 < wood.joined.meshes.size(); ++g) add(feet, *wood.joined.meshes[g]);
    const CMesh& before = *wood.joined.meshes.back();
    std::size_t thin = 0, kept = 0;
    for (std::size_t v = 0; v < before.vertexCount(); ++v) {
        const glm::vec3& p = before.positions[v];
        if (before.looks[v].thinness < 2 * VertexLook::kThinnessOfHalf || feet.contains({p.x, p.y, p.z})) continue;
        ++thin;
        kept += places.contains({p.x, p.y, p.z});
    }
    EXPECT_GE(double(kept), 0.99 * double(thin));
}
} // namespace

TEST(Displacement, IsAsDeepAsItsPictureSays) {
    const Wood wood("coconut_palm");
    const CMesh& trunk = *wood.joined.meshes[0];
    const auto outermost = [](const CMesh& mesh, float low, float high, bool least) { // distance from the mean of a slice
        glm::dvec2 middle(0);
        double count = 0, found = least ? 1e9 : 0;
        for (const bool second : {false, true})
            for (const glm::vec3& p : mesh.positions) {
                if (p.z < low || p.z > high) continue;
                if (!second) {
                    middle += glm::dvec2(p);
                    ++count;
                    continue;
                }
                const double away = glm::distance(glm::dvec2(p), middle / count);
                found = least ? std::min(found, away) : std::max(found, away);
            }
        return found;
    };
    const DisplacedStems even = wood.displaced(flat(), 0.02), rough = wood.displaced(ridges(0.05), 0.02);
    const double tile = 2 * 3.14159265 * 0.15; // the picture goes once around a trunk about so thick
    const double slice = outermost(*even.meshes[0], 3, 3.1f, false) - outermost(*even.meshes[0], 3, 3.1f, true);
    const double deep = outermost(*rough.meshes[0], 3, 3.1f, false) - outermost(*rough.meshes[0], 3, 3.1f, true);
    EXPECT_NEAR(deep - slice, 0.05 * tile, 0.35 * 0.05 * tile);
    EXPECT_GT(rough.meshes[0]->vertexCount(), trunk.vertexCount());
}

TEST(Displacement, RefusesTooMany) {
    const Wood wood("quaking_aspen");
    try {
        (void)wood.displaced(flat(), 0.001, {200'000});
        FAIL();
    } catch (const CError& e) {
        EXPECT_NE(std::string(e.what()).find("0.001 m would make more than 0.2 million triangles"), std::string::npos) << e.what();
    }
}

TEST(BarkRelief, IsRepeatedAboutItsMean) {
    const CBarkRelief relief({255, 0, 0, 0}, 2, 2, 0.1); // upper left is high
    EXPECT_NEAR(relief.at({0.25f, 0.75f}), 0.1 * 0.75, 1e-6);
    EXPECT_NEAR(relief.at({3.25f, -4.25f}), 0.1 * 0.75, 1e-6);
    EXPECT_NEAR(relief.at({0.75f, 0.75f}), -0.1 * 0.25, 1e-6);
    EXPECT_NEAR(relief.at({0.5f, 0.75f}), 0.1 * 0.25, 1e-6) << "half way";
    EXPECT_NEAR(relief.at({0.999999f, 0.75f}), relief.at({0, 0.75f}), 1e-5) << "no seam";
}

} // namespace stromar::test
