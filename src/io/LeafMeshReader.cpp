#include "stromar/io/LeafMeshReader.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cstring>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace stromar {

namespace {
using Json = nlohmann::json;

// What assimp makes of a byte can be hundreds of bytes.
constexpr std::uintmax_t kMaxObjBytes = 4u << 20, kMaxGlbBytes = 64u << 20; // pictures in a .glb are not unpacked
constexpr std::uint32_t kMaxHeadBytes = 1u << 20;
constexpr int kMaxDepth = 64; // of brackets: readers call themselves for each
constexpr double kMaxValues = 50.0 * kMaxLeafPoints; // vertices, corners and keys that a .glb refers to

/// Files refer to others, of any size or kind: none of them is opened.
class COneFile : public Assimp::DefaultIOSystem {
public:
    explicit COneFile(std::string file) : m_file(std::move(file)) {}
    bool Exists(const char* file) const override { return file == m_file && DefaultIOSystem::Exists(file); }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        return file == m_file ? DefaultIOSystem::Open(file, mode) : nullptr;
    }

private:
    std::string m_file;
};

/// The JSON of a .glb: behind a head of 12 bytes a chunk with its length and type. Null where it is none, or too large.
Json glbHead(const std::string& bytes) {
    constexpr std::size_t kHead = 20;
    std::uint32_t length = 0;
    if (bytes.size() >= kHead) std::memcpy(&length, bytes.data() + 12, sizeof length);
    if (!bytes.starts_with("glTF") || length == 0 || length > kMaxHeadBytes || length > bytes.size() - kHead) return {};
    int deepest = 0;
    const auto measure = [&](int depth, Json::parse_event_t, Json&) {
        deepest = std::max(deepest, depth);
        return true;
    };
    Json head = Json::parse(bytes.begin() + kHead, bytes.begin() + kHead + length, measure, false);
    return deepest <= kMaxDepth ? head : Json();
}

/// How many values its parts refer to, each as often as it is referred to: so many are copied.
double valuesIn(const Json& part, const Json& accessors) {
    double sum = 0;
    for (const auto& item : part.items()) {
        const Json& own = item.value();
        if (own.is_structured())
            sum += valuesIn(own, accessors);
        else if (own.is_number_unsigned() && own < accessors.size() && accessors[own.get<std::size_t>()].is_object())
            sum += accessors[own.get<std::size_t>()].value("count", 0.0);
    }
    return sum;
}

bool isModest(const std::string& glb) {
    const Json head = glbHead(glb);
    if (!head.is_object() || !head.contains("meshes") || !head.contains("accessors") || !head["accessors"].is_array()) return false;
    double values = 0;
    for (const char* part : {"meshes", "animations", "skins"})
        if (head.contains(part)) values += valuesIn(head[part], head["accessors"]);
    return values <= kMaxValues;
}

glm::dvec3 vectorOf(const aiVector3D& v) { return {v.x, v.y, v.z}; }

void add(LeafBlade& all, const aiMesh& mesh, const aiMatrix4x4& place) {
    const auto first = static_cast<std::uint32_t>(all.points.size());
    const aiMatrix3x3 normals = aiMatrix3x3(place).Inverse().Transpose();
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D at = mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0][i] : aiVector3D();
        const glm::dvec3 normal = mesh.HasNormals() ? vectorOf(normals * mesh.mNormals[i]) : glm::dvec3(0);
        const double size = glm::length(normal);
        all.points.push_back({vectorOf(place * mesh.mVertices[i]), size > 0 ? normal / size : glm::dvec3(0, 0, 1), {at.x, at.y}});
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
        for (unsigned c = 0; c < 3; ++c) all.indices.push_back(first + mesh.mFaces[f].mIndices[c]);
}

/// With all below it, as often as they stand there. False when that becomes too much.
bool add(LeafBlade& all, const aiScene& scene, const aiNode& node, const aiMatrix4x4& above) {
    const aiMatrix4x4 place = above * node.mTransformation;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
        if (!(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE)) continue;
        if (all.points.size() + mesh.mNumVertices > kMaxLeafPoints) return false;
        add(all, mesh, place);
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        if (!add(all, scene, *node.mChildren[c], place)) return false;
    return true;
}
} // namespace

LeafBlade readLeafMesh(const std::filesystem::path& file) {
    const auto fault = [&](const std::string& text) { return CError(file.string() + ": " + text); };
    const CError tooLarge = fault(translated(NC_("stromar", "is too large: a leaf may have at most %1 vertices"), kMaxLeafPoints));
    const std::string ending = lowerCase(file.extension().string());
    if (ending != ".obj" && ending != ".glb") throw fault(translated(NC_("stromar", "is neither .obj nor .glb")));
    std::error_code problem;
    const std::uintmax_t bytes = std::filesystem::file_size(file, problem);
    if (problem) throw fault(translated(NC_("stromar", "cannot be read: %1"), problem.message()));
    if (bytes > (ending == ".glb" ? kMaxGlbBytes : kMaxObjBytes)) throw tooLarge;
    if (ending == ".glb" && !isModest(readFile(file))) throw fault(translated(NC_("stromar", "is no .glb with a mesh, or too large for a leaf")));
    Assimp::Importer importer;
    importer.SetIOHandler(new COneFile(file.string())); // which the importer deletes
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices |
                                                                aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    if (!scene) throw fault(translated(NC_("stromar", "is no mesh that can be read: %1"), importer.GetErrorString()));
    LeafBlade all;
    if (!add(all, *scene, *scene->mRootNode, {})) throw tooLarge;
    if (all.indices.empty()) throw fault(translated(NC_("stromar", "has no triangles")));
    return all;
}

} // namespace stromar
