#include "stem/Simplifier.h"
#include "stem/TubeWriter.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Random.h"
#include <algorithm>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 64;

/// Whether a stem is among the share of its generation that is drawn. A smaller share chooses of what a larger one
/// does.
bool isChosen(const CStem& stem, std::uint32_t s, double share) {
    return share >= 1 || s == 0 || unitOf(hashCombine(0, stem.id)) < share;
}

void append(MeshPlan& whole, const MeshPlan& part) {
    const auto rings = static_cast<std::uint32_t>(whole.rings.size());
    const auto collarPoints = static_cast<std::uint32_t>(whole.collarPoints.size());
    const auto forks = static_cast<std::uint32_t>(whole.forks.size());
    const auto forkPoints = static_cast<std::uint32_t>(whole.forkPoints.size());
    whole.rings.insert(whole.rings.end(), part.rings.begin(), part.rings.end());
    whole.collarPoints.insert(whole.collarPoints.end(), part.collarPoints.begin(), part.collarPoints.end());
    whole.forkPoints.insert(whole.forkPoints.end(), part.forkPoints.begin(), part.forkPoints.end());
    for (Fork fork : part.forks) {
        fork.firstPoint += forkPoints;
        whole.forks.push_back(fork);
    }
    for (Tube tube : part.tubes) {
        tube.firstRing += rings;
        tube.firstCollarPoint += collarPoints;
        tube.firstFork += forks;
        whole.tubes.push_back(tube);
    }
}

/// Gives every tube its place in the mesh.
void layOut(MeshPlan& plan, std::size_t paths) {
    plan.tubeOfPath.assign(paths, -1);

    for (std::size_t t = 0; t < plan.tubes.size(); ++t) {
        Tube& tube = plan.tubes[t];
        plan.tubeOfPath[tube.path] = static_cast<std::int32_t>(t);
        measure(plan, tube);
        tube.firstVertex = static_cast<std::uint32_t>(plan.vertexCount);
        tube.firstIndex = plan.indexCount;
        plan.vertexCount += tube.vertexCount();
        plan.indexCount += tube.indexCount();
    }
}

MeshPlan planAll(const CTree& tree, int generation, const MeshParams& params, const Detail& detail,
                 const StemMesh* parents, const std::vector<bool>& drawn, const CProgress& progress) {
    const CGeneration& own = tree.generation(static_cast<std::size_t>(generation));
    std::vector<MeshPlan> parts((own.stems.size() + kGrain - 1) / kGrain);
    parallelFor(
        own.stems.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            CSimplifier simplifier(tree, generation, params, detail, parents);
            for (std::size_t s = begin; s < end; ++s)
                if (drawn[s]) simplifier.planStem(static_cast<std::uint32_t>(s), parts[begin / kGrain]);
        },
        progress);
    MeshPlan plan;
    for (const MeshPlan& part : parts) append(plan, part);
    layOut(plan, own.paths.size());
    return plan;
}

/// The part of the last generation's stems that fills what the others leave of the detail's share of triangles.
double shareOfTwigs(const CTree& tree, const MeshParams& params, const Detail& detail, const CProgress& progress) {
    const int last = static_cast<int>(tree.generationCount()) - 1;
    const auto size = [&](int generation, const Detail& at) {
        const std::vector<bool> all(tree.generation(static_cast<std::size_t>(generation)).stems.size(), true);
        return double(planAll(tree, generation, params, at, nullptr, all, progress).indexCount);
    };
    double left = 0;
    for (int g = 0; g <= last; ++g) left += detail.share * size(g, detailOf(detail.model, 0));
    for (int g = 0; g < last; ++g) left -= size(g, detail);
    return std::clamp(left / std::max(1.0, size(last, detail)), detail.share, 1.0);
}
} // namespace

bool isSparse(const CTree& tree, int generation, const Detail& detail, const StemSet& asCards) {
    return asCards.empty() && detail.share < 1 && generation >= 2 && generation + 1 == static_cast<int>(tree.generationCount());
}

MeshPlan planRings(const CTree& tree, int generation, const MeshParams& params, const Detail& detail,
                   const StemMesh* parents, const CProgress& progress, const StemSet& asCards) {
    const auto g = static_cast<std::size_t>(generation);
    const double share = isSparse(tree, generation, detail, asCards) ? shareOfTwigs(tree, params, detail, progress) : 1;
    std::vector<bool> chosen, drawn;
    for (std::uint32_t s = 0; s < tree.generation(g).stems.size(); ++s) {
        chosen.push_back(isChosen(tree.generation(g).stems[s], s, share));
        drawn.push_back(chosen.back() && !asCards.has(g, s));
    }
    MeshPlan plan = planAll(tree, generation, params, detail, parents, drawn, progress);
    plan.stemIsChosen = std::move(chosen);
    return plan;
}

} // namespace stromar
