#include "cli/Cli.h"
#include <gtest/gtest.h>

namespace stromar::test {

TEST(CheckCommand, APresetIsSoundAtEveryLevelOfDetail) {
    for (const char* lod : {"0", "1", "2", "3"}) {
        const ProcessResult run = cli({"check", kAspen, "--lod", lod});
        EXPECT_EQ(run.status, 0) << run.out << run.err;
        const bool cards = std::string_view(lod) >= "2";
        for (const char* row : {"mesh", "trunk", "branches 1", "all wood", "tilted normals", "are one surface with their parents, 0 have", "all sound"})
            EXPECT_NE(run.out.find(row), std::string::npos) << row;
        for (const char* row : {"branches 2", "leaves"})
            EXPECT_EQ(run.out.find(row) == std::string::npos, cards) << row;
        EXPECT_EQ(run.out.find("twigs") != std::string::npos, cards);
    }
}

/// Trunks that turn back inside their own thickness.
TEST(CheckCommand, FailsWhenSomethingIsWrong) {
    const ProcessResult run = cli({"check", kAspen, "--set", "Levels=1", "--set", "0SegSplits=1", "--set",
                                   "0SplitAngle=170", "--set", "Ratio=0.2", "--set", "0CurveRes=6"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("something is wrong"), std::string::npos) << run.out;
}

TEST(Info, SaysWhatLeafAreaIsKept) {
    const auto kept = [](const std::string& set, const char* lod) {
        return Json::parse(cli({"info", kAspen, "--set", set, "--lod", lod}).out).at("leaf_area_kept").get<double>();
    };
    for (const char* lod : {"0", "1", "2", "3"}) EXPECT_GT(kept("Leaves=25", lod), *lod < '2' ? 0.9 : 0.5) << lod; // cards cover as much with less
    EXPECT_GT(kept("Leaves=5", "3"), 0.9) << "too few for cards of twigs: thinned and enlarged";
    const Json simple = Json::parse(cli({"info", kAspen, "--set", "Leaves=800", "--model", "simple"}).out);
    EXPECT_LT(simple.at("leaf_area_kept").get<double>(), 0.6) << "as many as a slider can be followed with";
}

TEST(ExportCommand, TakesEveryRowOfTheTableOfChoices) {
    const CTemporaryFolder folder;
    const ProcessResult run =
        cli(smallTree("export", {"-o", (folder / "a.glb").string(), "--model", "full", "--lod", "0", "--lods",
                                 "one-file", "--scale", "100", "--up", "y", "--textures", "copy"}));
    EXPECT_EQ(run.status, 0) << run.err;
    std::set<std::string> expected{"a.glb"};
    for (const char* surface : {"bark", "bark_1", "bark_2", "leaf", "twig"})
        for (const char* map : {"", "_normal"}) expected.insert("a_" + std::string(surface) + map + ".png");
    for (const char* surface : {"leaf", "twig"}) expected.insert("a_" + std::string(surface) + "_roughness.png"); // barks are as rough all over
    EXPECT_EQ(folder.names(), expected);
    EXPECT_EQ(cli(smallTree("export", {"-o", (folder / "b.stl").string(), "--lods", "one-file"})).status, 2);
    EXPECT_EQ(cli(smallTree("export", {"-o", (folder / "b.glb").string(), "--up", "z"})).status, 2);
    EXPECT_EQ(cli(smallTree("export", {"-o", (folder / "b.glb").string(), "--up", "sideways"})).status, 2);
    EXPECT_EQ(folder.names(), expected);
}

} // namespace stromar::test
