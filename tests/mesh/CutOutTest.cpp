#include "stromar/mesh/twig/CutOut.h"
#include <gtest/gtest.h>
#include <random>

namespace stromar::test {

namespace {
constexpr int kSide = CCutOut::kSide;

double meanOf(const CCutOut& cutOut, int level) {
    double sum = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) sum += cutOut.meanAt(glm::vec2(x + 0.5, y + 0.5) / float(kSide), level);
    return sum / kSide / kSide;
}
} // namespace

TEST(CutOut, CoversAsMuchAtEveryLevel) {
    std::mt19937 random(1);
    std::vector<bool> cells;
    for (int i = 0; i < kSide * kSide; ++i) cells.push_back(random() % 4 == 0 && i % kSide < kSide / 2);
    const CCutOut cutOut(cells, true);
    const double covered = meanOf(cutOut, 0);
    EXPECT_NEAR(covered, 0.125, 0.01);
    for (int level = 1; level <= CCutOut::levelOf(1); ++level) EXPECT_NEAR(meanOf(cutOut, level), covered, 0.003) << level;
    for (int i = 0; i < kSide * kSide; ++i)
        EXPECT_EQ(cutOut.covers(glm::vec2(i % kSide + 0.5, i / kSide + 0.5) / float(kSide)), cells[static_cast<std::size_t>(i)]);
    EXPECT_LT(cutOut.meanAt({0.75, 0.5}, 5), 0.01);
    EXPECT_NEAR(cutOut.meanAt({0.25, 0.5}, 5), 0.25, 0.05);
}

TEST(CutOut, APixelShowsTheLevelOfItsFootprint) {
    EXPECT_EQ(CCutOut::levelOf(1e-9), 0);
    EXPECT_EQ(CCutOut::levelOf(1.0 / kSide), 0);
    EXPECT_EQ(CCutOut::levelOf(4.0 / kSide), 2);
    EXPECT_EQ(CCutOut::levelOf(1), 7);
    EXPECT_EQ(CCutOut::levelOf(100), 7);
}

TEST(CutOut, WithoutAPictureAllIsThere) {
    const CCutOut whole;
    EXPECT_TRUE(whole.covers({0.5, 0.5}));
    EXPECT_EQ(whole.meanAt({0.5, 0.5}, 7), 1);
}

} // namespace stromar::test
