#include "stromar/app/Pictures.h"
#include "stromar/app/Export.h"
#include "stromar/params/TreeFile.h"
#include "stromar/texture/Draw.h"
#include "util/TemporaryFolder.h"
#include <cstdlib>
#include <gtest/gtest.h>

namespace stromar {
namespace {

namespace fs = std::filesystem;

class RecipeTest : public ::testing::Test {
protected:
    RecipeTest() {
        setenv("XDG_CACHE_HOME", m_folder.path().c_str(), 1);
        m_params.global.levels = 2;
        m_params.text.barkTexture = "bark:birch seed=3";
    }
    ~RecipeTest() override { unsetenv("XDG_CACHE_HOME"); }
    fs::path bark() const { return textureOf(m_params, Surface::Bark, "/some/folder"); }

    test::CTemporaryFolder m_folder;
    CParams m_params;
};

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

TEST_F(RecipeTest, GoesWithTheExportedModel) {
    const auto model = CTreeCreator().create(m_params, detailOf(Model::Simple), CProgress());
    exportModel(*model, {}, m_folder.path() / "tree.obj", CProgress());
    EXPECT_EQ(readFile(m_folder.path() / "tree_bark.png"), readFile(bark()));
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
    for (const auto& file : fs::directory_iterator(fs::path(STROMAR_SOURCE) / "presets")) {
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
