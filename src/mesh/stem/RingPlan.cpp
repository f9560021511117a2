#include "stem/RingPlan.h"
#include "stem/CollarRoom.h"
#include "stem/Simplifier.h"
#include "stem/TubeWriter.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <iterator>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 64;
/// Of branches with so few points nobody sees how wide their collars are; their parents may be prisms of three sides.
struct ThinCollars {
    int points;
    CollarLimit limit;
};
/// By level of detail; branches of the last have no collars. Narrower ones, or more of them, would have level 2 cover visibly less than that.
constexpr ThinCollars kThinCollars[]{{4, {.narrowest = 0.35, .around = 0.5}}, {6, {.narrowest = 0.35, .around = 0.33}},
                                     {4, {.narrowest = 0.35, .around = 0.4}}};
static_assert(std::size(kThinCollars) == kMaxLod);

void append(MeshPlan& whole, const MeshPlan& part) {
    const auto rings = static_cast<std::uint32_t>(whole.rings.size());
    const auto collarPoints = static_cast<std::uint32_t>(whole.collarPoints.size());
    const auto forks = static_cast<std::uint32_t>(whole.forks.size());
    const auto forkPoints = static_cast<std::uint32_t>(whole.forkPoints.size());
    const auto branches = static_cast<std::uint32_t>(whole.branches.size());
    const auto barkJoints = static_cast<std::uint32_t>(whole.barkJoints.size());
    const auto branchPoints = static_cast<std::uint32_t>(whole.branchPoints.size());
    whole.rings.insert(whole.rings.end(), part.rings.begin(), part.rings.end());
    whole.collarPoints.insert(whole.collarPoints.end(), part.collarPoints.begin(), part.collarPoints.end());
    whole.forkPoints.insert(whole.forkPoints.end(), part.forkPoints.begin(), part.forkPoints.end());
    whole.branchPoints.insert(whole.branchPoints.end(), part.branchPoints.begin(), part.branchPoints.end());
    whole.barkJoints.insert(whole.barkJoints.end(), part.barkJoints.begin(), part.barkJoints.end());
    for (ForkedBranch branch : part.branches) {
        branch.firstPoint += branchPoints;
        whole.branches.push_back(branch);
    }
    for (Fork fork : part.forks) {
        fork.firstPoint += forkPoints;
        whole.forks.push_back(fork);
    }
    for (Tube tube : part.tubes) {
        tube.firstRing += rings;
        tube.firstCollarPoint += collarPoints;
        tube.firstFork += forks;
        tube.firstBranch += branches;
        tube.barkJoint += barkJoints;
        whole.tubes.push_back(tube);
    }
}

/// At a level of detail with collars.
CollarLimit limitOf(int points, int lod) {
    const ThinCollars& thin = kThinCollars[lod];
    return points <= thin.points ? thin.limit : CollarLimit();
}

std::vector<BranchFoot> feetOf(const CGeneration& generation, const CStemSurface& surface, int lod, const std::vector<bool>& drawn) {
    std::vector<BranchFoot> feet(generation.stems.size());
    for (std::size_t s = 0; s < feet.size(); ++s) {
        const CStem& stem = generation.stems[s];
        if (drawn[s]) feet[s] = {surface.drawnAtBase(stem, generation.segments[stem.firstSegment]), limitOf(surface.ringPoints(stem.radius), lod)};
    }
    return feet;
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
} // namespace

const Fork* MeshPlan::forkAt(const Tube& tube, std::uint32_t ring) const {
    const std::span<const Fork> own = forksOf(tube);
    const auto above = std::ranges::upper_bound(own, ring, {}, &Fork::ring);
    return above != own.begin() && ring < (above - 1)->ring + (above - 1)->rings ? &*(above - 1) : nullptr;
}

std::uint32_t MeshPlan::drawnPath(const CGeneration& generation, const CStem& stem, std::uint32_t path) const {
    while (path > 0 && tubeOfPath[stem.firstPath + path] < 0) path = static_cast<std::uint32_t>(generation.paths[stem.firstPath + path].source);
    return path;
}

const ForkedBranch* MeshPlan::branch(std::uint32_t stem) const {
    const auto at = std::ranges::lower_bound(branches, stem, {}, &ForkedBranch::stem);
    return at != branches.end() && at->stem == stem ? &*at : nullptr;
}

const Tube& MeshPlan::bearerOf(const MeshPlan& later, const Tube& branch) const {
    const std::size_t triangle = later.collarPoints[branch.firstCollarPoint].triangle;
    return *(std::ranges::upper_bound(tubes, triangle, {}, &Tube::firstIndex) - 1);
}

MeshPlan planStems(const CTree& tree, int generation, const MeshParams& params, const Detail& detail, StemsBelow below,
                   const std::vector<bool>& drawn, Thickening thickening, const BranchesAbove* above, const CProgress& progress) {
    const CGeneration& own = tree.generation(static_cast<std::size_t>(generation));
    std::vector<float> room;
    if (!below.empty() && detail.collarRings > 0) {
        const CStemSurface surface(tree, generation, params, detail, thickening);
        room = collarRoom(own, tree.generation(below.size() - 1), feetOf(own, surface, detail.lod, drawn));
    }
    std::vector<MeshPlan> parts((own.stems.size() + kGrain - 1) / kGrain);
    parallelFor(
        own.stems.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            CSimplifier simplifier(tree, generation, params, detail, below, room, thickening, above);
            for (std::size_t s = begin; s < end; ++s)
                if (drawn[s]) simplifier.planStem(static_cast<std::uint32_t>(s), parts[begin / kGrain]);
        },
        progress);
    MeshPlan plan;
    for (const MeshPlan& part : parts) append(plan, part);
    layOut(plan, own.paths.size());
    plan.detail = &detail;
    plan.thickening = std::move(thickening);
    return plan;
}

MeshPlan planRings(const CTree& tree, int generation, const MeshParams& params, const Detail& detail,
                   StemsBelow below, const CProgress& progress, const StemChoice& choice) {
    const auto g = static_cast<std::size_t>(generation);
    const std::size_t stems = tree.generation(g).stems.size(), branches = g + 1 < tree.generationCount() ? tree.generation(g + 1).stems.size() : 0;
    std::vector<bool> bears;
    for (std::size_t s = 0; s < stems; ++s) bears.push_back(choice.bears(g, s));
    const BranchesAbove above{choice.drawn(g + 1, branches), choice.thickening(g + 1)};
    MeshPlan plan = planStems(tree, generation, params, detail, below, choice.drawn(g, stems), choice.thickening(g), &above, progress);
    plan.stemBears = std::move(bears);
    return plan;
}

} // namespace stromar
