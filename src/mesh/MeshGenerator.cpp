#include "TubeWriter.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::size_t kTubeGrain = 128, kLeafGrain = 4096;

std::shared_ptr<CMesh> makeMesh(std::string name, Surface surface, std::size_t vertices, std::size_t indices) {
    auto mesh = std::make_shared<CMesh>();
    mesh->name = std::move(name);
    mesh->surface = surface;
    mesh->positions.resize(vertices);
    mesh->normals.resize(vertices);
    mesh->texCoords.resize(vertices);
    mesh->openness.resize(vertices);
    mesh->indices.resize(indices);
    return mesh;
}

/// The leaves that may be drawn: none hangs in the air.
std::vector<std::uint32_t> leavesOnChosenStems(const CTree& tree, const MeshPlan& last) {
    std::vector<std::uint32_t> leaves;
    leaves.reserve(tree.leaves().size());
    for (std::size_t i = 0; i < tree.leaves().size(); ++i)
        if (last.stemIsChosen[tree.leaves()[i].stem]) leaves.push_back(static_cast<std::uint32_t>(i));
    return leaves;
}

/// Chooses `count` of `total` leaves, evenly: the index of the i-th.
std::size_t chosenLeaf(std::size_t i, std::size_t count, std::size_t total) {
    return (2 * i + 1) * total / (2 * count);
}

void writeLeaf(const CLeaf& leaf, double growth, VertexSink sink, std::uint32_t* index, std::uint32_t first) {
    const glm::dvec3 p = glm::abs(leaf.position);
    const double least = 1e-5 * std::max({p.x, p.y, p.z});
    const glm::dvec3 side = std::max(least, leaf.width * growth) / 2 * glm::cross(leaf.normal, leaf.axis);
    const glm::dvec3 up = std::max(least, leaf.length * growth) * leaf.axis;
    sink.add(leaf.position + side, leaf.normal, 0, 0, 255);
    sink.add(leaf.position - side, leaf.normal, 1, 0, 255);
    sink.add(leaf.position - side + up, leaf.normal, 1, 1, 255);
    sink.add(leaf.position + side + up, leaf.normal, 0, 1, 255);
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) *index++ = first + corner;
}
} // namespace

std::shared_ptr<const CMesh> meshOfStems(const CTree& tree, int generation, const MeshPlan& plan, const CParams& params,
                                         const CProgress& progress) {
    const auto mesh = makeMesh(generation == 0 ? "trunk" : "branches " + std::to_string(generation), Surface::Bark,
                               plan.vertexCount, plan.indexCount);
    const CStemSurface surface(params, generation, tree);
    parallelFor(
        plan.tubes.size(), kTubeGrain,
        [&](std::size_t begin, std::size_t end) {
            CPointGenerator points(tree.generation(static_cast<std::size_t>(generation)), plan, surface);
            for (std::size_t t = begin; t < end; ++t) {
                const Tube& tube = plan.tubes[t];
                writeTube(tube, points, *mesh);
            }
        },
        progress);
    return mesh;
}

std::vector<StemMesh> meshAllStems(const CTree& tree, const CParams& params, const Detail& detail,
                                   const CProgress& progress) {
    std::vector<StemMesh> all;
    for (int g = 0; g < static_cast<int>(tree.generationCount()); ++g) {
        StemMesh own{planRings(tree, g, params, detail, all.empty() ? nullptr : &all.back(), progress), nullptr};
        own.mesh = meshOfStems(tree, g, own.plan, params, progress);
        all.push_back(std::move(own));
    }
    return all;
}

std::shared_ptr<const CMesh> meshOfLeaves(const CTree& tree, const MeshPlan& last, const Detail& detail,
                                          const CProgress& progress) {
    const std::vector<std::uint32_t> offered = leavesOnChosenStems(tree, last);
    const std::size_t total = tree.leaves().size();
    const auto share = static_cast<std::size_t>(std::ceil(double(total) * detail.share));
    const std::size_t count = std::min({detail.leafBudget, share, offered.size()});
    const double growth = count == 0 ? 1 : std::min(kMostLeafGrowth, std::sqrt(double(total) / double(count)));
    const auto mesh = makeMesh("leaves", Surface::Leaf, 4 * count, 6 * count);
    parallelFor(
        count, kLeafGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                writeLeaf(tree.leaves()[offered[chosenLeaf(i, count, offered.size())]], growth, sinkAt(*mesh, 4 * i),
                          mesh->indices.data() + 6 * i, static_cast<std::uint32_t>(4 * i));
        },
        progress);
    return mesh;
}

} // namespace stromar
