// The trunk alone, straight and upright: its surface can be told from the formulas.
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "weberpenn/Grown.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>

namespace stromar::test {

namespace {
struct Trunk {
    std::shared_ptr<const CTree> tree;
    MeshPlan plan;
    std::shared_ptr<const CMesh> mesh;
    MeshFaults faults() const { return checkStems(*tree, 0, {plan, mesh}, {}); }
    const CStem& stem() const { return tree->generation(0).stems[0]; }
};

Trunk trunkOf(const CParams& params, const Detail& detail = detailOf(Model::Full)) {
    const auto tree = grow(params);
    const StemMesh trunk = meshAllStems(*tree, meshParamsOf(params), detail, CProgress(2)).front();
    return {tree, trunk.plan, trunk.mesh};
}

/// Largest distance from the axis by height: the drawn profile.
std::map<float, double> profileOf(const CMesh& mesh) {
    std::map<float, double> profile;
    for (const glm::vec3& p : mesh.positions) {
        double& radius = profile.try_emplace(p.z, 0.0).first->second;
        radius = std::max(radius, std::hypot(double(p.x), double(p.y)));
    }
    return profile;
}

double drawnRadius(const std::map<float, double>& profile, double z) {
    auto high = profile.lower_bound(static_cast<float>(z));
    if (high == profile.end()) --high;
    if (high == profile.begin()) return high->second;
    const auto low = std::prev(high);
    const double t = std::clamp((z - low->first) / (high->first - low->first), 0.0, 1.0);
    return low->second + t * (high->second - low->second);
}

/// The corners on the walls: on lids the normals are upright.
template <typename Look>
void forEachWallVertex(const CMesh& mesh, Look&& look) {
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
        if (std::abs(mesh.normals[v].z) < 0.9f) look(mesh.positions[v], mesh.texCoords[v]);
}
} // namespace

TEST(TrunkSurface, FollowsTheTaper) {
    for (const double ratio : {0.015, 0.05})
        for (const double taper : {0.0, 0.5, 1.0, 1.3, 1.7, 2.0, 2.4, 3.0}) {
            CParams params = plainTrunk();
            weberPenn(params).ratio = ratio;
            weberPenn(params).level[0].taper = taper;
            const Trunk trunk = trunkOf(params);
            const auto profile = profileOf(*trunk.mesh);
            const CStem& measures = trunk.stem();
            double worst = 0;
            for (int i = 0; i <= 2000; ++i) {
                const double z = i / 2000.0;
                const double wanted = taperProfile(taper).radiusAt(z * measures.length, measures.length, measures.radius);
                worst = std::max(worst, std::abs(drawnRadius(profile, z * measures.length) - wanted));
            }
            EXPECT_LE(worst, 0.1 * measures.radius) << "taper " << taper << ", ratio " << ratio;
        }
}

TEST(TrunkSurface, FlaresAtTheGround) {
    for (const double flare : {-0.5, 0.5, 3.0}) {
        CParams params = plainTrunk();
        params.common.flare = flare;
        const Trunk trunk = trunkOf(params);
        const auto profile = profileOf(*trunk.mesh);
        const CStem& m = trunk.stem();
        for (int i = 0; i <= 1000; ++i) {
            const double z = i / 1000.0;
            const double wanted = m.radius * (1 + flare * (std::pow(100.0, std::max(0.0, 1 - 8 * z)) - 1) / 100);
            ASSERT_NEAR(drawnRadius(profile, z * m.length), wanted, 0.1 * m.radius) << "flare " << flare << " at " << z;
        }
        EXPECT_NEAR(profile.begin()->second, m.radius * (1 + 0.99 * flare), 1e-4 * m.radius);
    }
}

TEST(TrunkSurface, HasLobesAroundTheGround) {
    CParams params = plainTrunk();
    params.common.lobes = 5;
    params.common.lobeDepth = 0.3;
    params.common.lobeFade = 0;
    const Trunk trunk = trunkOf(params);
    const double radius = trunk.stem().radius;
    std::size_t looked = 0;
    forEachWallVertex(*trunk.mesh, [&](const glm::vec3& p, const glm::vec2&) {
        const double angle = std::atan2(p.y, p.x);
        EXPECT_NEAR(std::hypot(double(p.x), double(p.y)), radius * (1 + 0.3 * std::sin(5 * angle)), 1e-4 * radius);
        ++looked;
    });
    EXPECT_GE(looked, 2u * 40u) << "eight points a lobe";
}

TEST(TrunkSurface, HasRootsThatReachOutAndEnd) {
    CParams params = plainTrunk();
    params.common.roots = 5;
    params.common.rootReach = 2;
    params.common.rootHeight = 0.2;
    const Trunk trunk = trunkOf(params);
    const CStem& m = trunk.stem();
    std::vector<bool> reached(24);
    double farthest = 0;
    forEachWallVertex(*trunk.mesh, [&](const glm::vec3& p, const glm::vec2&) {
        const double out = std::hypot(double(p.x), double(p.y)) / m.radius - 1;
        EXPECT_GT(out, -1e-4);
        if (p.z > 0.2001 * m.length) {
            EXPECT_NEAR(out, 0, 1e-4);
        }
        if (p.z > 1e-6 * m.length) return;
        farthest = std::max(farthest, out);
        const auto sector = static_cast<std::size_t>((std::atan2(p.y, p.x) / std::numbers::pi + 1) * 11.999);
        reached[sector] = reached[sector] || out > 1.25;
    });
    EXPECT_GT(farthest, 1.6);
    EXPECT_LT(farthest, 2.7);
    int roots = 0; // sectors where one begins
    for (std::size_t i = 0; i < reached.size(); ++i) roots += reached[i] && !reached[(i + 23) % 24];
    EXPECT_EQ(roots, 5);
    EXPECT_EQ(inWords(trunk.faults()), "");
}

TEST(TrunkSurface, RootsAreSoundHoweverTheyReach) {
    for (const int roots : {1, 4, 9})
        for (const double reach : {0.4, 3.0, 9.0})
            for (const double height : {0.01, 0.2, 1.0})
                for (const int lobes : {0, 7}) {
                    CParams params = plainTrunk();
                    weberPenn(params).level[0].curve = 40;
                    weberPenn(params).level[0].taper = 1;
                    params.common.flare = 0.6;
                    params.common.roots = roots;
                    params.common.rootReach = reach;
                    params.common.rootHeight = height;
                    params.common.lobes = lobes;
                    params.common.lobeDepth = 0.1;
                    const Trunk trunk = trunkOf(params);
                    EXPECT_EQ(inWords(trunk.faults()), "")
                        << roots << " roots, reach " << reach << ", height " << height << ", " << lobes << " lobes";
                }
}

TEST(TrunkSurface, TheTextureGoesAroundAndAlong) {
    CParams params = plainTrunk();
    params.common.textureWrapX = 3;
    params.common.textureWrapY = 7;
    for (const Detail& detail : detailTable()) {
        const Trunk trunk = trunkOf(params, detail);
        const double length = trunk.stem().length;
        std::set<float> columns;
        forEachWallVertex(*trunk.mesh, [&](const glm::vec3& p, const glm::vec2& t) {
            double turn = std::atan2(p.y, p.x) / (2 * std::numbers::pi);
            if (turn < -1e-6) turn += 1;
            const bool atSeam = std::abs(turn) < 1e-6;
            EXPECT_NEAR(t.x, atSeam && t.x > 1 ? 3.0 : 3 * turn, 1e-5);
            EXPECT_NEAR(t.y, 7 * p.z / length, 1e-5);
            columns.insert(t.x);
        });
        ASSERT_FALSE(columns.empty());
        EXPECT_EQ(*columns.begin(), 0.f);
        EXPECT_EQ(*columns.rbegin(), 3.f);
    }
}

TEST(TrunkSurface, NormalsAreThoseOfACone) {
    CParams params = plainTrunk();
    weberPenn(params).level[0].taper = 0.6;
    const Trunk trunk = trunkOf(params);
    const CStem& m = trunk.stem();
    const double rise = 0.6 * m.radius / m.length;
    for (std::size_t v = 0; v < trunk.mesh->vertexCount(); ++v) {
        const glm::vec3& p = trunk.mesh->positions[v];
        const glm::vec3& n = trunk.mesh->normals[v];
        if (std::abs(n.z) > 0.9f) continue;
        const double r = std::hypot(double(p.x), double(p.y));
        const double wanted[] = {p.x / r, p.y / r, rise};
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(n[i], wanted[i] / std::hypot(1.0, rise), 1e-3);
    }
    EXPECT_EQ(inWords(trunk.faults()), "");
}

TEST(TrunkSurface, NormalsPointToTheFront) {
    for (const double taper : {0.0, 0.8, 1.0, 1.5, 2.0})
        for (const double flare : {0.0, 0.6, 3.0})
            for (const int lobes : {0, 3, 7})
                for (const double fade : {0.0, 1.0}) {
                    CParams params = plainTrunk();
                    weberPenn(params).level[0].taper = taper;
                    params.common.flare = flare;
                    params.common.lobes = lobes;
                    params.common.lobeDepth = 0.3;
                    params.common.lobeFade = fade;
                    const Trunk trunk = trunkOf(params);
                    EXPECT_EQ(inWords(trunk.faults()), "")
                        << "of " << trunk.mesh->triangleCount() << ", taper " << taper << ", flare " << flare << ", "
                        << lobes << " lobes, fade " << fade;
                }
}

TEST(TrunkSurface, EnclosesTheVolumeOfItsPrism) {
    const CParams params = plainTrunk();
    for (const Detail& detail : detailTable()) {
        const Trunk trunk = trunkOf(params, detail);
        const CStem& m = trunk.stem();
        const int n = detail.ringPoints;
        const double radius = detail.lod == 0 ? m.radius : m.radius * outlineShare(detailOf(Model::Full).ringPoints) / outlineShare(n);
        const double area = 0.5 * n * radius * radius * std::sin(2 * std::numbers::pi / n);
        EXPECT_NEAR(signedVolume(*trunk.mesh), area * m.length, 1e-4 * area * m.length) << detail.name;
    }
}

TEST(TrunkSurface, IsAsWideAtEveryLevelOfDetail) {
    const auto meanWidth = [](const Detail& detail) {
        const Trunk trunk = trunkOf(plainTrunk(), detail);
        double sum = 0;
        for (int degrees = 0; degrees < 180; ++degrees) {
            const glm::vec2 across(std::cos(degrees * std::numbers::pi / 180), std::sin(degrees * std::numbers::pi / 180));
            float low = 0, high = 0;
            forEachWallVertex(*trunk.mesh, [&](const glm::vec3& p, const glm::vec2&) {
                low = std::min(low, glm::dot(across, glm::vec2(p)));
                high = std::max(high, glm::dot(across, glm::vec2(p)));
            });
            sum += double(high - low) / 180;
        }
        return sum;
    };
    const double full = meanWidth(detailOf(Model::Full));
    for (int lod = 1; lod <= kMaxLod; ++lod) EXPECT_NEAR(meanWidth(detailOf(Model::Full, lod)) / full, 1, 1e-3) << lod;
}

TEST(TrunkSurface, IsNeverThinnerThanTheLeastRadius) {
    CParams params = plainTrunk();
    weberPenn(params).level[0].taper = 1;
    params.common.minRadius = 0.2;
    const Trunk trunk = trunkOf(params);
    for (const auto& [z, radius] : profileOf(*trunk.mesh)) {
        if (z > 0.99 * trunk.stem().length) continue; // the tip may be a point
        EXPECT_GE(radius, 0.2 - 1e-6) << z;
    }
}

TEST(TrunkSurface, AHelixKeepsItsWidth) {
    CParams params = plainTrunk();
    weberPenn(params).level[0].curveV = -30;
    const Trunk trunk = trunkOf(params);
    EXPECT_EQ(inWords(trunk.faults()), "");
    EXPECT_GT(signedVolume(*trunk.mesh), 0);
    const CStem& m = trunk.stem();
    const double around = m.length / weberPenn(params).level[0].curveRes * std::tan(std::numbers::pi / 6) / (2 * std::numbers::pi);
    const Bounds box = trunk.mesh->bounds();
    EXPECT_NEAR(box.max.y - box.min.y, 2 * (around + m.radius), 0.15 * (around + m.radius));
    EXPECT_NEAR(box.max.z, m.length, m.radius);
}

} // namespace stromar::test
