#include "io/Tools.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Export.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace stromar::test {
namespace {
using Json = nlohmann::json;

class Colours : public testing::Test {
protected:
    Json write(const ExportOptions& options, double variation = 0.5) {
        CParams params = preset("apple");
        params.common.leafColourV = variation;
        params.common.leafSunShade = 0;
        CTreeCreator creator;
        exportTree(creator, params, options, {}, m_file, CProgress(2));
        const std::string bytes = readFile(m_file);
        std::uint32_t size = 0;
        std::memcpy(&size, bytes.data() + 12, sizeof size);
        m_buffer = bytes.substr(28 + size);
        return Json::parse(bytes.substr(20, size));
    }
    /// Empty where a mesh has no such attribute.
    std::string attributeOf(const Json& file, const std::string& mesh, const std::string& name) const {
        for (const Json& one : file["meshes"]) {
            if (one["name"] != mesh) continue;
            const Json& attributes = one["primitives"][0]["attributes"];
            if (!attributes.contains(name)) return {};
            const Json& view = file["bufferViews"][file["accessors"][attributes[name].get<std::size_t>()]["bufferView"].get<std::size_t>()];
            return m_buffer.substr(view.value("byteOffset", std::size_t{0}), view["byteLength"].get<std::size_t>());
        }
        ADD_FAILURE() << "there is no mesh " << mesh;
        return {};
    }
    static ExportOptions with(ExportedOcclusion occlusion) {
        ExportOptions options;
        options.occlusion = static_cast<int>(occlusion);
        return options;
    }

    CTemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "apple.glb";
    std::string m_buffer;
};

double meanOf(const std::string& colours) {
    double sum = 0;
    for (const char c : colours) sum += static_cast<unsigned char>(c);
    return sum / double(colours.size());
}

TEST_F(Colours, OcclusionIsAnAttributeThatDarkensNothing) {
    const Json file = write({}, 0);
    EXPECT_EQ(attributeOf(file, "trunk", "COLOR_0"), "");
    EXPECT_EQ(attributeOf(file, "leaves", "COLOR_0"), "");
    const std::string bytes = attributeOf(file, "leaves", "_OCCLUSION");
    std::vector<float> open(bytes.size() / sizeof(float));
    ASSERT_GT(open.size(), 100u);
    std::memcpy(open.data(), bytes.data(), bytes.size());
    EXPECT_LT(std::ranges::min(open), 0.6);
    EXPECT_GT(std::ranges::max(open), 0.9);
    EXPECT_LE(std::ranges::max(open), 1);
}

TEST_F(Colours, OcclusionMayBeInTheColoursOrNowhere) {
    const Json inColours = write(with(ExportedOcclusion::InColours), 0);
    EXPECT_EQ(attributeOf(inColours, "leaves", "_OCCLUSION"), "");
    EXPECT_LT(meanOf(attributeOf(inColours, "leaves", "COLOR_0")), 245);
    EXPECT_NE(attributeOf(inColours, "trunk", "COLOR_0"), "");
    const Json nowhere = write(with(ExportedOcclusion::None), 0);
    EXPECT_EQ(attributeOf(nowhere, "leaves", "_OCCLUSION") + attributeOf(nowhere, "leaves", "COLOR_0"), "");
}

TEST_F(Colours, EveryLeafHasItsOwn) {
    const Json file = write(with(ExportedOcclusion::None));
    EXPECT_EQ(attributeOf(file, "trunk", "COLOR_0"), "");
    const std::string colours = attributeOf(file, "leaves", "COLOR_0");
    const std::size_t leaves = [&] {
        CTreeCreator creator;
        return creator.create(preset("apple"), detailOf(Model::Full), CProgress(2))->leaves()->count();
    }();
    const std::size_t perLeaf = colours.size() / leaves;
    ASSERT_EQ(colours.size() % leaves, 0u);
    std::set<std::string> different;
    for (std::size_t i = 0; i < leaves; ++i) {
        const std::string own = colours.substr(i * perLeaf, perLeaf);
        for (std::size_t v = 4; v < perLeaf; v += 4) ASSERT_EQ(own.substr(v, 4), own.substr(0, 4)) << "one colour over a leaf";
        different.insert(own.substr(0, 4));
    }
    EXPECT_GT(different.size(), std::min<std::size_t>(leaves / 2, 500));
    EXPECT_GT(meanOf(colours), 190);
    EXPECT_EQ(attributeOf(write(with(ExportedOcclusion::None), 0), "leaves", "COLOR_0"), "") << "all alike";
}

TEST_F(Colours, FormatsWithoutThemRefuse) {
    CTreeCreator creator;
    EXPECT_THROW(exportTree(creator, preset("apple"), with(ExportedOcclusion::InColours), {}, m_folder / "apple.obj", CProgress(2)), CError);
    ExportOptions unity = with(ExportedOcclusion::InColours);
    unity.wind = static_cast<int>(ExportedWind::Unity);
    EXPECT_THROW(exportTree(creator, preset("apple"), unity, {}, m_file, CProgress(2)), CError);
}
} // namespace
} // namespace stromar::test
