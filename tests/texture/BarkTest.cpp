#include "stromar/texture/Bark.h"
#include "stromar/util/Error.h"
#include "util/TemporaryFolder.h"
#include <cmath>
#include <gtest/gtest.h>

namespace stromar {
namespace {

TextureMaps drawn(const BarkParams& bark, int size = 128, int threads = 2) {
    return makeBark(bark, size, CProgress(threads));
}

double distance(const TextureMaps& maps, int x0, int y0, int x1, int y1) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
        sum += std::abs(double(maps.albedo[maps.at(x0, y0)][c]) - maps.albedo[maps.at(x1, y1)][c]) +
               std::abs(double(maps.normal[maps.at(x0, y0)][c]) - maps.normal[maps.at(x1, y1)][c]);
    return sum;
}

class BarkKind : public ::testing::TestWithParam<int> {};

TEST_P(BarkKind, OppositeEdgesAgreeLikeNeighbours) {
    const TextureMaps maps = drawn(barkBook().of(GetParam()), 192);
    const int n = maps.width;
    double acrossSeam = 0, acrossInside = 0, alongSeam = 0, alongInside = 0;
    for (int i = 0; i < n; ++i) {
        acrossSeam += distance(maps, n - 1, i, 0, i);
        alongSeam += distance(maps, i, n - 1, i, 0);
        for (int k = 0; k + 1 < n; ++k) {
            acrossInside += distance(maps, k, i, k + 1, i) / (n - 1);
            alongInside += distance(maps, i, k, i, k + 1) / (n - 1);
        }
    }
    EXPECT_LT(acrossSeam, 1.8 * acrossInside);
    EXPECT_LT(alongSeam, 1.8 * alongInside);
    EXPECT_GT(acrossInside, 0);
}

TEST_P(BarkKind, IsTheSameForAnyNumberOfThreads) {
    const TextureMaps one = drawn(barkBook().of(GetParam()), 96, 1), many = drawn(barkBook().of(GetParam()), 96, 5);
    EXPECT_EQ(one.albedo, many.albedo);
    EXPECT_EQ(one.normal, many.normal);
    EXPECT_EQ(one.roughness, many.roughness);
    EXPECT_EQ(one.height01, many.height01);
}

TEST_P(BarkKind, AnotherSizeShowsTheSameBark) {
    const TextureMaps large = drawn(barkBook().of(GetParam()), 256), small = drawn(barkBook().of(GetParam()), 64);
    double sum = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            double mean = 0;
            for (int k = 0; k < 16; ++k) mean += large.albedo[large.at(4 * x + k % 4, 4 * y + k / 4)][1] / 16.0;
            sum += std::abs(mean - small.albedo[small.at(x, y)][1]);
        }
    EXPECT_LT(sum / (64 * 64), 16);
}

TEST_P(BarkKind, AnotherSeedIsAnotherBark) {
    BarkParams other = barkBook().of(GetParam());
    other.seed = 99;
    EXPECT_NE(drawn(barkBook().of(GetParam())).albedo, drawn(other).albedo);
}

TEST_P(BarkKind, NormalsAreUnitAndFlatWithoutDepth) {
    BarkParams bark = barkBook().of(GetParam());
    for (const auto& n : drawn(bark).normal) {
        const double length = std::hypot(n[0] - 127.5, n[1] - 127.5, n[2] - 127.5) / 127.5;
        EXPECT_NEAR(length, 1, 0.02);
        EXPECT_GT(n[2], 127) << "out of the surface";
    }
    bark.depth = 0;
    for (const auto& n : drawn(bark, 32).normal) EXPECT_EQ(n, (std::array<std::uint8_t, 3>{128, 128, 255}));
}

TEST_P(BarkKind, ItsTextSaysOnlyWhatDiffers) {
    BarkParams bark = barkBook().of(GetParam());
    EXPECT_EQ(barkBook().text(bark), barkBook().kinds[static_cast<std::size_t>(GetParam())]);
    bark.seed = 12;
    bark.crack = 0.125;
    bark.dark = {1, 2, 255};
    EXPECT_TRUE(barkBook().read(barkBook().text(bark)) == bark) << barkBook().text(bark);
}

INSTANTIATE_TEST_SUITE_P(All, BarkKind, ::testing::Range(0, int(barkBook().kinds.size())),
                         [](const auto& kind) { return std::string(barkBook().kinds[std::size_t(kind.param)]); });

TEST(Bark, TheLightComesFromWhereTheReliefRises) {
    // In a height picture that rises to the right, normals lean to the left.
    const TextureMaps maps = drawn(barkBook().of(0), 256);
    double agreement = 0;
    for (int y = 1; y < 255; ++y)
        for (int x = 1; x < 255; ++x) {
            const double rise = maps.height01[maps.at(x + 1, y)] - maps.height01[maps.at(x - 1, y)];
            agreement -= rise * (maps.normal[maps.at(x, y)][0] - 127.5);
        }
    EXPECT_GT(agreement, 0);
}

TEST(Bark, WhatIsWrongIsSaid) {
    const auto problem = [](const char* text) {
        try {
            barkBook().read(text);
        } catch (const CError& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_NE(problem("furowed").find("did you mean 'furrowed'"), std::string::npos);
    EXPECT_NE(problem("").find("no bark"), std::string::npos);
    EXPECT_NE(problem("birch ridge=3").find("did you mean 'ridges'"), std::string::npos);
    EXPECT_NE(problem("birch ridges=300").find("from 1 to 64"), std::string::npos);
    EXPECT_NE(problem("birch ridges=3.5").find("whole"), std::string::npos);
    EXPECT_NE(problem("birch light=white").find("#rrggbb"), std::string::npos);
    EXPECT_NE(problem("birch ridges").find("ridges"), std::string::npos);
}

TEST(Bark, PngsHoldWhatWasDrawn) {
    const test::CTemporaryFolder folder;
    const TextureMaps maps = drawn(barkBook().of(1), 40);
    CFileSet files;
    writePngs(maps, folder.path() / "pine.png", files);
    files.commit();
    for (const char* name : {"pine.png", "pine_normal.png", "pine_roughness.png", "pine_height.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
    const TextureMaps read = readPngs(folder.path() / "pine.png");
    EXPECT_EQ(read.width, 40);
    EXPECT_EQ(read.height, 40);
    EXPECT_EQ(read.albedo, maps.albedo);
    EXPECT_EQ(read.normal, maps.normal);
    EXPECT_EQ(read.roughness, maps.roughness);
    EXPECT_EQ(read.height01, maps.height01);
    EXPECT_TRUE(read.translucency.empty() && read.back.empty());
}

TEST(Bark, OnlyPngsAreRead) {
    const test::CTemporaryFolder folder;
    writeFile(folder.path() / "no.png", "no picture");
    EXPECT_THROW(readPngs(folder.path() / "no.png"), CError);
    EXPECT_THROW(readPngs(folder.path() / "missing.png"), CError);
}

TEST(Bark, IsCancelled) {
    CProgress progress;
    progress.cancel();
    EXPECT_THROW(makeBark(barkBook().of(0), 64, progress), CCancelled);
}

} // namespace
} // namespace stromar
