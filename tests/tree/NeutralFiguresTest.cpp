#include "tree/Support.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

/// One generation as an independent program grows it from the same specification, every random draw in the middle.
struct Figures {
    std::size_t stems, clones;
    double length, radius; ///< sums
    double height, spread; ///< sums over the bases of z and of |x| + |y|; negative: not given
};

struct Species {
    const char* preset;
    std::vector<Figures> generations;
    std::size_t leaves;
};

const Species kSpecies[] = {
    {"quaking_aspen",
     {{1, 0, 13.0000, 0.1950, -1, -1},
      {50, 0, 146.1515, 1.5107, 455.867, -1},
      {1198, 0, 1508.6036, 12.5776, 11515.432, 1907.212}},
     22498},
    {"black_tupelo",
     {{1, 0, 23.0000, 0.3450, -1, -1},
      {50, 0, 257.4562, 2.4831, 696.900, -1},
      {996, 0, 2213.1734, 15.8672, 13813.453, 3077.396},
      {8963, 0, 5837.2156, 29.0109, 126991.112, 35713.556}},
     40334},
    {"weeping_willow",
     {{1, 4, 12.0000, 0.3600, -1, -1},
      {25, 104, 144.5106, 1.9350, 166.751, -1},
      {243, 588, 1174.4530, 8.5646, 2012.738, 643.939},
      {54164, 0, 19573.0442, 11.1330, 448066.384, 234335.198}},
     609421},
    {"ca_black_oak",
     {{1, 12, 10.0000, 0.1800, -1, -1},
      {40, 77, 215.4177, 3.1722, 223.211, -1},
      {3546, 692, 2964.0189, 25.1290, 22911.662, 11085.023}},
     66514},
};

/// 1e-5 of the value, but no less than half of the last digit that was written down.
void expectClose(double got, double figure, double lastDigit, const std::string& what) {
    if (figure < 0) return;
    EXPECT_NEAR(got, figure, std::max(1e-5 * figure, 0.51 * lastDigit)) << what;
}

void expectFigures(const CGeneration& generation, const Figures& expected, const std::string& where) {
    EXPECT_EQ(generation.stems.size(), expected.stems) << where;
    EXPECT_EQ(generation.cloneCount(), expected.clones) << where;
    double length = 0, radius = 0, height = 0, spread = 0;
    for (const CStem& stem : generation.stems) {
        const glm::dvec3 base = test::firstSegment(generation, stem).position;
        length += stem.length;
        radius += stem.radius;
        height += base.z;
        spread += std::abs(base.x) + std::abs(base.y);
    }
    expectClose(length, expected.length, 1e-4, where + " length");
    expectClose(radius, expected.radius, 1e-4, where + " radius");
    expectClose(height, expected.height, 1e-3, where + " height");
    expectClose(spread, expected.spread, 1e-3, where + " spread");
}

TEST(NeutralFigures, AgreeWithTheReferenceProgram) {
    for (const auto& [name, generations, leaves] : kSpecies) {
        const auto tree = test::growNeutral(test::with(test::preset(name), {{"AttractionAxis", 0}})); // the printed formula
        ASSERT_EQ(tree->generationCount(), generations.size()) << name;
        for (std::size_t g = 0; g < generations.size(); ++g)
            expectFigures(tree->generation(g), generations[g], std::string(name) + " generation " + std::to_string(g));
        EXPECT_EQ(tree->leaves().size(), leaves) << name;
    }
}

TEST(NeutralFigures, TheSeedDoesNotMatterInTheNeutralRun) {
    const CParams params = test::preset("quaking_aspen");
    EXPECT_EQ(test::difference(*test::growNeutral(params), *test::growNeutral(test::with(params, {{"Seed", 99}}))), "");
}

} // namespace
} // namespace stromar
