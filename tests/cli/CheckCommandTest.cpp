#include "cli/Cli.h"
#include <gtest/gtest.h>

namespace stromar::test {

TEST(CheckCommand, APresetIsSoundAtEveryLevelOfDetail) {
    for (const char* lod : {"0", "1", "2", "3"}) {
        const ProcessResult run = cli({"check", kAspen, "--lod", lod});
        EXPECT_EQ(run.status, 0) << run.out << run.err;
        for (const char* row : {"mesh", "trunk", "branches 1", "branches 2", "leaves", "tilted normals", "all sound"})
            EXPECT_NE(run.out.find(row), std::string::npos) << row;
    }
}

/// Trunks that turn back inside their own thickness.
TEST(CheckCommand, FailsWhenSomethingIsWrong) {
    const ProcessResult run = cli({"check", kAspen, "--set", "Levels=1", "--set", "0SegSplits=1", "--set",
                                   "0SplitAngle=170", "--set", "Ratio=0.2", "--set", "0CurveRes=6"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("something is wrong"), std::string::npos) << run.out;
}

TEST(Info, SaysWhatLeafAreaThinningCosts) {
    double last = 1;
    for (const char* lod : {"0", "1", "2", "3"}) {
        const double kept = Json::parse(cli({"info", kAspen, "--lod", lod}).out).at("leaf_area_kept");
        EXPECT_LE(kept, last);
        EXPECT_GT(kept, 0.2);
        last = kept;
    }
    EXPECT_LT(last, 0.6);
}

TEST(ExportCommand, TakesEveryRowOfTheTableOfChoices) {
    const CTemporaryFolder folder;
    const ProcessResult run =
        cli(smallTree("export", {"-o", (folder / "a.glb").string(), "--model", "full", "--lod", "0", "--lods",
                                 "one-file", "--scale", "100", "--up", "y", "--textures", "copy"}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(folder.names(), (std::set<std::string>{"a.glb", "a_bark.png", "a_bark_normal.png", "a_bark_roughness.png",
                                                     "a_leaf.png", "a_leaf_normal.png", "a_leaf_roughness.png"}));
    EXPECT_EQ(cli(smallTree("export", {"-o", (folder / "b.stl").string(), "--lods", "one-file"})).status, 2);
    EXPECT_EQ(cli(smallTree("export", {"-o", (folder / "b.glb").string(), "--up", "z"})).status, 2);
    EXPECT_EQ(cli(smallTree("export", {"-o", (folder / "b.glb").string(), "--up", "sideways"})).status, 2);
    EXPECT_EQ(folder.names().size(), 7u);
}

} // namespace stromar::test
