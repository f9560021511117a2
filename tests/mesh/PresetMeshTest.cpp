#include "stromar/app/TreeCreator.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
/// Calls `look(generation, plan, mesh)` for every mesh of stems of a preset.
template <typename Look>
void forEachStemMesh(const CTree& tree, const CParams& params, const Detail& detail, Look&& look) {
    for (int g = 0; const auto& [plan, mesh] : meshAllStems(tree, meshParamsOf(params), detail, CProgress(2)))
        look(g++, plan, *mesh);
}

constexpr double kStub = 6;
const std::vector<std::string> kMostUnited{"ca_black_oak", "english_oak", "lebanon_cedar", "strand_willow", "weeping_willow", "winter_oak"}; ///< with most branches to unite

/// The first vertex of a ring that shows a tube's own bark, and how many points it has: the lowest, of which a joined tube has a share; of one that
/// starts at its parent's fork the one above.
std::pair<std::size_t, std::uint32_t> fullRing(const MeshPlan& plan, const Tube& tube) {
    std::size_t vertex = tube.firstVertex;
    std::uint32_t r = 0;
    for (const std::uint32_t given = tube.forked ? plan.forksOf(tube)[0].rings : 0; r < given; ++r) vertex += plan.ringsOf(tube)[r].points + 1;
    return {vertex, plan.ringsOf(tube)[r].points};
}

std::string nameOf(const testing::TestParamInfo<std::size_t>& info) { return presets()[info.param].name; }

/// Whether all branches of a level are so short that their parents' wood hides them: such a level may have no triangles.
bool isHidden(const CTree& tree, std::size_t generation) {
    return generation > 0 && std::ranges::all_of(tree.generation(generation).stems, [](const CStem& stem) { return 0.8 * stem.length < stem.parentRadius; });
}
} // namespace

class PresetMesh : public testing::TestWithParam<std::size_t> {
protected:
    const CParams& params() const { return presets()[GetParam()].params; }
    CParams params(int seed) const {
        CParams changed = params();
        changed.common.seed = seed;
        return changed;
    }
};
INSTANTIATE_TEST_SUITE_P(Slow, PresetMesh, testing::Range<std::size_t>(0, presets().size()), nameOf);

namespace {
/// The stems of a tree as a level of detail draws them.
struct Level {
    const CParams& params;
    const CTree& tree;
    const Detail& detail;
    std::vector<StemMesh> stems = meshAllStems(tree, meshParamsOf(params), detail, CProgress(2));
};

void expectSound(const Level& level, const JoinedStems& joined) {
    for (std::size_t g = 0; g < level.stems.size(); ++g) {
        const std::string& name = level.stems[g].mesh->name;
        const MeshFaults faults = checkStems(level.tree, static_cast<int>(g), level.stems[g], level.stems);
        EXPECT_EQ(inWords(faults), "") << name;
        EXPECT_TRUE(faults.triangles > 0 || (level.detail.collarRings > 0 && isHidden(level.tree, g))) << name;
    }
    EXPECT_EQ(inWords(checkJoined(joined, level.stems)), "") << "joined";
    EXPECT_EQ(inWords(checkLeaves(*organsOf(level.tree, level.params, Organ::Leaf, level.stems, level.detail))), "");
}

void expectFacesOutwards(const Level& level) {
    for (std::size_t g = 0; const auto& [plan, mesh] : level.stems) {
        ASSERT_TRUE(!plan.tubes.empty() || (level.detail.collarRings > 0 && isHidden(level.tree, g)));
        EXPECT_EQ(invertedSurfaces(plan, *mesh), 0u) << "of " << plan.tubes.size() << ", " << mesh->name;
        ++g;
    }
}

void expectAlmostEveryBranchGrowsOutOfTheWood(const Level& level) {
    const bool byLevels = &level.params.block() == &weberPennBlock();
    std::size_t allChosen = 0, allAttached = 0;
    for (std::size_t g = 1; g < level.stems.size(); ++g) {
        const auto& stems = level.tree.generation(g).stems;
        const auto leavesWood = [&](std::size_t s) { // figures of the book have stubs as thick as long
            return byLevels || stems[s].length > kStub * std::max(stems[s].radius, stems[s].parentRadius);
        };
        const MeshPlan& plan = level.stems[g].plan;
        std::size_t chosen = 0, attached = 0;
        for (std::size_t s = 0; s < stems.size(); ++s) chosen += plan.stemBears[s] && leavesWood(s);
        for (const Tube& tube : plan.tubes) attached += (tube.collarRings > 0 || tube.forked) && leavesWood(tube.stem);
        if (byLevels) {
            EXPECT_GE(double(attached), 0.8 * double(chosen)) << level.stems[g].mesh->name;
        }
        allChosen += chosen;
        allAttached += attached;
    }
    // Where a stem and its branch part at a tip, both bend away, and some branches start inside the wood.
    EXPECT_GE(double(allAttached), 0.5 * double(allChosen));
}

/// Of the paths that fork from a stem, all but few are one surface with it by the plan of its rings; helices do not part, nor do whips that
/// hang down in one line.
void expectForksAreOneSurface(const Level& level) {
    std::size_t clones = 0, joined = 0;
    for (std::size_t g = 0; g < level.stems.size(); ++g) {
        const CGeneration& generation = level.tree.generation(g);
        for (const Tube& tube : level.stems[g].plan.tubes) {
            const CStem& stem = generation.stems[tube.stem];
            const CPath& path = generation.paths[tube.path];
            const CSegment* below = generation.segmentBelow(stem, path);
            if (!below || below->helixRadius > 0) continue;
            const CSegment& runsOn = generation.segmentAt(stem, static_cast<std::uint32_t>(path.source), path.firstPosition);
            if (glm::dot(runsOn.frame[2], generation.segments[path.firstSegment].frame[2]) > 0.9999) continue;
            ++clones;
            joined += tube.joined;
        }
    }
    EXPECT_GE(double(joined), 0.8 * double(clones)) << "of " << clones;
}

/// No branch and no clone keeps a lid inside the wood.
void expectAllIsOneSurface(const JoinedStems& joined) {
    EXPECT_EQ(joined.apart, 0u);
    EXPECT_EQ(joined.withoutCollar, 0u);
}

/// At every level of detail.
void expectSoundOf(const CParams& params) {
    const auto tree = grow(params);
    for (const Detail& detail : detailTable()) {
        SCOPED_TRACE(detail.name);
        const Level level{params, *tree, detail};
        expectSound(level, joinStems(*tree, level.stems, CProgress(2)));
    }
}

void expectIsOneSurfaceBesideCards(const CParams& params) {
    const auto model = CTreeCreator().create(params, detailOf(Model::Full, 2), CProgress(2), CTreeCreator::Plans::Keep);
    expectAllIsOneSurface(joinStems(*model->tree, *model->planned, CProgress(2)));
}
} // namespace

TEST_P(PresetMesh, IsSoundAndGrowsOutOfTheWoodAtEveryLevelOfDetail) {
    const auto tree = grow(params());
    for (const Detail& detail : detailTable()) {
        SCOPED_TRACE(detail.name);
        const Level level{params(), *tree, detail};
        const JoinedStems joined = joinStems(*tree, level.stems, CProgress(2));
        expectSound(level, joined);
        expectFacesOutwards(level);
        if (detail.collarRings == 0) continue;
        expectAlmostEveryBranchGrowsOutOfTheWood(level);
        expectForksAreOneSurface(level);
        if (detail.twigPlanes == 0) expectAllIsOneSurface(joined);
    }
}

class WoodBesideCards : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Slow, WoodBesideCards, testing::ValuesIn(kMostUnited),
                         [](const testing::TestParamInfo<std::string>& own) { return own.param; });
class WoodOfPresetBesideCards : public PresetMesh {};
INSTANTIATE_TEST_SUITE_P(Exhaustive, WoodOfPresetBesideCards, testing::Range<std::size_t>(0, presets().size()), nameOf);

TEST_P(WoodBesideCards, IsOneSurface) { expectIsOneSurfaceBesideCards(preset(GetParam())); }

TEST_P(WoodOfPresetBesideCards, IsOneSurface) { expectIsOneSurfaceBesideCards(params()); }

TEST_P(PresetMesh, IsSoundWithAnotherSeed) { expectSoundOf(params(13)); }

class PresetMeshOfAThirdSeed : public PresetMesh {};
INSTANTIATE_TEST_SUITE_P(Exhaustive, PresetMeshOfAThirdSeed, testing::Range<std::size_t>(0, presets().size()), nameOf);

TEST_P(PresetMeshOfAThirdSeed, IsSound) { expectSoundOf(params(4711)); }

/// Walls between rings of unequal size are covered by the check; here: there are such rings. A fork's paths and branches share the points
/// of the ring below them, which has at most as many as the one before.
TEST_P(PresetMesh, RingsHaveFewerPointsWhereTheyAreThin) {
    std::size_t halved = 0;
    forEachStemMesh(*grow(params()), params(), detailOf(Model::Full), [&](int, const MeshPlan& plan, const CMesh&) {
        for (const Tube& tube : plan.tubes) {
            const Ring* rings = plan.ringsOf(tube);
            const auto mayDiffer = [&](std::uint32_t r) {
                return tube.branchCount > 0 && std::ranges::any_of(plan.forksOf(tube), [&](const Fork& fork) { return fork.ring == r && fork.rings == 1; });
            };
            ASSERT_TRUE(tube.startsAtFork() ? rings[0].parted && rings[0].points < tube.points : rings[0].points == tube.points);
            std::uint32_t whole = tube.points; // but for the first of a fork's
            for (std::uint32_t r = 1; r < tube.ringCount; ++r) {
                const bool share = rings[r].parted && rings[r].points < whole && rings[r - 1].points == whole;
                ASSERT_TRUE(share || rings[r].points == whole || 2 * rings[r].points == whole || (mayDiffer(r) && rings[r].points < whole)) << r;
                if (share) continue;
                if (rings[r].points < whole) ++halved;
                whole = rings[r].points;
            }
        }
    });
    if (&params().block() != &weberPennBlock()) return;
    bool tapers = false; // the fans' stalks do not, and their trunk is a column with a round end
    for (int level = 0; level < weberPenn(params()).levels; ++level) {
        const double taper = weberPenn(params()).level[static_cast<std::size_t>(std::min(level, kParamLevels - 1))].taper;
        tapers = tapers || (taper >= 0.8 && taper <= 1.2);
    }
    EXPECT_EQ(halved > 0, tapers);
}

TEST_P(PresetMesh, BarkGoesWholeTimesAroundAndKeepsItsScale) {
    const double wrapX = params().common.textureWrapX, wrapY = params().common.textureWrapY;
    const auto tree = grow(params());
    const CStem& trunk = tree->generation(0).stems[0];
    std::size_t measured = 0;
    forEachStemMesh(
        *tree, params(), detailOf(Model::Full), [&](int g, const MeshPlan& plan, const CMesh& mesh) {
            for (const Tube& tube : plan.tubes) {
                const auto [base, points] = fullRing(plan, tube);
                const double around = (mesh.texCoords[base + points].x - mesh.texCoords[base].x) * float(tube.joined ? tube.points : points) / float(points);
                const CStem& own = tree->generation(std::size_t(g)).stems[tube.stem];
                const double radius = std::max(own.radius, params().common.minRadius);
                if (g == 0)
                    ASSERT_NEAR(around, wrapX, 1e-5 * wrapX);
                else
                    ASSERT_NEAR(around, std::max(1.0, std::round(wrapX * radius / trunk.radius)), 1e-5);
                if (!own.profile.isEven() || (g == 0 && params().common.flare > 0)) continue;
                // Metres per repeat along over metres per repeat around are the trunk's, wherever a stem is not too thin.
                const CGeneration& generation = tree->generation(std::size_t(g));
                const CStem& same = g == 0 ? own : trunk; // several trunks differ
                const double trunkShape = (same.length / wrapY) / (same.radius / wrapX);
                const bool ownFork = tube.forkCount > (tube.forked ? 1u : 0u);
                std::size_t vertex = tube.forked ? base + points + 1 : tube.firstVertex + tube.collarRings * (tube.points + 1);
                for (std::uint32_t r = tube.forked ? plan.forksOf(tube)[0].rings + 1 : 0; r + 1 < tube.ringCount && !ownFork; ++r) {
                    const Ring &low = plan.ringsOf(tube)[r], &high = plan.ringsOf(tube)[r + 1];
                    const auto placeOf = [&](const Ring& ring) {
                        const CSegment& segment = generation.segments[ring.segment];
                        const bool steps = own.profile.form == RadiusProfile::Form::Steps && segment.end() < own.length;
                        const double end = steps ? (&segment + 1)->radiusBase : segment.radiusEnd;
                        return std::pair(segment.start + ring.t * segment.length,
                                         std::max(segment.radiusBase + ring.t * (end - segment.radiusBase), params().common.minRadius));
                    };
                    const auto [from, wide] = placeOf(low);
                    const auto [to, narrow] = placeOf(high);
                    const double repeats = mesh.texCoords[vertex + low.points + 1].y - mesh.texCoords[vertex].y;
                    vertex += low.points + 1;
                    if (narrow < 0.15 * radius) break;
                    const double perRadius = (to - from) * std::round(around) / trunkShape;
                    constexpr double slack = 1.05; // rounding
                    ASSERT_GT(repeats, perRadius / std::max(wide, narrow) / slack - 1e-5) << mesh.name;
                    ASSERT_LT(repeats, perRadius / std::min(wide, narrow) * slack + 1e-5) << mesh.name;
                    ++measured;
                }
            }
        });
    EXPECT_GT(measured, 1u);
}

using Meshes = std::vector<std::shared_ptr<const CMesh>>;

void expectSame(const Meshes& one, const Meshes& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t m = 0; m < one.size(); ++m) EXPECT_TRUE(sameBytes(*one[m], *other[m])) << one[m]->name;
}

void expectWithinTheTreesSize(const Meshes& meshes, const CTree& tree, const CParams& params) {
    const Bounds trunk = meshes.front()->bounds();
    EXPECT_LT(trunk.min.z, 0.01f);
    if (&params.block() == &weberPennBlock()) {
        EXPECT_NEAR(trunk.max.z, tree.generation(0).stems[0].length, 0.35 * tree.height());
    }
    for (const auto& mesh : meshes) {
        if (mesh->vertexCount() == 0) continue; // leaves in winter
        EXPECT_LT(mesh->bounds().max.z, 1.6 * tree.height()) << mesh->name;
    }
}

TEST_P(PresetMesh, IsTheSameForEveryNumberOfThreadsAndHasFewerTrianglesAtEveryLevelOfDetail) {
    const auto alone = grow(params(), 1), tree = grow(params(), 5);
    std::size_t last = std::numeric_limits<std::size_t>::max();
    for (const Detail& detail : detailTable()) {
        SCOPED_TRACE(detail.name);
        const Meshes meshes = meshesOf(*alone, params(), detail, 1);
        expectSame(meshes, meshesOf(*tree, params(), detail, 5));
        if (detail.model != Model::Full) continue;
        if (detail.lod == 0) expectWithinTheTreesSize(meshes, *alone, params());
        std::size_t triangles = 0;
        for (const auto& mesh : meshes) triangles += mesh->triangleCount();
        EXPECT_LT(triangles, last);
        last = triangles;
    }
}

class PresetMeshOfTwoThreads : public PresetMesh {};
INSTANTIATE_TEST_SUITE_P(Exhaustive, PresetMeshOfTwoThreads, testing::Range<std::size_t>(0, presets().size()), nameOf);

TEST_P(PresetMeshOfTwoThreads, IsTheSame) {
    const auto alone = grow(params(), 1), tree = grow(params(), 2);
    for (const Detail& detail : detailTable()) {
        SCOPED_TRACE(detail.name);
        expectSame(meshesOf(*alone, params(), detail, 1), meshesOf(*tree, params(), detail, 2));
    }
}

} // namespace stromar::test
