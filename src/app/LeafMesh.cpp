#include "stromar/app/LeafMesh.h"
#include "stromar/io/LeafMeshReader.h"
#include "stromar/mesh/LeafMeshes.h"
#include "stromar/model/MeshValues.h"
#include "stromar/util/Error.h"
#include <map>
#include <mutex>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr std::size_t kKnownMeshes = 16; // files

/// What was read of a file, and when that was written.
struct ReadMesh {
    fs::file_time_type written;
    std::shared_ptr<const LeafBlade> mesh;
};

std::shared_ptr<const LeafBlade> meshIn(const fs::path& file) {
    static std::mutex mutex;
    static std::map<fs::path, ReadMesh> known;
    std::error_code problem; // reading says it better
    const fs::file_time_type written = fs::last_write_time(file, problem);
    const std::lock_guard lock(mutex);
    if (known.size() > kKnownMeshes) known.clear();
    ReadMesh& own = known[file];
    if (!own.mesh || own.written != written) own = {written, std::make_shared<const LeafBlade>(readLeafMesh(file))};
    return own.mesh;
}
} // namespace

std::shared_ptr<const LeafBlade> leafMeshOf(const CParams& params, std::size_t kind) {
    const std::string& name = params.text.*kLeafMeshes[kind];
    if (name.empty()) return nullptr;
    if (const BuiltInLeaf* own = builtInLeaf(name)) {
        LeafBlade blade = own->make(false);
        blade.far = std::make_shared<const LeafBlade>(own->make(true));
        return std::make_shared<const LeafBlade>(std::move(blade));
    }
    const fs::path file = params.folder / name;
    try {
        return std::make_shared<const LeafBlade>(bladeOf(*meshIn(file), params.common.leafScaleX));
    } catch (const CError& e) {
        const std::string text = e.what();
        throw CError(text.starts_with(file.string()) ? text : file.string() + ": " + text);
    }
}

MeshParams meshParamsWithLeaf(const CParams& params) {
    MeshParams mesh = meshParamsOf(params);
    mesh.leaf.mesh = leafMeshOf(params, 0);
    for (std::size_t other = 0; other < mesh.otherLeaves.size(); ++other) mesh.otherLeaves[other].mesh = leafMeshOf(params, other + 1);
    return mesh;
}

} // namespace stromar
