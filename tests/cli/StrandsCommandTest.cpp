// What the command line says of trees of strands.
#include "cli/Cli.h"
#include <cmath>
#include <gtest/gtest.h>

namespace stromar::test {

TEST(StrandsCommand, StructureTellsStrandsAndOrders) {
    const ProcessResult result = cli({"structure", presetFile("strand_bonsai"), "--segments", "--set", "Strands=50"});
    ASSERT_EQ(result.status, 0) << result.err;
    int stems = 0, segments = 0;
    for (const Json& line : jsonLines(result.out)) {
        const bool isSegment = line.contains("radius_base");
        ++(isSegment ? segments : stems);
        EXPECT_TRUE(line.at("strands").is_number_integer());
        EXPECT_EQ(line.at("gravelius"), line.at("generation"));
        EXPECT_GE(line.at("weibull"), line.at("gravelius"));
        if (!isSegment) continue;
        EXPECT_DOUBLE_EQ(line.at("diameter").get<double>(), 2 * line.at("radius_base").get<double>());
        EXPECT_NEAR(line.at("diameter").get<double>(), 0.0034 * std::sqrt(line.at("strands").get<double>()), 1e-15);
        EXPECT_GT(line.at("inherited"), 0);
        EXPECT_GT(line.at("length"), 0);
    }
    EXPECT_EQ(stems, 50);
    EXPECT_EQ(segments, 99);
    EXPECT_FALSE(jsonLines(cli({"structure", presetFile("quaking_aspen")}).out).front().contains("strands"));
}

TEST(StrandsCommand, NamesThePointOfACurveThatIsWrong) {
    const ProcessResult result = cli({"info", presetFile("strand_oak"), "--set", "SplitAngleG=0:50, 0:40"});
    EXPECT_NE(result.status, 0);
    EXPECT_NE(result.err.find("point 2"), std::string::npos) << result.err;
    EXPECT_EQ(cli({"info", presetFile("strand_oak"), "--set", "SplitAngleOver=rootLength", "--set", "Strands=40"}).status, 0);
    EXPECT_NE(cli({"info", presetFile("strand_oak"), "--set", "StrandShareOver=height"}).status, 0);
}

} // namespace stromar::test
