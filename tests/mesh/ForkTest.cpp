#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
constexpr double kFacesDown = -0.2; // a normal's z, at most
constexpr double kAround = 0.6;     // metres
constexpr double kCrotch = 0.12;    // metres from the middle
constexpr double kStraight = 0.98;  // cosine: within 11 degrees of a limb's azimuth
constexpr double kMaxRidge = 14;    // degrees
constexpr std::size_t kMinEdges = 20;

struct Face {
    glm::dvec3 normal, middle;
};
Face faceOf(const CMesh& mesh, std::size_t firstIndex) {
    const auto corner = [&](std::size_t i) { return glm::dvec3(mesh.positions[mesh.indices[firstIndex + i]]); };
    const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
    return {glm::normalize(glm::cross(b - a, c - a)), (a + b + c) / 3.0};
}

/// Degrees that the wood bends outwards most right below a limb that leaves `place` in a direction, across edges that run around it.
double sharpestRidgeBelow(const CMesh& mesh, const glm::dvec3& place, const glm::dvec3& limb) {
    std::size_t looked = 0;
    const auto edges = trianglesByEdge(mesh);
    const glm::dvec2 aside = glm::normalize(glm::dvec2(limb));
    double sharpest = 0;
    for (const auto& [edge, triangle] : edges) {
        const auto other = edges.find({edge[1], edge[0]});
        const glm::dvec3 from(edge[0][0], edge[0][1], edge[0][2]), to(edge[1][0], edge[1][1], edge[1][2]), middle = (from + to) / 2.0 - place;
        const double out = glm::length(glm::dvec2(middle));
        const bool isNear = out > kCrotch && glm::length(middle) < kAround && glm::dot(glm::dvec2(middle), aside) > kStraight * out;
        const bool runsAround = std::abs(to.z - from.z) < glm::distance(from, to) / 2;
        if (other == edges.end() || !isNear || !runsAround) continue;
        const Face one = faceOf(mesh, triangle), two = faceOf(mesh, other->second);
        if (one.normal.z > kFacesDown) continue;
        ++looked;
        if (glm::dot(two.middle - one.middle, one.normal) >= 0) continue; // no ridge
        sharpest = std::max(sharpest, 360 / kTurn * std::acos(std::min(1.0, glm::dot(one.normal, two.normal))));
    }
    EXPECT_GE(looked, kMinEdges) << "the wood below the limb is not seen";
    return sharpest;
}
} // namespace

/// The wood runs out along the under sides of the limbs in one bend.
TEST(Fork, LimbsHaveNoRidgeBelow) {
    for (int seed = 1; seed <= 8; ++seed) {
        CParams params = preset("umbrella_acacia"); // four limbs from one place
        params.common.seed = seed;
        weberPenn(params).levels = 1;
        const auto tree = grow(params);
        const CGeneration& trunk = tree->generation(0);
        const auto mesh = meshAllStems(*tree, meshParamsOf(params), detailOf(Model::Full), CProgress(2))[0].mesh;
        for (std::uint32_t p = 1; p < trunk.stems[0].pathCount; ++p) {
            const CSegment& first = trunk.segments[trunk.paths[p].firstSegment];
            EXPECT_LT(sharpestRidgeBelow(*mesh, first.position, first.frame[2]), kMaxRidge) << "seed " << seed << ", path " << p;
        }
    }
}

} // namespace stromar::test
