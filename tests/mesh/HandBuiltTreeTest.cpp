// A tree that no builder made: segments of unequal length, six generations, a fork, leaves on the trunk and on twigs.
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/mesh/check/MeshCheck.h"
#include "stromar/mesh/twig/Twig.h"
#include "stromar/tree/Nearest.h"
#include "stromar/util/Random.h"
#include <gtest/gtest.h>
#include <numbers>

namespace stromar {
namespace {

constexpr int kGenerations = 6;

/// Lengths of a stem's segments, parts of it: none like the next.
constexpr double kParts[] = {0.08, 0.31, 0.13, 0.28, 0.2};

/// Builds generations stem by stem.
class CHand {
public:
    CHand() {
        for (int g = 0; g < kGenerations; ++g) m_generations.push_back(std::make_shared<CGeneration>());
        addStem(0, -1, 0, 0, glm::dvec3(0), Frame(1.0), 6, 0.2, 0);
        for (int g = 1; g < kGenerations; ++g)
            for (std::uint32_t parent = 0; parent < m_generations[slot(g - 1)]->stems.size(); ++parent) addChildren(g, parent);
    }

    CTree tree() const {
        std::vector<std::shared_ptr<const CGeneration>> all(m_generations.begin(), m_generations.end());
        const auto none = std::make_shared<const COrgans>();
        return CTree(6, all, {.flare = 0.6, .lobes = 5, .lobeDepth = 0.1, .lobeFade = 0.8, .roots = 4, .rootReach = 1, .rootHeight = 0.1})
            .withOrgans({allOrgans(leaves(), all), none, none});
    }

private:
    static std::size_t slot(int g) { return static_cast<std::size_t>(g); }

    void addChildren(int g, std::uint32_t parent) {
        const CGeneration& below = *m_generations[slot(g - 1)];
        const CStem stem = below.stems[parent];
        for (int i = 0; i < (g < 3 ? 4 : 2); ++i) {
            const double offset = stem.length * (0.35 + 0.15 * i);
            const std::uint32_t position = segmentAt(below, stem, offset);
            const CSegment& wood = below.segmentAt(stem, 0, position);
            const double t = (offset - wood.start) / wood.length;
            const Frame frame = rotatedX(rotatedZ(wood.frame, 2.4 * i + parent), 0.9);
            const double radius = wood.radiusBase + t * (wood.radiusEnd - wood.radiusBase);
            addStem(g, static_cast<std::int32_t>(parent), position, offset, wood.centre(t), frame, 0.45 * stem.length,
                    0.5 * radius, radius);
        }
    }

    static std::uint32_t segmentAt(const CGeneration& generation, const CStem& stem, double offset) {
        std::uint32_t position = 0;
        while (generation.segmentAt(stem, 0, position).end() < offset) ++position;
        return position;
    }

    void addStem(int g, std::int32_t parent, std::uint32_t position, double offset, const glm::dvec3& base,
                 const Frame& frame, double length, double radius, double parentRadius) {
        CGeneration& generation = *m_generations[slot(g)];
        CStem stem{};
        stem.id = hashCombine(slot(g), generation.stems.size());
        stem.length = length;
        stem.radius = radius;
        stem.offset = offset;
        stem.parentRadius = parentRadius;
        stem.parent = parent;
        stem.position = position;
        stem.firstPath = static_cast<std::uint32_t>(generation.paths.size());
        stem.pathCount = 2;
        stem.firstSegment = static_cast<std::uint32_t>(generation.segments.size());
        addPath(generation, {0, stem.firstSegment, 5, 0, -1}, base, frame, 0, length, radius);
        CSegment& fork = generation.segments[stem.firstSegment + 3];
        fork.forks = true;
        // A clone that is longer than what it left.
        addPath(generation, {1, stem.firstSegment + 5, 3, 4, 0}, fork.axisPoint(1), rotatedX(fork.frame, -0.5), fork.end(),
                0.7 * length, fork.radiusEnd);
        stem.segmentCount = 8;
        generation.stems.push_back(stem);
    }

    static void addPath(CGeneration& generation, const CPath& path, glm::dvec3 at, Frame frame, double start, double length,
                        double radius) {
        double sum = 0, done = 0;
        for (std::uint32_t s = 0; s < path.segmentCount; ++s) sum += kParts[s];
        for (std::uint32_t s = 0; s < path.segmentCount; ++s) {
            CSegment segment{};
            segment.position = at;
            segment.frame = frame;
            segment.start = start + done;
            segment.length = length * kParts[s] / sum;
            segment.radiusBase = radius * (1 - 0.8 * done / length);
            done += segment.length;
            segment.radiusEnd = radius * (1 - 0.8 * done / length);
            generation.segments.push_back(segment);
            at = segment.axisPoint(1);
            frame = rotatedX(frame, 0.12);
        }
        generation.paths.push_back(path);
    }

    /// On the trunk's third segment, then on all stems of the last generation.
    LeafArray leaves() const {
        LeafArray all;
        const auto add = [&](int g, std::uint32_t stem, std::uint32_t position) {
            const CGeneration& generation = *m_generations[slot(g)];
            const CSegment& segment = generation.segmentAt(generation.stems[stem], 0, position);
            all.push_back({segment.centre(0.5), segment.frame[0], segment.frame[1], 0.1f, 0.05f, stem, std::uint32_t(g), 0});
        };
        for (int i = 0; i < 8; ++i) add(0, 0, 2);
        for (std::uint32_t s = 0; s < m_generations.back()->stems.size(); ++s)
            for (std::uint32_t i = 0; i < 5; ++i) add(kGenerations - 1, s, i);
        return all;
    }

    std::vector<std::shared_ptr<CGeneration>> m_generations;
};

MeshParams meshParams() {
    MeshParams params;
    params.minRadius = 0.0002;
    params.leaf.aspect = 0.5;
    return params;
}

TEST(HandBuiltTree, IsSoundAtEveryLevelOfDetail) {
    const CTree tree = CHand().tree();
    for (const Detail& detail : detailTable()) {
        const auto all = meshAllStems(tree, meshParams(), detail, CProgress(2));
        ASSERT_EQ(all.size(), std::size_t{kGenerations});
        for (std::size_t g = 0; g < all.size(); ++g) {
            const MeshFaults faults = checkStems(tree, static_cast<int>(g), all[g], all);
            EXPECT_TRUE(faults.sound()) << detail.name << ", generation " << g;
            EXPECT_GT(faults.surfaces, 0u);
            if (g > 0 && detail.model == Model::Full && detail.lod == 0) {
                EXPECT_GT(faults.attached, faults.surfaces / 4) << "generation " << g;
            }
        }
        EXPECT_TRUE(checkLeaves(
            *meshOfOrgans(tree, Organ::Leaf, plansOf(all), meshParams(), detail, CProgress(2))[0]->expanded(CProgress(2))).sound());
    }
}

TEST(HandBuiltTree, LeavesOfTheTrunkAreDrawnBesideCards) {
    const CTree tree = CHand().tree();
    const Detail& detail = detailOf(Model::Full, 2);
    const auto all = meshAllStems(tree, meshParams(), detail, CProgress(2));
    const auto twig = typicalTwig(tree, meshParams(), CProgress(2));
    ASSERT_TRUE(twig);
    EXPECT_GT(meshOfTwigs(twigsOf(tree, *tree.organs(Organ::Leaf)), tree, *tree.organs(Organ::Leaf), *twig, meshParams(), detail, CProgress(2))->vertexCount(), 0u);
    const OrganMeshes own = meshOfOrgans(tree, Organ::Leaf, plansOf(all), meshParams(), detail, CProgress(2),
                                  twigsOf(tree, *tree.organs(Organ::Leaf)));
    EXPECT_EQ(own[0]->vertexCount(), 8 * bladeOf(meshParams(), Organ::Leaf, detail).points.size()) << "those of the trunk";
}

TEST(HandBuiltTree, RingsStandAtTheSegmentsEnds) {
    const CTree tree = CHand().tree();
    const MeshPlan plan = planRings(tree, 1, meshParams(), detailOf(Model::Simple), {}, CProgress());
    const CGeneration& generation = tree.generation(1);
    for (const Tube& tube : plan.tubes) {
        double last = -1;
        for (std::uint32_t r = 0; r < tube.ringCount; ++r) {
            const Ring& ring = plan.ringsOf(tube)[r];
            const CSegment& segment = generation.segments[ring.segment];
            const double along = segment.start + ring.t * segment.length;
            EXPECT_TRUE(along > last || (ring.parted && along == last)) << "rings rise along the path";
            last = along;
        }
        EXPECT_DOUBLE_EQ(last, generation.lengthOf(generation.paths[tube.path]));
    }
}

TEST(HandBuiltTree, PickingFindsItsStems) {
    const CTree tree = CHand().tree();
    const CGeneration& twigs = tree.generation(kGenerations - 1);
    for (std::uint32_t s = 0; s < twigs.stems.size(); s += 17)
        EXPECT_EQ(nearestStem(tree, kGenerations - 1, twigs.segmentAt(twigs.stems[s], 0, 2).axisPoint(0.4)), s);
}

} // namespace
} // namespace stromar
