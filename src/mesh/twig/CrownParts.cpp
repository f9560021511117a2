#include "foliage/Foliage.h"
#include "foliage/LeafBlade.h"
#include "twig/CrownView.h"
#include "twig/LeafyTwigs.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::size_t kMaxVertices = 2'000'000; // of leaves: those of a file may have 20,000 each

/// Keeps at most so many, evenly chosen; which part of them.
double thin(std::vector<std::uint32_t>& all, std::size_t max) {
    const std::size_t total = all.size(), count = std::clamp<std::size_t>(max, 1, total);
    for (std::size_t i = 0; i < count; ++i) all[i] = all[evenly(i, count, total)];
    all.resize(count);
    return double(count) / double(total);
}

std::size_t verticesOf(const OrganMeshes& meshes) {
    std::size_t sum = 0;
    for (const auto& mesh : meshes) sum += mesh->vertexCount();
    return sum;
}
} // namespace

std::vector<CrownPart> leafParts(const std::shared_ptr<const COrgans>& leaves, const StemSet* stems, double present, const CTree& tree,
                                 const MeshParams& params, const LeafMasks& masks, const Detail& detail, const CProgress& progress) {
    const SeasonShare season = params.seasonOf(Organ::Leaf);
    std::array<std::vector<std::uint32_t>, kLeafKinds> shown;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < leaves->grown.size(); ++i) {
        const CLeaf& leaf = leaves->grown[i];
        const CStem& stem = tree.generation(leaf.generation).stems[leaf.stem];
        if ((stems && !stems->has(leaf.generation, leaf.stem)) || hasFallen(stem, leaf.number, season.share)) continue;
        shown[params.kindOf(stem, leaf.number)].push_back(i);
        ++count;
    }
    const Rounding rounding = roundingOf(tree, *leaves, params.leaf);
    const CrownShade shade = shadeOf(tree, *leaves, params.sunAndShade);
    const auto kinds = static_cast<std::size_t>(std::ranges::count_if(shown, [](const auto& own) { return !own.empty(); }));
    std::vector<CrownPart> parts;
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) {
        if (shown[kind].empty()) continue;
        LeafBlade blade = makeBlade(params.formOf(kind), detail);
        const double part = thin(shown[kind], kMaxVertices / kinds / blade.points.size());
        const double growth = season.size * std::sqrt(present / std::max(1.0, double(count)) / part);
        const COrganMesh own(Organ::Leaf, kind, std::move(blade), leaves, std::move(shown[kind]), growth, rounding, shade);
        parts.push_back({own.expanded(progress), &masks[kind]});
    }
    return parts;
}

std::vector<CrownPart> blossomParts(const CrownOrgans& organs, const CTree& tree, const MeshParams& params, const Detail& detail, const CProgress& progress) {
    const SeasonShare season = params.seasonOf(Organ::Blossom);
    if (!organs.blossoms || season.share <= 0) return {};
    std::vector<std::uint32_t> shown;
    for (std::uint32_t i = 0; i < organs.blossoms->grown.size(); ++i) {
        const CLeaf& blossom = organs.blossoms->grown[i];
        if (!hasFallen(tree.generation(blossom.generation).stems[blossom.stem], blossom.number, season.share)) shown.push_back(i);
    }
    if (shown.empty()) return {};
    LeafBlade blade = bladeOf(params, Organ::Blossom, detail, 0);
    const double part = thin(shown, kMaxVertices / blade.points.size()) * double(organs.blossoms->grown.size()) / double(organs.blossoms->total);
    const COrganMesh own(Organ::Blossom, 0, std::move(blade), organs.blossoms, std::move(shown), season.size / std::sqrt(part),
                         roundingOf(tree, *organs.blossoms, params.leaf), CrownShade());
    return {{own.expanded(progress), &organs.blossomMask, nullptr, CrownLayer::Blossom}};
}

CrownPart otherWood(const StemSet& twigs, const CTree& tree, double minRadius) {
    return {woodBeside(twigs, tree, minRadius), nullptr, nullptr, CrownLayer::OtherWood};
}

std::vector<CrownPart> partsOf(const OrganMeshes& leaves, const LeafMasks& masks, const CProgress& progress) {
    std::vector<CrownPart> parts;
    if (verticesOf(leaves) > kMaxVertices) return parts;
    for (const auto& mesh : leaves)
        if (mesh->count() > 0) parts.push_back({mesh->expanded(progress), &masks[mesh->kind()]});
    return parts;
}

namespace {
/// With room for larger ones.
CrownFrame frameOf(const std::vector<CrownPart>& parts) {
    Bounds box = parts.front().mesh->bounds();
    for (const CrownPart& part : parts) box = {glm::min(box.min, part.mesh->bounds().min), glm::max(box.max, part.mesh->bounds().max)};
    return {glm::dvec3(box.min + box.max) / 2.0, 0.55 * glm::length(glm::dvec3(box.max - box.min))};
}

OrganMeshes resized(const OrganMeshes& meshes, double areas) {
    OrganMeshes sized;
    for (const auto& mesh : meshes) sized.push_back(mesh->resized(std::sqrt(areas)));
    return sized;
}

/// In the size in which they cover as much as the whole: beside the wood, for what lies before or behind it covers nothing.
OrganMeshes fittingTo(const std::vector<CrownPart>& whole, const OrganMeshes& thinned, const CTree& tree, double minRadius, const LeafMasks& masks,
                      const Detail& detail, const CProgress& progress) {
    if (whole.empty() || verticesOf(thinned) > kMaxVertices) return thinned;
    const CrownFrame frame = frameOf(whole);
    const CCrownCover cover(frame, pixelsOf(frame, tree.height(), detail), {otherWood({}, tree, minRadius)}, progress);
    const CrownFit fit = fitTo(cover.with(whole), 1, kGoodFit, [&](double areas) { return cover.with(partsOf(resized(thinned, areas), masks, progress)); });
    return resized(thinned, fit.areas);
}
} // namespace

OrganMeshes fittingLeaves(const OrganMeshes& thinned, const std::shared_ptr<const COrgans>& all, const CTree& tree, const LeafMasks& masks,
                          const MeshParams& params, const Detail& detail, const CProgress& progress) {
    const double present = double(all->grown.size()) * params.seasonOf(Organ::Leaf).share;
    if (present < 1 || double(all->grown.size()) > kMeasuredLeaves || verticesOf(thinned) > kMaxVertices) return thinned;
    return fittingTo(leafParts(all, nullptr, present, tree, params, masks, detailOf(Model::Full), progress), thinned, tree, params.minRadius, masks, detail, progress);
}

OrganMeshes fittingBlossoms(const OrganMeshes& thinned, const OrganMeshes& whole, const CrownOrgans& crown, const CTree& tree, const LeafMasks& masks,
                            const MeshParams& params, const Detail& detail, const CProgress& progress) {
    constexpr double kPower = 0.8; // of its area that is seen of a blossom among leaves
    constexpr double kMost = 1.4;  // how many times as much may be seen of larger ones
    const LeafMasks own{crown.blossomMask};
    const std::vector<CrownPart> all = partsOf(whole, own, progress);
    const OrganMeshes fitted = fittingTo(all, thinned, tree, params.minRadius, own, detail, progress);
    const double present = crown.leaves ? double(crown.leaves->total) * params.seasonOf(Organ::Leaf).share : 0;
    if (all.empty() || present < 1 || verticesOf(fitted) > kMaxVertices) return fitted;
    const std::vector<CrownPart> now = partsOf(fitted, own, progress),
                                 leaves = leafParts(crown.leaves, nullptr, present, tree, params, masks, detailOf(Model::Full, 1), progress);
    const CrownFrame frame = frameOf(all);
    const auto overAll = [&](const std::vector<CrownPart>& hiding) {
        return seenOverSeen(now, all, hiding, frame, pixelsOf(frame, tree.height(), detail), progress);
    };
    const double more = overAll(leaves) / std::max(1e-6, overAll({}));
    return resized(fitted, std::pow(std::clamp(more, 1 / kMost, kMost), -1 / kPower));
}

} // namespace stromar
