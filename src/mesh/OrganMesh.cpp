#include "LeafBlade.h"
#include "TubeWriter.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/params/Season.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 4096;
constexpr std::uint64_t kFallOrder = 0x6c656166;

/// What the season leaves of an organ.
struct Seasonal {
    double share, size;
};

Seasonal seasonalOf(const GlobalParams& g, Organ organ) {
    const Phenology now = phenologyOf(g);
    switch (organ) {
    case Organ::Blossom: return {now.blossoms, 1};
    case Organ::Fruit: return {now.fruits, now.fruitSize};
    default: return {now.leaves, now.leafSize};
    }
}

/// The organs that are there and may be drawn: none hangs in the air.
struct Offered {
    std::vector<std::uint32_t> drawable; ///< on stems that are drawn
    std::size_t total = 0;               ///< on all stems
};

Offered offeredOf(const CTree& tree, Organ organ, const MeshPlan& last, double share) {
    const LeafArray& all = *tree.shared(organ);
    const auto& stems = tree.generation(tree.generationCount() - 1).stems;
    Offered offered;
    offered.drawable.reserve(all.size());
    std::uint32_t stem = 0, onStem = 0; // organs lie in the order of their stems
    for (std::size_t i = 0; i < all.size(); ++i) {
        onStem = all[i].stem == stem ? onStem + 1 : 0;
        stem = all[i].stem;
        // One that has fallen stays on the ground when others fall.
        const double falls = double(hashCombine(hashCombine(kFallOrder, stems[stem].id), onStem) >> 11) * 0x1p-53;
        if (falls >= share) continue;
        ++offered.total;
        if (last.stemIsChosen[stem]) offered.drawable.push_back(static_cast<std::uint32_t>(i));
    }
    return offered;
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

struct OrganLook {
    const char* name;
    Surface surface;
};
constexpr OrganLook kLooks[] = {{"leaves", Surface::Leaf}, {"blossoms", Surface::Blossom}, {"fruits", Surface::Fruit}};

LeafBlade bladeOf(const GlobalParams& g, Organ organ, const Detail& detail) {
    switch (organ) {
    case Organ::Blossom: return makeCard();
    case Organ::Fruit: return makeFruit(g.fruitStalk, detail);
    default: return makeBlade(g, detail);
    }
}
} // namespace

std::shared_ptr<const CMesh> meshOfOrgans(const CTree& tree, Organ organ, const MeshPlan& last, const CParams& params,
                                          const Detail& detail, const CProgress& progress) {
    const GlobalParams global = CTreeParams(params, 0, tree.scaleTree()).global();
    const Seasonal season = seasonalOf(global, organ);
    const LeafArray& all = *tree.shared(organ);
    const Offered offered = offeredOf(tree, organ, last, season.share);
    const auto share = static_cast<std::size_t>(std::ceil(double(offered.total) * detail.share));
    const std::size_t count = std::min({detail.leafBudget, share, offered.drawable.size()});
    const double thinned = count == 0 ? 1 : std::min(kMostLeafGrowth, std::sqrt(double(offered.total) / double(count)));
    const LeafBlade blade = bladeOf(global, organ, detail);
    const Rounding rounding = organ == Organ::Fruit ? Rounding() : roundingOf(all, global);
    const std::size_t points = blade.points.size(), corners = blade.indices.size();
    const OrganLook& look = kLooks[static_cast<std::size_t>(organ)];
    const auto mesh = allocateMesh(look.name, look.surface, points * count, corners * count);
    parallelFor(
        count, kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                writeLeaf(all[offered.drawable[chosenLeaf(i, count, offered.drawable.size())]], thinned * season.size,
                          blade, rounding, sinkAt(*mesh, points * i), mesh->indices.data() + corners * i,
                          static_cast<std::uint32_t>(points * i));
        },
        progress);
    return mesh;
}

std::size_t verticesPerOrgan(const CParams& params, Organ organ, const Detail& detail) {
    return bladeOf(CTreeParams(params, 0, 1).global(), organ, detail).points.size();
}

} // namespace stromar
