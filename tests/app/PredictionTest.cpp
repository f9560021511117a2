#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Prediction.h"
#include "app/SameModel.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Methods.h"
#include "stromar/mesh/JoinedStems.h"
#include "stromar/model/JoinedModel.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>

namespace stromar::test {

namespace {
constexpr Caps kCaps{{0, 14, 6, 3}, 0.9, 8, 30, 4};

/// Of the wood that is joined, and the plans it is joined by.
double bytesOfJoining(const TreeModel& model) {
    std::vector<StemMesh> stems;
    for (std::size_t g = 0; g < model.stems.size(); ++g)
        stems.push_back(planned(model, g, stems, CProgress(2)));
    const JoinedStems wood = joinStems(*model.tree, stems, CProgress(2));
    double bytes = 0;
    for (std::size_t g = 0; g < stems.size(); ++g)
        bytes += double(wood.meshes[g]->bytes()) + double(wood.sources[g].size()) * sizeof(VertexSource) + double(stems[g].plan.rings.size()) * sizeof(Ring);
    return bytes;
}

/// What is held at once: the structure with the builder's scratch, its largest generation twice; organs; meshes, and
/// a writer's copy of them; the wood that was joined for the writer, and the plans it was joined by.
double heldBytes(const TreeModel& model, const SizeBound& scratch) {
    double bytes = 0, largest = 0;
    for (const auto& generation : model.tree->generations()) {
        const double own = double(generation->stems.size()) * (sizeof(CStem) + scratch.scratchPerStem) +
                           double(generation->paths.size()) * (sizeof(CPath) + sizeof(double)) +
                           double(generation->segments.size()) * (sizeof(CSegment) + scratch.scratchPerSegment);
        bytes += own;
        largest = std::max(largest, own);
    }
    for (const Organ organ : kOrgans) bytes += double(model.tree->grown(organ).size()) * sizeof(CLeaf);
    for (const auto& mesh : model.meshes()) bytes += 2 * double(mesh->bytes());
    return bytes + largest + (model.detail->collarRings > 0 ? bytesOfJoining(model) : 0);
}

struct Built {
    double stems, segments, organs, vertices, bytes;
};
constexpr std::pair<const char*, double Built::*> kFields[] = {{"stems", &Built::stems},
                                                               {"segments", &Built::segments},
                                                               {"organs", &Built::organs},
                                                               {"vertices", &Built::vertices},
                                                               {"bytes", &Built::bytes}};

Built builtOf(const TreeModel& model) {
    Built built{};
    for (const auto& generation : model.tree->generations()) {
        built.stems += double(generation->stems.size());
        built.segments += double(generation->segments.size());
    }
    for (const Organ organ : kOrgans) built.organs += double(model.tree->organs(organ)->total);
    built.vertices = double(model.vertexCount());
    built.bytes = heldBytes(model, methodOf(model.params).bound(model.params, CProgress()));
    return built;
}

/// Never more than predicted; `near` times as much is predicted at most. A creator that is used for one tree's levels of detail
/// grows it once. Gives the triangles.
std::size_t expectWithin(CTreeCreator& creator, const CParams& params, const Detail& detail, const std::string& label,
                  double near = std::numeric_limits<double>::max()) {
    const Prediction size = predictSize(params, detail);
    const Built predicted{size.stems, size.segments, size.organs, size.vertices, size.bytes};
    const auto model = creator.create(params, detail, CProgress(2));
    const Built built = builtOf(*model);
    for (const auto& [name, field] : kFields) {
        EXPECT_LE(built.*field, predicted.*field * (1 + 1e-9)) << label << ": " << name;
        EXPECT_LE(predicted.*field / near, built.*field + 1) << label << ": " << name;
    }
    return model->triangleCount();
}

/// What the last level of detail has of the triangles of the first, at most, unless it has no more than kFew.
constexpr std::size_t kFew = 5000;
constexpr double kLargestShare = 0.05;

void expectFewTriangles(const std::string& name, std::size_t finest, std::size_t coarsest) {
    EXPECT_LE(coarsest, std::max(kFew, static_cast<std::size_t>(kLargestShare * double(finest)))) << name << " of " << finest;
}

/// The numbers before " million vertices" in a refusal.
std::vector<double> millionsIn(const std::string& text) {
    std::vector<double> found;
    for (std::size_t at = text.find(" million vertices"); at != std::string::npos;
         at = text.find(" million vertices", at + 1))
        found.push_back(std::atof(text.c_str() + text.rfind(' ', at - 1)));
    return found;
}

std::string refusal(const CParams& params, double limit) {
    try {
        CTreeCreator(true, {.vertices = limit}).create(params, detailOf(Model::Full), CProgress(2));
    } catch (const CError& e) {
        return e.what();
    }
    return "not refused";
}
} // namespace

/// How many times as much as is built may be predicted: how much of straight stems is left out nobody knows before.
double nearFor(const Detail& detail) { return detail.share < 1 ? 6 : 5; }

TEST(SlowPrediction, BoundsThePresetsAndIsNear) {
    for (const Sample& sample : presets()) {
        CTreeCreator creator(true, SizeLimits::none());
        std::size_t finest = 0, last = 0;
        for (const Detail& detail : detailTable()) {
            last = expectWithin(creator, sample.params, detail, sample.name + ", " + std::string(detail.name), nearFor(detail));
            finest = std::max(finest, last);
        }
        expectFewTriangles(sample.name, finest, last);
    }
}

/// A seed, and from which level of detail on it is looked at: the largest take time.
class PredictionOfSeeds : public ::testing::TestWithParam<std::pair<int, int>> {};
INSTANTIATE_TEST_SUITE_P(Slow, PredictionOfSeeds, ::testing::Values(std::pair(77, 3)));
INSTANTIATE_TEST_SUITE_P(Exhaustive, PredictionOfSeeds, ::testing::Values(std::pair(1, 1), std::pair(4711, 2)));

TEST_P(PredictionOfSeeds, BoundThePresets) {
    for (const Sample& sample : presets()) {
        CTreeCreator creator(true, SizeLimits::none());
        CParams params = sample.params;
        params.common.seed = GetParam().first;
        for (const Detail& detail : detailTable())
            if (detail.model == Model::Simple || detail.lod >= GetParam().second)
                expectWithin(creator, params, detail, sample.name + ", " + std::string(detail.name));
    }
}

/// From the sample on that is the parameter.
constexpr std::uint64_t kSamplesOfATest = 55;
class PredictionOfSamples : public ::testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Slow, PredictionOfSamples, ::testing::Values<std::uint64_t>(1000));
INSTANTIATE_TEST_SUITE_P(Exhaustive, PredictionOfSamples, ::testing::Range<std::uint64_t>(1000 + kSamplesOfATest, 1220, kSamplesOfATest));

TEST_P(PredictionOfSamples, BoundsThem) {
    int looked = 0;
    for (std::uint64_t number = GetParam(); number < GetParam() + kSamplesOfATest; ++number) {
        const CParams params = randomParams(number, kCaps);
        CTreeCreator creator(number % 4 != 0, SizeLimits::none());
        for (const Detail& detail : detailTable()) {
            if (predictSize(params, detail).vertices > 1e6) continue; // time
            expectWithin(creator, params, detail, "sample " + std::to_string(number) + ", " + std::string(detail.name));
            ++looked;
        }
    }
    EXPECT_GE(looked, 150);
}

TEST(Prediction, BoundsDeepTrees) {
    int looked = 0;
    for (int levels = 5; levels <= 9; ++levels)
        for (std::uint64_t number = 2000; number < 2006; ++number) {
            CParams params = randomParams(number, {{0, 2, 2, 2}, 0.1, 3, 5, 4});
            weberPenn(params).levels = levels;
            const std::string label = "levels " + std::to_string(levels) + ", sample " + std::to_string(number);
            if (predictSize(params, detailOf(Model::Full)).vertices > 2e6) continue; // time
            CTreeCreator creator(true, SizeLimits::none());
            expectWithin(creator, params, detailOf(Model::Full), label);
            ++looked;
        }
    EXPECT_GE(looked, 10);
}

/// Of so many segments.
class PredictionOfTrunks : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Slow, PredictionOfTrunks, ::testing::Values(1, 7, 200));
INSTANTIATE_TEST_SUITE_P(Exhaustive, PredictionOfTrunks, ::testing::Values(2, 60));

TEST_P(PredictionOfTrunks, BoundsManySpheresSplitsAndTurns) {
    for (const double taper : {1.0, 1.5, 2.0, 2.5, 3.0})
        for (const double helix : {0.0, -60.0})
            for (const int splits : {0, 3})
                for (const double ratio : {0.0001, 0.002, 0.05, 1.0}) {
                    CParams params;
                    weberPenn(params).levels = 1;
                    weberPenn(params).ratio = ratio;
                    weberPenn(params).baseSplits = splits;
                    params.common.flare = 20;
                    weberPenn(params).level[0].curveRes = GetParam();
                    weberPenn(params).level[0].taper = taper;
                    weberPenn(params).level[0].curveV = helix;
                    CTreeCreator creator(true, SizeLimits::none());
                    for (const Detail& detail : detailTable())
                        expectWithin(creator, params, detail,
                                     "taper " + std::to_string(taper) + ", curve " + std::to_string(helix) + ", splits " +
                                         std::to_string(splits) + ", ratio " + std::to_string(ratio) + ", " +
                                         std::string(detail.name));
                }
}

TEST(Prediction, ARefusalNamesBothNumbers) {
    CParams params = preset("quaking_aspen");
    weberPenn(params).level[1].branches = 5000;
    weberPenn(params).level[2].branches = 5000;
    const std::string text = refusal(params, SizeLimits::kMaxVertices);
    const double predicted = predictSize(params, detailOf(Model::Full)).vertices / 1e6;
    const auto numbers = millionsIn(text);
    ASSERT_EQ(numbers.size(), 2u) << text;
    EXPECT_NEAR(numbers[0], predicted, 0.1 + 0.01 * predicted) << text;
    EXPECT_NEAR(numbers[1], 20, 0.01) << text;
}

TEST(Prediction, ARefusalNamesSmallLimitsToo) {
    const std::string text = refusal(preset("quaking_aspen"), 1000);
    EXPECT_NE(text, "not refused");
    const auto numbers = millionsIn(text);
    const bool asNumber =
        text.find("1000 vertices") != std::string::npos || text.find("1,000 vertices") != std::string::npos;
    EXPECT_TRUE(asNumber || (numbers.size() == 2 && numbers[1] < 0.002)) << text;
}

TEST(Prediction, TheLargestTreeIsRefusedAtOnce) {
    CParams params;
    for (const ParamRef& ref : numberParams()) ref.set(params, ref.info->range.max);
    for (const Detail& detail : detailTable()) {
        const Prediction size = predictSize(params, detail);
        EXPECT_TRUE(std::isfinite(size.vertices) && std::isfinite(size.stems) && std::isfinite(size.leaves));
        EXPECT_THROW(CTreeCreator().create(params, detail, CProgress(2)), CError);
    }
}

TEST(Prediction, ARefusedTreeLeavesTheCreatorAsItWas) {
    CTreeCreator creator;
    const CParams params = preset("quaking_aspen");
    const auto before = creator.create(params, detailOf(Model::Simple), CProgress(2));
    CParams large = params;
    weberPenn(large).level[1].branches = weberPenn(large).level[2].branches = 5000;
    EXPECT_THROW(creator.create(large, detailOf(Model::Simple), CProgress(2)), CError);
    EXPECT_EQ(creator.create(params, detailOf(Model::Simple), CProgress(2))->stems, before->stems);
}

TEST(SlowPrediction, LeavesThatAreNotShownTakeNoMemory) {
    CParams params = preset("weeping_willow");
    weberPenn(params).leaves = -5000;
    weberPenn(params).level[3].curve = 1592;
    const Detail& cards = detailOf(Model::Full, 2);
    EXPECT_LT(predictSize(params, cards).bytes, 1e9);
    EXPECT_GT(predictSize(params, detailOf(Model::Full)).bytes, 1e10) << "LOD 0 would show them";
    const auto model = CTreeCreator().create(params, cards, CProgress(2));
    EXPECT_GT(model->tree->organs(Organ::Leaf)->total, 1e8);
    EXPECT_LT(model->tree->leaves().size(), 20000u) << "those of one twig";
}

TEST(Prediction, ATreeThatWouldFillTheMemoryIsRefusedWithBothNumbers) {
    CParams params = preset("scots_pine");
    weberPenn(params).trunks = 100;
    weberPenn(params).scaleV = 240;
    weberPenn(params).leaves = 1873;
    weberPenn(params).level[2].segSplits = 9.1;
    try {
        CTreeCreator(true, {.bytes = 8e9}).create(params, detailOf(Model::Full, 3), CProgress(2));
        FAIL() << "it was grown";
    } catch (const CError& e) {
        const std::string why = e.what();
        EXPECT_NE(why.find(" GB of memory"), std::string::npos) << why;
        EXPECT_NE(why.find("the limit is 8 GB"), std::string::npos) << why;
    }
}

} // namespace stromar::test
