#include "ExportedModels.h"
#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 3;

Motion growth() {
    Motion motion;
    motion.frames = kFrames;
    return motion;
}

Motion wind() {
    Motion motion = growth();
    motion.wind.strength = 0.8;
    return motion;
}

void writeSamples(const Motion& motion, const ExportOptions& options, const fs::path& path, const SizeLimits& limits = {}) {
    exportTimeSamples(sampleModel("small").params, options, motion, 1, true, limits, {}, path, CProgress(2));
}

void writeFrames(const Motion& motion, const ExportOptions& options, const fs::path& path) {
    exportFrames(sampleModel("small").params, options, motion, 1, true, SizeLimits(), {}, path, [](const fs::path&) {}, CProgress(2));
}

/// The text of a value behind what leads to it, "[…]"; empty where it is not.
std::string valueBehind(const std::string& text, const std::string& lead, std::size_t from = 0) {
    const std::size_t at = text.find(lead, from);
    if (at == std::string::npos) return {};
    const std::size_t begin = text.find('[', at + lead.size());
    return text.substr(begin, text.find(']', begin) + 1 - begin);
}

/// The part of the text that a mesh takes.
std::string meshIn(const std::string& text, const std::string& name) {
    const std::size_t begin = text.find("def Mesh \"" + name + "\"");
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find("\n    }\n", begin) - begin);
}

/// Of an attribute at a time; its value where it has no samples.
std::string sampleOf(const std::string& mesh, const std::string& attribute, int time) {
    const std::size_t samples = mesh.find(attribute + ".timeSamples");
    return samples == std::string::npos ? valueBehind(mesh, attribute + " = ") : valueBehind(mesh, " " + std::to_string(time) + ": ", samples);
}

/// Every moment is what the file of that frame alone holds.
void expectFramesIn(const std::string& text, const fs::path& frames) {
    for (int frame = 1; frame <= kFrames; ++frame) {
        const std::string alone = readFile(framePath(frames, std::size_t(frame - 1), kFrames));
        for (const char* mesh : {"trunk", "branches_1", "leaves"})
            for (const char* attribute : {"extent", "faceVertexCounts", "faceVertexIndices", "normals", "points", "primvars:st"}) {
                const std::string wanted = valueBehind(meshIn(alone, mesh), std::string(attribute) + " = ");
                const std::string found = sampleOf(meshIn(text, mesh), attribute, frame);
                if (wanted.empty() && std::string(attribute) == "extent") continue; // of nothing
                EXPECT_EQ(found, wanted.empty() ? "[]" : wanted) << frame << ' ' << mesh << ' ' << attribute;
            }
    }
}
} // namespace

TEST(TimeSamples, AreTheFramesOfAGrowingTree) {
    const CTemporaryFolder folder;
    writeSamples(growth(), {}, folder / "all.usda");
    writeFrames(growth(), {}, folder / "each.usda");
    const std::string text = readFile(folder / "all.usda");
    expectFramesIn(text, folder / "each.usda");
    for (const char* said : {"startTimeCode = 1\n", "endTimeCode = 3\n", "timeCodesPerSecond = 25\n", "points.timeSamples = {", "primvars:st.timeSamples = {"})
        EXPECT_NE(text.find(said), std::string::npos) << said;
    EXPECT_EQ(valueBehind(meshIn(text, "leaves"), "points = "), sampleOf(meshIn(text, "leaves"), "points", kFrames)) << "programs without motion show the last";
}

TEST(TimeSamples, OfTheWindMoveNothingButVertices) {
    const CTemporaryFolder folder;
    Motion motion = wind();
    motion.seconds = 2;
    writeSamples(motion, {}, folder / "all.usda");
    writeFrames(motion, {}, folder / "each.usda");
    const std::string text = readFile(folder / "all.usda");
    expectFramesIn(text, folder / "each.usda");
    EXPECT_NE(text.find("timeCodesPerSecond = 1.5\n"), std::string::npos);
    EXPECT_NE(text.find("normals.timeSamples = {"), std::string::npos);
    EXPECT_EQ(text.find("faceVertexIndices.timeSamples"), std::string::npos);
    EXPECT_EQ(text.find("primvars:st.timeSamples"), std::string::npos);
}

TEST(TimeSamples, GoWithEveryLevelOfDetailAndWithMergedMeshes) {
    const CTemporaryFolder folder;
    ExportOptions options;
    options.lods = static_cast<int>(ExportedLods::FileEach);
    options.objects = static_cast<int>(ExportedObjects::Materials);
    writeSamples(wind(), options, folder / "tree.usdz");
    for (int lod = 0; lod < 4; ++lod) {
        const std::string text = readFile(folder / ("tree_LOD" + std::to_string(lod) + ".usdz"));
        EXPECT_NE(text.find("def Mesh \"bark\""), std::string::npos) << lod;
        EXPECT_FALSE(sampleOf(meshIn(text, "bark"), "points", kFrames).empty()) << lod;
    }
}

TEST(TimeSamples, AreRefusedWhereTheyCannotBe) {
    const CTemporaryFolder folder;
    EXPECT_THROW(writeSamples(growth(), {}, folder / "tree.glb"), CError);
    ExportOptions options;
    options.lods = static_cast<int>(ExportedLods::InOneFile);
    EXPECT_THROW(writeSamples(wind(), options, folder / "tree.usda"), CError);
    options = {};
    options.lod = 2;
    EXPECT_THROW(writeSamples(growth(), options, folder / "tree.usda"), CError) << "cards of another twig in every frame";
    Motion many = wind();
    many.frames = 100000;
    EXPECT_THROW(writeSamples(many, {}, folder / "tree.usda"), CTooLarge);
    EXPECT_TRUE(folder.names().empty());
}

} // namespace stromar::test
