#include "foliage/Foliage.h"
#include "foliage/LeafBlade.h"
#include "stem/TubeWriter.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 4096;
/// The organs that are there and may be drawn: none hangs in the air.
struct Offered {
    std::vector<std::uint32_t> drawable; ///< on stems that are drawn
    std::size_t total = 0;               ///< on all stems
};

Offered offeredOf(const CTree& tree, Organ organ, std::span<const MeshPlan* const> plans, double share,
                  std::uint32_t except) {
    Offered offered;
    offered.drawable.reserve(tree.shared(organ)->size());
    forEachPresent(tree, organ, share, [&](std::size_t i, const CLeaf& own) {
        if (own.generation == except) return;
        ++offered.total;
        if (plans[own.generation]->stemIsChosen[own.stem]) offered.drawable.push_back(static_cast<std::uint32_t>(i));
    });
    return offered;
}

void writeLeaf(const CLeaf& leaf, double growth, const LeafBlade& blade, const Rounding& rounding, VertexSink sink,
               std::uint32_t* index, std::uint32_t first) {
    const CBladePlacer placer(leaf, growth);
    for (const LeafBlade::Point& point : blade.points) {
        const glm::dvec3 place = leaf.position + placer.offset(point);
        sink.add(place, rounding.turned(placer.normal(point), place), point.texCoord.x, point.texCoord.y, 255);
    }
    for (const std::uint32_t corner : blade.indices) *index++ = first + corner;
}

struct OrganLook {
    const char* name;
    Surface surface;
};
constexpr OrganLook kLooks[] = {{"leaves", Surface::Leaf}, {"blossoms", Surface::Blossom}, {"fruits", Surface::Fruit}};
} // namespace

std::shared_ptr<const CMesh> meshOfOrgans(const CTree& tree, Organ organ, std::span<const MeshPlan* const> plans,
                                          const MeshParams& params, const Detail& detail, const CProgress& progress,
                                          std::uint32_t except) {
    const SeasonShare season = params.seasonOf(organ);
    const LeafArray& all = *tree.shared(organ);
    const Offered offered = offeredOf(tree, organ, plans, season.share, except);
    const auto share = std::max(kFewOrgans, static_cast<std::size_t>(std::ceil(double(offered.total) * detail.share)));
    const std::size_t count = std::min({detail.leafBudget, share, offered.drawable.size()});
    const double thinned = count == 0 ? 1 : std::min(kMaxLeafGrowth, std::sqrt(double(offered.total) / double(count)));
    const LeafBlade blade = bladeOf(params, organ, detail);
    const Rounding rounding = organ == Organ::Fruit ? Rounding() : roundingOf(all, params.leaf);
    const std::size_t points = blade.points.size(), corners = blade.indices.size();
    const OrganLook& look = kLooks[static_cast<std::size_t>(organ)];
    const auto mesh = allocateMesh(look.name, look.surface, points * count, corners * count);
    parallelFor(
        count, kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                writeLeaf(all[offered.drawable[evenly(i, count, offered.drawable.size())]], thinned * season.size,
                          blade, rounding, sinkAt(*mesh, points * i), mesh->indices.data() + corners * i,
                          static_cast<std::uint32_t>(points * i));
        },
        progress);
    return mesh;
}

std::size_t verticesPerOrgan(const MeshParams& params, Organ organ, const Detail& detail) {
    return bladeOf(params, organ, detail).points.size();
}

} // namespace stromar
