#include "stromar/app/Engines.h"
#include "app/SameModel.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <turbojpeg.h>

namespace stromar::test {

namespace {
namespace fs = std::filesystem;

/// With the choices in words.
ExportOptions chosen(std::initializer_list<ChosenValue> values) {
    ExportOptions options;
    for (const ChosenValue& value : values) setChoice(options, value.key, value.value);
    return options;
}

class EngineExport : public testing::Test {
protected:
    fs::path write(const ExportOptions& options, const std::string& ending) {
        exportModels({smallModel()}, options, {}, m_folder / ("tree" + ending), CProgress(2));
        return m_folder / ("tree" + ending);
    }
    TextureMaps picture(const char* name) { return readPng(m_folder / name); }
    CTemporaryFolder m_folder;
};

std::vector<std::string> settingsErrorsOf(const std::string& text) {
    try {
        parseSettings(text, "a.export");
    } catch (const CInputError& e) {
        std::vector<std::string> all;
        for (const Message& message : e.messages()) all.push_back(message.toString());
        return all;
    }
    return {};
}

std::size_t linesWith(const std::string& text, const std::string& start) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find("\n" + start, at)) != std::string::npos; ++at) ++count;
    return count;
}
} // namespace

TEST(Engines, EachCanBeWrittenInItsFormat) {
    std::vector<std::string_view> keys;
    for (const Engine& engine : engineTable()) {
        EXPECT_EQ(std::ranges::count(keys, engine.key), 0);
        keys.push_back(engine.key);
        EXPECT_FALSE(engine.label.empty() || engine.notes.empty()) << engine.key;
        const ExportSettings settings = settingsFor(engine);
        const Format* format = formatOf("model" + settings.ending);
        ASSERT_TRUE(format) << engine.key;
        EXPECT_EQ(conflictOf(settings.options, *format), "") << engine.key;
        EXPECT_EQ(adviceOn(settings.options, *format), "") << engine.key;
        EXPECT_EQ(engineNamed(engine.key), &engine);
    }
    for (const char* promised : {"unreal", "unity", "godot", "blender", "three"}) EXPECT_TRUE(engineNamed(promised)) << promised;
    EXPECT_FALSE(engineNamed("maya"));
}

TEST(ExportSettings, AreReadAsTheyWereWritten) {
    for (const Engine& engine : engineTable()) {
        ExportSettings settings = settingsFor(engine);
        EXPECT_EQ(parseSettings(settingsText(settings), "a.export"), settings) << engine.key;
        settings.ending = ".obj";
        settings.options.scale = 2.5;
        settings.options.lods = 0;
        EXPECT_EQ(parseSettings(settingsText(settings), "a.export"), settings) << settingsText(settings);
    }
    EXPECT_EQ(parseSettings("", "a.export"), ExportSettings());
    EXPECT_EQ(parseSettings("lods = file-each # all four\r\nfor = unity\n", "a.export").options.packedMaps,
              static_cast<int>(ExportedPackedMaps::UnityMask))
        << "the engine comes first wherever it stands";
}

TEST(ExportSettings, EveryErrorHasItsPlace) {
    EXPECT_EQ(settingsErrorsOf("for = maya\n  scale = big\nlods=two\n\nwhat\nup = sideways\nformat = .max\nlod = 1.5\ntexture-size = 9000\nlod_s = none\n"),
              (std::vector<std::string>{"a.export:1:7: error: 'for' is one of unreal, unity, godot, blender, three, not 'maya'",
                                        "a.export:2:11: error: 'scale': 'big' is not a number",
                                        "a.export:3:6: error: 'lods' is one of none, one-file, file-each, not 'two'",
                                        "a.export:5:1: error: a line says 'key = value'",
                                        "a.export:6:6: error: 'up' is one of format, y, z, not 'sideways'",
                                        "a.export:7:10: error: " + unknownFormat("model.max"),
                                        "a.export:8:7: error: 'lod': '1.5' is not a number without decimals",
                                        "a.export:9:16: error: 'texture-size' is between 0 and 8192, not 9000",
                                        "a.export:10:1: error: there is no choice 'lod_s', did you mean 'lods'?"}));
}

TEST_F(EngineExport, PicturesAreHalvedUntilTheyFit) {
    write(chosen({{"texture-size", "300"}}), ".gltf");
    for (const char* name : {"tree_bark.png", "tree_bark_normal.png", "tree_leaf.png", "tree_leaf_roughness.png"}) {
        const TextureMaps small = picture(name);
        EXPECT_LE(std::max(small.width, small.height), 300) << name;
        EXPECT_GT(std::max(small.width, small.height), 100) << name;
    }
    const auto cover = [](const TextureMaps& maps) {
        return double(std::ranges::count_if(maps.albedo, [](const auto& p) { return p[3] > 102; })) / double(maps.albedo.size());
    };
    EXPECT_NEAR(cover(picture("tree_leaf.png")), cover(readPng(textureOf(smallModel()->params, Surface::Leaf, {}))), 0.03) << "leaves keep their area";
}

/// What a decoder sees.
std::vector<std::array<std::uint8_t, 4>> jpegPixels(const std::string& bytes, int& width, int& height) {
    const std::unique_ptr<void, int (*)(void*)> jpeg(tjInitDecompress(), tjDestroy);
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    int sampling = 0, colours = 0;
    EXPECT_EQ(tjDecompressHeader3(jpeg.get(), data, bytes.size(), &width, &height, &sampling, &colours), 0);
    std::vector<std::array<std::uint8_t, 4>> pixels(static_cast<std::size_t>(width * height));
    EXPECT_EQ(tjDecompress2(jpeg.get(), data, bytes.size(), pixels.front().data(), width, 0, height, TJPF_RGBX, TJFLAG_ACCURATEDCT), 0);
    return pixels;
}

TEST_F(EngineExport, ColoursOfBarkMayBeJpeg) {
    const fs::path file = write(chosen({{"texture-format", "jpg"}}), ".gltf");
    for (const char* name : {"tree_bark_normal.png", "tree_leaf.png", "tree_leaf_normal.png", "tree_leaf_roughness.png"})
        EXPECT_GT(picture(name).width, 100) << name << " is as before";
    EXPECT_FALSE(fs::exists(file.parent_path() / "tree_bark.png"));
    int width = 0, height = 0;
    const std::string bytes = readFile(file.parent_path() / "tree_bark.jpg");
    const auto pixels = jpegPixels(bytes, width, height);
    const TextureMaps plain = readPng(textureOf(smallModel()->params, Surface::Bark, {}));
    ASSERT_EQ(width, plain.width);
    ASSERT_EQ(height, plain.height);
    double off = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) off += std::abs(int(pixels[i][c]) - int(plain.albedo[i][c]));
    EXPECT_LT(off / double(3 * pixels.size()), 4) << "of 255, on the average";
    EXPECT_LT(bytes.size(), fs::file_size(textureOf(smallModel()->params, Surface::Bark, {})) / 2);
    EXPECT_NE(readFile(file).find("\"tree_bark.jpg\""), std::string::npos);
}

TEST_F(EngineExport, NormalsForDirectXPointDown) {
    write({}, ".gltf");
    const TextureMaps up = picture("tree_bark_normal.png");
    write(chosen({{"normal-maps", "dx"}}), ".gltf");
    const TextureMaps down = picture("tree_bark_normal.png");
    ASSERT_EQ(up.albedo.size(), down.albedo.size());
    for (std::size_t i = 0; i < up.albedo.size(); ++i) {
        ASSERT_EQ(up.albedo[i][0], down.albedo[i][0]);
        ASSERT_EQ(int(down.albedo[i][1]), std::min(255, 256 - int(up.albedo[i][1])));
    }
}

TEST_F(EngineExport, MapsArePacked) {
    const TextureMaps rough = readPng(mapBeside(textureOf(smallModel()->params, Surface::Bark, {}), "_roughness"));
    write(chosen({{"packed-maps", "orm"}}), ".gltf");
    const TextureMaps orm = picture("tree_bark_orm.png");
    const std::string text = readFile(m_folder / "tree.gltf");
    EXPECT_NE(text.find("occlusionTexture"), std::string::npos);
    EXPECT_NE(text.find("tree_bark_orm.png"), std::string::npos);
    write(chosen({{"packed-maps", "unity"}}), ".glb");
    const TextureMaps mask = picture("tree_bark_mask.png");
    for (std::size_t i = 0; i < rough.albedo.size(); i += 97) {
        const std::uint8_t r = rough.albedo[i][1];
        ASSERT_EQ(orm.albedo[i], (std::array<std::uint8_t, 4>{255, r, 0, 255}));
        ASSERT_EQ(mask.albedo[i], (std::array<std::uint8_t, 4>{0, 255, 0, static_cast<std::uint8_t>(255 - r)}));
    }
}

TEST_F(EngineExport, PicturesHoldNoMoreThanTheyShow) {
    write({}, ".gltf");
    EXPECT_FALSE(std::filesystem::exists(m_folder / "tree_bark_roughness.png")) << "as rough all over: a number says it";
    EXPECT_TRUE(std::filesystem::exists(m_folder / "tree_leaf_roughness.png"));
    const TextureMaps rough = readPng(mapBeside(textureOf(smallModel()->params, Surface::Bark, {}), "_roughness"));
    const auto json = nlohmann::json::parse(readFile(m_folder / "tree.gltf"));
    EXPECT_NEAR(json.at("materials").at(0).at("pbrMetallicRoughness").at("roughnessFactor").get<double>(), rough.albedo[0][1] / 255.0, 1e-4);
    constexpr std::size_t kColourType = 25; // of a PNG file: 2 is RGB, 6 has alpha
    EXPECT_EQ(readFile(m_folder / "tree_bark.png")[kColourType], 2);
    EXPECT_EQ(readFile(m_folder / "tree_leaf.png")[kColourType], 6);
}

TEST_F(EngineExport, ObjHasAPictureOfOpacityAndMaps) {
    write({}, ".obj");
    const std::string library = readFile(m_folder / "tree.mtl");
    for (const char* line : {"map_d tree_leaf_opacity.png", "norm tree_bark_normal.png", "map_Bump tree_leaf_normal.png", "map_Pr tree_leaf_roughness.png"})
        EXPECT_NE(library.find(line), std::string::npos) << line;
    EXPECT_EQ(library.find("map_d tree_leaf.png"), std::string::npos) << "three.js would take its green";
    const TextureMaps mask = picture("tree_leaf_opacity.png"), leaf = picture("tree_leaf.png");
    for (std::size_t i = 0; i < mask.albedo.size(); i += 61) {
        const std::uint8_t a = leaf.albedo[i][3];
        ASSERT_EQ(mask.albedo[i], (std::array<std::uint8_t, 4>{a, a, a, a}));
    }
}

TEST_F(EngineExport, LeavesHaveABackWhereReadersCull) {
    const auto faces = [&](std::initializer_list<ChosenValue> values) { return linesWith(readFile(write(chosen(values), ".obj")), "f "); };
    const std::size_t one = faces({{"two-sided", "no"}}), two = faces({{"two-sided", "yes"}});
    EXPECT_EQ(two - one, smallModel()->leaves()->triangleCount());
    EXPECT_EQ(faces({}), two) << "usual in this format";
    for (const Format& format : formatTable()) {
        const bool expected = format.ending == ".obj" || format.ending == ".dae" || format.ending == ".3ds" || format.ending == ".lwo";
        EXPECT_EQ(isTwoSided({}, format), expected) << format.ending;
    }
    EXPECT_NE(conflictOf(chosen({{"two-sided", "yes"}}), *formatOf("a.glb")), "") << "it shows both by itself";
}

TEST_F(EngineExport, NamesHaveNoBlanks) {
    const std::string text = readFile(write({}, ".obj"));
    EXPECT_EQ(linesWith(text, "o branches_1"), 1u);
    for (std::size_t at = 0; (at = text.find("\no ", at)) != std::string::npos; ++at)
        EXPECT_EQ(text.substr(at + 3, text.find('\n', at + 3) - at - 3).find(' '), std::string::npos);
}

TEST(ExportChoices, LevelsThatProgramsStackAreAdvisedAgainst) {
    const ExportOptions stacked = chosen({{"lods", "one-file"}});
    EXPECT_NE(adviceOn(stacked, *formatOf("a.glb")), "");
    if (const Format* osg = formatOf("a.osgb")) {
        EXPECT_EQ(adviceOn(stacked, *osg), "") << "its readers switch";
    }
    EXPECT_EQ(adviceOn(chosen({{"lods", "file-each"}}), *formatOf("a.glb")), "");
    EXPECT_NE(conflictOf(chosen({{"textures", "refer"}, {"texture-size", "256"}}), *formatOf("a.gltf")), "");
}

} // namespace stromar::test
