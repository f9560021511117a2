#include "stromar/io/LeafMeshReader.h"
#include "stromar/util/Error.h"
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::uintmax_t kMaxBytes = 64u << 20; // text of so many points is far less

glm::dvec3 vectorOf(const aiVector3D& v) { return {v.x, v.y, v.z}; }

void add(LeafBlade& all, const aiMesh& mesh) {
    const auto first = static_cast<std::uint32_t>(all.points.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D at = mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0][i] : aiVector3D();
        const glm::dvec3 normal = mesh.HasNormals() ? vectorOf(mesh.mNormals[i]) : glm::dvec3(0);
        const double size = glm::length(normal);
        all.points.push_back({vectorOf(mesh.mVertices[i]), size > 0.5 ? normal / size : glm::dvec3(0, 0, 1), {at.x, at.y}});
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
        for (unsigned c = 0; c < 3; ++c) all.indices.push_back(first + mesh.mFaces[f].mIndices[c]);
}
} // namespace

LeafBlade readLeafMesh(const std::filesystem::path& file) {
    const auto fault = [&](const std::string& text) { return CError(file.string() + ": " + text); };
    std::error_code problem;
    const std::uintmax_t bytes = std::filesystem::file_size(file, problem);
    if (problem) throw fault("cannot be read: " + problem.message());
    if (bytes > kMaxBytes) throw fault("is too large for a leaf");
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_GenSmoothNormals |
                                                                aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                                                                aiProcess_ValidateDataStructure);
    if (!scene) throw fault(std::string("is no mesh that can be read: ") + importer.GetErrorString());
    LeafBlade all;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m)
        if (scene->mMeshes[m]->mPrimitiveTypes & aiPrimitiveType_TRIANGLE) add(all, *scene->mMeshes[m]);
    if (all.indices.empty()) throw fault("has no triangles");
    if (all.points.size() > kMaxLeafPoints)
        throw fault("has " + std::to_string(all.points.size()) + " vertices; a leaf may have at most " + std::to_string(kMaxLeafPoints));
    return all;
}

} // namespace stromar
