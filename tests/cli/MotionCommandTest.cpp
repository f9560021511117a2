// Growth and wind from the command line: frames, loops, clamps, and what an interruption leaves.
#include "cli/Cli.h"
#include "stromar/app/Formats.h"
#include "stromar/util/FileSet.h"
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace stromar::test {
namespace {

TEST(Frames, OfGrowthAreNumberedAndEndWithTheGrownTree) {
    const CTemporaryFolder folder;
    const ProcessResult run = cli(exportTo(folder / "oak.obj", {"--frames", "4"}));
    ASSERT_EQ(run.status, 0) << run.err;
    std::set<std::string> expected{"oak_leaf_opacity.png", "oak_leaf_roughness.png"};
    for (const std::string surface : {"bark", "bark_1", "bark_2", "leaf"}) // the first frame has no use for some
        for (const char* map : {"", "_normal"}) expected.insert("oak_" + surface + map + ".png");
    for (const std::string number : {"0001", "0002", "0003", "0004"})
        for (const char* ending : {".obj", ".mtl"}) expected.insert("oak_" + number + ending);
    EXPECT_EQ(folder.names(), expected) << "pictures are shared";
    for (int i = 1; i < 4; ++i)
        EXPECT_LT(std::filesystem::file_size(folder / ("oak_000" + std::to_string(i) + ".obj")),
                  std::filesystem::file_size(folder / ("oak_000" + std::to_string(i + 1) + ".obj")));
    ASSERT_EQ(cli(exportTo(folder / "whole.ply", {})).status, 0);
    ASSERT_EQ(cli(exportTo(folder / "grow.ply", {"--frames", "2"})).status, 0);
    EXPECT_EQ(readFile(folder / "whole.ply"), readFile(folder / "grow_0002.ply"));
    ASSERT_EQ(cli(exportTo(folder / "half.ply", {"--age", "0.5"})).status, 0);
    EXPECT_EQ(readFile(folder / "half.ply"), readFile(folder / "grow_0001.ply"));
}

TEST(Frames, AreTheSameForAnyNumberOfThreads) {
    const CTemporaryFolder one, four;
    for (const Words& motion : {Words{"--frames", "5"}, Words{"--frames", "5", "--wind-strength", "1"}}) {
        Words alone = exportTo(one / "x.glb", motion), together = exportTo(four / "x.glb", motion);
        alone.insert(alone.end(), {"--threads", "1"});
        together.insert(together.end(), {"--threads", "4"});
        ASSERT_EQ(cli(alone).status, 0);
        ASSERT_EQ(cli(together).status, 0);
        ASSERT_EQ(one.names().size(), 5u);
        for (const std::string& name : one.names()) EXPECT_TRUE(readFile(one / name) == readFile(four / name)) << name;
    }
}

TEST(Frames, InTheWindAreALoopOfOneTree) {
    const CTemporaryFolder folder;
    ASSERT_EQ(cli(exportTo(folder / "w.ply", {"--frames", "3", "--wind-strength", "1", "--seconds", "2"})).status, 0);
    ASSERT_EQ(cli(exportTo(folder / "still.ply", {})).status, 0);
    std::set<std::string> contents{readFile(folder / "still.ply")};
    for (const char* name : {"w_0001.ply", "w_0002.ply", "w_0003.ply"}) {
        contents.insert(readFile(folder / name));
        EXPECT_EQ(std::filesystem::file_size(folder / name), std::filesystem::file_size(folder / "still.ply"))
            << "the same vertices";
    }
    EXPECT_EQ(contents.size(), 4u) << "each elsewhere";
    ASSERT_EQ(cli(exportTo(folder / "calm.ply", {"--frames", "1", "--wind-strength", "0"})).status, 0);
    EXPECT_EQ(readFile(folder / "calm_0001.ply"), readFile(folder / "still.ply")) << "bit by bit";
}

TEST(Frames, ValuesOutOfRangeAreClampedAndNoNumbersRefused) {
    const CTemporaryFolder folder;
    const auto with = [&](const Words& more) { return cli(exportTo(folder / "x.ply", more)); };
    for (const Words& beyond : {Words{"--wind-strength", "99"},
                                {"--wind-strength", "-1"},
                                {"--gusts", "2"},
                                {"--fps", "0"},
                                {"--wind-direction", "720"},
                                {"--age", "2"}}) {
        const ProcessResult run = with(beyond);
        EXPECT_EQ(run.status, 0) << beyond.front() << run.err;
        EXPECT_NE(run.err.find("warning"), std::string::npos) << beyond.front();
    }
    for (const char* flag : {"--wind-strength", "--gusts", "--fps", "--wind-direction", "--seconds"})
        for (const char* wrong : {"nan", "strong", "inf"}) EXPECT_EQ(with({flag, wrong}).status, 2) << flag << wrong;
    for (const char* wrong : {"0", "-3", "many", "1000000000"}) EXPECT_EQ(with({"--frames", wrong}).status, 2) << wrong;
}

TEST(Frames, BeforeItsLifeATreeIsAnEmptyFileOfEveryFormat) {
    for (const Format& format : formatTable()) {
        const CTemporaryFolder folder;
        const ProcessResult run = cli(exportTo(folder / ("x" + std::string(format.ending)), {"--age", "0"}));
        EXPECT_EQ(run.status, 0) << format.ending << run.err;
        EXPECT_TRUE(std::filesystem::exists(folder / ("x" + std::string(format.ending))));
    }
}

TEST(Frames, AnInterruptKeepsTheFinishedOnesAndSaysHowMany) {
    const CTemporaryFolder folder;
    CProcess process(cliCommand({"export", kAspen, "-o", (folder / "x.obj").string(), "--frames", "500"}));
    for (int i = 0; i < 10'000 && !std::filesystem::exists(folder / "x_0003.obj"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    process.signal(SIGINT);
    const ProcessResult run = process.wait();
    EXPECT_EQ(run.status, 1);
    std::size_t models = 0;
    for (const std::string& name : folder.names()) {
        models += name.ends_with(".obj");
        EXPECT_TRUE(name.ends_with(".obj") || name.ends_with(".mtl") || name.ends_with(".png"))
            << "half-written: " << name;
    }
    EXPECT_GE(models, 2u) << "the second may still be under way when the third is there";
    EXPECT_LT(models, 500u);
    EXPECT_NE(run.err.find(std::to_string(models) + " of 500 files"), std::string::npos) << run.err;
}

TEST(Frames, ThatCannotBeWrittenLeaveNoneHalfWritten) {
    const CTemporaryFolder folder;
    const ProcessResult run =
        cli({"export", kAspen, "-o", (folder / "x.obj").string(), "--frames", "4"}, {.maxFileBytes = 6'000'000});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err, "");
    for (const std::string& name : folder.names())
        EXPECT_TRUE(name.ends_with(".obj") || name.ends_with(".mtl") || name.ends_with(".png"))
            << "half-written: " << name;
    EXPECT_FALSE(std::filesystem::exists(folder / "x_0004.obj"));
}

} // namespace
} // namespace stromar::test
