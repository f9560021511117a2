#include "join/BoundsTree.h"
#include "join/Triangulation.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/mesh/Sway.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

namespace stromar::test {

namespace {
struct Grown {
    explicit Grown(const CParams& params, int lod = 0, int threads = 2)
        : tree(grow(params)), stems(meshAllStems(*tree, meshParamsOf(params), detailOf(Model::Full, lod), CProgress(threads))),
          joined(joinStems(*tree, stems, CProgress(threads))) {}
    std::shared_ptr<const CTree> tree;
    std::vector<StemMesh> stems;
    JoinedStems joined;

    std::size_t attached() const {
        std::size_t count = 0;
        for (const StemMesh& own : stems)
            for (const Tube& tube : own.plan.tubes) count += tube.collarRings > 0 || tube.forked;
        return count;
    }
    /// Branches without a collar, and clones of a fork that could not be made.
    std::size_t startInside() const {
        std::size_t count = 0;
        for (std::size_t g = 0; g < stems.size(); ++g)
            for (const Tube& tube : stems[g].plan.tubes)
                count += tube.collarRings == 0 && !tube.startsAtFork() && (g > 0 || tree->generation(g).paths[tube.path].source >= 0);
        return count;
    }
    std::size_t left() const { return joined.apart + joined.withoutCollar; }
};

/// A square of `count` by `count` cells, 0..1, counter-clockwise triangles.
CTriangulation square(std::uint32_t count) {
    std::vector<CTriangulation::Triangle> triangles;
    const auto add = [&](std::array<glm::uvec2, 3> corners) {
        CTriangulation::Triangle& own = triangles.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
            own.vertices[c] = corners[c].y * (count + 1) + corners[c].x;
            own.at[c] = glm::dvec2(corners[c]) / double(count);
        }
    };
    for (std::uint32_t y = 0; y < count; ++y)
        for (std::uint32_t x = 0; x < count; ++x) {
            add({glm::uvec2(x, y), glm::uvec2(x + 1, y), glm::uvec2(x + 1, y + 1)});
            add({glm::uvec2(x, y), glm::uvec2(x + 1, y + 1), glm::uvec2(x, y + 1)});
        }
    return CTriangulation(std::move(triangles), (count + 1) * (count + 1));
}

double areaOf(const CTriangulation::Triangle& t) {
    const glm::dvec2 u = t.at[1] - t.at[0], v = t.at[2] - t.at[0];
    return (u.x * v.y - u.y * v.x) / 2;
}

double areaLeft(const CTriangulation& surface) {
    double sum = 0;
    for (const auto& triangle : surface.triangles())
        if (!triangle.removed) sum += areaOf(triangle);
    return sum;
}

/// A circle about a point, in a square of so many cells; clockwise when `turn` is −1.
std::vector<CTriangulation::LoopPoint> circle(std::uint32_t cells, glm::dvec2 middle, double radius, int points, double turn = 1) {
    std::vector<CTriangulation::LoopPoint> loop;
    for (int i = 0; i < points; ++i) {
        const double angle = turn * 2 * std::numbers::pi * (i + 0.3) / points;
        const glm::dvec2 at = middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)), cell = at * double(cells);
        const glm::dvec2 within = cell - glm::floor(cell);
        const auto index = static_cast<std::uint32_t>(cell.y) * cells + static_cast<std::uint32_t>(cell.x);
        loop.push_back({2 * index + (within.y > within.x ? 1 : 0), at});
    }
    return loop;
}

double volumeApart(const std::vector<StemMesh>& stems) {
    double volume = 0;
    for (const StemMesh& own : stems) volume += signedVolume(*own.mesh);
    return volume;
}

/// Whether a tube has a vertex at a place that shows the same of the bark, whose picture repeats.
bool hasWithBark(const CMesh& mesh, const Tube& tube, const glm::vec3& place, const glm::vec2& bark) {
    for (std::size_t v = tube.firstVertex; v < tube.firstVertex + tube.vertexCount(); ++v) {
        const glm::vec2 apart = glm::abs(mesh.texCoords[v] - bark);
        if (mesh.positions[v] == place && std::abs(apart.x - std::round(apart.x)) < 1e-3 && apart.y < 1e-3) return true;
    }
    return false;
}

/// The edges of the holes of a mesh, as of trianglesByEdge().
std::map<MeshEdge, std::size_t> bordersOf(const CMesh& mesh) {
    const std::map<MeshEdge, std::size_t> edges = trianglesByEdge(mesh);
    std::map<MeshEdge, std::size_t> borders;
    for (const auto& [edge, triangle] : edges)
        if (!edges.contains({edge[1], edge[0]})) borders[edge] = triangle;
    return borders;
}

/// Degrees by which the seams turn that limbs share with the trunk, by stem.
std::map<std::uint32_t, double> turnsOfSeams(const Grown& tree) {
    const auto trunk = bordersOf(*tree.joined.meshes[0]), limbs = bordersOf(*tree.joined.meshes[1]);
    const std::vector<Tube>& tubes = tree.stems[1].plan.tubes;
    std::map<std::uint32_t, std::map<std::array<float, 3>, std::array<float, 3>>> seams; // from each place to the next
    for (const auto& [edge, triangle] : limbs) {
        if (!trunk.contains({edge[1], edge[0]})) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const VertexSource& source = tree.joined.sources[1][tree.joined.meshes[1]->indices[triangle + c]];
            if (source.generation == 1) seams[(std::ranges::upper_bound(tubes, source.vertex, {}, &Tube::firstVertex) - 1)->stem][edge[0]] = edge[1];
        }
    }
    std::map<std::uint32_t, double> turns;
    for (const auto& [stem, seam] : seams)
        for (const auto& [from, to] : seam) {
            const auto next = seam.find(to);
            if (next == seam.end()) continue;
            const auto way = [](const auto& a, const auto& b) { return glm::dvec3(b[0] - a[0], b[1] - a[1], b[2] - a[2]); };
            const glm::dvec3 in = way(from, to), out = way(to, next->second);
            turns[stem] += glm::degrees(std::atan2(glm::length(glm::cross(in, out)), glm::dot(in, out)));
        }
    return turns;
}

double areaOfCircle(double radius, int points) { return points / 2.0 * radius * radius * std::sin(2 * std::numbers::pi / points); }
} // namespace

TEST(Triangulation, CutsLoopsOut) {
    for (const std::uint32_t cells : {1u, 3u, 10u}) {
        CTriangulation surface = square(cells);
        EXPECT_TRUE(surface.cutOut(circle(cells, {0.31, 0.33}, 0.2, 9)));
        EXPECT_TRUE(surface.cutOut(circle(cells, {0.71, 0.68}, 0.25, 24))) << cells;
        EXPECT_NEAR(areaLeft(surface), 1 - areaOfCircle(0.2, 9) - areaOfCircle(0.25, 24), 1e-9) << cells;
        for (const auto& triangle : surface.triangles()) EXPECT_GT(areaOf(triangle), -1e-12);
        surface.improve([](const auto& corners, const auto&) { return (corners[0] + corners[2]) % 2 == 0; });
        EXPECT_NEAR(areaLeft(surface), 1 - areaOfCircle(0.2, 9) - areaOfCircle(0.25, 24), 1e-9) << cells;
    }
}

TEST(Triangulation, RefusesWhatOverlaps) {
    CTriangulation surface = square(4);
    ASSERT_TRUE(surface.cutOut(circle(4, {0.4, 0.42}, 0.2, 12)));
    EXPECT_FALSE(surface.cutOut(circle(4, {0.6, 0.42}, 0.2, 11))) << "crosses it";
    EXPECT_FALSE(surface.cutOut(circle(4, {0.41, 0.42}, 0.1, 7))) << "lies inside";
    EXPECT_FALSE(surface.cutOut(circle(4, {0.41, 0.43}, 0.35, 17))) << "lies around it";
    EXPECT_FALSE(surface.cutOut(circle(4, {0.8, 0.8}, 0.1, 8, -1))) << "is clockwise";
    EXPECT_NEAR(areaLeft(surface), 1 - areaOfCircle(0.2, 12), 1e-9);
}

TEST(JoinedStems, TheAspenIsOneSurface) {
    const Grown aspen(preset("quaking_aspen"));
    EXPECT_EQ(aspen.joined.apart, 0u);
    EXPECT_EQ(aspen.joined.joined, aspen.attached());
    const MeshFaults faults = checkJoined(aspen.joined, aspen.stems);
    EXPECT_EQ(inWords(faults), "");
    EXPECT_EQ(faults.surfaces, 1u);
}

TEST(SlowJoinedStems, SoAreTheOthers) {
    struct Model {
        const char* name;
        int lod = 0;
    };
    for (const auto& [name, lod] : {Model{"english_oak"}, {"european_beech"}, {"silver_birch"}, {"norway_spruce"}, {"strand_oak"}, {"strand_poplar"},
                                    {"weeping_willow"}, {"winter_oak"}, {"ca_black_oak"}, {"strand_willow"}, {"lebanon_cedar"}, {"olive"},
                                    {"silver_fir", 1}, {"olive", 1}, {"ca_black_oak", 2}, {"english_oak", 2}, {"weeping_willow", 2}}) {
        const Grown tree(preset(name), lod);
        EXPECT_EQ(tree.left(), 0u) << name << lod;
        EXPECT_EQ(tree.joined.joined, tree.attached() + tree.startInside()) << name << lod;
        const MeshFaults faults = checkJoined(tree.joined, tree.stems);
        EXPECT_EQ(inWords(faults), "") << name << lod;
        EXPECT_EQ(faults.surfaces, 1u) << name << lod;
    }
}

/// Of the Norway maple sixteen collars cross others or the border between limbs, of the silver fir's coarse model 96.
TEST(JoinedStems, WhereCollarsCrossTheWoodIsCutAndSewn) {
    const Grown maple(preset("norway_maple")), fir(preset("silver_fir"), 1);
    EXPECT_EQ(maple.left(), 0u);
    EXPECT_EQ(fir.left(), 0u);
    for (const Grown* tree : {&maple, &fir}) {
        EXPECT_EQ(inWords(checkJoined(tree->joined, tree->stems)), "");
        const double apart = volumeApart(tree->stems), joined = signedVolume(tree->joined.meshes);
        EXPECT_NEAR(joined, apart, 0.02 * apart) << "nothing but what lies inside is gone";
    }
}

TEST(JoinedStems, TheClonesOfAHelixPartAtAFork) {
    const Grown oak(preset("ca_black_oak"));
    std::size_t clones = 0, joined = 0;
    for (const Tube& tube : oak.stems[2].plan.tubes) {
        if (oak.tree->generation(2).paths[tube.path].source < 0) continue;
        ++clones;
        joined += tube.joined;
    }
    EXPECT_GE(clones, 700u);
    EXPECT_GE(joined, 600u);
    EXPECT_EQ(oak.left(), 0u);
}

/// Where limbs run through each other in the trunk, one that is cut out along the wrong line shows teeth.
TEST(JoinedStems, SeamsOfLimbsAreSmooth) {
    const Grown cedar(preset("lebanon_cedar"));
    const auto turns = turnsOfSeams(cedar);
    for (const auto& [stem, turn] : turns) EXPECT_LT(turn, 600) << "of stem " << stem;
    EXPECT_LE(std::ranges::count_if(turns, [](const auto& own) { return own.second > 480; }), 2);
    EXPECT_GE(std::ranges::count_if(turns, [](const auto& own) { return own.second > 360; }), 40) << "some grow out of others";
}

/// A clone that hangs down in the path it split from would be drawn twice.
TEST(JoinedStems, AClonesWoodIsDrawnOnceWhereItLiesInItsSource) {
    const Grown willow(preset("weeping_willow"));
    const CGeneration& whips = willow.tree->generation(2);
    const MeshPlan& plan = willow.stems[2].plan;
    std::size_t hidden = 0, ofHidden = 0;
    for (const CStem& stem : whips.stems)
        for (std::uint32_t p = 1; p < stem.pathCount; ++p) {
            if (plan.tubeOfPath[stem.firstPath + p] >= 0) continue;
            const CPath& path = whips.paths[stem.firstPath + p];
            const std::uint32_t wood = plan.drawnPath(whips, stem, p);
            ASSERT_GE(plan.tubeOfPath[stem.firstPath + wood], 0);
            ++hidden;
            ofHidden += wood != static_cast<std::uint32_t>(path.source);
            for (std::uint32_t i = 0; i < path.segmentCount; ++i) {
                const CSegment &own = whips.segments[path.firstSegment + i], &beside = whips.segmentAt(stem, wood, path.firstPosition + i);
                EXPECT_LE(glm::distance(own.centre(1), beside.centre(1)), 0.5 * std::max(beside.radiusBase, 0.001)) << "it would be seen";
            }
        }
    EXPECT_GE(hidden, 190u);
    EXPECT_GE(ofHidden, 20u) << "clones of clones lie in the same wood";
}

TEST(JoinedStems, ABranchAtAForkMayStandOnTheLimbBesideItsOwn) {
    const Grown olive(preset("olive"));
    std::size_t beside = 0, onGrandparent = 0, withoutCollar = 0, clones = 0; // that start inside the wood
    for (std::size_t g = 1; g < olive.stems.size(); ++g) {
        const MeshPlan& plan = olive.stems[g].plan;
        for (const Tube& tube : plan.tubes) {
            const CStem& stem = olive.tree->generation(g).stems[tube.stem];
            const CStem& parent = olive.tree->generation(g - 1).stems[static_cast<std::size_t>(stem.parent)];
            const bool first = olive.tree->generation(g).paths[tube.path].source < 0;
            withoutCollar += first && tube.collarRings == 0;
            clones += !first && !tube.joined;
            if (tube.collarRings == 0) continue;
            const CStem& sitting = olive.tree->ancestor(g, stem, tube.standsOn - 1);
            const Tube& wood = olive.stems[g - tube.standsOn].plan.bearerOf(plan, tube);
            EXPECT_EQ(wood.stem, static_cast<std::uint32_t>(sitting.parent));
            onGrandparent += tube.standsOn > 1;
            beside += tube.standsOn == 1 && wood.path != parent.firstPath + stem.path;
        }
    }
    EXPECT_GE(beside, 30u);
    EXPECT_GE(onGrandparent, 5u) << "they start below where their parent leaves its own parent's wood";
    EXPECT_LE(withoutCollar, 10u);
    EXPECT_EQ(olive.startInside(), withoutCollar + clones);
    EXPECT_EQ(checkJoined(olive.joined, olive.stems).surfaces, 1u);
}

/// Also of branches that start where their parent is still inside the wood.
TEST(JoinedStems, TheFootOfABranchMovesWithTheWoodItStandsOn) {
    const Grown oak(preset("winter_oak"));
    const CWindTable table(oak.tree, *oak.tree, 1, 1);
    std::size_t onGrandparents = 0;
    for (std::size_t g = 1; g < oak.stems.size(); ++g) {
        const StemMesh& own = oak.stems[g];
        const SwayPlaces places = swayOfStems(table, g, own.plan, *own.mesh, CProgress(2));
        for (const Tube& tube : own.plan.tubes) {
            if (tube.collarRings == 0) continue;
            onGrandparents += tube.standsOn > 1;
            const CStem& sitting = oak.tree->ancestor(g, oak.tree->generation(g).stems[tube.stem], tube.standsOn - 1);
            const CGeneration& wood = oak.tree->generation(g - tube.standsOn);
            const CPath& path = wood.paths[wood.stems[static_cast<std::size_t>(sitting.parent)].firstPath + sitting.path];
            const std::size_t first = table.nodeOf(g - tube.standsOn, path.firstSegment);
            for (std::uint32_t i = 0; i <= tube.points; ++i) {
                const std::size_t node = places[tube.firstVertex + i].index();
                ASSERT_TRUE(node >= first && node < first + path.segmentCount) << tube.standsOn;
            }
        }
    }
    EXPECT_GE(onGrandparents, 300u);
}

/// Three limbs of equal thickness leave each node of figure 2.8, one as the stem runs on.
TEST(JoinedStems, BranchesThatPartAtANodeAreOneSurface) {
    for (const int lod : {0, 1, 2}) {
        const Grown ternary(preset("abop_2_8d"), lod);
        const std::size_t apart = lod < 2 ? 0 : 2; // of limbs of one point's share some would fold
        EXPECT_LE(ternary.joined.apart, apart) << lod;
        EXPECT_GE(ternary.joined.joined, 728u - apart) << lod;
        const MeshFaults faults = checkJoined(ternary.joined, ternary.stems);
        EXPECT_EQ(inWords(faults), "") << lod;
        EXPECT_LE(faults.surfaces, 1 + apart) << lod;
        EXPECT_NEAR(signedVolume(ternary.joined.meshes), volumeApart(ternary.stems), 1e-3 * volumeApart(ternary.stems)) << "they share no wood, LOD " << lod;
    }
}

TEST(JoinedStems, TheBarkRunsOnIntoABranchThatStartsAtAFork) {
    const Grown oak(preset("strand_oak"));
    std::size_t compared = 0;
    for (std::size_t g = 1; g < oak.stems.size(); ++g) {
        const MeshPlan &plan = oak.stems[g].plan, &below = oak.stems[g - 1].plan;
        const CMesh &mesh = *oak.stems[g].mesh, &parents = *oak.stems[g - 1].mesh;
        for (const Tube& tube : plan.tubes) {
            if (!tube.forked) continue;
            const CStem& stem = oak.tree->generation(g).stems[tube.stem];
            const CStem& parent = oak.tree->generation(g - 1).stems[static_cast<std::size_t>(stem.parent)];
            const Tube& wood = below.tubes[static_cast<std::size_t>(below.tubeOfPath[parent.firstPath])];
            for (std::uint32_t i = 0; i <= plan.ringsOf(tube)[0].points; ++i) {
                const std::size_t own = tube.firstVertex + i;
                EXPECT_TRUE(hasWithBark(parents, wood, mesh.positions[own], mesh.texCoords[own])) << "generation " << g << ", stem " << tube.stem;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 10000u);
}

/// What lies inside the wood is gone: the volume is that of the stems without what they share.
TEST(JoinedStems, LeavesOutWhatLiesInside) {
    const Grown aspen(preset("quaking_aspen"));
    const double apart = volumeApart(aspen.stems);
    std::size_t triangles = 0, before = 0;
    for (std::size_t g = 0; g < aspen.stems.size(); ++g) {
        before += aspen.stems[g].mesh->triangleCount();
        triangles += aspen.joined.meshes[g]->triangleCount();
    }
    EXPECT_NEAR(signedVolume(aspen.joined.meshes), apart, 0.01 * apart);
    EXPECT_LT(signedVolume(aspen.joined.meshes), apart);
    EXPECT_LT(triangles, 1.05 * double(before));
}

/// The walls of all stems as they are closed by themselves.
class CWalls {
public:
    explicit CWalls(const Grown& tree) : m_corners(cornersOf(tree)), m_tree(boundsOf(m_corners)) {}

    /// Of a place, metres; no more than `most`.
    double distance(const glm::vec3& place, float most) {
        double least = most;
        m_tree.forEachTouching({place - most, place + most}, [&](std::uint32_t t) {
            const auto& [a, b, c] = m_corners[t];
            least = std::min(least, glm::distance(glm::dvec3(place), nearestOnTriangle(place, a, b, c)));
            return true;
        });
        return least;
    }

private:
    using Corners = std::array<glm::vec3, 3>;
    static std::vector<Corners> cornersOf(const Grown& tree) {
        std::vector<Corners> all;
        for (const StemMesh& own : tree.stems)
            for (std::size_t i = 0; i < own.mesh->indices.size(); i += 3)
                for (std::size_t c = 0; c < 3; ++c) (c == 0 ? all.emplace_back() : all.back())[c] = own.mesh->positions[own.mesh->indices[i + c]];
        return all;
    }
    static std::vector<Bounds> boundsOf(const std::vector<Corners>& corners) {
        std::vector<Bounds> all(corners.size(), kNowhere);
        for (std::size_t t = 0; t < corners.size(); ++t)
            for (const glm::vec3& corner : corners[t]) include(all[t], corner);
        return all;
    }
    std::vector<Corners> m_corners;
    CBoundsTree m_tree;
};

TEST(JoinedStems, VerticesAreWhereTheyComeFrom) {
    const Grown oak(preset("winter_oak"), 1);
    CWalls walls(oak);
    std::vector<std::map<std::uint32_t, std::size_t>> feet(oak.stems.size()); // by generation and vertex: that of the wood
    for (std::size_t g = 1; g < oak.stems.size(); ++g)
        for (const Tube& tube : oak.stems[g].plan.tubes)
            for (std::uint32_t i = 0; i < tube.points && tube.collarRings > 0; ++i) feet[g][tube.firstVertex + i] = g - tube.standsOn;
    for (std::size_t g = 0; g < oak.stems.size(); ++g) {
        const CMesh& mesh = *oak.joined.meshes[g];
        ASSERT_EQ(oak.joined.sources[g].size(), mesh.vertexCount());
        ASSERT_EQ(mesh.looks.size(), mesh.vertexCount());
        std::size_t edges = 0, added = 0;
        for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
            const VertexSource& source = oak.joined.sources[g][v];
            if (const glm::vec3& from = oak.stems[source.generation].mesh->positions[source.vertex]; mesh.positions[v] != from) {
                ASSERT_LT(glm::distance(mesh.positions[v], from), 1); // on the loop around a branch that comes out somewhere else
                ASSERT_LT(walls.distance(mesh.positions[v], 0.03f), 0.02);
                ++added;
                continue;
            }
            if (source.generation != g) {
                const auto foot = feet[source.generation].find(source.vertex);
                ASSERT_TRUE(foot != feet[source.generation].end() && foot->second == g) << "of a branch that stands here";
            }
            edges += source.generation == g + 1;
        }
        EXPECT_LT(double(added), 0.05 * double(mesh.vertexCount()));
        EXPECT_EQ(edges > 0, g + 1 < oak.stems.size());
    }
}

/// The bark of a wall runs on around a branch, also across its seam.
TEST(JoinedStems, NoTriangleOfATrunkShowsHalfItsBark) {
    for (const std::string name : {"quaking_aspen", "english_oak", "norway_spruce"}) {
        const Grown tree(preset(name));
        const CMesh& mesh = *tree.joined.meshes[0];
        const float around = static_cast<float>(preset(name).common.textureWrapX);
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
            ASSERT_LT(std::abs(mesh.texCoords[mesh.indices[i]].x - mesh.texCoords[mesh.indices[next]].x), 0.45f * around) << name;
        }
    }
}

TEST(JoinedStems, IsTheSameForEveryNumberOfThreads) {
    const Grown one(preset("ash"), 1, 1), many(preset("ash"), 1, 5);
    for (std::size_t g = 0; g < one.stems.size(); ++g) EXPECT_TRUE(sameBytes(*one.joined.meshes[g], *many.joined.meshes[g]));
}

TEST(JoinedStems, OfNothingIsNothing) {
    const JoinedStems none = joinStems(CTree(1, {}), {}, CProgress(1));
    EXPECT_TRUE(none.meshes.empty());
}

TEST(JoinedStems, CanBeCancelled) {
    const CParams& params = preset("quaking_aspen");
    const auto tree = grow(params);
    const auto stems = meshAllStems(*tree, meshParamsOf(params), detailOf(Model::Full), CProgress(2));
    const CProgress stopped(2);
    stopped.cancel();
    EXPECT_THROW(joinStems(*tree, stems, stopped), CCancelled);
}

} // namespace stromar::test
