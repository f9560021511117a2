// Trees of L-systems by the command line: the figures of the book, and what is wrong with a grammar.
#include "cli/Cli.h"
#include "tree/LSystemFigures.h"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

/// "abop_2_6a" of "2.6a".
std::string presetOf(std::string figure) {
    std::ranges::replace(figure, '.', '_');
    return presetFile("abop_" + figure);
}

glm::dvec3 vectorOf(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

class Grammars : public testing::Test {
protected:
    void SetUp() override {
        m_folder = std::filesystem::temp_directory_path() / ("stromar-grammars-" + std::to_string(getpid()));
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::string written(const std::string& name, const std::string& text) const {
        std::ofstream(m_folder / name) << text;
        return (m_folder / name).string();
    }
    std::string tree(const std::string& grammar, const std::string& more = "") const {
        return written("a.tree", "Format = 2\nMethod = l-system\nGrammar = \"\"\"\n" + grammar + "\n\"\"\"\n" + more);
    }

    std::filesystem::path m_folder;
};
} // namespace

TEST(LSystemFigures, AreInTheSegmentsOfTheStructure) {
    for (const Figure& figure : kFigures) {
        SCOPED_TRACE(figure.name);
        const bool isTernary = figure.rules == kTernary;
        const double lengthUnit = isTernary ? 0.01 : 1, widthUnit = isTernary ? 0.01 : 0.03;
        const ProcessResult result = cli({"structure", presetOf(figure.name), "--segments"});
        ASSERT_EQ(result.status, 0) << result.err;
        std::size_t segments = 0;
        double length = 0, maxWidth = 0, minWidth = 1e9;
        glm::dvec3 low(0), high(0);
        for (const Json& line : jsonLines(result.out)) {
            if (!line.contains("radius_base")) continue; // a stem
            ++segments;
            ASSERT_EQ(line.at("radius_base"), line.at("radius_end"));
            const double width = 2 * line.at("radius_base").get<double>() / widthUnit;
            length += glm::distance(vectorOf(line.at("base")), vectorOf(line.at("end"))) / lengthUnit;
            maxWidth = std::max(maxWidth, width);
            minWidth = std::min(minWidth, width);
            for (const char* end : {"base", "end"}) {
                const glm::dvec3 at = yUp(vectorOf(line.at(end)) / lengthUnit);
                low = glm::min(low, at);
                high = glm::max(high, at);
            }
        }
        EXPECT_EQ(segments, figure.segments);
        EXPECT_NEAR(length, figure.length, 1e-4 * figure.length);
        EXPECT_NEAR(maxWidth, figure.maxWidth, 1e-4 * figure.maxWidth);
        EXPECT_NEAR(minWidth, figure.minWidth, 1e-4 * figure.minWidth);
        for (int k = 0; k < 3; ++k) {
            const double near = 1e-4 * figure.high.y + 6e-4; // as they are printed
            EXPECT_NEAR(low[k], figure.low[k], near) << k;
            EXPECT_NEAR(high[k], figure.high[k], near) << k;
        }
    }
}

TEST_F(Grammars, FaultsAreToldAtTheirPlaceInTheFile) {
    const ProcessResult unknown = cli({"info", tree("#define a 3\naxiom: F(b)[+F]")});
    EXPECT_NE(unknown.status, 0);
    EXPECT_NE(unknown.err.find("a.tree:5:10: error: 'b' is not defined here"), std::string::npos) << unknown.err;
    const ProcessResult open = cli({"info", tree("axiom: F[+F")});
    EXPECT_NE(open.err.find("a.tree:4:9: error: there is no ] for this ["), std::string::npos) << open.err;
    const ProcessResult set = cli({"info", tree("axiom: F"), "--set", "Grammar=axiom: F(1/0)"});
    EXPECT_NE(set.err.find("Grammar:1:11: error: "), std::string::npos) << set.err;
    const ProcessResult dead = cli({"info", tree("axiom: F\nA -> F")});
    EXPECT_EQ(dead.status, 0) << dead.err;
    EXPECT_NE(dead.err.find("a.tree:5:1: warning: this production never matches"), std::string::npos) << dead.err;
}

TEST_F(Grammars, ThatDoubleForEverAreRefusedBeforeTheyGrow) {
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult counted = cli({"info", tree("axiom: A\nA -> F A A", "Derivations = 60")});
    EXPECT_NE(counted.status, 0);
    EXPECT_NE(counted.err.find("makes 2305843009213693952 modules in 60 derivations"), std::string::npos) << counted.err;
    const ProcessResult limited = cli({"info", tree("axiom: A(0)\nA(x) : x < 100 -> F A(x+1) A(x+1)", "Derivations = 60")});
    EXPECT_NE(limited.status, 0);
    EXPECT_NE(limited.err.find("more than 20000000 modules"), std::string::npos) << limited.err;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60)) << "nothing was grown";
}

TEST_F(Grammars, OfOtherFilesAreTaken) {
    const std::string grammar = written("pole.l", "axiom: F(2)F(3)");
    const Json info = Json::parse(cli({"info", tree("axiom: F"), "--set", "Grammar=@" + grammar}).out);
    EXPECT_EQ(info.at("generations")[0].at("segments"), 2);
    EXPECT_EQ(info.at("generations")[0].at("length_sum"), 5.0);
}

TEST_F(Grammars, ThatDrawNothingSaySo) {
    const ProcessResult result = cli({"info", tree("axiom: A\nA -> F", "Derivations = 0")});
    EXPECT_NE(result.status, 0);
    EXPECT_NE(result.err.find("draws nothing"), std::string::npos) << result.err;
}

} // namespace stromar::test
