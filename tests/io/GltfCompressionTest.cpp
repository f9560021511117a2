// Compressed glTF: read by three.js, checked by the validator, decoded back to what was compressed.
#include "Checkout.h"
#include "io/ExportedModels.h"
#include "io/NodeReads.h"
#include "io/Tools.h"
#include "stromar/app/Export.h"
#include "stromar/util/FileSet.h"
#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

namespace stromar::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {
fs::path exported(const CTemporaryFolder& folder, const TreeModel& model, ExportedCompression compression, const char* ending,
                  ExportedLods lods = ExportedLods::None) {
    const fs::path path = folder / ("tree_" + std::to_string(static_cast<int>(compression)) + ending);
    ExportOptions options;
    options.compression = static_cast<int>(compression);
    options.lods = static_cast<int>(lods);
    CTreeCreator creator;
    exportTree(creator, model.params, options, {}, path, CProgress(2));
    return path;
}

/// A .gltf with its buffer.
struct File {
    Json json;
    std::string buffer;

    explicit File(const fs::path& path) : json(Json::parse(readFile(path))) {
        buffer = readFile(path.parent_path() / json["buffers"][0]["uri"].get<std::string>());
    }
    std::string bytesOf(const Json& view) const { return buffer.substr(view.value("byteOffset", 0u), view["byteLength"]); }
    const Json& viewOf(const Json& accessor) const { return json["bufferViews"][json["accessors"][accessor.get<std::size_t>()]["bufferView"].get<std::size_t>()]; }

    /// As a program with the decoder reads it.
    std::string decoded(const Json& view) const {
        if (!view.contains("extensions")) return bytesOf(view);
        const Json& packed = view["extensions"]["EXT_meshopt_compression"];
        const std::size_t count = packed["count"], stride = packed["byteStride"];
        const std::string source = buffer.substr(packed["byteOffset"], packed["byteLength"]);
        std::string bytes(count * stride, '\0');
        const auto* from = reinterpret_cast<const unsigned char*>(source.data());
        const int failed = packed["mode"] == "TRIANGLES" ? meshopt_decodeIndexBuffer(bytes.data(), count, stride, from, source.size())
                                                         : meshopt_decodeVertexBuffer(bytes.data(), count, stride, from, source.size());
        EXPECT_EQ(failed, 0);
        return bytes;
    }
};

/// The same triangles, whichever corner they begin with.
std::vector<std::array<std::uint32_t, 3>> trianglesIn(const std::string& bytes, std::size_t stride) {
    std::vector<std::array<std::uint32_t, 3>> triangles(bytes.size() / stride / 3);
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) std::memcpy(&triangles[i / 3][i % 3], bytes.data() + i * stride, stride);
    for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return triangles;
}
} // namespace

class GltfCompression : public testing::TestWithParam<ExportedCompression> {};
INSTANTIATE_TEST_SUITE_P(All, GltfCompression, testing::Values(ExportedCompression::Quantised, ExportedCompression::Meshopt),
                         [](const auto& one) { return std::string(one.param == ExportedCompression::Quantised ? "quantize" : "meshopt"); });

TEST_P(GltfCompression, IsValidAndSmaller) {
    needTool(fs::exists(inBin("../node_modules/gltf-validator")), "the validator of glTF files (npm)");
    if (HasFailure() || IsSkipped()) return;
    const CTemporaryFolder folder;
    const TreeModel& model = sampleModel("aspen");
    for (const ExportedLods lods : {ExportedLods::None, ExportedLods::InOneFile}) {
        const fs::path path = exported(folder, model, GetParam(), ".gltf", lods), plain = exported(folder, model, ExportedCompression::None, ".gltf", lods);
        const Json issues = validatedGltf(path).at("issues");
        EXPECT_EQ(issues.at("numErrors"), 0) << issues.dump(1);
        EXPECT_EQ(issues.at("numWarnings"), 0) << issues.dump(1);
        EXPECT_LT(double(File(path).buffer.size()), (GetParam() == ExportedCompression::Quantised ? 0.62 : 0.3) * double(File(plain).buffer.size()));
        ExportOptions options;
        options.compression = static_cast<int>(GetParam());
        if (lods == ExportedLods::None) {
            EXPECT_NEAR(estimatedBytes(double(model.vertexCount()), options, *formatOf(path)) / double(File(path).buffer.size()), 1, 0.5);
        }
        EXPECT_EQ(File(path).json["extensionsRequired"].size(), GetParam() == ExportedCompression::Quantised ? 1u : 2u);
    }
}

TEST_P(GltfCompression, ThreeReadsTheSameTree) {
    needTool(fs::exists(inBin("../node_modules/three")), "three.js (npm)");
    if (HasFailure() || IsSkipped()) return;
    const CTemporaryFolder folder;
    const TreeModel& model = sampleModel("aspen");
    const auto read = [&](ExportedCompression compression) {
        return readByThree(exported(folder, model, compression, ".glb"));
    };
    const Json plain = read(ExportedCompression::None), small = read(GetParam());
    for (const char* same : {"triangles", "objects", "materials", "opaque", "colours"}) EXPECT_EQ(small.at(same), plain.at(same)) << same;
    for (const char* corner : {"min", "max"})
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(small.at(corner).at(i), plain.at(corner).at(i), 0.0005) << corner << i << ": half a step";
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(small.at("normal").at(i), plain.at("normal").at(i), 0.01) << "the mean of all";
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(small.at("uv").at(i), plain.at("uv").at(i), 0.001) << "the mean of all";
}

TEST(GltfMeshopt, DecodesToWhatWasQuantised) {
    const CTemporaryFolder folder;
    const TreeModel& model = sampleModel("aspen");
    const File packed(exported(folder, model, ExportedCompression::Meshopt, ".gltf")), plain(exported(folder, model, ExportedCompression::Quantised, ".gltf"));
    ASSERT_EQ(packed.json["meshes"].size(), plain.json["meshes"].size());
    for (std::size_t m = 0; m < plain.json["meshes"].size(); ++m) {
        const Json &one = packed.json["meshes"][m]["primitives"][0], &other = plain.json["meshes"][m]["primitives"][0];
        for (const auto& [name, accessor] : other["attributes"].items())
            EXPECT_TRUE(packed.decoded(packed.viewOf(one["attributes"][name])) == plain.bytesOf(plain.viewOf(accessor))) << name;
        const std::size_t stride = plain.json["accessors"][other["indices"].get<std::size_t>()]["componentType"] == 5123 ? 2 : 4;
        EXPECT_TRUE(trianglesIn(packed.decoded(packed.viewOf(one["indices"])), stride) == trianglesIn(plain.bytesOf(plain.viewOf(other["indices"])), stride));
    }
}

TEST(GltfMeshopt, OfATreeBeforeItsLifeIsAFileWithoutMeshes) {
    const CTemporaryFolder folder;
    ExportOptions options;
    options.compression = static_cast<int>(ExportedCompression::Meshopt);
    CTreeCreator creator;
    creator.setAge(0);
    exportTree(creator, sampleModel("small").params, options, {}, folder / "seed.gltf", CProgress(2));
    const Json file = Json::parse(readFile(folder / "seed.gltf"));
    EXPECT_FALSE(file.contains("meshes"));
    EXPECT_FALSE(file.contains("extensionsRequired"));
    for (const Json& buffer : file.value("buffers", Json::array())) EXPECT_GT(buffer["byteLength"], 0);
}

TEST(GltfCompressionChoice, IsRefusedWhereItCannotBe) {
    ExportOptions options;
    options.compression = static_cast<int>(ExportedCompression::Meshopt);
    EXPECT_EQ(conflictText(options, *formatOf("x.glb")), "");
    EXPECT_EQ(conflictText(options, *formatOf("x.obj")), ".obj cannot be compressed; choose glTF");
    options.wind = static_cast<int>(ExportedWind::Attributes);
    EXPECT_EQ(conflictText(options, *formatOf("x.glb")), "what moves in the wind cannot be compressed");
}

} // namespace stromar::test
