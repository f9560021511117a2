#include "stem/BranchForks.h"
#include <algorithm>

namespace stromar {

std::uint32_t CBranchForks::pointsNeeded(const ForkNode& node, double radius) const {
    int needed = m_surface.roundPoints(radius);
    for (const std::uint32_t b : node.branches) needed = std::max(needed, m_branchSurface.roundPoints(m_branches.stems[b].radius));
    return static_cast<std::uint32_t>(needed);
}

bool CBranchForks::mayPart(const ForkNode& node, double radius) const {
    return node.branches.size() > 1 || pointsNeeded(node, radius) >= static_cast<std::uint32_t>(m_detail.forkPoints);
}

std::uint32_t CBranchForks::pointsAt(const ForkNode& node, double radius, std::uint32_t points) const {
    const std::uint32_t spare = m_detail.lod == 0 && node.branches.size() > 1; // limbs of one point's share are poor
    const std::uint32_t least = std::max(pointsNeeded(node, radius), static_cast<std::uint32_t>(node.limbs()) + spare);
    return double(points) > kTooManyPoints * double(least) ? least : points;
}

bool CBranchForks::fold(const ForkRings& rings, std::uint32_t points) {
    return std::ranges::any_of(rings.limbs, [&](const ForkLimb& limb) {
        if (!limb.isBranch) return false;
        const CStem& branch = m_branches.stems[limb.number];
        ForkStart start{{branch.firstSegment, points, 0}, limb, 0};
        for (double& along : start.limb.along) along -= branch.offset;
        MeshPlan plan;
        Tube tube{.stem = limb.number, .path = branch.firstPath, .points = points, .forked = true};
        tube.maxTurn = points > 3 ? m_branchSurface.turnOf(branch, m_detail.maxTurn) : 0;
        addForkPoints(limb.points, plan);
        plan.barkJoints.push_back(barkJointOf(limb, points));
        addLimbRings(m_branches, start, tube, plan);
        tube.ringCount = static_cast<std::uint32_t>(plan.rings.size());
        return !m_trial.write(plan, tube);
    });
}

void CBranchForks::add(const ForkLimb& limb, std::uint32_t points, Tube& tube, MeshPlan& plan) const {
    plan.branches.push_back({limb.number, {points, limb.share, limb.rings()}, static_cast<std::uint32_t>(plan.branchPoints.size()),
                             limb.along.back() - baseOf(limb), limb.seam, barkJointOf(limb, points)});
    plan.branchPoints.insert(plan.branchPoints.end(), limb.points.begin(), limb.points.end());
    tube.branchCount = static_cast<std::uint32_t>(plan.branches.size()) - tube.firstBranch;
}

BarkJoint CBranchForks::barkJointOf(const ForkLimb& limb, std::uint32_t points) const {
    const double turn = (double(limb.points[0].turn) + double(limb.points[limb.share].turn)) / 2, along = limb.along.front();
    return {turn, along - baseOf(limb), limb.along.back() - baseOf(limb), {m_bark.around(turn + double(limb.turned) / points), m_bark.at(along)},
            m_bark.around(), m_bark.perMetreAt(along)};
}

ForkStart startOnParent(const MeshPlan& parents, const CStem& branch, std::uint32_t number) {
    const ForkedBranch* given = parents.branch(number);
    if (!given) return {};
    const auto first = parents.branchPoints.begin() + given->firstPoint;
    ForkStart start{{branch.firstSegment, given->limb.points, 0}, {.isBranch = true, .number = number, .share = given->limb.share, .points = {first, first + given->limb.pointCount()}, .along = {}, .seam = given->seam}};
    for (std::uint32_t r = 0; r < given->limb.rings; ++r) start.limb.along.push_back(double(first[given->limb.firstOf(r)].along) - branch.offset);
    start.limb.along.push_back(given->clear);
    return start;
}

} // namespace stromar
