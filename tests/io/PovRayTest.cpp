// Scenes read and rendered by POV-Ray. It must be installed: a scene that nobody renders is not tested.
#include "cli/Process.h"
#include "io/ExportedModels.h"
#include "stromar/util/FileSet.h"
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace stromar::test {

namespace {
/// Looks straight along z at a tree that stands around the axis; prints its extent.
std::string wrapperFor(const TreeModel& model, const std::string& file = "tree.pov") {
    const double size = 1.2 * model.tree->height();
    std::ostringstream scene;
    scene << "#version 3.7;\n#declare Tree_Only = 1;\n#include \"" << file << "\"\n"
          << "#debug concat(\"EXTENT \", vstr(3, min_extent(Tree), \" \", 0, 6), \" \", vstr(3, max_extent(Tree), \" "
             "\", 0, 6), \"\\n\")\n"
          << "global_settings { assumed_gamma 1.0 }\nbackground { rgb <1, 0, 1> }\n"
          << "camera { orthographic location <0, " << size / 2 << ", " << -2 * size << "> look_at <0, " << size / 2
          << ", 0> up " << size << "*y right " << size << "*x }\n"
          << "light_source { <0, " << size / 2 << ", " << -5 * size << "> rgb 1 }\nobject { Tree }\n";
    return scene.str();
}

ProcessResult render(const CExported& file, const std::string& scene) {
    return runProcess({"povray", "+I" + scene, "+Oout.ppm", "+FP", "+W64", "+H64", "-D", "+A0.3", "-GW", "+GWwarnings"},
                      {.folder = file.folder()});
}

/// Light through leaves is a feature that POV-Ray calls experimental; nothing else may be worth a warning.
std::string warningIn(const std::string& text) {
    for (std::size_t at = text.find("Warning:"); at != std::string::npos; at = text.find("Warning:", at + 1)) {
        const std::string warning = text.substr(at, 140);
        if (warning.find("backside illumination") == std::string::npos) return warning;
    }
    return {};
}

struct Pixel {
    unsigned char r, g, b;
    bool operator==(const Pixel&) const = default;
};
std::vector<Pixel> pixelsOf(const std::string& path) {
    const std::string content = readFile(path);
    const std::string size = "64 64";
    std::vector<Pixel> pixels(64 * 64);
    if (!content.starts_with("P6") || content.find(size) == std::string::npos || content.size() < 3 * pixels.size())
        return {};
    const std::size_t start = content.size() - 3 * pixels.size();
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(content[start + i]); };
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = {byte(3 * i), byte(3 * i + 1), byte(3 * i + 2)};
    return pixels;
}

Bounds extentIn(const std::string& text) {
    const std::size_t at = text.find("EXTENT ");
    Bounds box{glm::vec3(NAN), glm::vec3(NAN)};
    std::istringstream numbers(at == std::string::npos ? "" : text.substr(at + 7));
    numbers >> box.min.x >> box.min.y >> box.min.z >> box.max.x >> box.max.y >> box.max.z;
    return box;
}

/// All vectors of the lists that start with a word, and how many each list says it has.
struct Lists {
    std::size_t said = 0;
    std::vector<std::vector<float>> vectors;
};
Lists listsOf(const std::string& scene, const std::string& word) {
    Lists lists;
    for (std::size_t at = scene.find(word + " {"); at != std::string::npos; at = scene.find(word + " {", at)) {
        std::istringstream in(scene.substr(at + word.size() + 2, scene.find('}', at) - at - word.size() - 2));
        at += word.size();
        std::size_t count = 0;
        in >> count;
        lists.said += count;
        std::string vector;
        while (std::getline(in, vector, '<') && std::getline(in, vector, '>')) {
            for (char& c : vector) c = c == ',' ? ' ' : c;
            std::istringstream parts(vector);
            lists.vectors.emplace_back();
            for (float value = 0; parts >> value;) lists.vectors.back().push_back(value);
        }
    }
    return lists;
}

std::vector<float> asList(const glm::vec3& v) { return {v.x, v.y, v.z}; }
} // namespace

class PovRay : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, PovRay, testing::Values("small", "aspen"));

TEST_P(PovRay, ReadsAndRendersTheTree) {
    const TreeModel& model = sampleModel(GetParam());
    const CExported file(model, ".pov");
    writeFile(file.folder() + "/wrapper.pov", wrapperFor(model));
    const ProcessResult run = render(file, "wrapper.pov");
    ASSERT_EQ(run.status, 0) << "is POV-Ray installed? " << run.err;
    expectNear(extentIn(run.err + run.out), boundsOf(model, yUpLeftHanded));
    EXPECT_EQ(warningIn(run.err), "");
    EXPECT_EQ(run.err.find("egenerate"), std::string::npos) << run.err;
    const auto pixels = pixelsOf(file.folder() + "/out.ppm");
    ASSERT_FALSE(pixels.empty());
    std::size_t tree = 0, dark = 0;
    for (const Pixel& p : pixels) {
        tree += p != Pixel{255, 0, 255};
        dark += p.r + p.g + p.b < 24;
    }
    EXPECT_GT(tree, 40u) << "nothing to be seen";
    EXPECT_LT(tree, 3500u) << "the leaves' corners are not cut out";
    EXPECT_LT(dark, tree / 2) << "the side that faces the light is black";
}

TEST_P(PovRay, RendersTheSceneWithItsStage) {
    const CExported file(sampleModel(GetParam()), ".pov");
    const ProcessResult run = render(file, "tree.pov");
    ASSERT_EQ(run.status, 0) << "is POV-Ray installed? " << run.err;
    EXPECT_EQ(warningIn(run.err), "");
    const auto pixels = pixelsOf(file.folder() + "/out.ppm");
    ASSERT_FALSE(pixels.empty());
    std::set<int> colours;
    for (const Pixel& p : pixels) colours.insert(p.r << 16 | p.g << 8 | p.b);
    EXPECT_GT(colours.size(), 20u) << "one cannot see the tree";
}

TEST_P(PovRay, HoldsEveryVertexAndFace) {
    const TreeModel& model = sampleModel(GetParam());
    const std::string scene = readFile(CExported(model, ".pov").path());
    const Lists positions = listsOf(scene, "vertex_vectors"), normals = listsOf(scene, "normal_vectors"),
                coords = listsOf(scene, "uv_vectors"), faces = listsOf(scene, "face_indices");
    ASSERT_EQ(positions.vectors.size(), model.vertexCount());
    ASSERT_EQ(faces.vectors.size(), model.triangleCount());
    for (const Lists* lists : {&positions, &normals, &coords}) ASSERT_EQ(lists->said, model.vertexCount());
    EXPECT_EQ(faces.said, model.triangleCount());
    std::size_t vertex = 0, face = 0;
    for (const auto& mesh : model.meshes()) {
        for (std::size_t v = 0; v < mesh->vertexCount(); ++v, ++vertex) {
            ASSERT_EQ(positions.vectors[vertex], asList(yUpLeftHanded(mesh->positions[v])));
            ASSERT_EQ(normals.vectors[vertex], asList(yUpLeftHanded(mesh->normals[v])));
            ASSERT_EQ(coords.vectors[vertex], (std::vector<float>{mesh->texCoords[v].x, mesh->texCoords[v].y}));
        }
        for (std::size_t i = 0; i < mesh->indices.size(); i += 3, ++face)
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_EQ(faces.vectors[face].at(c), static_cast<float>(mesh->indices[i + c]));
    }
}

TEST(PovRayNames, ThatAreUnusual) {
    const TreeModel& model = sampleModel("small");
    for (const char* stem : {"my tree", "Břečťan", "a#b", "it's", "1st"}) {
        const CExported file(model, ".pov", stem);
        writeFile(file.folder() + "/plain.pov", readFile(file.path())); // it cannot include files of every name
        writeFile(file.folder() + "/wrapper.pov", wrapperFor(model, "plain.pov"));
        const ProcessResult run = render(file, "wrapper.pov");
        EXPECT_EQ(run.status, 0) << stem << ": " << run.err;
    }
}

} // namespace stromar::test
