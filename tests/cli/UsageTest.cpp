// Exit status 0, 1, 2; messages on standard error, data on standard output.
#include "cli/Cli.h"
#include "stromar/util/FileSet.h"
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
void expectStatus(int status, const Words& words, const std::string& said = {}) {
    const ProcessResult run = cli(words);
    std::string line;
    for (const std::string& word : words) line += word + " ";
    EXPECT_EQ(run.status, status) << line << "\n" << run.err;
    if (status == 0) return;
    EXPECT_EQ(run.out, "") << line;
    EXPECT_NE(run.err, "") << line;
    EXPECT_NE(run.err.find(said), std::string::npos) << line << "\n" << run.err;
}

Words inSmallTree(const Words& more) { return smallTree("info", more); }
} // namespace

TEST(Usage, WrongWordsEndWithTwo) {
    expectStatus(2, {});
    expectStatus(2, {"frobnicate"});
    expectStatus(2, {"info"});
    expectStatus(2, {"info", kAspen, "--frobnicate"}, "--frobnicate");
    expectStatus(2, {"info", kAspen, "second.tree"}, "second.tree");
    expectStatus(2, {"params", "--xml"});
    expectStatus(2, {"params", "--json", "--markdown"});
    expectStatus(2, {"structure", kAspen, "--model", "full"}, "--model");
}

TEST(Usage, WrongModelsEndWithTwo) {
    expectStatus(2, inSmallTree({"--model", "best"}), "best");
    for (const char* lod : {"-1", "4", "fine", "1.5"}) expectStatus(2, inSmallTree({"--lod", lod}));
    for (const char* lod : {"0", "3"}) {
        expectStatus(2, inSmallTree({"--model", "simple", "--lod", lod}), "lod");
        expectStatus(2, inSmallTree({"--lod", lod, "--model", "simple"}), "lod");
    }
    expectStatus(0, inSmallTree({"--model", "full", "--lod", "3"}));
    expectStatus(0, inSmallTree({"--model", "simple"}));
}

TEST(Usage, WrongCommonFlagsEndWithTwo) {
    expectStatus(2, inSmallTree({"--variation", "maybe"}), "maybe");
    for (const char* threads : {"0", "-1", "two", "1.5"}) expectStatus(2, inSmallTree({"--threads", threads}));
    for (const char* seed : {"x", "1.5", ""}) expectStatus(2, inSmallTree({"--seed", seed}));
    expectStatus(2, inSmallTree({"--threads"}));
    expectStatus(2, inSmallTree({"--set"}));
}

TEST(Usage, WrongSettingsEndWithTwo) {
    expectStatus(2, inSmallTree({"--set", "1DwnAngle=30"}), "1DownAngle");
    expectStatus(2, inSmallTree({"--set", "Qqqqqqqq=30"}), "Qqqqqqqq");
    expectStatus(2, inSmallTree({"--set", "0DownAngle=30"}), "0DownAngle");
    expectStatus(2, inSmallTree({"--set", "Scale"}), "Scale");
    expectStatus(2, inSmallTree({"--set", "=3"}));
    for (const char* value : {"tall", "", "1,5", "1m", "nan", "inf", "0x10"})
        expectStatus(2, inSmallTree({"--set", std::string("Scale=") + value}), "Scale");
    expectStatus(2, inSmallTree({"--set", "1Branches=3.5"}), "1Branches");
    expectStatus(2, inSmallTree({"--set", "Shape=conic"}), "conical");
    expectStatus(2, inSmallTree({"--set", "Method=strands"}), "strands");
}

TEST(Usage, SettingsInEveryFormAreTaken) {
    expectStatus(0, inSmallTree({"--set", "Scale=12", "--set", "Shape=conical", "--set", "0Curve=-1e1", "--set",
                                 "Species=a = b"}));
    const auto changed = Json::parse(cli(inSmallTree({"--set", "Species=a = b"})).out);
    EXPECT_EQ(changed.at("species"), "a = b");
    expectStatus(0, inSmallTree({"--set=Scale=12", "--seed=7", "--lod=1"}));
}

TEST(Usage, OutOfRangeIsClampedWithAWarning) {
    const ProcessResult run = cli(inSmallTree({"--set", "LobeDepth=7"}));
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("LobeDepth"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("warning"), std::string::npos) << run.err;
    const ProcessResult most = cli(inSmallTree({"--set", "LobeDepth=1"}));
    EXPECT_EQ(most.err, "");
    EXPECT_EQ(Json::parse(run.out).at("bounds"), Json::parse(most.out).at("bounds"));
}

TEST(Usage, QuietIsSilent) {
    const CTemporaryFolder folder;
    const ProcessResult run = cli(inSmallTree({"--set", "LobeDepth=7", "--quiet"}));
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    const ProcessResult exported = cli(smallTree("export", {"-o", (folder / "x.obj").string(), "--quiet"}));
    EXPECT_EQ(exported.status, 0);
    EXPECT_EQ(exported.out + exported.err, "");
    EXPECT_NE(cli({"info", "none.tree", "--quiet"}).err, "") << "errors are no chatter";
}

TEST(Usage, UnreadableFilesEndWithOne) {
    const CTemporaryFolder folder;
    writeFile(folder / "broken.tree", "Format = 1\nScale = 10\n1DownAngle = thirty\n");
    writeFile(folder / "empty.tree", "");
    writeFile(folder / "binary.tree", std::string("\x7f\x45\0\1\2\3", 6));
    writeFile(folder / "newer.tree", "Format = 99\nScale = 10\n");
    expectStatus(1, {"info", (folder / "none.tree").string()}, "none.tree");
    expectStatus(1, {"info", folder.path().string()}, folder.path().filename().string());
    expectStatus(1, {"info", (folder / "broken.tree").string()}, "broken.tree:3:");
    for (const char* name : {"empty.tree", "binary.tree", "newer.tree"})
        for (const char* command : {"info", "structure"}) expectStatus(1, {command, (folder / name).string()}, name);
}

TEST(Usage, WarningsOfTheFileNameThePlace) {
    const CTemporaryFolder folder;
    writeFile(folder / "odd.tree", "Format = 1\nLevels = 1\nNoSuchKey = 4\nLobeDepth = 7\n");
    const ProcessResult run = cli({"info", (folder / "odd.tree").string()});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("odd.tree:3:"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("odd.tree:4:"), std::string::npos) << run.err;
    EXPECT_TRUE(Json::accept(run.out)) << run.out;
}

TEST(Usage, WrongRecipesNameThePlace) {
    const CTemporaryFolder folder;
    const std::string file = (folder / "wrong.tree").string();
    writeFile(file,
              "Format = 1\nLevels = 2\n  BarkTexture =  \"bark:furowed\"\nLeafTexture = \"leaf:oak lobes=600\"\n");
    const ProcessResult run = cli({"info", file});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("wrong.tree:3:18: error: there is no bark 'furowed', did you mean 'furrowed'?"),
              std::string::npos)
        << run.err;
    EXPECT_NE(run.err.find("wrong.tree:4:15: error: "), std::string::npos) << run.err;
    const Words mended{"--set", "BarkTexture=bark:furrowed", "--set", "LeafTexture="};
    EXPECT_EQ(cli({"info", file, mended[0], mended[1], mended[2], mended[3]}).status, 0);
    EXPECT_EQ(cli(inSmallTree({"--set", "BarkTexture=bark:furowed"})).status, 2);
}

TEST(Usage, ATooLargeTreeEndsWithOne) {
    for (const char* command : {"info", "structure"})
        expectStatus(1, {command, kAspen, "--set", "1Branches=5000", "--set", "2Branches=5000"}, "million vertices");
}

TEST(Usage, HelpIsData) {
    for (const Words& words : {Words{"--help"}, Words{"info", "--help"}, Words{"export", "--help"}}) {
        const ProcessResult run = cli(words);
        EXPECT_EQ(run.status, 0);
        EXPECT_NE(run.out, "");
        EXPECT_EQ(run.err, "");
    }
    const std::string help = cli({"--help"}).out;
    for (const char* command : {"info", "structure", "export", "params", "formats"})
        EXPECT_NE(help.find(command), std::string::npos) << command;
}

TEST(Usage, AFullDiskEndsWithOne) {
    for (const Words& words : {smallTree("info"), smallTree("structure"), Words{"params"}, Words{"params", "--json"},
                               Words{"params", "--markdown"}, Words{"formats"}}) {
        const ProcessResult run = cli(words, {.output = "/dev/full"});
        EXPECT_EQ(run.status, 1) << words.front() << run.err;
        EXPECT_NE(run.err, "") << words.front();
    }
}

} // namespace stromar::test
