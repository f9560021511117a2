#include "stromar/mesh/OrganMesh.h"
#include "foliage/Foliage.h"
#include "foliage/LeafBlade.h"
#include "stem/TubeWriter.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 4096;

struct OrganLook {
    const char* name;
    Surface surface;
};
constexpr OrganLook kLooks[] = {{"leaves", Surface::Leaf}, {"blossoms", Surface::Blossom}, {"fruits", Surface::Fruit}};
static_assert(std::size(kLooks) == kOrgans.size());

const OrganLook& lookOf(Organ organ) { return kLooks[static_cast<std::size_t>(organ)]; }

} // namespace

COrganMesh::COrganMesh(Organ organ, std::size_t kind, LeafBlade blade, std::shared_ptr<const COrgans> organs,
                       std::vector<std::uint32_t> shown, double growth, const Rounding& rounding, const CrownShade& shade)
    : m_organ(organ), m_kind(kind), m_blade(std::move(blade)), m_organs(std::move(organs)), m_count(shown.size()),
      m_growth(growth), m_rounding(rounding), m_shade(shade) {
    if (m_count < m_organs->grown.size()) m_shown = std::move(shown);
}

std::string COrganMesh::name() const { return lookOf(m_organ).name + (m_kind > 0 ? " " + std::to_string(m_kind + 1) : ""); }
Surface COrganMesh::surface() const { return m_organ == Organ::Leaf ? kLeafSurfaces[m_kind] : lookOf(m_organ).surface; }

InstancePlace COrganMesh::place(std::size_t i) const {
    const CBladePlacer placer(leaf(i), sizeOf(leaf(i)));
    const glm::dquat turn = glm::quat_cast(placer.axes());
    return {leaf(i).position, static_cast<float>(placer.length()), static_cast<float>(placer.width()),
            glm::vec4(turn.x, turn.y, turn.z, turn.w)};
}

Bounds COrganMesh::bounds(const CProgress& progress) const {
    std::vector<Bounds> parts((count() + kGrain - 1) / kGrain);
    parallelFor(
        count(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            Bounds box{leaf(begin).position, leaf(begin).position};
            bool first = true;
            for (std::size_t i = begin; i < end; ++i) {
                const CBladePlacer placer(leaf(i), sizeOf(leaf(i)));
                for (const LeafBlade::Point& point : m_blade.points) {
                    const glm::vec3 p(placer.place(point));
                    box = first ? Bounds{p, p} : Bounds{glm::min(box.min, p), glm::max(box.max, p)};
                    first = false;
                }
            }
            parts[begin / kGrain] = box;
        },
        progress);
    Bounds all = parts.front();
    for (const Bounds& box : parts) all = {glm::min(all.min, box.min), glm::max(all.max, box.max)};
    return all;
}

COrganMesh::Hit COrganMesh::meet(const glm::dvec3& from, const glm::dvec3& direction) const {
    double reach = 0; // of the blade's points from its foot, in its larger size
    for (const LeafBlade::Point& point : m_blade.points) reach = std::max(reach, glm::length(point.place));
    Hit nearest;
    for (std::size_t i = 0; i < count(); ++i) {
        const CBladePlacer placer(leaf(i), sizeOf(leaf(i)));
        const double size = reach * std::max(placer.length(), placer.width());
        const double closest = glm::dot(placer.foot() - from, direction) / glm::dot(direction, direction);
        const glm::dvec3 off = from + closest * direction - placer.foot();
        if (glm::dot(off, off) > size * size) continue;
        for (std::size_t t = 0; t < m_blade.indices.size(); t += 3) {
            const auto corner = [&](std::size_t c) { return placer.place(m_blade.points[m_blade.indices[t + c]]); };
            const auto met = meetTriangle(from, direction, corner(0), corner(1), corner(2));
            if (met && *met > 0 && (nearest.instance < 0 || *met < nearest.distance))
                nearest = {static_cast<std::int64_t>(i), *met};
        }
    }
    return nearest;
}

std::shared_ptr<const COrganMesh> COrganMesh::resized(double factor) const {
    auto other = std::make_shared<COrganMesh>(*this);
    other->m_growth *= factor;
    return other;
}

std::shared_ptr<const CMesh> COrganMesh::expanded(const CProgress& progress) const {
    const std::size_t points = m_blade.points.size(), corners = m_blade.indices.size();
    const auto mesh = allocateMesh(name(), surface(), vertexCount(), corners * count());
    const auto write = [&](std::size_t i) {
        const CBladePlacer placer(leaf(i), sizeOf(leaf(i)));
        VertexSink sink = sinkAt(*mesh, points * i);
        for (const LeafBlade::Point& point : m_blade.points) {
            const glm::dvec3 place = placer.place(point);
            sink.add(place, m_rounding.turned(placer.normal(point), place), point.texCoord.x, point.texCoord.y, {});
        }
        std::uint32_t* index = mesh->indices.data() + corners * i;
        for (const std::uint32_t corner : m_blade.indices) *index++ = static_cast<std::uint32_t>(points * i) + corner;
    };
    parallelFor(
        count(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) write(i);
        },
        progress);
    return mesh;
}

OrganDemand demandOf(const Detail& detail, std::span<const MeshPlan* const> plans, const StemSet& asCards) {
    OrganDemand demand;
    demand.share = detail.share;
    if (detail.leafBudget != std::numeric_limits<std::size_t>::max()) demand.max = double(detail.leafBudget);
    demand.few = double(kFewOrgans);
    const auto bearsAll = [](const MeshPlan* plan) {
        return std::ranges::find(plan->stemBears, false) == plan->stemBears.end();
    };
    if (asCards.empty() && std::ranges::all_of(plans, bearsAll)) return demand;
    demand.stems.emplace();
    for (const MeshPlan* plan : plans) demand.stems->stems.push_back(plan->stemBears);
    for (std::size_t g = 0; g < asCards.stems.size(); ++g)
        for (std::size_t s = 0; s < asCards.stems[g].size(); ++s)
            if (asCards.stems[g][s]) demand.stems->stems[g][s] = false;
    return demand;
}

namespace {
/// Of a leaf, on the average of the kinds.
double trianglesOfLeaf(const MeshParams& params, const Detail& detail) {
    double sum = 0;
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind)
        if (const double share = params.shareOf(kind); share > 0) sum += share * double(bladeOf(params, Organ::Leaf, detail, kind).indices.size()) / 3;
    return sum;
}
} // namespace

LeafShare leafShareOf(const MeshParams& params, const Detail& detail, double fullWood, double wood, const LeafCount& leaves) {
    constexpr double kFewTriangles = 5000, kShare = 0.048, kLeast = 0.4, kOfCard = 2; // of all triangles: how many wood has is sampled
    if (detail.lod < kMaxLod || leaves.onStems + leaves.onTwigs == 0) return {};
    const double full = fullWood + (leaves.onStems + leaves.onTwigs) * trianglesOfLeaf(params, detailOf(detail.model, 0));
    const double onStems = std::min(leaves.onStems, detail.share * (leaves.onStems + leaves.onTwigs));
    const double ofLeaves = onStems * trianglesOfLeaf(params, detail), ofCards = leaves.onTwigs * detail.cardShare * kOfCard;
    const double left = std::max(kFewTriangles, kShare * full) - wood;
    const auto shareOf = [&](double own, double others) { return std::clamp((left - others) / std::max(1.0, own), kLeast, 1.0); };
    const double share = shareOf(ofLeaves, ofCards);
    return {share, shareOf(ofCards, share * ofLeaves)};
}

OrganMeshes meshOfOrgans(const CTree& tree, Organ organ, std::span<const MeshPlan* const> plans, const MeshParams& params,
                         const Detail& detail, const CProgress& progress, const StemSet& asCards) {
    progress.poll();
    const SeasonShare season = params.seasonOf(organ);
    const auto& organs = tree.organs(organ);
    const std::size_t total = organs->total - organs->countOn(asCards);
    std::vector<std::vector<std::uint32_t>> shown(organ == Organ::Leaf ? kLeafKinds : 1); // by kind
    shown[0].reserve(organs->grown.size());
    std::size_t drawable = 0;
    for (std::uint32_t i = 0; i < organs->grown.size(); ++i) {
        const CLeaf& own = organs->grown[i];
        if (asCards.has(own.generation, own.stem) || !plans[own.generation]->stemBears[own.stem]) continue;
        ++drawable;
        const CStem& stem = tree.generation(own.generation).stems[own.stem];
        if (hasFallen(stem, own.number, season.share)) continue;
        shown[organ == Organ::Leaf ? params.kindOf(stem, own.number) : 0].push_back(i);
    }
    const double thinned = drawable == 0 ? 1 : std::min(detail.maxLeafGrowth, std::sqrt(double(total) / double(drawable)));
    const Rounding rounding = organ == Organ::Fruit ? Rounding() : roundingOf(tree, *organs, params.leaf);
    const CrownShade shade = organ == Organ::Leaf ? shadeOf(tree, *organs, params.sunAndShade) : CrownShade();
    OrganMeshes meshes;
    for (std::size_t kind = 0; kind < shown.size(); ++kind)
        meshes.push_back(std::make_shared<const COrganMesh>(organ, kind, bladeOf(params, organ, detail, kind), organs,
                                                            std::move(shown[kind]), thinned * season.size, rounding, shade));
    return meshes;
}

} // namespace stromar
