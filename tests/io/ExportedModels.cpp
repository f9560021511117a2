#include "io/ExportedModels.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Export.h"
#include "stromar/model/JoinedModel.h"
#include <algorithm>
#include <glm/common.hpp>
#include <gtest/gtest.h>
#include <stdexcept>

namespace stromar::test {

const ForeignReader kAssimp{"assimp", {".obj", ".dae", ".3ds", ".lwo", ".glb", ".gltf"}};
const ForeignReader kOsg{"osgDB in another process",
                         {".osg", ".osgt", ".osgb", ".obj", ".3ds", ".dae", ".ply", ".stl"}};
const ForeignReader kPovRay{"POV-Ray", {".pov"}};
const ForeignReader kThree{"three.js", {".fbx", ".usda", ".usdz"}};

namespace {
/// With one bark for all stems; with its wood in one piece, as files have it.
std::shared_ptr<const TreeModel> create(CParams params, const Detail& detail) {
    params.text.bark1Texture = params.text.bark2Texture = params.text.bark3Texture = "";
    return joined(CTreeCreator().create(params, detail, CProgress(2)), CProgress(2));
}

CParams fewBranches() {
    CParams params = preset("quaking_aspen");
    weberPenn(params).level[1].branches = 8;
    weberPenn(params).level[2].branches = 4;
    params.common.textureWrapX = 2;
    params.common.textureWrapY = 3;
    return params;
}
} // namespace

const std::vector<SampleModel>& sampleModels() {
    static const std::vector<SampleModel> all = {{"small", create(fewBranches(), detailOf(Model::Full))},
                                                 {"aspen", create(preset("quaking_aspen"), detailOf(Model::Full))},
                                                 {"tupelo", create(preset("black_tupelo"), detailOf(Model::Full))}};
    return all;
}

const TreeModel& sampleModel(const std::string& name) {
    const auto found = std::ranges::find(sampleModels(), name, &SampleModel::name);
    if (found == sampleModels().end()) throw std::runtime_error("no model " + name);
    return *found->model;
}

std::vector<Corner> cornersOf(const TreeModel& model, Axes axes) {
    std::vector<Corner> corners;
    for (const auto& mesh : model.meshes())
        for (const std::uint32_t v : mesh->indices)
            corners.push_back({axes(mesh->positions[v]), axes(mesh->normals[v]), mesh->texCoords[v]});
    return corners;
}

Bounds boundsOf(const TreeModel& model, Axes axes) {
    std::vector<glm::vec3> points;
    for (const auto& mesh : model.meshes())
        for (const glm::vec3& p : mesh->positions) points.push_back(axes(p));
    Bounds box{points.front(), points.front()};
    for (const glm::vec3& p : points) box = {glm::min(box.min, p), glm::max(box.max, p)};
    return box;
}

double barkVolume(const TreeModel& model) { return signedVolume(model.stems); }

void expectNear(const Bounds& box, const Bounds& wanted) {
    for (int i = 0; i < 3; ++i) {
        const float tolerance = 1e-4f * (wanted.max[i] - wanted.min[i]);
        EXPECT_NEAR(box.min[i], wanted.min[i], tolerance) << "axis " << i;
        EXPECT_NEAR(box.max[i], wanted.max[i], tolerance) << "axis " << i;
    }
}

CExported::CExported(const TreeModel& model, const std::string& ending, const std::string& stem)
    : m_path((m_folder / (stem + ending)).string()) {
    ExportOptions options;
    options.twoSided = static_cast<int>(ExportedTwoSided::No); // as many triangles as the model
    exportModels({std::shared_ptr<const TreeModel>(std::shared_ptr<const TreeModel>(), &model)}, options, {}, m_path, CProgress(2));
}

void PrintTo(const ReadCase& readCase, std::ostream* out) { *out << readCase.sample << readCase.ending; }

std::vector<ReadCase> readCases(const ForeignReader& reader, const std::vector<std::string>& samples) {
    std::vector<ReadCase> all;
    for (const std::string& ending : reader.endings)
        for (const std::string& sample : samples) all.push_back({ending, sample});
    return all;
}

std::string labelOf(const testing::TestParamInfo<ReadCase>& info) { return info.param.ending.substr(1) + "_" + info.param.sample; }

ExportOptions chosen(std::initializer_list<std::pair<const char*, const char*>> words) {
    ExportOptions options;
    for (const auto& [key, word] : words) setChoice(options, key, word);
    return options;
}

} // namespace stromar::test
