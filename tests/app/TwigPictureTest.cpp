#include "mesh/SampleTrees.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Export.h"
#include "stromar/app/Pictures.h"
#include "stromar/texture/TextureMaps.h"
#include "util/TemporaryFolder.h"
#include <chrono>
#include <cstdlib>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
namespace fs = std::filesystem;

class TwigPicture : public testing::Test {
protected:
    TwigPicture() { setenv("XDG_CACHE_HOME", (m_folder.path() / "cache").c_str(), 1); }
    ~TwigPicture() override { unsetenv("XDG_CACHE_HOME"); }

    std::shared_ptr<const TreeModel> create(int lod) {
        return CTreeCreator().create(m_params, detailOf(Model::Full, lod), CProgress(2));
    }
    fs::path file(const TreeModel& model) const { return textureOf(model, Surface::Twig, m_folder.path()); }

    CTemporaryFolder m_folder;
    CParams m_params = preset("quaking_aspen");
};
class SlowTwigPicture : public TwigPicture {};

/// Sums of what is opaque.
struct Seen {
    double opaque = 0, green = 0;
};

Seen seenOf(const TextureMaps& maps) {
    Seen seen;
    for (const auto& c : maps.albedo)
        if (c[3] > 100) {
            seen.opaque += 1;
            seen.green += c[1] > c[0] && c[1] > c[2] ? 1 : 0;
        }
    return seen;
}
} // namespace

TEST_F(TwigPicture, ShowsTheLeavesOfItsTree) {
    const auto model = create(2);
    makePictures(*model, m_folder.path(), CProgress());
    const TextureMaps maps = readPngs(file(*model));
    ASSERT_EQ(maps.width, 512);
    const Seen seen = seenOf(maps);
    const double pixels = double(maps.albedo.size());
    const double cards = model->twig->shownArea / model->twig->cardArea(); // the leaves' own pictures are cut out
    EXPECT_GT(seen.opaque / pixels, 0.3 * cards);
    EXPECT_LT(seen.opaque / pixels, 1.1 * cards + 0.1);
    EXPECT_GT(seen.green, 0.7 * seen.opaque);
    EXPECT_EQ(maps.normal.size(), maps.albedo.size());
    EXPECT_EQ(maps.translucency.size(), maps.albedo.size());
    for (int i = 0; i < maps.width; ++i) // nothing is cut off
        for (const std::size_t edge :
             {maps.at(i, 0), maps.at(i, maps.height - 1), maps.at(0, i), maps.at(maps.width - 1, i)})
            ASSERT_EQ(maps.albedo[edge][3], 0);
}

/// Smaller pictures mix what is opaque with what is not.
TEST_F(TwigPicture, HasNoDarkEdgesOnEitherSide) {
    const auto model = create(2);
    makePictures(*model, m_folder.path(), CProgress());
    const TextureMaps maps = readPngs(file(*model));
    ASSERT_EQ(maps.back.size(), maps.albedo.size());
    const auto light = [](const std::vector<std::array<std::uint8_t, 4>>& pixels, bool opaque) {
        double sum = 0, count = 0;
        for (const auto& c : pixels)
            if ((c[3] > 200) == opaque) sum += c[0] + c[1] + c[2], ++count;
        return sum / count;
    };
    EXPECT_NEAR(light(maps.albedo, false) / light(maps.albedo, true), 1, 0.4);
    EXPECT_NEAR(light(maps.back, false) / light(maps.back, true), 1, 0.4);
    for (std::size_t i = 0; i < maps.albedo.size(); ++i)
        if (maps.albedo[i][3] == 0) {
            ASSERT_GT(maps.translucency[i], 100) << "light goes through what is left of a leaf";
        }
    const auto meanOf = [&](const auto& valueOf, bool opaque) {
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < maps.albedo.size(); ++i)
            if (maps.albedo[i][3] == (opaque ? 255 : 0)) sum += valueOf(i), ++count;
        return sum / count;
    };
    const auto through = [&](std::size_t i) { return double(maps.translucency[i]); };
    const auto rough = [&](std::size_t i) { return double(maps.roughness[i]); };
    const auto out = [&](std::size_t i) { return double(maps.normal[i][2]); };
    EXPECT_NEAR(meanOf(through, false) / meanOf(through, true), 1, 0.1);
    EXPECT_NEAR(meanOf(rough, false) / meanOf(rough, true), 1, 0.1);
    EXPECT_NEAR(meanOf(out, false) / meanOf(out, true), 1, 0.1) << "leaves do not become flat";
    EXPECT_LT(meanOf(out, true), 240);
}

TEST_F(SlowTwigPicture, IsOneForAllLevelsOfDetailAndOnlyWhereCardsAre) {
    EXPECT_TRUE(file(*create(0)).empty());
    EXPECT_TRUE(file(*create(1)).empty());
    const auto two = create(2), three = create(3);
    makePictures(*two, m_folder.path(), CProgress());
    EXPECT_EQ(file(*two), file(*three));
    EXPECT_TRUE(fs::exists(file(*three)));
    m_params.common.seed = 99;
    EXPECT_NE(file(*create(2)), file(*two));
}

TEST_F(SlowTwigPicture, FollowsTheLeavesPicture) {
    const auto before = create(2);
    makePictures(*before, m_folder.path(), CProgress());
    m_params.text.leafTexture = "leaf:maple season=10.2 autumn=#d01010";
    const auto after = create(2);
    makePictures(*after, m_folder.path(), CProgress());
    ASSERT_NE(file(*after), file(*before));
    const Seen seen = seenOf(readPngs(file(*after)));
    EXPECT_LT(seen.green, 0.3 * seen.opaque);
}

/// Two processes may draw the same leaf at the same time.
TEST_F(SlowTwigPicture, StaysWhenARecipeIsDrawnAgain) {
    const auto model = create(2);
    makePictures(*model, m_folder.path(), CProgress());
    const fs::path before = file(*model), leaf = textureOf(m_params, Surface::Leaf, m_folder.path());
    fs::last_write_time(leaf, fs::last_write_time(leaf) + std::chrono::seconds(5));
    EXPECT_EQ(file(*model), before);
}

TEST_F(TwigPicture, FollowsAPictureThatIsWrittenAnew) {
    const fs::path leaf = m_folder.path() / "own.png";
    makePictures(m_params, CProgress());
    fs::copy_file(textureOf(m_params, Surface::Leaf, m_folder.path()), leaf);
    m_params.text.leafTexture = "own.png";
    const auto model = create(2);
    const fs::path before = file(*model);
    fs::last_write_time(leaf, fs::last_write_time(leaf) + std::chrono::seconds(5));
    EXPECT_NE(file(*model), before);
}

TEST_F(TwigPicture, IsNotMadeOfPicturesThatCannotBeRead) {
    m_params.text.leafTexture = "leaf.jpg";
    EXPECT_FALSE(create(2)->twig);
    EXPECT_EQ(create(2)->leaves()->surface(), Surface::Leaf);
    m_params.text.leafTexture = "missing.png";
    EXPECT_THROW(makePictures(*create(2), m_folder.path(), CProgress()), CError);
}

TEST_F(TwigPicture, StandsForTheLastStemsAndTheirLeaves) {
    const auto model = create(2);
    ASSERT_TRUE(model->cards);
    EXPECT_EQ(model->cards->surface, Surface::Twig);
    EXPECT_EQ(model->leaves()->vertexCount(), 0u);
    EXPECT_EQ(model->stems.back()->vertexCount(), 0u);
    EXPECT_GT(model->stems[1]->vertexCount(), 0u);
    CTreeCreator creator; // one that keeps what it made
    creator.create(m_params, detailOf(Model::Full, 2), CProgress(2));
    weberPenn(m_params).leaves = 2;
    const auto few = creator.create(m_params, detailOf(Model::Full, 2), CProgress(2));
    EXPECT_FALSE(few->cards);
    EXPECT_GT(few->leaves()->vertexCount(), 0u);
    EXPECT_GT(few->stems.back()->vertexCount(), 0u);
}

TEST_F(SlowTwigPicture, GoesWithTheModel) {
    const fs::path path = m_folder.path() / "aspen.obj";
    exportModel(*create(2), m_folder.path(), path, CProgress(2));
    EXPECT_TRUE(fs::exists(m_folder.path() / "aspen_twig.png"));
    EXPECT_FALSE(fs::exists(m_folder.path() / "aspen_blossom.png"));
}

} // namespace stromar::test
