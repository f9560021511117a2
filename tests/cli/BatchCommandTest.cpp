#include "Checkout.h"
#include "cli/Cli.h"
#include "stromar/util/FileSet.h"
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
std::string planFor(const std::string& output) {
    return "{\"trees\": \"" + inSource("presets/quaking_aspen.tree") + "\", \"lods\": [3], \"seeds\": [1, 2], \"output\": \"" + output + "\"}";
}
} // namespace

TEST(BatchCommand, WritesSkipsAndSaysSo) {
    const CTemporaryFolder folder;
    writeFile(folder / "plan.json", planFor("out/{tree}_{seed}.{format}"));
    const std::string plan = (folder / "plan.json").string();
    ProcessResult run = cli({"batch", plan, "--dry-run"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("quaking_aspen_2.glb"), std::string::npos);
    EXPECT_NE(run.out.find("2 models"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "nothing is written";
    run = cli({"batch", plan, "--jobs", "2"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find("2/2 "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("2 written, 0 unchanged, 0 failed"), std::string::npos) << run.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "out/quaking_aspen_1.glb"));
    run = cli({"batch", plan});
    EXPECT_NE(run.err.find("0 written, 2 unchanged, 0 failed"), std::string::npos) << run.err;
    run = cli({"batch", plan, "--quiet", "--force", "--max-vertices", "10"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("quaking_aspen_1.glb: this tree would have"), std::string::npos) << run.err;
}

TEST(BatchCommand, AWrongPlanIsRefusedBeforeTheFirstTree) {
    const CTemporaryFolder folder;
    writeFile(folder / "plan.json", planFor("out/{tree}.{format}"));
    ProcessResult run = cli({"batch", (folder / "plan.json").string()});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("two models have the name"), std::string::npos) << run.err;
    writeFile(folder / "plan.json", "{\"tree\": 1}");
    run = cli({"batch", (folder / "plan.json").string()});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("plan.json:1:2: error: a plan has no \"tree\""), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    EXPECT_EQ(cli({"batch", (folder / "none.json").string()}).status, 1);
}

TEST(BatchCommand, PartsAreMerged) {
    const CTemporaryFolder folder;
    writeFile(folder / "plan.json", planFor("out/{tree}_{seed}.{format}"));
    const std::string plan = (folder / "plan.json").string();
    EXPECT_EQ(cli({"batch", plan, "--part", "2/2", "--quiet"}).status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "out/quaking_aspen_1.glb"));
    ProcessResult run = cli({"batch", plan, "--merge"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("1 models, 1 missing"), std::string::npos) << run.err;
    EXPECT_EQ(cli({"batch", plan, "--part", "1/2", "--quiet"}).status, 0);
    run = cli({"batch", plan, "--merge"});
    EXPECT_EQ(run.status, 0) << run.err;
    const std::string merged = readFile(folder / "out/manifest.json");
    std::filesystem::remove_all(folder / "out");
    EXPECT_EQ(cli({"batch", plan, "--quiet"}).status, 0);
    EXPECT_EQ(readFile(folder / "out/manifest.json"), merged);
    for (const char* wrong : {"0/2", "3/2", "1", "1/2/3", "a/b", "1.5/2"}) EXPECT_EQ(cli({"batch", plan, "--part", wrong}).status, 2) << wrong;
}

} // namespace stromar::test
