#include "cli/Cli.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>

namespace stromar::test {

TEST(TextureCommand, WritesThePictureAndItsRelief) {
    const CTemporaryFolder folder;
    const std::string path = (folder.path() / "oak.png").string();
    const ProcessResult run = cli({"texture", "bark:furrowed", "ridges=5", "seed=3", "--size", "64", "-o", path});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* name : {"oak.png", "oak_normal.png", "oak_roughness.png", "oak_height.png"})
        EXPECT_GT(std::filesystem::file_size(folder.path() / name), 60u) << name;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "oak_translucency.png")) << "no light goes through bark";
    EXPECT_EQ(cli({"texture", "leaf:oak", "--size", "64", "-o", path}).status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "oak_translucency.png"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "oak_back.png"));
}

TEST(TextureCommand, WrongRecipesEndWithTwoAndLeaveNothing) {
    const CTemporaryFolder folder;
    const std::string path = (folder.path() / "a.png").string();
    for (const auto& [words, said] : {std::pair{Words{"texture", "bark:furowed", "-o", path}, "furrowed"},
                                      {Words{"texture", "bark:birch", "ridges=many", "-o", path}, "ridges"},
                                      {Words{"texture", "bark:birch", "-o", path + ".jpg"}, ".png"},
                                      {Words{"texture", "bark:birch", "--size", "3", "-o", path}, "size"},
                                      {Words{"texture", "leaf:oke", "-o", path}, "oak"},
                                      {Words{"texture", "birch", "-o", path}, "bark:"},
                                      {Words{"texture", "-o", path}, "recipe"}}) {
        const ProcessResult run = cli(words);
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TextureCommand, AFolderThatIsNotThereEndsWithOne) {
    EXPECT_EQ(cli({"texture", "bark:birch", "--size", "32", "-o", "/no/such/folder/a.png"}).status, 1);
}

} // namespace stromar::test
