#include "stromar/io/Writers.h"
#include <algorithm>
#include <assimp/Exporter.hpp>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/scene.h>
#include <exception>
#include <string>

namespace stromar {

namespace {
/// Lets assimp write into one of our streams.
class CStream : public Assimp::IOStream {
public:
    CStream(std::ostream& out, std::exception_ptr& failure) : m_out(out), m_failure(failure) {}
    std::size_t Read(void*, std::size_t, std::size_t) override { return 0; }
    std::size_t Write(const void* bytes, std::size_t size, std::size_t count) override {
        try {
            if (!m_failure) m_out.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size * count));
        } catch (...) {
            m_failure = std::current_exception(); // assimp would make a text of it
        }
        return m_failure ? 0 : count;
    }
    aiReturn Seek(std::size_t, aiOrigin) override { return aiReturn_FAILURE; }
    std::size_t Tell() const override { return static_cast<std::size_t>(m_out.tellp()); }
    std::size_t FileSize() const override { return Tell(); }
    void Flush() override {}

private:
    std::ostream& m_out;
    std::exception_ptr& m_failure;
};

class CFiles : public Assimp::IOSystem {
public:
    CFiles(CFileSet& files, std::exception_ptr& failure) : m_files(files), m_failure(failure) {}
    bool Exists(const char*) const override { return false; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* path, const char*) override {
        try {
            return new CStream(m_files.create(path), m_failure);
        } catch (...) {
            m_failure = std::current_exception();
            return nullptr;
        }
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    CFileSet& m_files;
    std::exception_ptr& m_failure;
};

aiVector3D inAssimp(const glm::vec3& v) { return {v.x, v.y, v.z}; }

aiMesh* makeMesh(const CMesh& mesh) {
    auto* made = new aiMesh;
    made->mName = mesh.name;
    made->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    const std::size_t count = mesh.vertexCount();
    made->mNumVertices = static_cast<unsigned>(count);
    made->mVertices = new aiVector3D[count];
    made->mNormals = new aiVector3D[count];
    made->mTextureCoords[0] = new aiVector3D[count];
    made->mNumUVComponents[0] = 2;
    for (std::size_t v = 0; v < count; ++v) {
        made->mVertices[v] = inAssimp(mesh.positions[v]);
        made->mNormals[v] = inAssimp(mesh.normals[v]);
        made->mTextureCoords[0][v] = {mesh.texCoords[v].x, mesh.texCoords[v].y, 0};
    }
    made->mNumFaces = static_cast<unsigned>(mesh.triangleCount());
    made->mFaces = new aiFace[mesh.triangleCount()];
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
        aiFace& face = made->mFaces[t];
        face.mNumIndices = 3;
        face.mIndices = new unsigned[3];
        std::copy_n(&mesh.indices[3 * t], 3, face.mIndices);
    }
    return made;
}

/// A node per mesh under one that bears the model's name.
std::unique_ptr<aiScene> makeScene(const ExportModel& model) {
    auto scene = std::make_unique<aiScene>();
    const auto meshes = static_cast<unsigned>(model.meshes.size());
    scene->mNumMeshes = meshes;
    scene->mMeshes = new aiMesh*[meshes];
    scene->mNumMaterials = 1; // the formats have none, and assimp asks for one
    scene->mMaterials = new aiMaterial*[1]{new aiMaterial};
    scene->mRootNode = new aiNode(model.name);
    scene->mRootNode->mNumChildren = meshes;
    scene->mRootNode->mChildren = new aiNode*[meshes];
    for (unsigned i = 0; i < meshes; ++i) {
        scene->mMeshes[i] = makeMesh(*model.meshes[i]);
        auto* node = scene->mRootNode->mChildren[i] = new aiNode(model.meshes[i]->name);
        node->mParent = scene->mRootNode;
        node->mNumMeshes = 1;
        node->mMeshes = new unsigned[1]{i};
    }
    return scene;
}

void writeByAssimp(const char* format, const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    std::exception_ptr failure;
    Assimp::Exporter exporter;
    exporter.SetIOHandler(new CFiles(files, failure));
    const aiReturn result = exporter.Export(makeScene(model).get(), format, path.string());
    if (failure) std::rethrow_exception(failure);
    if (result != aiReturn_SUCCESS)
        throw CError("assimp cannot write " + path.string() + ": " + exporter.GetErrorString());
}
} // namespace

void writeStl(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    writeByAssimp("stlb", model, path, files);
}

void writePly(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    writeByAssimp("plyb", model, path, files);
}

} // namespace stromar
