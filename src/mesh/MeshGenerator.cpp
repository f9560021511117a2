#include "LeafBlade.h"
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

/// Where leaves look when they are shaded as a round crown, and by how much.
struct Rounding {
    glm::dvec3 centre{0};
    double share = 0;
    double least = 0; ///< cosine to a leaf's own normal, so that its folded halves are not seen from behind
};

Rounding roundingOf(const LeafArray& leaves, const GlobalParams& g) {
    const double steepest = std::atan(std::tan(std::abs(g.leafFold)) * std::max(1.0, g.leafScaleX)); // of any leaflet
    Rounding rounding{glm::dvec3(0), g.leafRounding, std::min(0.99, 0.05 + std::sin(steepest))};
    if (g.leafRounding <= 0 || leaves.empty()) return rounding;
    glm::dvec3 low = leaves[0].position, high = low;
    for (const CLeaf& leaf : leaves) {
        low = glm::min(low, leaf.position);
        high = glm::max(high, leaf.position);
    }
    rounding.centre = (low + high) / 2.0;
    return rounding;
}

/// A normal turned outwards, but never to the back of its leaf.
glm::dvec3 rounded(const glm::dvec3& normal, const glm::dvec3& place, const Rounding& rounding) {
    const glm::dvec3 away = place - rounding.centre;
    const double distance = glm::length(away);
    if (rounding.share <= 0 || distance < 1e-9) return normal;
    const glm::dvec3 turned = (1 - rounding.share) * normal + rounding.share / distance * away;
    const double length = glm::length(turned), front = glm::dot(turned, normal);
    if (length > 1e-9 && front >= rounding.least * length) return turned / length;
    const glm::dvec3 across = turned - front * normal;
    const double side = glm::length(across);
    if (side < 1e-9) return normal;
    return rounding.least * normal + std::sqrt(1 - rounding.least * rounding.least) / side * across;
}

void writeLeaf(const CLeaf& leaf, double growth, const LeafBlade& blade, const Rounding& rounding, VertexSink sink,
               std::uint32_t* index, std::uint32_t first) {
    const glm::dvec3 p = glm::abs(leaf.position);
    const double least = 1e-5 * std::max({p.x, p.y, p.z});
    const glm::dvec3 right = glm::cross(leaf.axis, leaf.normal);
    const double width = std::max(least, leaf.width * growth), length = std::max(least, leaf.length * growth);
    for (const LeafBlade::Point& point : blade.points) {
        const glm::dvec3 place = leaf.position + width * point.place.x * right + length * point.place.y * leaf.axis +
                                 width * point.place.z * leaf.normal;
        const glm::dvec3 normal = glm::normalize(point.normal.x / width * right + point.normal.y / length * leaf.axis +
                                                 point.normal.z / width * leaf.normal);
        sink.add(place, rounded(normal, place, rounding), point.texCoord.x, point.texCoord.y, 255);
    }
    for (const std::uint32_t corner : blade.indices) *index++ = first + corner;
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
                writeTube(plan, tube, points, *mesh);
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

std::shared_ptr<const CMesh> meshOfLeaves(const CTree& tree, const MeshPlan& last, const CParams& params,
                                          const Detail& detail, const CProgress& progress) {
    const std::vector<std::uint32_t> offered = leavesOnChosenStems(tree, last);
    const std::size_t total = tree.leaves().size();
    const auto share = static_cast<std::size_t>(std::ceil(double(total) * detail.share));
    const std::size_t count = std::min({detail.leafBudget, share, offered.size()});
    const double growth = count == 0 ? 1 : std::min(kMostLeafGrowth, std::sqrt(double(total) / double(count)));
    const GlobalParams global = CTreeParams(params, 0, tree.scaleTree()).global();
    const LeafBlade blade = makeBlade(global, detail);
    const Rounding rounding = roundingOf(tree.leaves(), global);
    const std::size_t points = blade.points.size(), corners = blade.indices.size();
    const auto mesh = makeMesh("leaves", Surface::Leaf, points * count, corners * count);
    parallelFor(
        count, kLeafGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                writeLeaf(tree.leaves()[offered[chosenLeaf(i, count, offered.size())]], growth, blade, rounding,
                          sinkAt(*mesh, points * i), mesh->indices.data() + corners * i,
                          static_cast<std::uint32_t>(points * i));
        },
        progress);
    return mesh;
}

std::size_t verticesPerLeaf(const CParams& params, const Detail& detail) {
    return makeBlade(CTreeParams(params, 0, 1).global(), detail).points.size();
}

} // namespace stromar
