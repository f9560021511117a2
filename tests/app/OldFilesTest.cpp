// A file that opened once grows the same tree for ever: the first presets, and what they grew then.
#include "Checkout.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include <cmath>
#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace {
using Json = nlohmann::json;
const std::string kFolder = inSource("tests/data/first-presets/");
constexpr double kTolerance = 1e-4;

const Json& expected() {
    static const Json all = Json::parse(readFile(kFolder + "expected.json"));
    return all;
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const auto& [name, tree] : expected().items()) all.push_back(name);
    return all;
}

void expectNear(double value, const Json& wanted, const std::string& what) {
    EXPECT_NEAR(value, wanted.get<double>(), kTolerance * std::max(1.0, std::abs(wanted.get<double>()))) << what;
}

void expectGeneration(const CGeneration& generation, const Json& wanted, const std::string& what) {
    EXPECT_EQ(generation.stems.size(), wanted.at("stems")) << what;
    EXPECT_EQ(generation.cloneCount(), wanted.at("clones")) << what;
    EXPECT_EQ(generation.segments.size(), wanted.at("segments")) << what;
    double length = 0, radius = 0;
    for (const CStem& stem : generation.stems) {
        length += stem.length;
        radius += stem.radius;
    }
    expectNear(length, wanted.at("length_sum"), what + ", lengths");
    expectNear(radius, wanted.at("radius_sum"), what + ", radii");
}

Bounds boundsOf(const TreeModel& model) {
    const Bounds all = model.bounds().value();
    return all;
}
} // namespace

class OldFile : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(First, OldFile, testing::ValuesIn(names()), [](const auto& name) { return name.param; });

TEST_P(OldFile, GrowsTheSameTree) {
    const CTreeFile file = CTreeFile::read(kFolder + GetParam() + ".tree");
    EXPECT_TRUE(file.warnings().empty());
    EXPECT_EQ(file.text(file.params()), readFile(kFolder + GetParam() + ".tree")) << "saved byte for byte";
    const auto model = CTreeCreator().create(file.params(), detailOf(Model::Full), CProgress(2));
    const Json& wanted = expected().at(GetParam());
    ASSERT_EQ(model->tree->generationCount(), wanted.at("generations").size());
    for (std::size_t g = 0; g < model->tree->generationCount(); ++g)
        expectGeneration(model->tree->generation(g), wanted.at("generations")[g], "generation " + std::to_string(g));
    EXPECT_EQ(model->tree->leaves().size(), wanted.at("leaves"));
    const Bounds bounds = boundsOf(*model);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<glm::length_t>(i);
        expectNear(bounds.min[axis], wanted.at("bounds").at("min")[i], "low bound");
        expectNear(bounds.max[axis], wanted.at("bounds").at("max")[i], "high bound");
    }
}

TEST(OldFiles, AllTwentyEightAreThere) { EXPECT_EQ(names().size(), 28u); }

} // namespace stromar::test
