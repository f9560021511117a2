#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/mesh/twig/Twig.h"
#include "mesh/MeshMeasures.h"
#include "mesh/Cards.h"
#include "mesh/SampleTrees.h"
#include "stromar/mesh/check/MeshCheck.h"
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace stromar::test {

namespace {
const std::set<std::string> kWithoutCards{"fan_palm", "coconut_palm", "lady_fern"}; // too few leaves on a stem, or too many

struct Carded {
    std::shared_ptr<const CTree> tree;
    std::shared_ptr<const Twig> twig;
};

Carded cardsOf(const CParams& params) {
    const auto tree = grow(params);
    return {tree, twigOf(*tree, params)};
}

std::shared_ptr<const CMesh> cardMesh(const CTree& tree, const Twig& twig, const CParams& params, const Detail& detail,
                                      int threads = 2) {
    const COrgans& leaves = *tree.organs(Organ::Leaf);
    return meshOfTwigs(twigsOf(tree, leaves), tree, leaves, twig, meshParamsOf(params), detail, CProgress(threads));
}

std::size_t quads(const CMesh& mesh) { return mesh.triangleCount() / 2; }
} // namespace

class PresetTwig : public testing::TestWithParam<int> {
protected:
    PresetTwig() : m_sample(weberPennPresets()[static_cast<std::size_t>(GetParam())]) {
        m_sample.params.common.season = 7;
        m_made = cardsOf(m_sample.params);
    }

    Sample m_sample;
    Carded m_made;
};
INSTANTIATE_TEST_SUITE_P(All, PresetTwig, testing::Range(0, static_cast<int>(weberPennPresets().size())),
                         [](const auto& one) { return weberPennPresets()[static_cast<std::size_t>(one.param)].name; });

TEST_P(PresetTwig, KeepsTheCrown) {
    ASSERT_EQ(m_made.twig == nullptr, kWithoutCards.contains(m_sample.name));
    if (!m_made.twig) return;
    const Twig& twig = *m_made.twig;
    const Bounds all = meshesOf(*m_made.tree, m_sample.params, detailOf(Model::Full)).back()->bounds();
    EXPECT_GT(twig.twigsCover, 0.005);
    EXPECT_NEAR(twig.cardsCover.near, twig.twigsCover, 0.03 * twig.twigsCover);
    for (const int lod : {2, 3}) {
        const Detail& detail = detailOf(Model::Full, lod);
        const auto mesh = cardMesh(*m_made.tree, twig, m_sample.params, detail);
        EXPECT_TRUE(checkLeaves(*mesh).sound()) << lod;
        EXPECT_LE(double(quads(*mesh)), std::ceil(detail.share * double(m_made.tree->leaves().size())));
        // Of a plane one half is seen on the average; crossed ones hide a little of each other.
        const double seen = 0.5 * mesh->area() * twig.shownArea / twig.cardArea(), ofTwigs = twig.seenPerLeaf * double(m_made.tree->leaves().size());
        EXPECT_GT(seen, 0.4 * ofTwigs) << lod << ": what hangs beyond a dense crown is seen better";
        EXPECT_LT(seen, 1.45 * ofTwigs) << lod;
        const Bounds box = mesh->bounds();
        for (int i = 0; i < 3; ++i) {
            EXPECT_GT(box.max[i] - box.min[i], 0.85f * (all.max[i] - all.min[i])) << lod << ", " << i;
            EXPECT_LT(box.max[i] - box.min[i], 1.35f * (all.max[i] - all.min[i])) << lod << ", " << i;
        }
    }
}

TEST_P(PresetTwig, LiesInItsPicture) {
    if (!m_made.twig) return;
    const Twig& twig = *m_made.twig;
    EXPECT_EQ(twig.low.x, -twig.high.x);
    for (const auto& mesh : {twig.wood, twig.leaves})
        for (const glm::vec3& p : mesh->positions) {
            EXPECT_GT(p.x, twig.low.x);
            EXPECT_LT(p.x, twig.high.x);
            EXPECT_GT(p.y, twig.low.y);
            EXPECT_LT(p.y, twig.high.y);
        }
    EXPECT_NEAR(twig.wood->bounds().max.y, twig.length, 1e-4);
    EXPECT_GT(twig.shownArea, 0.02 * twig.cardArea());
    EXPECT_LT(twig.shownArea, twig.cardArea());
    EXPECT_NEAR(twig.allLeafArea, twig.leafArea * double(m_made.tree->leaves().size()), 1e-6 * twig.allLeafArea);
}

TEST(Twig, IsPressedSoThatNoLeafIsSeenEdgeOn) {
    CParams params = preset("coconut_palm"); // its leaflets stand across the frond
    EXPECT_FALSE(cardsOf(params).twig) << "too many to be told apart";
    weberPenn(params).leaves = 50;
    const auto twig = cardsOf(params).twig;
    std::size_t edgeOn = 0;
    for (const glm::vec3& n : twig->leaves->normals)
        if (std::abs(n.z) < 0.5f) ++edgeOn;
    EXPECT_LT(double(edgeOn), 0.02 * double(twig->leaves->vertexCount()));
    EXPECT_TRUE(twig->flat);
}

TEST(Twig, CardsStandAboutTheirStems) {
    const CParams params = preset("quaking_aspen");
    const auto [tree, twig] = cardsOf(params);
    const auto mesh = cardMesh(*tree, *twig, params, detailOf(Model::Full, 3));
    std::size_t card = 0;
    const CGeneration& last = tree->generation(tree->generationCount() - 1);
    ASSERT_EQ(mesh->vertexCount(), 4 * last.stems.size()) << "every stem bears leaves";
    for (const CStem& stem : last.stems) {
        const glm::vec3* p = &mesh->positions[4 * card++];
        const glm::dvec3 foot(0.5f * (p[0] + p[1]));
        EXPECT_LT(glm::distance(foot, last.segments[stem.firstSegment].position), 0.25 * stem.length);
    }
}

TEST(Twig, OfAnotherSeasonBearsWhatIsThere) {
    CParams params = preset("english_oak");
    params.common.season = 7;
    const auto summer = cardsOf(params).twig;
    params.common.season = 10.4;
    const auto autumn = cardsOf(params).twig;
    ASSERT_TRUE(autumn);
    EXPECT_LT(autumn->allLeafArea, 0.9 * summer->allLeafArea);
    params.common.season = 1;
    EXPECT_FALSE(cardsOf(params).twig);
}

TEST(Twig, IsOfNoUseForFewLeavesAndLongStems) {
    CParams params = preset("quaking_aspen");
    weberPenn(params).leaves = 3;
    EXPECT_FALSE(cardsOf(params).twig);
    weberPenn(params).leaves = 25;
    params.common.leafScale = 0.03;
    EXPECT_FALSE(cardsOf(params).twig);
    weberPenn(params).leaves = 0;
    EXPECT_FALSE(cardsOf(params).twig);
    weberPenn(params).leaves = 25;
    weberPenn(params).levels = 1;
    EXPECT_FALSE(cardsOf(params).twig);
}

TEST(Twig, OfRandomTreesIsSoundAndTheSameForEveryNumberOfThreads) {
    int looked = 0;
    for (std::uint64_t number = 1; number <= 400; ++number) {
        const CParams params = randomParams(number);
        const auto [tree, twig] = cardsOf(params);
        if (!twig) continue;
        for (const int lod : {2, 3}) {
            const Detail& detail = detailOf(Model::Full, lod);
            const auto mesh = cardMesh(*tree, *twig, params, detail, 3);
            const MeshFaults faults = checkLeaves(*mesh);
            EXPECT_TRUE(faults.sound()) << number << ", LOD " << lod << ": " << inWords(faults);
            const auto again = cardMesh(*tree, *twig, params, detail, 1);
            EXPECT_TRUE(std::ranges::equal(mesh->positions, again->positions)) << number;
            EXPECT_TRUE(std::ranges::equal(mesh->normals, again->normals)) << number;
            ++looked;
        }
    }
    EXPECT_GT(looked, 60);
}

} // namespace stromar::test
