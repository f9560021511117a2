#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/mesh/check/MeshCheck.h"
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <set>

namespace stromar::test {
namespace {

CParams orchard() {
    CParams params = preset("apple");
    params.common.fruits = 4;
    params.common.blossoms = 3;
    return params;
}

std::shared_ptr<const CMesh> organs(CParams params, Organ organ, double month, const Detail& detail) {
    params.common.season = month;
    const auto tree = grow(params);
    const auto all = meshAllStems(*tree, meshParamsOf(params), detail, CProgress(2));
    return organsOf(*tree, params, organ, all, detail);
}
const Detail& full(int lod = 0) { return detailOf(Model::Full, lod); }
} // namespace

TEST(OrganMesh, FruitsAreClosedAndSound) {
    for (const Detail& detail : detailTable()) {
        const auto fruits = organs(orchard(), Organ::Fruit, 9, detail);
        ASSERT_GT(fruits->triangleCount(), 0u) << detail.name;
        EXPECT_TRUE(checkLeaves(*fruits).sound()) << detail.name;
        EXPECT_EQ(fruits->surface, Surface::Fruit);
        const std::size_t each = bladeOf(meshParamsOf(orchard()), Organ::Fruit, detail).points.size();
        EXPECT_EQ(fruits->vertexCount() % each, 0u);
        EXPECT_GT(signedVolume(*fruits), 0) << detail.name << ": they face outwards";
    }
}

TEST(OrganMesh, TheSeasonHasItsOrgans) {
    const auto count = [](Organ organ, double month) { return organs(orchard(), organ, month, full())->vertexCount(); };
    EXPECT_EQ(count(Organ::Leaf, 1), 0u);
    EXPECT_GT(count(Organ::Leaf, 7), count(Organ::Leaf, 10.6));
    EXPECT_GT(count(Organ::Leaf, 10.6), 0u);
    EXPECT_EQ(count(Organ::Blossom, 7), 0u);
    EXPECT_GT(count(Organ::Blossom, 4.7), 0u);
    EXPECT_EQ(count(Organ::Fruit, 4), 0u);
    EXPECT_GT(count(Organ::Fruit, 9), 0u);
}

TEST(OrganMesh, LeavesThatFallEarlyAreGoneLater) {
    const auto early = organs(orchard(), Organ::Leaf, 10.3, full()),
               late = organs(orchard(), Organ::Leaf, 10.8, full());
    std::set<std::pair<float, float>> places;
    for (const glm::vec3& p : early->positions) places.insert({p.x, p.z});
    for (const glm::vec3& p : late->positions) ASSERT_TRUE(places.contains({p.x, p.z}));
}

TEST(OrganMesh, LeavesInTheShadeAreLarger) {
    CParams params = preset("norway_maple");
    const auto lengths = [&](double sunAndShade) {
        params.common.leafSunShade = sunAndShade;
        const auto tree = grow(params);
        const auto all = meshAllStems(*tree, meshParamsOf(params), full(), CProgress(2));
        std::vector<const MeshPlan*> plans;
        for (const StemMesh& own : all) plans.push_back(&own.plan);
        const auto leaves = meshOfOrgans(*tree, Organ::Leaf, plans, meshParamsOf(params), full(), CProgress(2));
        std::vector<InstancePlace> places;
        for (std::size_t i = 0; i < leaves[0]->count(); ++i) places.push_back(leaves[0]->place(i));
        return places;
    };
    const auto even = lengths(0), shaded = lengths(1);
    ASSERT_EQ(even.size(), shaded.size());
    glm::vec3 low(1e9f), high(-1e9f);
    for (const InstancePlace& place : even) {
        low = glm::min(low, place.position);
        high = glm::max(high, place.position);
    }
    double inner = 0, inners = 0, outer = 0, outers = 0, smallest = 1e9, largest = 0, area = 0;
    for (std::size_t i = 0; i < even.size(); ++i) {
        const double ratio = shaded[i].length / even[i].length;
        smallest = std::min(smallest, ratio);
        largest = std::max(largest, ratio);
        area += ratio * ratio;
        ASSERT_NEAR(shaded[i].width / even[i].width, ratio, 1e-5) << "they keep their shape";
        const float out = glm::length((even[i].position - (low + high) / 2.f) / ((high - low) / 2.f));
        if (out < 0.5f) inner += ratio, ++inners;
        if (out > 0.95f) outer += ratio, ++outers;
    }
    ASSERT_GT(inners, 10);
    ASSERT_GT(outers, 10);
    EXPECT_LE(largest, 1.6 * smallest + 1e-6);
    EXPECT_GT(largest, 1.5 * smallest);
    EXPECT_GT(inner / inners, 1.25 * outer / outers);
    EXPECT_NEAR(area / double(even.size()), 1, 1e-6) << "all together have the same area";
}

TEST(OrganMesh, DomesOfBlossomsStandOutInTheMiddle) {
    MeshParams params = meshParamsOf(orchard());
    params.blossomDome = 1;
    const LeafBlade dome = bladeOf(params, Organ::Blossom, full());
    double middle = -1e9, corner = 1e9;
    for (const LeafBlade::Point& point : dome.points) {
        const double out = std::hypot(point.place.x, point.place.y - 0.5);
        if (out < 0.01) middle = point.place.z;
        if (out > 0.7) corner = point.place.z;
        EXPECT_NEAR(glm::length(point.normal), 1, 1e-9);
        EXPECT_GE(point.normal.x * point.place.x + point.normal.y * (point.place.y - 0.5), out > 0.01 ? 1e-3 : -1e-9) << "they look outwards";
    }
    EXPECT_NEAR(middle - corner, 1, 1e-9);
    EXPECT_EQ(bladeOf(params, Organ::Blossom, full(2)).points.size(), 4u) << "far ones are cards";
    params.blossomDome = 0;
    EXPECT_EQ(bladeOf(params, Organ::Blossom, full()).points.size(), 4u);
}

TEST(OrganMesh, PlanesCrossInTheLengthOfTheirLeaf) {
    CParams params = preset("quaking_aspen");
    const auto one = organs(params, Organ::Leaf, 7, full());
    params.common.leafPlanes = 3;
    const auto three = organs(params, Organ::Leaf, 7, full());
    EXPECT_EQ(three->vertexCount(), 3 * one->vertexCount());
    EXPECT_TRUE(checkLeaves(*three).sound());
    const auto middle = [](const CMesh& mesh, std::size_t card) {
        return (mesh.positions[4 * card] + mesh.positions[4 * card + 1] + mesh.positions[4 * card + 2] +
                mesh.positions[4 * card + 3]) /
               4.0f;
    };
    for (std::size_t leaf = 0; leaf < 50; ++leaf)
        for (std::size_t plane = 1; plane < 3; ++plane)
            EXPECT_LT(glm::length(middle(*three, 3 * leaf) - middle(*three, 3 * leaf + plane)), 1e-4f);
}

TEST(OrganMesh, EveryLeafShapeIsSound) {
    for (int shape = 0; shape <= 12; ++shape) {
        CParams params = preset("quaking_aspen");
        params.common.leafForm = 1;
        params.common.leafShape = shape;
        EXPECT_TRUE(checkLeaves(*organs(params, Organ::Leaf, 7, full())).sound()) << shape;
    }
}

namespace {
std::shared_ptr<const COrganMesh> instancesOf(const CParams& params, const Detail& detail) {
    const auto tree = grow(params);
    const auto all = meshAllStems(*tree, meshParamsOf(params), detail, CProgress(2));
    return meshOfOrgans(*tree, Organ::Leaf, plansOf(all), meshParamsOf(params), detail, CProgress(2))[0];
}
} // namespace

TEST(OrganMesh, InstancesStandWhereTheirVerticesDo) {
    CParams params = preset("european_beech");
    params.common.leafForm = 1;
    params.common.leafFold = 20;
    const auto leaves = instancesOf(params, full());
    const auto mesh = leaves->expanded(CProgress(2));
    ASSERT_EQ(mesh->vertexCount(), leaves->vertexCount());
    ASSERT_EQ(mesh->triangleCount(), leaves->triangleCount());
    const auto& points = leaves->blade().points;
    for (std::size_t i = 0; i < leaves->count(); i += 97) {
        const InstancePlace place = leaves->place(i);
        const glm::dvec3 q(place.turn), size(place.width, place.length, place.width);
        for (std::size_t p = 0; p < points.size(); ++p) { // as the shader turns them
            const glm::dvec3 v = points[p].place * size;
            const glm::dvec3 turned = v + 2.0 * glm::cross(q, glm::cross(q, v) + double(place.turn.w) * v);
            const glm::dvec3 wanted(mesh->positions[i * points.size() + p]);
            ASSERT_LT(glm::distance(glm::dvec3(place.position) + turned, wanted), 1e-5) << i;
        }
    }
    const Bounds box = mesh->bounds(), own = leaves->bounds(CProgress(2));
    EXPECT_EQ(box.min, own.min);
    EXPECT_EQ(box.max, own.max);
}

TEST(OrganMesh, ARayMeetsTheNearestLeaf) {
    const auto leaves = instancesOf(preset("quaking_aspen"), full());
    const auto mesh = leaves->expanded(CProgress(2));
    int met = 0;
    for (std::size_t i = 0; i < leaves->count(); i += 311) {
        const glm::dvec3 from(20, -30, 9), middle(leaves->leaf(i).position + 0.4f * leaves->leaf(i).length * leaves->leaf(i).axis);
        const auto hit = leaves->meet(from, middle - from);
        if (hit.instance < 0) continue; // it is seen edge-on
        ++met;
        EXPECT_LE(hit.distance, 1 + 1e-6) << "that leaf, or one before it";
        const Bounds box = mesh->bounds();
        const glm::dvec3 at = from + hit.distance * (middle - from);
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(at[k], box.min[k] - 1e-4);
            EXPECT_LE(at[k], box.max[k] + 1e-4);
        }
    }
    EXPECT_GT(met, 20);
    EXPECT_EQ(leaves->meet({20, -30, 9}, {0, -1, 0}).instance, -1) << "behind";
}

} // namespace stromar::test
