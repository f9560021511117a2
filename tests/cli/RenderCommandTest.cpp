#include "Checkout.h"
#include "cli/Cli.h"
#include "cli/Picture.h"
#include "stromar/params/TreeFile.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <array>
#include <fstream>
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

class Render : public ::testing::Test {
protected:
    Picture render(const Words& more, const char* samples = "1") {
        Words words{"render",    inSource("presets/quaking_aspen.tree"),
                    "-o",        path(),
                    "--size",    "200x240",
                    "--samples", samples,
                    "--set",     "1Branches=20",
                    "--set",     "BarkTexture=",
                    "--set",     "LeafTexture="};
        words.insert(words.end(), more.begin(), more.end());
        const ProcessResult run = cli(words);
        EXPECT_EQ(run.status, 0) << run.err;
        return readPng(path());
    }
    std::string path() const { return (m_folder.path() / "tree.png").string(); }

    CTemporaryFolder m_folder;
};
class SlowRender : public Render {};

bool isGreen(const std::array<int, 4>& c) { return c[1] > c[0] && c[1] > c[2]; }
} // namespace

TEST_F(Render, ThinWoodTakesOnTheBarkOfBranches) {
    const Words bare{"--set", "Levels=1", "--set", "0Taper=1", "--set", "1BarkTexture=bark:smooth light=#ff0000 dark=#ee0000"};
    const Picture trunk = render(bare);
    EXPECT_EQ(trunk.red(0, trunk.height), 0u) << "without branches there is no such bark";
    Words branches = bare;
    branches[1] = "Levels=2";
    const Picture tree = render(branches);
    EXPECT_EQ(tree.red(tree.height * 17 / 20, tree.height), 0u) << "the foot of the trunk";
    EXPECT_GT(tree.red(0, tree.height / 2), 200u);
}

/// Wood thinner than a pixel is a faint line in a single picture, as it is in the mean of many; not dots.
TEST_F(Render, ThinWoodIsDrawnAsLines) {
    struct Wood {
        double covered = 0, dots = 0, seen = 0;
    };
    const auto woodOf = [&](const char* samples) {
        const Picture p = render({"--set", "1Branches=50", "--season", "winter", "--transparent", "--fit"}, samples);
        const auto alpha = [&](unsigned x, unsigned y) { return int(p.rgba[4 * (y * p.width + x) + 3]); };
        Wood wood;
        for (unsigned y = 1; y + 1 < p.height; ++y)
            for (unsigned x = 1; x + 1 < p.width; ++x) {
                if (alpha(x, y) == 0) continue;
                int around = 0;
                for (unsigned n = 0; n < 9; ++n) around += n != 4 && alpha(x + n % 3 - 1, y + n / 3 - 1) > 0;
                wood.covered += alpha(x, y) / 255.0;
                wood.seen += 1;
                wood.dots += around < 2;
            }
        return wood;
    };
    const Wood one = woodOf("1"), many = woodOf("64");
    EXPECT_GT(one.seen, 2000);
    EXPECT_LT(one.dots, 0.02 * one.seen);
    EXPECT_NEAR(one.covered, many.covered, 0.15 * many.covered);
}

/// Mesa draws without the extension as older drivers do.
TEST_F(SlowRender, OpenGlBeforeInstancesDrawsTheSame) {
    const Picture instances = render({}, "32"); // the noise of small leaves differs
    setenv("MESA_GL_VERSION_OVERRIDE", "3.0", 1);
    setenv("MESA_EXTENSION_OVERRIDE", "-GL_ARB_instanced_arrays", 1);
    const Picture vertices = render({}, "32");
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_EXTENSION_OVERRIDE");
    ASSERT_EQ(instances.width, 200u);
    ASSERT_EQ(vertices.width, 200u);
    const TileDifference worst = worstTile(instances.bytes(), vertices.bytes());
    EXPECT_LT(worst.mean, kMaxTileDifference) << worst;
}

TEST_F(Render, DrawsALoopOfTheWindAndGrowthFromOnePlace) {
    const auto frames = [&](const Words& more) {
        Words words{"render", kAspen, "-o", path(), "--size", "100x120", "--samples", "1", "--frames", "3"};
        words.insert(words.end(), more.begin(), more.end());
        const ProcessResult run = cli(words);
        EXPECT_EQ(run.status, 0) << run.err;
        std::vector<Picture> pictures;
        for (const char* number : {"1", "2", "3"}) pictures.push_back(readPng(m_folder / ("tree_000" + std::string(number) + ".png")));
        return pictures;
    };
    const auto apart = [](const Picture& a, const Picture& b) { return worstTile(a.bytes(), b.bytes()).mean; };
    const std::vector<Picture> blown = frames({"--wind-strength", "1.5", "--gusts", "1", "--seconds", "5"});
    EXPECT_GT(apart(blown[0], blown[1]), 1);
    EXPECT_GT(apart(blown[1], blown[2]), 1);
    const std::vector<Picture> grown = frames({});
    cli({"render", kAspen, "-o", path(), "--size", "100x120", "--samples", "1"});
    EXPECT_EQ(apart(grown[2], readPng(path())), 0) << "the last one is the grown tree";
    const auto green = [](const Picture& picture) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) count += picture.rgba[i + 2] < 70;
        return count;
    };
    EXPECT_LT(green(grown[0]), green(grown[1]));
    EXPECT_LT(green(grown[1]), green(grown[2]));
}

TEST_F(Render, ShowsSkyTreeAndGround) {
    const Picture picture = render({});
    ASSERT_EQ(picture.width, 200u);
    ASSERT_EQ(picture.height, 240u);
    const auto sky = picture.mean(0, 0, 40, 20), ground = picture.mean(150, 220, 200, 240),
               crown = picture.mean(85, 80, 115, 120);
    EXPECT_GT(sky[2], sky[0]) << "blue above";
    EXPECT_TRUE(isGreen(ground));
    EXPECT_TRUE(isGreen(crown));
    EXPECT_LT(crown[0] + crown[1] + crown[2], sky[0] + sky[1] + sky[2] - 60);
    EXPECT_EQ(sky[3], 255);
}

TEST_F(Render, CastsAShadowAwayFromTheSun) {
    // In the morning the sun stands on the right.
    const Picture morning = render({"--hour", "8.5"}), evening = render({"--hour", "15.5"});
    const auto brightness = [](const Picture& p, unsigned x) {
        const auto c = p.mean(x, 205, x + 30, 225);
        return c[0] + c[1] + c[2];
    };
    EXPECT_LT(brightness(morning, 10) - brightness(morning, 160),
              brightness(evening, 10) - brightness(evening, 160) - 20);
}

TEST_F(Render, TransparentShowsTheTreeAlone) {
    const Picture picture = render({"--transparent"});
    EXPECT_EQ(picture.mean(0, 0, 40, 40)[3], 0);
    EXPECT_EQ(picture.mean(150, 220, 200, 240)[3], 0);
    EXPECT_GT(picture.mean(85, 80, 115, 120)[3], 100);
}

TEST_F(Render, FitFillsThePictureFromAnywhere) {
    for (const char* from : {"0,0", "120,35", "-60,-10"}) {
        const Picture picture = render({"--transparent", "--fit", "--from", from, "--focal-length", "28"});
        unsigned left = picture.width, right = 0, top = picture.height, bottom = 0;
        for (unsigned y = 0; y < picture.height; ++y)
            for (unsigned x = 0; x < picture.width; ++x)
                if (picture.rgba[4 * (y * picture.width + x) + 3] > 0) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                    top = std::min(top, y);
                    bottom = std::max(bottom, y);
                }
        EXPECT_GT(std::max(double(right - left) / picture.width, double(bottom - top) / picture.height), 0.93) << from;
        EXPECT_GT(std::min({left, top, picture.width - 1 - right, picture.height - 1 - bottom}), 0u) << from;
    }
}

TEST_F(Render, LongLensesShowLess) {
    const Picture wide = render({"--focal-length", "20"}), tele = render({"--focal-length", "200"});
    EXPECT_GT(worstTile(wide.bytes(), tele.bytes()).mean, kMaxTileDifference);
}

TEST_F(SlowRender, BackdropsAndLightAreThoseThatWereAskedFor) {
    const auto corner = [](const Picture& p) { return p.mean(0, 0, 40, 20); };
    EXPECT_GT(corner(render({"--backdrop", "light"}))[0], 200);
    EXPECT_LT(corner(render({"--backdrop", "dark"}))[0], 140);
    EXPECT_EQ(corner(render({"--backdrop", "none"}))[3], 0);
    const auto usual = corner(render({}));
    EXPECT_GT(corner(render({"--exposure", "1"}))[0], usual[0] + 10);
    EXPECT_LT(corner(render({"--sky-strength", "0.3"}))[2], usual[2] - 30);
    const auto warm = corner(render({"--sky-temperature", "2500"}));
    EXPECT_GT(warm[0] - warm[2], usual[0] - usual[2] + 20);
    const auto ground = [](const Picture& p) { return p.mean(10, 205, 60, 225); };
    EXPECT_GT(ground(render({"--sun-strength", "2"}))[1], ground(render({"--sun-strength", "0"}))[1] + 15);
}

/// A panorama of one colour.
void writePanorama(const std::string& path, std::array<unsigned char, 3> colour) {
    std::ofstream file(path, std::ios::binary);
    file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    for (int pixel = 0; pixel < 8; ++pixel) {
        for (const unsigned char value : colour) file.put(static_cast<char>(value));
        file.put(static_cast<char>(129)); // exponent: times 2 / 256
    }
}

TEST_F(Render, ABackdropMayBeAPictureOrAPanoramaThatLights) {
    const std::string bark = (m_folder.path() / "bark.png").string(), hot = (m_folder.path() / "hot.hdr").string();
    ASSERT_EQ(cli({"texture", "bark:furrowed dark=#ff0000 light=#ff0000", "--size", "64", "-o", bark}).status, 0);
    const auto corner = [](const Picture& p) { return p.mean(0, 0, 40, 20); };
    const auto behind = corner(render({"--backdrop", bark}));
    EXPECT_GT(behind[0], behind[2] + 60);
    writePanorama(hot, {250, 60, 20});
    const Picture usual = render({}), lit = render({"--backdrop", hot});
    EXPECT_GT(corner(lit)[0], corner(lit)[2] + 60);
    const auto trunk = [](const Picture& p) { return p.mean(97, 195, 103, 210); };
    EXPECT_GT(trunk(lit)[0] - trunk(lit)[2], trunk(usual)[0] - trunk(usual)[2] + 20) << "its light falls on the tree";
    for (const char* wrong : {"none.png", "tree.gif", "purple"})
        EXPECT_NE(cli({"render", kAspen, "-o", path(), "--backdrop", wrong}).status, 0) << wrong;
}

TEST_F(Render, DisplacedBarkHasARoughOutline) {
    const auto outline = [](const Picture& p) { // how much the trunk's left edge goes to and fro
        int last = 0, way = 0;
        for (unsigned y = p.height / 2; y < p.height; ++y) {
            int x = 0;
            while (x < static_cast<int>(p.width) && p.rgba[4 * (y * p.width + static_cast<unsigned>(x)) + 3] < 128) ++x;
            if (last > 0 && x < static_cast<int>(p.width)) way += std::abs(x - last);
            last = x;
        }
        return way;
    };
    const Words pole{"--set", "Levels=1", "--set", "Scale=3", "--set", "Ratio=0.1", "--set", "Leaves=0", "--set", "BarkTexture=bark:furrowed ridges=12",
                     "--transparent", "--fit", "--season", "winter"};
    Words rough = pole;
    rough.insert(rough.end(), {"--displacement", "0.01", "--displacement-strength", "4"});
    EXPECT_GT(outline(render(rough)), 1.5 * outline(render(pole)));
    EXPECT_NE(cli({"render", kAspen, "-o", path(), "--displacement", "0.0001"}).err.find("million triangles"), std::string::npos);
}

/// A few bytes can be a picture that takes all memory.
TEST_F(Render, HugePicturesAreRefused) {
    const std::string huge = (m_folder.path() / "huge.png").string(), tree = (m_folder.path() / "huge.tree").string();
    std::ofstream(huge, std::ios::binary) << std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\1\0\0\0\1\0\0\x08\6\0\0\0", 29);
    std::ofstream(tree) << "Format = 1\nScale = 2\nLevels = 1\nBarkTexture = \"huge.png\"\n";
    for (const Words& words : {Words{"render", kAspen, "-o", path(), "--backdrop", huge}, Words{"render", tree, "-o", path()}}) {
        const auto result = cli(words);
        EXPECT_NE(result.status, 0);
        EXPECT_NE(result.err.find("65536 x 65536 pixels is too large"), std::string::npos) << result.err;
    }
}

TEST_F(Render, SeveralTreesStandInARow) {
    const auto columns = [](const Picture& p) {
        std::vector<std::size_t> trees; // pixels of each, between empty columns
        bool inside = false;
        for (unsigned x = 0; x < p.width; ++x) {
            std::size_t count = 0;
            for (unsigned y = 0; y < p.height; ++y) count += p.rgba[4 * (y * p.width + x) + 3] > 0;
            if (count > 0 && !inside) trees.push_back(0);
            if (count > 0) trees.back() += count;
            inside = count > 0;
        }
        return trees;
    };
    const auto row = columns(render({kAspen, kAspen, "--transparent", "--fit"}));
    ASSERT_EQ(row.size(), 3u) << "with air between them";
    for (const std::size_t pixels : row) EXPECT_NEAR(double(pixels), double(row[0]), 0.15 * double(row[0]));
    const auto side = columns(render({kAspen, "--transparent", "--fit", "--from", "90,0"}));
    EXPECT_EQ(side.size(), 2u) << "the row lies across the view";
}

TEST_F(Render, SeveralTreesStandStill) {
    for (const Words& motion : {Words{"--frames", "3"}, Words{"--wind-strength", "0.5"}}) {
        Words words{"render", kAspen, kAspen, "-o", path()};
        words.insert(words.end(), motion.begin(), motion.end());
        const ProcessResult run = cli(words);
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find("several trees stand still"), std::string::npos) << run.err;
    }
    EXPECT_EQ(cli({"render", kAspen, "none.tree", "-o", path()}).status, 1);
}

TEST_F(SlowRender, AnyNumberOfSamplesIsDrawn) {
    for (const char* samples : {"3", "5", "20"}) {
        const ProcessResult run = cli({"render", kAspen, "-o", path(), "--size", "200", "--samples", samples});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(readPng(path()).width, 200u) << samples;
    }
    EXPECT_EQ(cli({"render", kAspen, "-o", path(), "--from", "north"}).status, 2);
    EXPECT_EQ(cli({"render", kAspen, "-o", path(), "--from", "0,95"}).status, 2);
}

TEST_F(Render, WinterIsBare) {
    const auto summer = render({}).mean(60, 60, 140, 160),
               winter = render({"--season", "winter"}).mean(60, 60, 140, 160);
    EXPECT_GT(winter[2], summer[2] + 20) << "the sky is seen";
}

TEST_F(Render, ViewsDiffer) {
    const Picture front = render({}), top = render({"--view", "top"}), close = render({"--view", "closeup"});
    EXPECT_NE(front.rgba, top.rgba);
    EXPECT_NE(front.rgba, close.rgba);
}

TEST_F(Render, SaysWhatIsWrong) {
    const std::string preset = inSource("presets/quaking_aspen.tree");
    for (const auto& [words, said] : {std::pair{Words{"--size", "3x3"}, "WxH"},
                                      {Words{"--size", "wide"}, "WxH"},
                                      {Words{"--view", "below"}, "view"},
                                      {Words{"--season", "monsoon"}, "Season"},
                                      {Words{"--hour", "25"}, "hour"}}) {
        Words all{"render", preset, "-o", path()};
        all.insert(all.end(), words.begin(), words.end());
        const ProcessResult run = cli(all);
        EXPECT_EQ(run.status, 2) << said;
        EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
    }
    EXPECT_EQ(cli({"render", preset, "-o", path() + ".jpg"}).status, 2);
    EXPECT_EQ(cli({"render", preset, "-o", "/no/such/folder/a.png", "--size", "32x32"}).status, 1);
}

/// Every preset looks as it does in the window's library and in the manual.
class SpeciesPicture : public ::testing::TestWithParam<std::string> {};

constexpr std::size_t kSpeciesStep = 6;

/// Every sixth, from some of the first on: the sheets show nearly all of them too.
std::vector<std::string> everySixthPreset(std::initializer_list<std::size_t> firsts) {
    std::vector<std::string> names, chosen;
    for (const auto& file : std::filesystem::directory_iterator(inSource("presets")))
        if (file.path().extension() == ".tree") names.push_back(file.path().stem().string());
    std::ranges::sort(names);
    for (std::size_t first : firsts)
        for (; first < names.size(); first += kSpeciesStep) chosen.push_back(names[first]);
    return chosen;
}
INSTANTIATE_TEST_SUITE_P(Slow, SpeciesPicture, ::testing::ValuesIn(everySixthPreset({0})),
                         [](const auto& name) { return name.param; });
INSTANTIATE_TEST_SUITE_P(Exhaustive, SpeciesPicture, ::testing::ValuesIn(everySixthPreset({1, 2, 3, 4, 5})),
                         [](const auto& name) { return name.param; });

/// How far a preset, with more words for the command line, is from its picture in the manual.
TileDifference differenceFromTheManual(const std::string& preset, const Words& more = {}) {
    const CTemporaryFolder folder;
    const std::string path = (folder.path() / "now.png").string();
    Words words{"render", presetFile(preset), "-o", path, "--size", "192x192", "--samples", "16", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const ProcessResult run = cli(words);
    EXPECT_EQ(run.status, 0) << run.err;
    const Picture now = readPng(path), shown = readPng(inSource("docs/images/presets/" + preset + ".png"));
    if (now.rgba.empty() || now.width != shown.width || now.height != shown.height) {
        ADD_FAILURE() << "no pictures of one size: run script/make-species";
        return {};
    }
    return worstTile(now.bytes(), shown.bytes());
}

TEST_P(SpeciesPicture, IsThatOfTheManual) {
    const TileDifference worst = differenceFromTheManual(GetParam());
    EXPECT_LT(worst.mean, kMaxTileDifference) << worst << ": run script/make-species and look";
}

/// Species whose trunk is seen: thick and thin, bare and between branches.
class TrunkPicture : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Slow, TrunkPicture, ::testing::Values("black_tupelo", "coconut_palm", "quaking_aspen", "sapling"),
                         [](const auto& name) { return name.param; });
INSTANTIATE_TEST_SUITE_P(Exhaustive, TrunkPicture,
                         ::testing::Values("italian_cypress", "lombardy_poplar", "european_larch", "silver_birch"),
                         [](const auto& name) { return name.param; });

TEST_P(TrunkPicture, ShowsWhenTheTrunkIsTooThick) {
    const CParams params = CTreeFile::read(presetFile(GetParam())).params();
    const double factor = weberPenn(params).trunkScale;
    const TileDifference worst =
        differenceFromTheManual(GetParam(), {"--set", "0Scale=" + std::to_string(1.5 * factor)});
    EXPECT_GT(worst.mean, 1.5 * kMaxTileDifference) << worst;
}

} // namespace stromar::test
