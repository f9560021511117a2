// What every format has in common: all files or none, pictures beside the model, nothing of this machine in the files.
#include "Checkout.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Export.h"
#include "app/SameModel.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Formats.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>
#include <thread>

namespace stromar::test {

namespace {
namespace fs = std::filesystem;

std::shared_ptr<const TreeModel> largeModel() {
    static const auto model = createAnew(preset("quaking_aspen"), detailOf(Model::Full));
    return model;
}

/// The small model with pictures of its own.
TreeModel withPictures(const std::string& bark, const std::string& leaf) {
    TreeModel model = *smallModel();
    model.params.text.barkTexture = bark;
    model.params.text.leafTexture = leaf;
    return model;
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

std::string labelOf(const testing::TestParamInfo<std::size_t>& info) {
    return std::string(formatTable()[info.param].ending.substr(1));
}
} // namespace

class Export : public testing::TestWithParam<std::size_t> {
protected:
    std::string ending() const { return std::string(formatTable()[GetParam()].ending); }
    fs::path target() const { return m_folder / ("tree" + ending()); }
    const Format& format() const { return formatTable()[GetParam()]; }
    bool copiesPictures() const { return format().pictures == Pictures::Beside; }
    void expectUntouched(const std::set<std::string>& names = {}) const { EXPECT_EQ(m_folder.names(), names); }

    CTemporaryFolder m_folder;
};
INSTANTIATE_TEST_SUITE_P(All, Export, testing::Range<std::size_t>(0, formatTable().size()), labelOf);

TEST_P(Export, PutsPicturesBesideTheModel) {
    exportModel(*smallModel(), {}, target(), CProgress(2));
    EXPECT_GT(fs::file_size(target()), 1000u);
    const std::string content = readFile(target());
    std::string library;
    if (fs::exists(m_folder / "tree.mtl")) library = readFile(m_folder / "tree.mtl");
    std::set<std::string> names = {"tree" + ending()};
    if (!library.empty()) names.insert("tree.mtl");
    if (ending() == ".gltf") names.insert("tree.bin");
    for (const Surface surface : {Surface::Bark, Surface::Leaf}) {
        if (!copiesPictures()) break;
        const std::string picture = surface == Surface::Bark ? "tree_bark.png" : "tree_leaf.png";
        ASSERT_TRUE(fs::exists(m_folder / picture)) << picture;
        EXPECT_EQ(readFile(m_folder / picture), readFile(textureOf(smallModel()->params, surface, {})));
        EXPECT_GE(countOf(content + library, picture), 1u) << picture;
        EXPECT_EQ(countOf(content + library, "/" + picture), 0u) << picture;
        EXPECT_EQ(countOf(content + library, "\\" + picture), 0u) << picture;
        names.insert(picture);
    }
    if (format().has(Content::NormalMaps) && copiesPictures()) names.insert({"tree_bark_normal.png", "tree_leaf_normal.png"});
    if ((format().has(Content::RoughnessMaps) || format().looseRoughness) && copiesPictures()) names.insert("tree_leaf_roughness.png");
    if (format().opacity) names.insert("tree_leaf_opacity.png");
    EXPECT_EQ(m_folder.names(), names) << "other files lie about";
}

TEST_P(Export, ABarkOfALevelIsAMaterialOfItsOwn) {
    TreeModel model = *smallModel();
    model.params.text.bark2Texture = "bark:birch seed=4";
    exportModel(model, {}, target(), CProgress(2));
    if (format().pictures == Pictures::None) return;
    std::string content;
    for (const std::string& name : m_folder.names())
        if (!name.ends_with(".png")) content += readFile(m_folder / name);
    EXPECT_GE(countOf(content, "bark_2"), 1u);
    EXPECT_EQ(countOf(content, "bark_1"), 0u) << "shows that of the trunk";
    EXPECT_EQ(fs::exists(m_folder / "tree_bark_2.png"), copiesPictures());
    if (!copiesPictures()) return;
    EXPECT_EQ(readFile(m_folder / "tree_bark_2.png"), readFile(textureOf(model.params, Surface::Bark2, {})));
}

TEST_P(Export, HoldsNothingOfThisMachine) {
    exportModel(*smallModel(), {}, target(), CProgress(2));
    for (const std::string& name : m_folder.names()) {
        if (name.ends_with(".png")) continue;
        const std::string content = readFile(m_folder / name);
        EXPECT_EQ(content.find(m_folder.path().string()), std::string::npos) << name;
        EXPECT_EQ(content.find(inSource()), std::string::npos) << name;
    }
}

TEST_P(Export, GivesTheSameBytesAgain) {
    const CTemporaryFolder other;
    exportModel(*smallModel(), {}, target(), CProgress(1));
    exportModel(*smallModel(), {}, other / target().filename(), CProgress(2));
    ASSERT_EQ(m_folder.names(), other.names());
    for (const std::string& name : m_folder.names())
        EXPECT_TRUE(readFile(m_folder / name) == readFile(other / name)) << name;
}

TEST_P(Export, ReplacesAnOlderModel) {
    writeFile(target(), std::string(3'000'000, 'x'));
    exportModel(*smallModel(), {}, target(), CProgress(2));
    const CTemporaryFolder other;
    exportModel(*smallModel(), {}, other / target().filename(), CProgress(2));
    EXPECT_TRUE(readFile(target()) == readFile(other / target().filename()));
}

TEST_P(Export, TakesTheTreesOwnPictures) {
    const CTemporaryFolder trees;
    fs::create_directory(trees / "pictures");
    writeFile(trees / "pictures/my bark.JPG", "not really a picture");
    const TreeModel model = withPictures("pictures/my bark.JPG", "");
    if (!copiesPictures()) {
        exportModel(*smallModel(), trees.path(), target(), CProgress(2));
        return expectUntouched({target().filename().string()}); // the model alone
    }
    exportModel(model, trees.path(), target(), CProgress(2));
    EXPECT_EQ(readFile(m_folder / "tree_bark.JPG"), "not really a picture");
}

TEST_P(Export, AMissingPictureLeavesNothing) {
    if (format().pictures == Pictures::None) {
        EXPECT_NO_THROW(exportModel(withPictures("none.png", "none.png"), m_folder.path(), target(), CProgress(2)));
        return expectUntouched({target().filename().string()}); // it shows none
    }
    for (const TreeModel& model : {withPictures("none.png", ""), withPictures("", "none.png")})
        EXPECT_THROW(exportModel(model, m_folder.path(), target(), CProgress(2)), CError);
    expectUntouched();
    writeFile(target(), "older");
    EXPECT_THROW(exportModel(withPictures("", "none.png"), m_folder.path(), target(), CProgress(2)), CError);
    EXPECT_EQ(readFile(target()), "older");
    expectUntouched({target().filename().string()});
}

TEST_P(Export, AMissingFolderIsAnError) {
    EXPECT_THROW(exportModel(*smallModel(), {}, m_folder / "none" / target().filename(), CProgress(2)), CError);
    expectUntouched();
}

TEST_P(Export, AFolderInThePlaceStays) {
    fs::create_directory(target());
    writeFile(target() / "inside", "kept");
    EXPECT_THROW(exportModel(*smallModel(), {}, target(), CProgress(2)), CError);
    EXPECT_EQ(readFile(target() / "inside"), "kept");
    expectUntouched({target().filename().string()});
}

TEST_P(Export, AFolderInAPicturesPlaceLeavesTheModel) {
    fs::create_directory(m_folder / "tree_leaf.png");
    writeFile(target(), "older");
    if (!copiesPictures()) { // nothing wants that place
        EXPECT_NO_THROW(exportModel(*smallModel(), {}, target(), CProgress(2)));
        EXPECT_NE(readFile(target()), "older");
        return expectUntouched({"tree_leaf.png", target().filename().string()});
    }
    EXPECT_THROW(exportModel(*smallModel(), {}, target(), CProgress(2)), CError);
    EXPECT_EQ(readFile(target()), "older");
    expectUntouched({"tree_leaf.png", target().filename().string()});
}

TEST_P(Export, CancelledBeforeTheStartLeavesNothing) {
    writeFile(target(), "older");
    const CProgress cancelled(2);
    cancelled.cancel();
    EXPECT_THROW(exportModel(*smallModel(), {}, target(), cancelled), CCancelled);
    EXPECT_EQ(readFile(target()), "older");
    expectUntouched({target().filename().string()});
}

TEST_P(Export, CancelledHalfwayLeavesNothing) {
    writeFile(target(), "older");
    const auto model = largeModel();
    const CProgress progress(2);
    const std::jthread canceller([&](const std::stop_token& stop) {
        while (!stop.stop_requested() && progress.done() < 0.05) std::this_thread::yield();
        progress.cancel();
    });
    EXPECT_THROW(exportModel(*model, {}, target(), progress), CCancelled);
    EXPECT_EQ(readFile(target()), "older");
    expectUntouched({target().filename().string()});
}

TEST_P(Export, ReportsHowFarItIs) {
    const auto model = createAnew(preset("quaking_aspen"), detailOf(Model::Simple));
    const CProgress progress(2);
    exportModel(*model, {}, target(), progress);
    EXPECT_GT(progress.done(), 0.5) << "the format's bytesPerVertex is too large";
    double written = static_cast<double>(fs::file_size(target()));
    if (ending() == ".gltf") written += static_cast<double>(fs::file_size(m_folder / "tree.bin"));
    const double expected = formatTable()[GetParam()].bytesPerVertex * static_cast<double>(model->vertexCount());
    EXPECT_GT(written / expected, 0.5);
    EXPECT_LT(written / expected, 2.0);
}

TEST_P(Export, GivesWhatTheOptionsSayOrRefuses) {
    for (const ExportChoice& choice : exportChoices())
        for (std::size_t word = 1; word < choice.words.size(); ++word) {
            if (!choice.field || choice.key == "lods" || choice.key == "model") continue;
            const CTemporaryFolder folder;
            ExportOptions options;
            options.*choice.field = static_cast<int>(word);
            if (choice.key == "impostor") options.textureSize = 128; // time
            if (choice.key == "watertight") options.voxelSize = 0.05; // likewise
            const fs::path path = folder / target().filename();
            const auto write = [&] { exportModels({smallModel()}, options, {}, path, CProgress(2)); };
            SCOPED_TRACE(std::string(choice.key) + " " + std::string(choice.words[word]));
            if (conflictOf(options, format()).empty()) {
                write();
                EXPECT_TRUE(fs::exists(path));
                const bool copied = choice.key == "textures" ? choice.words[word] == "copy" : copiesPictures();
                const bool asJpeg = choice.key == "texture-format" && choice.words[word] == "jpg";
                EXPECT_EQ(folder.names().contains(asJpeg ? "tree_bark.jpg" : "tree_bark.png"), copied && format().pictures != Pictures::None);
            } else {
                EXPECT_THROW(write(), CError);
                EXPECT_TRUE(folder.names().empty());
            }
        }
}

TEST_P(Export, WritesLevelsOfDetail) {
    std::vector<std::shared_ptr<const TreeModel>> lods;
    CTreeCreator creator;
    ExportOptions options;
    for (const auto kind : {ExportedLods::FileEach, ExportedLods::InOneFile}) {
        options.lods = static_cast<int>(kind);
        if (!conflictOf(options, format()).empty()) continue;
        lods.clear();
        for (const Detail* detail : detailsOf(options))
            lods.push_back(creator.create(smallModel()->params, *detail, CProgress(2)));
        ASSERT_EQ(lods.size(), 4u);
        exportModels(lods, options, {}, target(), CProgress(2));
    }
    std::uintmax_t last = UINTMAX_MAX;
    for (int lod = 0; lod < 4; ++lod) {
        const fs::path each = m_folder / ("tree_LOD" + std::to_string(lod) + (ending() == ".gltf" ? ".bin" : ending()));
        ASSERT_TRUE(fs::exists(each)) << each;
        if (lod == 2 && format().pictures >= Pictures::Inside) last = UINTMAX_MAX; // with the picture of the twigs, which the finer ones have no use for
        EXPECT_LT(fs::file_size(each), last) << each;
        last = fs::file_size(each);
    }
    EXPECT_EQ(fs::exists(target()), format().lods);
}

TEST_P(Export, ScalesAndTurns) {
    ExportOptions options;
    options.scale = 100;
    EXPECT_EQ(conflictOf(options, format()), "");
    exportModels({smallModel()}, options, {}, target(), CProgress(2));
    EXPECT_GT(fs::file_size(target()), 1000u);
    options.up = static_cast<int>(format().upAxis == "y" ? ExportedUp::Z : ExportedUp::Y);
    EXPECT_EQ(conflictOf(options, format()).empty(), format().anyUp);
}

TEST(ExportAnything, AnUnknownFormatIsAnError) {
    const CTemporaryFolder folder;
    EXPECT_THROW(exportModel(*smallModel(), {}, folder / "tree.dwg", CProgress(2)), CError);
    EXPECT_TRUE(folder.names().empty());
}

TEST(ExportAnything, BuiltInPicturesExist) {
    for (const Surface surface : {Surface::Bark, Surface::Leaf})
        EXPECT_TRUE(fs::is_regular_file(textureOf(CParams(), surface, {})));
}

} // namespace stromar::test
