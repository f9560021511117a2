// Species from three distances in four seasons, against what script/make-sheets has drawn.
#include "Checkout.h"
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

std::filesystem::path sheetOf(const std::string& preset) { return inSource("tests/data/sheets/" + preset + ".png"); }

std::vector<std::string> speciesNames() {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(inSource("presets")))
        if (const std::string name = file.path().stem().string(); file.path().extension() == ".tree" && !name.starts_with("abop_"))
            names.push_back(name);
    std::ranges::sort(names);
    return names;
}

/// The sheet's tile of a row and a column against the tree as it is now.
void expectTile(const std::string& preset, unsigned row, unsigned column) {
    const CTemporaryFolder folder;
    const std::string path = (folder.path() / "now.png").string();
    const Picture sheet = readPng(sheetOf(preset));
    ASSERT_EQ(sheet.width, 4 * kCells);
    ASSERT_EQ(sheet.height, 3 * kCells);
    Words words{"render",   presetFile(preset), "-o",     path, "--size", std::to_string(kSide), "--samples", "4",
                "--season", kMonths[column],    "--quiet"};
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

std::string nameOf(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

class WholeSheet : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Slow, WholeSheet, ::testing::Values("rowan"), nameOf);
INSTANTIATE_TEST_SUITE_P(Exhaustive, WholeSheet, ::testing::Values("quaking_aspen", "hazel", "coconut_palm"), nameOf);

TEST_P(WholeSheet, ShowsTheTreeAsItIsNow) {
    for (unsigned row = 0; row < kDistances.size(); ++row)
        for (unsigned column = 0; column < kMonths.size(); ++column) expectTile(GetParam(), row, column);
}

/// One distance in one season of every species: all of them take a quarter of an hour.
class SheetTile : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Slow, SheetTile, ::testing::ValuesIn(speciesNames()), nameOf);

TEST_P(SheetTile, ShowsTheTreeAsItIsNow) {
    const std::vector<std::string> names = speciesNames();
    const auto number = static_cast<unsigned>(std::ranges::find(names, GetParam()) - names.begin());
    expectTile(GetParam(), number % 3, number % 4);
}
} // namespace

} // namespace stromar::test
