// Models read back by OpenSceneGraph in a fresh process.
#include "Checkout.h"
#include "cli/Process.h"
#include "io/ExportedModels.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/app/Export.h"
#include <filesystem>
#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace {
Bounds boundsIn(const nlohmann::json& stats) {
    const auto vector = [](const nlohmann::json& v) { return glm::vec3(v.at(0), v.at(1), v.at(2)); };
    return {vector(stats.at("min")), vector(stats.at("max"))};
}

std::set<std::string> fileNames(const nlohmann::json& paths) {
    std::set<std::string> names;
    for (const std::string path : paths) names.insert(std::filesystem::path(path).filename().string());
    return names;
}
void expectTexCoords(const nlohmann::json& stats, const TreeModel& model) {
    glm::vec2 low(1e30f), high(-1e30f);
    for (const Corner& corner : cornersOf(model, zUp)) {
        low = glm::min(low, corner.texCoord);
        high = glm::max(high, corner.texCoord);
    }
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(stats.at("tex_min").at(static_cast<std::size_t>(i)), low[i], 1e-5);
        EXPECT_NEAR(stats.at("tex_max").at(static_cast<std::size_t>(i)), high[i], 1e-5);
    }
}

/// Its 3DS reader says so of every file without animation.
std::string withoutNotice(std::string text) {
    const std::string notice = "Warning: in 3ds loader: file has no nodes, traversing by meshes instead\n";
    if (const auto at = text.find(notice); at != std::string::npos) text.erase(at, notice.size());
    return text;
}
} // namespace

class OsgReads : public testing::TestWithParam<ReadCase> {};
INSTANTIATE_TEST_SUITE_P(All, OsgReads, testing::ValuesIn(readCases(kOsg, {"small", "aspen"})), labelOf);

TEST_P(OsgReads, TheWholeModel) {
    const TreeModel& model = sampleModel(GetParam().sample);
    const CExported file(model, GetParam().ending);
    const ProcessResult run = runProcess({inBin("osg-stats"), file.path()}, {.folder = file.folder()});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(withoutNotice(run.err), "");
    const auto stats = nlohmann::json::parse(run.out);
    EXPECT_EQ(stats.at("triangles"), model.triangleCount());
    expectNear(boundsIn(stats), boundsOf(model, zUp)); // its readers turn OBJ and COLLADA files upright
    const bool plain = formatOf(file.path())->pictures == Pictures::None;
    if (plain || GetParam().ending == ".dae") return; // its COLLADA reader drops materials and texture coordinates
    EXPECT_NEAR(stats.at("bark_volume"), barkVolume(model), 0.01 * barkVolume(model))
        << "the bark does not face outwards";
    EXPECT_EQ(stats.at("materials"), (nlohmann::json{"bark", "leaf"}));
    EXPECT_EQ(fileNames(stats.at("textures")), (std::set<std::string>{"tree_bark.png", "tree_leaf.png"}));
    expectTexCoords(stats, model);
}

TEST(OsgReadsLods, AllOfThem) {
    CTreeCreator creator;
    std::vector<std::shared_ptr<const TreeModel>> lods;
    std::size_t triangles = 0;
    ExportOptions options;
    options.lods = static_cast<int>(ExportedLods::InOneFile);
    for (const Detail* detail : detailsOf(options)) {
        lods.push_back(joined(creator.create(sampleModel("small").params, *detail, CProgress(2)), CProgress(2)));
        triangles += lods.back()->triangleCount();
    }
    for (const char* ending : {".osg", ".osgt", ".osgb"}) {
        const CTemporaryFolder folder;
        const auto path = folder / ("tree" + std::string(ending));
        exportModels(lods, options, {}, path, CProgress(2));
        const ProcessResult run =
            runProcess({inBin("osg-stats"), path.string()}, {.folder = folder.path().string()});
        ASSERT_EQ(run.status, 0) << run.err;
        const auto stats = nlohmann::json::parse(run.out);
        EXPECT_EQ(stats.at("triangles"), triangles) << ending;
        EXPECT_EQ(stats.at("root"), "LOD") << ending;
    }
}

} // namespace stromar::test
