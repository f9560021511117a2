#include "stromar/params/methods/weberpenn/TreeParams.h"
#include "tree/Support.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace stromar {
namespace {

using namespace test;

constexpr double kClose = 1e-9;
constexpr double kUnitLength = 1e-6; // of leaves

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void expectOrthonormal(const Frame& f) {
    for (int i = 0; i < 3; ++i) {
        ASSERT_NEAR(glm::length(f[i]), 1, kClose);
        ASSERT_NEAR(glm::dot(f[i], f[(i + 1) % 3]), 0, kClose);
    }
    ASSERT_NEAR(glm::dot(glm::cross(f[0], f[1]), f[2]), 1, kClose) << "left-handed";
}

/// What holds for every tree of the model.
class CTreeCheck {
public:
    CTreeCheck(const CTree& tree, const CParams& params) : m_tree(tree), m_params(params) {}

    void run() {
        ASSERT_EQ(m_tree.generationCount(), static_cast<std::size_t>(weberPenn(m_params).levels));
        for (m_g = 0; m_g < m_tree.generationCount() && !failed(); ++m_g) checkGeneration(m_tree.generation(m_g));
        if (!failed()) checkLeaves();
    }

private:
    static bool failed() { return testing::Test::HasFatalFailure(); }

    void checkGeneration(const CGeneration& generation) {
        std::uint32_t paths = 0, segments = 0;
        std::int32_t parent = -1;
        std::set<std::uint64_t> ids;
        for (const CStem& stem : generation.stems) {
            ASSERT_EQ(stem.firstPath, paths);
            ASSERT_EQ(stem.firstSegment, segments);
            ASSERT_GE(stem.pathCount, 1u);
            ASSERT_GE(stem.parent, parent) << "in the order of the parents";
            ASSERT_TRUE(ids.insert(stem.id).second) << "two stems of one id";
            paths += stem.pathCount;
            segments += stem.segmentCount;
            parent = stem.parent;
            checkPaths(generation, stem);
            if (failed()) return;
            checkSegments(generation, stem);
            if (failed()) return;
            ASSERT_EQ(stem.parent == -1, m_g == 0);
            if (m_g > 0) checkOnParent(generation, stem);
            if (failed()) return;
        }
        ASSERT_EQ(generation.paths.size(), paths);
        ASSERT_EQ(generation.segments.size(), segments);
    }

    void checkPaths(const CGeneration& generation, const CStem& stem) {
        std::uint32_t segment = stem.firstSegment;
        std::set<std::uint64_t> ids;
        for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
            const CPath& path = generation.paths[stem.firstPath + p];
            ASSERT_EQ(path.firstSegment, segment);
            ASSERT_EQ(path.firstPosition + path.segmentCount, curveRes(generation));
            ASSERT_TRUE(ids.insert(path.id).second);
            segment += path.segmentCount;
            if (p == 0) {
                ASSERT_EQ(path.source, -1);
                ASSERT_EQ(path.firstPosition, 0u);
                ASSERT_EQ(grownOf(m_tree, m_g).rotationPhase[stem.firstPath], 0);
                continue;
            }
            ASSERT_GE(path.source, 0);
            ASSERT_LT(path.source, static_cast<std::int32_t>(p));
            ASSERT_GE(path.firstPosition, 1u);
            ASSERT_GE(path.segmentCount, 1u);
            const auto source = static_cast<std::uint32_t>(path.source);
            ASSERT_LT(generation.paths[stem.firstPath + source].firstPosition, path.firstPosition)
                << "splits one joint later";
            const CSegment& fork = segmentOf(generation, stem, source, path.firstPosition - 1);
            ASSERT_TRUE(fork.forks);
            ASSERT_LT(glm::length(fork.axisPoint(1) - generation.segments[path.firstSegment].position), kClose);
        }
        ASSERT_EQ(segment, stem.firstSegment + stem.segmentCount);
    }

    void checkSegments(const CGeneration& generation, const CStem& stem) {
        std::vector<double> density(curveRes(generation), 0);
        const double length = stem.length / curveRes(generation);
        const RadiusProfile profile = taperProfile(seenBy(m_g).level().taper);
        for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
            const CPath& path = generation.paths[stem.firstPath + p];
            for (std::uint32_t s = 0; s < path.segmentCount; ++s) {
                const CSegment& segment = generation.segments[path.firstSegment + s];
                const std::uint32_t position = path.firstPosition + s;
                ASSERT_TRUE(finite(segment.position));
                expectOrthonormal(segment.frame);
                ASSERT_NEAR(segment.length, length, kClose);
                ASSERT_NEAR(segment.start, position * length, kClose);
                if (s > 0) {
                    ASSERT_LT(
                        glm::length(generation.segments[path.firstSegment + s - 1].axisPoint(1) - segment.position),
                        kClose);
                }
                for (const auto& [radius, end] :
                     {std::pair(segment.radiusBase, position), {segment.radiusEnd, position + 1}})
                    {
                    const double along = end == curveRes(generation) ? stem.length : end * length;
                    ASSERT_NEAR(radius, profile.radiusAt(along, stem.length, stem.radius), 1e-7);
                }
                density[position] += grownOf(m_tree, m_g).density[path.firstSegment + s];
            }
        }
        for (const double sum : density) ASSERT_NEAR(sum, 1, kClose) << "clones share what the stem bears";
    }

    void checkOnParent(const CGeneration& generation, const CStem& stem) {
        const CGeneration& parents = m_tree.generation(m_g - 1);
        ASSERT_LT(stem.parent, static_cast<std::int32_t>(parents.stems.size()));
        const CStem& parent = parents.stems[static_cast<std::size_t>(stem.parent)];
        ASSERT_LT(stem.path, parent.pathCount);
        ASSERT_GE(stem.position, parents.paths[parent.firstPath + stem.path].firstPosition);
        ASSERT_LT(stem.position, curveRes(parents));
        const CSegment& segment = segmentOf(parents, parent, stem.path, stem.position);
        const CStem& m = stem;
        const double w = m.offset / segment.length - stem.position;
        ASSERT_GE(w, -kClose);
        ASSERT_LE(w, 1 + kClose);
        ASSERT_LT(glm::length(firstSegment(generation, stem).position - segment.centre(w)), 1e-8)
            << "not on the drawn line";
        ASSERT_EQ(scratchOf(generation, stem).parentLength, parent.length);
        ASSERT_GT(m.length, 1e-5);
        checkSizes(generation, stem, parent);
    }

    CTreeParams seenBy(std::size_t generation) const {
        return {m_params, static_cast<int>(generation), m_tree.height()};
    }

    void checkSizes(const CGeneration& generation, const CStem& stem, const CStem& parent) {
        const CStem& m = stem;
        const double tapered =
            taperProfile(seenBy(m_g - 1).level().taper).radiusAt(m.offset, parent.length, parent.radius);
        const double wood = m_g == 1 ? tapered * m_tree.base().flareAt(m.offset / parent.length) : tapered;
        ASSERT_TRUE(std::isfinite(m.radius) && m.radius >= 0);
        ASSERT_NEAR(stem.parentRadius, wood, kClose);
        ASSERT_LE(m.radius, wood + kClose) << "thicker than its parent";
        const double inherited =
            parent.radius * std::pow(m.length / parent.length, weberPenn(m_params).ratioPower);
        ASSERT_NEAR(m.radius, std::min(inherited, wood), kClose);
        const double bare = m_g == 1 ? weberPenn(m_params).baseSize * m_tree.height() : 0;
        ASSERT_GE(m.offset, bare - kClose) << "on the bare trunk";
        const StemMeasures on = grownOf(m_tree, m_g - 1).measuresOf(static_cast<std::size_t>(stem.parent));
        ASSERT_LE(m.length, seenBy(m_g).calc().length(scratchOf(generation, stem).lengthMax, on, m.offset) + kClose);
    }

    void checkLeaves() {
        if (m_tree.generationCount() < 2) return;
        const CGeneration& last = m_tree.generation(m_tree.generationCount() - 1);
        for (const CLeaf& leaf : m_tree.leaves()) {
            ASSERT_LT(leaf.stem, last.stems.size());
            ASSERT_TRUE(finite(leaf.position) && finite(leaf.axis) && finite(leaf.normal));
            ASSERT_NEAR(glm::length(leaf.axis), 1, kUnitLength);
            ASSERT_NEAR(glm::length(leaf.normal), 1, kUnitLength);
            ASSERT_NEAR(glm::dot(leaf.axis, leaf.normal), 0, kUnitLength);
            ASSERT_GT(leaf.length, 0);
            ASSERT_GT(leaf.width, 0);
        }
    }

    const CTree& m_tree;
    const CParams& m_params;
    std::size_t m_g = 0;
};

TEST(Invariants, HoldForManyTrees) {
    std::size_t stems = 0, clones = 0, leaves = 0, most = 0;
    for (unsigned seed = 0; seed < 120; ++seed) {
        const CParams params = randomTree(seed);
        const auto tree = grow(params, seed % 4 != 3);
        CTreeCheck(*tree, params).run();
        ASSERT_FALSE(HasFatalFailure()) << "random tree " << seed;
        for (const auto& generation : tree->generations()) clones += generation->cloneCount();
        stems += tree->stemCount();
        leaves += tree->leaves().size();
        most = std::max(most, tree->stemCount());
    }
    EXPECT_GT(stems, 5000u);
    EXPECT_GT(clones, 500u);
    EXPECT_GT(leaves, 5000u);
    EXPECT_LT(most, 30000u);
}

TEST(Invariants, HoldForThePresets) {
    for (const char* name : {"quaking_aspen", "black_tupelo", "ca_black_oak"}) {
        const CParams params = preset(name);
        CTreeCheck(*grow(params), params).run();
        ASSERT_FALSE(HasFatalFailure()) << name;
    }
}

TEST(Invariants, TheThreadsDoNotMatter) {
    std::vector<CParams> trees{richTree(), preset("quaking_aspen"), preset("ca_black_oak")};
    for (unsigned seed = 0; seed < 20; ++seed) trees.push_back(randomTree(seed));
    for (const CParams& params : trees) {
        const auto one = grow(params, true, 1);
        for (const int threads : {2, 5}) ASSERT_EQ(difference(*one, *grow(params, true, threads)), "") << threads;
    }
}

TEST(Invariants, TheSameSeedGrowsTheSameTree) {
    EXPECT_EQ(difference(*grow(richTree()), *grow(richTree())), "");
    EXPECT_EQ(difference(*growNeutral(richTree()), *growNeutral(richTree())), "");
}

} // namespace
} // namespace stromar
