// The trunk of a felled tree: cut into two closed parts, nothing lost.
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/ModelSway.h"
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

double volume(const CMesh& mesh) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const auto corner = [&](std::size_t c) { return glm::dvec3(mesh.positions[mesh.indices[t + c]]); };
        sum += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6;
    }
    return sum;
}

class Fell : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Trees, Fell,
                         ::testing::Values("quaking_aspen", "english_oak", "bamboo", "strand_birch", "abop_2_6c"));

TEST_P(Fell, BothPartsOfATrunkAreClosedAndItsWoodIsAllThere) {
    CTreeCreator creator;
    const auto model = creator.create(preset(GetParam()), detailOf(Model::Full), CProgress(2));
    const auto sway = swayOf(model, nullptr, CProgress(2));
    const double height = 0.13 * model->tree->height();
    const CFall fall(sway->table, {0, height});
    ASSERT_TRUE(fall.anythingFalls());
    const auto cut = felled(sway, fall);
    const CMesh &before = *model->stems[0], &after = *cut->model->stems[0];
    EXPECT_GT(after.vertexCount(), before.vertexCount());
    EXPECT_EQ(openEdges({&before}), 0u);
    EXPECT_EQ(openEdges({&after}), 0u);
    EXPECT_NEAR(volume(after), volume(before), 1e-4 * volume(before));
    const SwayPlaces& places = *cut->placesOf(after);
    ASSERT_EQ(places.size(), after.vertexCount());
    WindPose pose;
    fall.pose(fall.seconds(), pose, CProgress(2));
    const auto lying = swayed(after, places, *cut->table, pose, CProgress(2));
    std::size_t stump = 0;
    for (std::size_t v = 0; v < after.vertexCount(); ++v) stump += lying->positions[v] == after.positions[v];
    EXPECT_GT(stump, 3u);
    EXPECT_LT(stump, after.vertexCount());
    EXPECT_EQ(openEdges({lying.get()}), 0u) << "neither part is torn";
    EXPECT_NEAR(volume(*lying), volume(after), 0.03 * volume(after));
}

TEST(Fell, AtTheGroundNothingIsCut) {
    CTreeCreator creator;
    const auto sway =
        swayOf(creator.create(preset("apple"), detailOf(Model::Simple), CProgress(2)), nullptr, CProgress(2));
    EXPECT_EQ(felled(sway, CFall(sway->table, {0, 0})), sway);
    EXPECT_EQ(felled(sway, CFall(sway->table, {0, 100})), sway);
}

} // namespace
} // namespace stromar::test
