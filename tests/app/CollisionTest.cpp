#include "mesh/SampleTrees.h"
#include "stromar/app/Collision.h"
#include "stromar/app/Export.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace {
using Json = nlohmann::json;

double distanceTo(const glm::dvec3& point, const Capsule& capsule) {
    const glm::dvec3 along = capsule.to - capsule.from;
    const double part = std::clamp(glm::dot(point - capsule.from, along) / std::max(1e-12, glm::dot(along, along)), 0.0, 1.0);
    return glm::length(point - (capsule.from + part * along)) - capsule.radius;
}
} // namespace

TEST(Collision, CoversTheTrunkAndThickBranches) {
    for (const char* name : {"quaking_aspen", "english_oak", "weeping_willow", "coconut_palm", "strand_winter"}) {
        CTreeCreator creator;
        const auto model = creator.create(preset(name), detailOf(Model::Simple), CProgress(2));
        const std::vector<Capsule> capsules = collisionOf(*model->tree);
        ASSERT_FALSE(capsules.empty()) << name;
        EXPECT_LE(capsules.size(), kMaxCapsules);
        EXPECT_TRUE(std::ranges::is_sorted(capsules, std::greater(), &Capsule::radius));
        for (const CSegment& segment : model->tree->generation(0).segments) {
            if (segment.radiusEnd < 0.25 * model->tree->generation(0).stems[0].radius) continue;
            const double nearest = distanceTo(segment.axisPoint(0.5), *std::ranges::min_element(capsules, {}, [&](const Capsule& c) { return distanceTo(segment.axisPoint(0.5), c); }));
            EXPECT_LT(nearest, 0) << name << ": the trunk's axis lies inside";
        }
    }
}

TEST(Collision, FilesHaveHullsWithTheNamesThatEnginesLookFor) {
    const CTemporaryFolder folder;
    CTreeCreator creator;
    const CParams params = preset("quaking_aspen");
    for (const auto& [kind, start, end] : {std::tuple{ExportedCollision::Unreal, "UCX_trunk_", ""}, {ExportedCollision::Godot, "oak_collision_", "-colonly"}}) {
        ExportOptions options;
        options.collision = static_cast<int>(kind);
        options.scale = 2;
        options.lod = 3;
        exportTree(creator, params, options, {}, folder / "oak.gltf", CProgress(2));
        const Json list = Json::parse(readFile(folder / "oak_collision.json")), file = Json::parse(readFile(folder / "oak.gltf"));
        EXPECT_EQ(list["up"], "y");
        std::size_t hulls = 0;
        double top = 0;
        for (const Json& node : file["nodes"]) {
            const std::string name = node["name"];
            if (!name.starts_with(start) || !name.ends_with(end)) continue;
            ++hulls;
            const Json& primitive = file["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
            EXPECT_EQ(file["accessors"][primitive["indices"].get<std::size_t>()]["count"], 3 * (8 * 2 + 8 * 2 * 3)) << "two ends and three bands";
            top = std::max(top, file["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()]["max"][1].get<double>());
        }
        EXPECT_EQ(hulls, list["capsules"].size());
        EXPECT_GT(hulls, 0u);
        double wanted = 0;
        for (const Json& capsule : list["capsules"])
            wanted = std::max({wanted, capsule["from"][1].get<double>() + capsule["radius"].get<double>(), capsule["to"][1].get<double>() + capsule["radius"].get<double>()});
        EXPECT_NEAR(top, wanted, 0.02 * wanted) << "the same in both, in the scale of the file";
    }
    ExportOptions options;
    options.collision = static_cast<int>(ExportedCollision::Json);
    exportTree(creator, params, options, {}, folder / "list.obj", CProgress(2));
    EXPECT_EQ(readFile(folder / "list.obj").find("UCX"), std::string::npos);
    EXPECT_THROW(exportTree(creator, params, options, {}, folder / "list.stl", CProgress(2)), CError);
}

TEST(Collision, OnlyTheFinestOfSeveralFilesHasIt) {
    const CTemporaryFolder folder;
    CTreeCreator creator;
    ExportOptions options;
    options.collision = static_cast<int>(ExportedCollision::Unreal);
    options.lods = static_cast<int>(ExportedLods::FileEach);
    exportTree(creator, preset("quaking_aspen"), options, {}, folder / "a.gltf", CProgress(2));
    EXPECT_NE(readFile(folder / "a_LOD0.gltf").find("UCX_"), std::string::npos);
    EXPECT_EQ(readFile(folder / "a_LOD1.gltf").find("UCX_"), std::string::npos);
}

} // namespace stromar::test
