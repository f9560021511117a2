// Species from three distances in four seasons, against what script/make-sheets has drawn.
#include "cli/Cli.h"
#include "cli/Picture.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

constexpr unsigned kSide = 96; // pixels of a picture; the sheets have kTileSide by kTileSide of them as one
constexpr unsigned kCells = kSide / kTileSide;
const std::vector<Words> kDistances{{"--fit"}, {"--view", "crown"}, {"--view", "closeup"}};
const Words kMonths{"spring", "summer", "autumn", "winter"};

std::filesystem::path sheetOf(const std::string& preset) { return STROMAR_SOURCE "/tests/data/sheets/" + preset + ".png"; }

std::vector<std::string> speciesNames() {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(STROMAR_SOURCE "/presets"))
        if (const std::string name = file.path().stem().string(); file.path().extension() == ".tree" && !name.starts_with("abop_"))
            names.push_back(name);
    std::ranges::sort(names);
    return names;
}

class Sheet : public ::testing::TestWithParam<std::string> {};
// All of them take a quarter of an hour: --gtest_also_run_disabled_tests.
INSTANTIATE_TEST_SUITE_P(Few, Sheet, ::testing::Values("quaking_aspen", "hazel", "rowan", "coconut_palm"), [](const auto& name) { return name.param; });
INSTANTIATE_TEST_SUITE_P(DISABLED_All, Sheet, ::testing::ValuesIn(speciesNames()), [](const auto& name) { return name.param; });

TEST_P(Sheet, ShowsTheTreeAsItIsNow) {
    const CTemporaryFolder folder;
    const std::string path = (folder.path() / "now.png").string();
    const Picture sheet = readPng(sheetOf(GetParam()));
    ASSERT_EQ(sheet.width, 4 * kCells);
    for (unsigned row = 0; row < kDistances.size(); ++row)
        for (unsigned column = 0; column < kMonths.size(); ++column) {
            Words words{"render",   presetFile(GetParam()), "-o", path,     "--size", std::to_string(kSide), "--samples", "4",
                        "--season", kMonths[column],        "--quiet"};
            words.insert(words.end(), kDistances[row].begin(), kDistances[row].end());
            ASSERT_EQ(cli(words).status, 0);
            const Picture now = readPng(path);
            double worst = 0;
            for (unsigned y = 0; y < kCells; ++y)
                for (unsigned x = 0; x < kCells; ++x) {
                    const auto mean = now.mean(x * kTileSide, y * kTileSide, (x + 1) * kTileSide, (y + 1) * kTileSide);
                    const auto shown = sheet.mean(column * kCells + x, row * kCells + y, column * kCells + x + 1, row * kCells + y + 1);
                    for (unsigned c = 0; c < 3; ++c) worst = std::max(worst, std::abs(double(mean[c] - shown[c])));
                }
            EXPECT_LT(worst, kMaxTileDifference) << kDistances[row].back() << " in " << kMonths[column] << ": run script/make-sheets and look";
        }
}
} // namespace

TEST(Sheets, EverySpeciesHasOne) {
    for (const std::string& name : speciesNames()) EXPECT_EQ(readPng(sheetOf(name)).height, 3 * kCells) << name;
}

} // namespace stromar::test
