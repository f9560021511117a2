#include "cli/Cli.h"
#include "stromar/app/Formats.h"
#include "stromar/util/FileSet.h"
#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace stromar::test {

namespace {
namespace fs = std::filesystem;

/// Whether a file in the folder has at least so many bytes, within ten seconds.
bool waitForBytes(const CTemporaryFolder& folder, std::uintmax_t bytes) {
    for (int i = 0; i < 10'000; ++i) {
        for (const std::string& name : folder.names()) {
            std::error_code vanished;
            const auto size = fs::file_size(folder / name, vanished);
            if (!vanished && size >= bytes) return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}
} // namespace

TEST(ExportCommand, AnEngineGivesDefaultsThatFlagsChange) {
    const CTemporaryFolder folder;
    ProcessResult run = cli(exportTo(folder / "tree", {"--lods", "none", "--for", "unity"}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(folder.names().contains("tree.glb")) << "the engine's format, one level of detail";
    EXPECT_TRUE(folder.names().contains("tree_bark_mask.png")) << "the engine's maps";
    EXPECT_FALSE(folder.names().contains("tree_LOD0.glb"));
    run = cli(exportTo(folder / "two", {"--for", "maya"}));
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("maya"), std::string::npos);
}

TEST(ExportCommand, SettingsOfAFile) {
    const CTemporaryFolder folder;
    writeFile(folder / "mine.export", "format = .obj\ntwo-sided = no\nscale = 100\n");
    ProcessResult run = cli(exportTo(folder / "tree", {"--settings", (folder / "mine.export").string()}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(folder.names().contains("tree.obj"));
    writeFile(folder / "wrong.export", "scale = 100\nup = down\n");
    run = cli(exportTo(folder / "three.glb", {"--settings", (folder / "wrong.export").string()}));
    EXPECT_NE(run.status, 0);
    EXPECT_NE(run.err.find("wrong.export:2:6: error: 'up' is one of format, y, z, not 'down'"), std::string::npos) << run.err;
    EXPECT_FALSE(folder.names().contains("three.glb"));
}

TEST(ExportCommand, ASolidIsReportedAsThat) {
    const CTemporaryFolder folder;
    const ProcessResult run = cli(exportTo(folder / "tree.stl", {"--watertight", "voxel", "0.1"}));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("tree.stl: the wood as one solid"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("triangles"), std::string::npos) << "those of the model are not in the file";
}

TEST(ExportCommand, WritesEveryFormat) {
    for (const Format& format : formatTable()) {
        const CTemporaryFolder folder;
        const std::string name = "tree" + std::string(format.ending);
        const ProcessResult run = cli(exportTo(folder / name));
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.out, "") << "the model is the data";
        EXPECT_NE(run.err.find("triangles"), std::string::npos) << run.err;
        EXPECT_GT(fs::file_size(folder / name), 5'000u) << format.ending;
        for (const char* picture : {"tree_bark.png", "tree_leaf.png"})
            EXPECT_EQ(fs::exists(folder / picture), format.pictures == Pictures::Beside) << format.ending;
    }
}

TEST(SlowExportCommand, GivesTheSameBytesForEveryNumberOfThreads) {
    for (const Format& format : formatTable()) {
        const CTemporaryFolder one, two;
        const std::string name = "tree" + std::string(format.ending);
        ASSERT_EQ(cli({"export", kAspen, "--lod", "2", "-o", (one / name).string(), "--threads", "1"}).status, 0);
        ASSERT_EQ(cli({"export", kAspen, "--lod", "2", "-o", (two / name).string(), "--threads", "2"}).status, 0);
        ASSERT_EQ(one.names(), two.names());
        for (const std::string& file : one.names()) EXPECT_TRUE(readFile(one / file) == readFile(two / file)) << file;
    }
}

TEST(ExportCommand, WritesIntoTheCurrentFolder) {
    const CTemporaryFolder folder;
    const ProcessResult run = cli(exportTo("here.obj"), {.folder = folder.path().string()});
    EXPECT_EQ(run.status, 0) << run.err;
    std::set<std::string> expected{"here.obj", "here.mtl", "here_leaf_opacity.png", "here_leaf_roughness.png"};
    for (const std::string surface : {"bark", "bark_1", "bark_2", "leaf"})
        for (const char* map : {"", "_normal"}) expected.insert("here_" + surface + map + ".png");
    EXPECT_EQ(folder.names(), expected);
}

TEST(ExportCommand, FindsPicturesFromTheTreesFolder) {
    const CTemporaryFolder folder;
    fs::create_directories(folder / "trees/pictures");
    writeFile(folder / "trees/pictures/own.png", "a picture");
    writeFile(folder / "trees/own.tree", "Format = 1\nLevels = 1\nBarkTexture = pictures/own.png\n");
    const std::string out = (folder / "x.obj").string();
    const ProcessResult run = cli({"export", "own.tree", "-o", out}, {.folder = (folder / "trees").string()});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(readFile(folder / "x_bark.png"), "a picture");
}

TEST(ExportCommand, WrongUsageEndsWithTwo) {
    const CTemporaryFolder folder;
    EXPECT_EQ(cli({"export", kAspen}).status, 2);
    for (const char* name : {"x.obk", "x", "x.tree"}) {
        const ProcessResult run = cli(exportTo(folder / name));
        EXPECT_EQ(run.status, 2) << name;
        EXPECT_NE(run.err.find(".obj"), std::string::npos) << run.err;
    }
    EXPECT_EQ(cli(exportTo(folder / "x.obj", {"--model", "simple", "--lod", "1"})).status, 2);
    EXPECT_EQ(cli(exportTo(folder / "x.obj", {"--set", "Scale=tall"})).status, 2);
    EXPECT_TRUE(folder.names().empty());
}

TEST(ExportCommand, AFailureLeavesTheOlderFile) {
    const CTemporaryFolder folder;
    writeFile(folder / "broken.tree", "Scale = tall\n");
    writeFile(folder / "x.obj", "older");
    const std::string out = (folder / "x.obj").string();
    const Words failing[] = {{"export", (folder / "broken.tree").string(), "-o", out},
                             {"export", (folder / "none.tree").string(), "-o", out},
                             exportTo(out, {"--set", "BarkTexture=none.png"}),
                             exportTo(out, {"--set", "1Branches=5000", "--set", "2Branches=5000"})};
    for (const Words& words : failing) {
        const ProcessResult run = cli(words);
        EXPECT_EQ(run.status, 1) << run.err;
        EXPECT_EQ(readFile(folder / "x.obj"), "older");
        EXPECT_EQ(folder.names(), (std::set<std::string>{"broken.tree", "x.obj"}));
    }
}

TEST(ExportCommand, AMissingFolderEndsWithOne) {
    const CTemporaryFolder folder;
    const ProcessResult run = cli(exportTo(folder / "none" / "x.obj"));
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("x.obj: there is no folder"), std::string::npos) << "not of a picture: " << run.err;
    EXPECT_TRUE(folder.names().empty());
}

TEST(ExportCommand, AFullDiskLeavesTheOlderFile) {
    for (const Format& format : formatTable()) {
        const CTemporaryFolder folder;
        const std::string name = "x" + std::string(format.ending);
        writeFile(folder / name, "older");
        const ProcessResult run = cli({"export", kAspen, "-o", (folder / name).string()}, {.maxFileBytes = 1'500'000});
        EXPECT_EQ(run.status, 1) << format.ending << ": " << run.err;
        EXPECT_NE(run.err, "") << format.ending;
        EXPECT_EQ(readFile(folder / name), "older") << format.ending;
        EXPECT_EQ(folder.names(), std::set<std::string>{name}) << format.ending;
    }
}

TEST(SlowExportCommand, AnInterruptLeavesNoFile) {
    for (const Format& format : formatTable()) {
        const CTemporaryFolder folder;
        CProcess process(cliCommand(
            {"export", presetFile("ca_black_oak"), "-o", (folder / ("x" + std::string(format.ending))).string()}));
        const bool writing = waitForBytes(folder, 1'600'000); // more than the pictures have
        process.signal(SIGINT);
        const ProcessResult run = process.wait();
        EXPECT_TRUE(writing) << format.ending;
        EXPECT_EQ(run.status, 1) << format.ending << ": " << run.err;
        EXPECT_TRUE(folder.names().empty()) << format.ending << ": " << *folder.names().begin();
    }
}

TEST(ExportCommand, AnInterruptWhileGrowingLeavesNoFile) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "ThreadSanitizer delivers the signal only when the work is done";
#endif
    const CTemporaryFolder folder;
    CProcess process(cliCommand({"export", presetFile("weeping_willow"), "-o", (folder / "x.obj").string()}));
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    process.signal(SIGINT);
    const int status = process.wait().status;
    EXPECT_TRUE(status == 1 || status == -SIGINT) << status; // a slow start may come before the program listens
    EXPECT_TRUE(folder.names().empty());
}

} // namespace stromar::test
