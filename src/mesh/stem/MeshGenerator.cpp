#include "stem/TubeWriter.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"

namespace stromar {

namespace {
constexpr std::size_t kTubeGrain = 128;
} // namespace

std::shared_ptr<const CMesh> meshOfStems(const CTree& tree, int generation, const MeshPlan& plan, const MeshParams& params,
                                         const CProgress& progress) {
    const auto mesh = allocateMesh(generation == 0 ? "trunk" : "branches_" + std::to_string(generation),
                                   barkOf(static_cast<std::size_t>(generation)), plan.vertexCount, plan.indexCount);
    const CStemSurface surface(tree, generation, params, *plan.detail, plan.thickening);
    parallelFor(
        plan.tubes.size(), kTubeGrain,
        [&](std::size_t begin, std::size_t end) {
            CPointGenerator points(tree.generation(static_cast<std::size_t>(generation)), plan, surface);
            for (std::size_t t = begin; t < end; ++t) {
                const Tube& tube = plan.tubes[t];
                writeTube(plan, tube, points, *mesh);
            }
        },
        progress);
    return mesh;
}

std::vector<std::span<const Tube>> surfacesOf(const MeshPlan& plan) {
    std::vector<std::span<const Tube>> surfaces;
    const std::span<const Tube> all(plan.tubes);
    for (std::size_t first = 0, end = 1; first < all.size(); first = end++) {
        while (end < all.size() && all[end].joined) ++end;
        surfaces.push_back(all.subspan(first, end - first));
    }
    return surfaces;
}

std::vector<const MeshPlan*> plansOf(std::span<const StemMesh> stems) {
    std::vector<const MeshPlan*> plans;
    for (const StemMesh& own : stems) plans.push_back(&own.plan);
    return plans;
}

std::vector<const StemMesh*> stemsBelow(std::span<const StemMesh> stems, std::size_t generation) {
    std::vector<const StemMesh*> below;
    for (const StemMesh& own : stems.first(generation)) below.push_back(&own);
    return below;
}

std::vector<StemMesh> meshAllStems(const CTree& tree, const MeshParams& params, const Detail& detail,
                                   const CProgress& progress) {
    const StemChoice choice = chooseStems(tree, params, detail, {}, progress);
    std::vector<StemMesh> all;
    for (int g = 0; g < static_cast<int>(tree.generationCount()); ++g) {
        StemMesh own{planRings(tree, g, params, detail, stemsBelow(all, all.size()), progress, choice), nullptr};
        own.mesh = meshOfStems(tree, g, own.plan, params, progress);
        all.push_back(std::move(own));
    }
    return all;
}

} // namespace stromar
