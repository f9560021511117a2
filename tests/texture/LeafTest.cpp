#include "stromar/texture/Draw.h"
#include "stromar/texture/Opacity.h"
#include "stromar/util/Error.h"
#include <cmath>
#include <gtest/gtest.h>

namespace stromar {
namespace {

TextureMaps drawn(const LeafParams& leaf, int size = 96, int threads = 2) {
    return makeLeaf(leaf, size, CProgress(threads));
}

double coverage(const Pixels& pixels, double soft = 0) {
    double sum = 0;
    for (const auto& p : pixels) sum += coverOf(p[3] / 255.0, kAlphaCut, soft);
    return sum / double(pixels.size());
}

class LeafKind : public ::testing::TestWithParam<int> {
protected:
    LeafParams leaf() const { return leafBook().of(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(All, LeafKind, ::testing::Range(0, int(leafBook().kinds.size())), [](const auto& kind) {
    std::string name(leafBook().kinds[std::size_t(kind.param)]);
    std::erase(name, '-');
    return name;
});

TEST_P(LeafKind, FillsItsCardAndLeavesRoom) {
    const TextureMaps maps = drawn(leaf(), 128);
    EXPECT_GT(coverage(maps.albedo), 0.15);
    EXPECT_LT(coverage(maps.albedo), 0.9);
    int highest = 128;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            if (maps.albedo[maps.at(x, y)][3] > 128) highest = std::min(highest, y);
    EXPECT_LT(highest, 26) << "the tip lies at the upper edge";
}

TEST_P(LeafKind, IsTheSameForAnyNumberOfThreadsAndNotForAnotherSeed) {
    const TextureMaps one = drawn(leaf(), 64, 1), many = drawn(leaf(), 64, 5);
    EXPECT_EQ(one.albedo, many.albedo);
    EXPECT_EQ(one.back, many.back);
    EXPECT_EQ(one.normal, many.normal);
    EXPECT_EQ(one.roughness, many.roughness);
    EXPECT_EQ(one.translucency, many.translucency);
    LeafParams other = leaf();
    other.seed = 77;
    EXPECT_NE(one.albedo, drawn(other, 64).albedo);
}

TEST_P(LeafKind, AnotherSizeShowsTheSameLeaf) {
    const double large = coverage(drawn(leaf(), 192).albedo), small = coverage(drawn(leaf(), 64).albedo);
    EXPECT_NEAR(large, small, 0.12 * large);
}

TEST_P(LeafKind, ItsColoursGoOnUnderTheTransparentPart) {
    const TextureMaps maps = drawn(leaf());
    double mean[3] = {0, 0, 0}, outside[3] = {0, 0, 0}, in = 0, out = 0;
    for (const auto& p : maps.albedo) {
        (p[3] > 128 ? in : out) += 1;
        for (std::size_t c = 0; c < 3; ++c) (p[3] > 128 ? mean : outside)[c] += p[c];
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / in, outside[c] / out, 45);
}

TEST_P(LeafKind, ItsTextSaysOnlyWhatDiffers) {
    LeafParams own = leaf();
    EXPECT_EQ(leafBook().text(own), leafBook().kinds[static_cast<std::size_t>(GetParam())]);
    own.seed = 12;
    own.green = {1, 2, 255};
    EXPECT_TRUE(leafBook().read(leafBook().text(own)) == own);
}

TEST(Leaf, TheSeasonTurnsItsColour) {
    const auto meanOf = [](double month) {
        LeafParams leaf = leafBook().read("maple");
        leaf.season = month;
        double sum[3] = {0, 0, 0};
        for (const auto& p : drawn(leaf).albedo)
            for (std::size_t c = 0; c < 3; ++c) sum[c] += p[3] > 128 ? p[c] : 0;
        return std::pair{sum[0] / sum[1], sum[2] / sum[1]}; // red and blue to green
    };
    EXPECT_EQ(meanOf(7), meanOf(8));
    EXPECT_LT(meanOf(7).first, 0.9) << "green";
    EXPECT_GT(meanOf(10.3).first, 1.2) << "yellow to red";
    EXPECT_GT(meanOf(9.6).first, meanOf(9).first) << "little by little";
}

TEST(Leaf, LightGoesThroughTheBladeMoreThanThroughItsMidrib) {
    const TextureMaps maps = drawn(leafBook().read("beech spots=0"), 256);
    const auto through = [&](int x, int y) { return int(maps.translucency[maps.at(x, y)]); };
    EXPECT_LT(through(128, 130), through(128 + 40, 124));
}

TEST(Opacity, SpreadColoursKeepsWhatIsOpaque) {
    Pixels pixels(64, {0, 0, 0, 0});
    pixels[27] = {200, 100, 50, 255};
    spreadColours(pixels, 8, 8);
    EXPECT_EQ(pixels[27], (std::array<std::uint8_t, 4>{200, 100, 50, 255}));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_EQ(pixels[i][3], i == 27 ? 255 : 0);
        EXPECT_NEAR(pixels[i][0], 200, 1) << i;
    }
}

/// A thin stem beside a leaf does not stain all that is left free.
TEST(Opacity, SpreadColoursAreMeansByWhatIsCovered) {
    constexpr int kSide = 64;
    Pixels pixels(kSide * kSide, {0, 0, 0, 0});
    for (int y = 0; y < kSide; ++y) {
        pixels[std::size_t(y * kSide + 28)] = {200, 0, 0, 255};
        for (int x = 40; x < 60; ++x) pixels[std::size_t(y * kSide + x)] = {0, 200, 0, 255};
    }
    spreadColours(pixels, kSide, kSide);
    for (const int x : {4, 20, 27, 38, 62}) {
        const auto& p = pixels[std::size_t(30 * kSide + x)];
        EXPECT_GT(p[1], 3 * p[0]) << x;
        EXPECT_NEAR(p[0] + p[1], 200, 2) << "a mean, as bright as both";
    }
}

TEST(Opacity, SmallerPicturesHaveTheColoursOfWhatCovers) {
    constexpr int kSide = 16;
    Pixels pixels(kSide * kSide, {250, 10, 10, 0});
    for (int y = 5; y < 12; ++y)
        for (int x = 3; x < 8; ++x) pixels[std::size_t(y * kSide + x)] = {20, 120, 40, 255};
    for (const Pixels& level : mipmapsKeepingCoverage(pixels, kSide, kSide))
        for (const auto& p : level)
            if (p[3] > 0) {
                EXPECT_EQ(p[1], 120);
            }
}

TEST(Leaf, WhatIsCutOutOfItIsAsItselfInAllMaps) {
    const TextureMaps maps = drawn(leafBook().read("beech"), 128);
    for (const auto* map : {&maps.roughness, &maps.translucency}) {
        double sums[2] = {}, counts[2] = {};
        for (std::size_t i = 0; i < map->size(); ++i)
            if (const auto opacity = maps.albedo[i][3]; opacity == 0 || opacity == 255) sums[opacity / 255] += (*map)[i], ++counts[opacity / 255];
        EXPECT_NEAR(sums[0] / counts[0] / (sums[1] / counts[1]), 1, 0.1);
    }
}

TEST(Opacity, MipmapsKeepTheCoverage) {
    for (const char* recipe : {"leaf:spruce", "leaf:ash", "leaf:pine", "leaf:maple"}) {
        const TextureMaps maps = CRecipe(recipe).draw(256, CProgress());
        const std::vector<Pixels> levels = mipmapsKeepingCoverage(maps.albedo, 256, 256, softeningOf(false));
        ASSERT_EQ(levels.size(), 9u);
        EXPECT_EQ(levels.back().size(), 1u);
        const double wanted = coverage(levels[0], 0);
        for (std::size_t i = 1; i < levels.size(); ++i)
            EXPECT_NEAR(coverage(levels[i], softeningOf(false).at(std::exp2(i) / 256)), wanted, 0.1 * wanted) << recipe << " level " << i;
    }
}

/// A level of a square picture.
struct Level {
    const Pixels& pixels;
    int side;

    /// As a graphics card has it, which interpolates between pixels.
    double opacityAt(double u, double v) const {
        const auto at = [&](int x, int y) { return pixels[std::size_t(std::clamp(y, 0, side - 1) * side + std::clamp(x, 0, side - 1))][3] / 255.0; };
        const double x = u * side - 0.5, y = v * side - 0.5;
        const int left = int(std::floor(x)), top = int(std::floor(y));
        const double across = x - left, down = y - top;
        return (1 - down) * ((1 - across) * at(left, top) + across * at(left + 1, top)) + down * ((1 - across) * at(left, top + 1) + across * at(left + 1, top + 1));
    }
};

/// What is shown of what has so much opacity at each place.
template <typename OpacityAt> double drawnCoverage(int side, double soft, OpacityAt&& opacityAt) {
    const int samples = 5 * side;
    double sum = 0;
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) sum += coverOf(opacityAt((i + 0.5) / samples, (j + 0.5) / samples), kAlphaCut, soft);
    return sum / (double(samples) * samples);
}
double drawnCoverage(const Pixels& pixels, int side, double soft) {
    return drawnCoverage(side, soft, [&](double u, double v) { return Level{pixels, side}.opacityAt(u, v); });
}

TEST(Opacity, ManyLeavesInAPictureCoverTheSameBetweenTwoOfItsHalves) {
    constexpr int kSide = 128;
    Pixels pixels(kSide * kSide, {40, 90, 20, 0});
    for (const auto& [x0, y0] : {std::pair{28, 20}, {84, 32}, {30, 76}, {80, 92}}) // four leaves: 11 % of the picture
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 20; ++x) pixels[std::size_t((y0 + y) * kSide + x0 + x)][3] = 255;
    const Softening softening = softeningOf(true);
    const auto levels = mipmapsKeepingCoverage(pixels, kSide, kSide, softening);
    const double wanted = drawnCoverage(levels[0], kSide, 0);
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        const Level large{levels[i], kSide >> i}, small{levels[i + 1], kSide >> (i + 1)};
        const double covered = drawnCoverage(large.side, softening.at(std::sqrt(0.5) / small.side), [&](double u, double v) { return (large.opacityAt(u, v) + small.opacityAt(u, v)) / 2; });
        EXPECT_NEAR(covered, wanted, 0.12 * wanted) << "between " << large.side << " and " << small.side << " pixels";
    }
}

TEST(Opacity, ThinLeavesDoNotFade) {
    constexpr int kSide = 256;
    Pixels pixels(kSide * kSide, {40, 90, 20, 0});
    for (int y = 20; y < 236; ++y)
        for (const int foot : {30, 90, 150}) // three slanting leaves, five pixels wide: 6 % of the picture
            for (int x = 0; x < 5; ++x) pixels[std::size_t(y * kSide + foot + y / 4 + x)][3] = 255;
    const auto levels = mipmapsKeepingCoverage(pixels, kSide, kSide, softeningOf(false));
    const double wanted = drawnCoverage(levels[0], kSide, 0);
    for (std::size_t i = 1; i < 4; ++i)
        EXPECT_NEAR(drawnCoverage(levels[i], kSide >> i, softeningOf(false).at(std::exp2(i) / kSide)), wanted, 0.1 * wanted) << "level " << i;
}

TEST(Opacity, HairsAreAsWideAsTheyWere) {
    constexpr int kSide = 64;
    Pixels pixels(kSide * kSide, {40, 90, 20, 0});
    for (int y = 4; y < 60; ++y) {
        for (int x = 8; x < 20; ++x) pixels[std::size_t(y * kSide + x)][3] = 255; // a leaf
        for (const int x : {30, 40, 50}) pixels[std::size_t(y * kSide + x)][3] = 200; // hairs of less than a pixel
    }
    double mean = 0;
    for (const auto& p : pixels) mean += p[3] / 255.0 / double(pixels.size());
    EXPECT_GT(drawnCoverage(pixels, kSide, 0), 1.03 * mean);
    setCoverage(pixels, kSide, kSide, mean);
    EXPECT_NEAR(drawnCoverage(pixels, kSide, 0), mean, 0.03 * mean);
    EXPECT_EQ(pixels[std::size_t(30 * kSide + 12)][3], 255) << "what is opaque stays so";
    EXPECT_EQ(pixels[0][3], 0);
}

TEST(Opacity, OddSizesAreHalvedToo) {
    const Pixels pixels(5 * 3, {10, 20, 30, 255});
    const auto levels = mipmapsKeepingCoverage(pixels, 5, 3);
    ASSERT_EQ(levels.size(), 3u); // 5 × 3, 2 × 1, 1 × 1
    EXPECT_EQ(levels[1].size(), 2u);
    EXPECT_EQ(levels[2].size(), 1u);
    EXPECT_EQ(levels[2][0], pixels[0]);
}

TEST(Recipe, OfAnyBookIsReadChangedAndWritten) {
    for (const char* book : {"bark", "leaf"})
        for (const std::string& text : plainRecipes(book)) {
            CRecipe recipe(text);
            EXPECT_EQ(recipe.text(), text);
            const std::vector<CRecipe::Row> rows = recipe.rows();
            for (std::size_t i = 0; i < rows.size(); ++i) {
                recipe.setValue(i, recipe.value(i));
                if (rows[i].type == CRecipe::Type::Tint) recipe.setValue(i, "#010203");
            }
            EXPECT_EQ(CRecipe(recipe.text()).text(), recipe.text());
            recipe.setKind(recipe.kind());
            EXPECT_EQ(recipe.text(), text);
        }
    EXPECT_THROW(CRecipe("oak"), CError);
    EXPECT_THROW(CRecipe("wood:oak"), CError);
    EXPECT_TRUE(isRecipe("leaf:oak"));
    EXPECT_FALSE(isRecipe("leaf.png"));
}

} // namespace
} // namespace stromar
