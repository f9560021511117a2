#include "Checkout.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Pictures.h"
#include "stromar/app/Export.h"
#include "stromar/params/TreeFile.h"
#include "stromar/texture/Draw.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace stromar {
namespace {

namespace fs = std::filesystem;

class RecipeTest : public ::testing::Test {
protected:
    RecipeTest() {
        setenv("XDG_CACHE_HOME", m_folder.path().c_str(), 1);
        weberPenn(m_params).levels = 2;
        m_params.text.barkTexture = "bark:birch seed=3";
    }
    ~RecipeTest() override { unsetenv("XDG_CACHE_HOME"); }
    static void write(const fs::path& file, int hoursAgo) {
        writeFile(file, std::string(500, 'x'));
        const timespec then{time(nullptr) - 3600 * hoursAgo, 0}, both[] = {then, then};
        utimensat(AT_FDCWD, file.c_str(), both, 0);
    }
    static std::vector<std::string> namesIn(const fs::path& folder) {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }
    fs::path bark() const { return textureOf(m_params, Surface::Bark, "/some/folder"); }

    test::CTemporaryFolder m_folder;
    CParams m_params;
};

TEST_F(RecipeTest, WhatIsLongestUnusedGoesFirst) {
    const fs::path folder = pictureCache() / "textures";
    fs::create_directories(folder);
    for (int age = 0; age < 4; ++age)
        for (const char* map : {".png", "_normal.png"}) write(folder / (std::to_string(age) + map), age);
    EXPECT_EQ(pictureCacheSize(), 4000u);
    trimPictureCache(4000);
    EXPECT_EQ(pictureCacheSize(), 4000u);
    const auto written = fs::last_write_time(folder / "3.png");
    EXPECT_TRUE(isKept(folder / "3.png"));
    EXPECT_FALSE(isKept(folder / "4.png"));
    EXPECT_EQ(fs::last_write_time(folder / "3.png"), written) << "other pictures are named after it";
    trimPictureCache(2500);
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"0.png", "0_normal.png", "3.png", "3_normal.png"})) << "those that were used last";
    trimPictureCache(1);
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"0.png", "0_normal.png", "3.png", "3_normal.png"})) << "and may be in use";
    trimPictureCache(0);
    EXPECT_EQ(pictureCacheSize(), 0u);
    makePictures(m_params, CProgress());
    EXPECT_TRUE(fs::exists(bark())) << "drawn again when it is needed";
}

TEST_F(RecipeTest, IsDrawnOnceAndKept) {
    EXPECT_FALSE(fs::exists(bark()));
    makePictures(m_params, CProgress());
    ASSERT_TRUE(fs::exists(bark()));
    EXPECT_TRUE(fs::exists(bark().parent_path() / (bark().stem().string() + "_normal.png")));
    const auto drawn = fs::last_write_time(bark());
    makePictures(m_params, CProgress());
    EXPECT_EQ(fs::last_write_time(bark()), drawn);
    const fs::path first = bark();
    m_params.text.barkTexture = "bark:birch seed=4";
    EXPECT_NE(bark(), first);
}

TEST_F(RecipeTest, HasAPreviewUntilTheWholeIsThere) {
    m_params.text.leafTexture = "leaf:maple";
    for (const Surface surface : {Surface::Leaf, Surface::Bark}) {
        const fs::path small = textureOf(m_params, surface, {}, PictureQuality::Preview), whole = textureOf(m_params, surface, {});
        EXPECT_NE(small, whole);
        fs::remove_all(pictureCache());
        makePictures(m_params, CProgress(), PictureQuality::Preview);
        EXPECT_TRUE(fs::exists(small));
        EXPECT_FALSE(fs::exists(whole));
        makePictures(m_params, CProgress());
        EXPECT_TRUE(fs::exists(whole));
        fs::remove(small);
        makePictures(m_params, CProgress(), PictureQuality::Preview);
        EXPECT_FALSE(fs::exists(small)) << "the whole is better";
    }
}

TEST_F(RecipeTest, OfLeavesFollowsTheMonth) {
    m_params.text.leafTexture = "leaf:maple";
    const auto at = [&](double month) {
        m_params.common.season = month;
        return pictureOf(m_params, Surface::Leaf);
    };
    EXPECT_EQ(at(7), "leaf:maple");
    EXPECT_EQ(at(8), "leaf:maple") << "summer is one picture";
    EXPECT_EQ(at(9.8), "leaf:maple season=9.8");
    EXPECT_EQ(at(9.83), at(9.8)) << "in steps";
    m_params.common.evergreen = 1;
    EXPECT_EQ(at(9.8), "leaf:maple");
    m_params.common.evergreen = 0;
    m_params.text.leafTexture = "leaf:maple season=7";
    EXPECT_EQ(at(9.8), "leaf:maple season=7") << "the recipe's own month";
    m_params.text.leafTexture = "mine.png";
    EXPECT_EQ(at(9.8), "mine.png");
}

TEST_F(RecipeTest, OfBlossomsAndFruitsIsDrawnOnlyForTreesThatHaveSome) {
    const fs::path blossom = textureOf(m_params, Surface::Blossom, {});
    EXPECT_TRUE(texturesOf(m_params, {})[std::size_t(Surface::Blossom)].empty());
    makePictures(m_params, CProgress());
    EXPECT_FALSE(fs::exists(blossom));
    m_params.common.blossoms = 3;
    makePictures(m_params, CProgress());
    EXPECT_TRUE(fs::exists(blossom));
    EXPECT_EQ(texturesOf(m_params, {})[std::size_t(Surface::Blossom)], blossom);
}

TEST_F(RecipeTest, GoesWithTheExportedModel) {
    const auto model = CTreeCreator().create(m_params, detailOf(Model::Simple), CProgress());
    exportModel(*model, {}, m_folder.path() / "tree.obj", CProgress());
    EXPECT_EQ(readFile(m_folder.path() / "tree_bark.png"), readFile(bark()));
}

TEST_F(RecipeTest, ExportedBlossomsAndFruitsHaveTheirMaterials) {
    CParams params = CTreeFile::read(test::inSource("presets/apple.tree")).params();
    weberPenn(params).level[1].branches = 8;
    weberPenn(params).level[2].branches = 8;
    params.common.season = 9;
    const auto model = CTreeCreator().create(params, detailOf(Model::Full), CProgress());
    exportModel(*model, {}, m_folder.path() / "tree.obj", CProgress());
    const std::string library = readFile(m_folder.path() / "tree.mtl");
    EXPECT_NE(library.find("newmtl fruit"), std::string::npos);
    EXPECT_EQ(library.find("newmtl blossom"), std::string::npos) << "none is there in September";
    EXPECT_TRUE(fs::exists(m_folder.path() / "tree_fruit.png"));
    EXPECT_NE(readFile(m_folder.path() / "tree.obj").find("usemtl fruit"), std::string::npos);
}

TEST_F(RecipeTest, WhatIsWrongWithItIsSaidAndNothingIsWritten) {
    m_params.text.barkTexture = "bark:brich";
    const auto model = CTreeCreator().create(m_params, detailOf(Model::Simple), CProgress());
    try {
        exportModel(*model, {}, m_folder.path() / "tree.obj", CProgress());
        FAIL();
    } catch (const CError& e) {
        EXPECT_NE(std::string(e.what()).find("did you mean 'birch'"), std::string::npos) << e.what();
    }
    EXPECT_FALSE(fs::exists(m_folder.path() / "tree.obj"));
}

TEST_F(RecipeTest, IsNoPath) {
    EXPECT_TRUE(isRecipe("bark:oak"));
    EXPECT_FALSE(isRecipe("bark.png"));
    EXPECT_FALSE(isRecipe(""));
    m_params.text.barkTexture = "mine.png";
    EXPECT_EQ(bark(), "/some/folder/mine.png");
    EXPECT_NO_THROW(makePictures(m_params, CProgress()));
}

TEST(Recipes, OfThePresetsAreWellWritten) {
    for (const auto& file : fs::directory_iterator(fs::path(test::inSource("presets")))) {
        const CParams params = CTreeFile::read(file.path()).params();
        EXPECT_TRUE(isRecipe(params.text.barkTexture)) << file.path();
        CProgress cancelled;
        cancelled.cancel();
        try {
            makePictures(params, cancelled); // as far as the drawing
        } catch (const CCancelled&) {
        }
    }
}

} // namespace
} // namespace stromar
