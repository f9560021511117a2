#include "cli/Cli.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>

namespace stromar::test {

TEST(TextureCommand, WritesThePictureAndItsRelief) {
    const CTemporaryFolder folder;
    const std::string path = (folder.path() / "oak.png").string();
    const ProcessResult run = cli({"texture", "furrowed", "ridges=5", "seed=3", "--size", "64", "-o", path});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* name : {"oak.png", "oak_normal.png", "oak_roughness.png", "oak_height.png"})
        EXPECT_GT(std::filesystem::file_size(folder.path() / name), 60u) << name;
}

TEST(TextureCommand, WrongRecipesEndWithTwoAndLeaveNothing) {
    const CTemporaryFolder folder;
    const std::string path = (folder.path() / "a.png").string();
    for (const auto& [words, said] : {std::pair{Words{"texture", "furowed", "-o", path}, "furrowed"},
                                      {Words{"texture", "birch", "ridges=many", "-o", path}, "ridges"},
                                      {Words{"texture", "birch", "-o", path + ".jpg"}, ".png"},
                                      {Words{"texture", "birch", "--size", "3", "-o", path}, "size"},
                                      {Words{"texture", "-o", path}, "recipe"}}) {
        const ProcessResult run = cli(words);
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TextureCommand, AFolderThatIsNotThereEndsWithOne) {
    EXPECT_EQ(cli({"texture", "birch", "--size", "32", "-o", "/no/such/folder/a.png"}).status, 1);
}

} // namespace stromar::test
