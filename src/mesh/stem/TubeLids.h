#pragma once
#include "stromar/mesh/MeshBuilder.h"
#include <vector>

namespace stromar {

/// Where a lid with a middle lies in its mesh: first the middle, then the points around it; a triangle for each.
struct LidPlace {
    std::uint32_t vertex, points;
    std::size_t index;
};

/// The lids of a tube come last: over the holes of branches that start at its forks, and that at its base.
inline std::vector<LidPlace> branchLidsOf(const MeshPlan& plan, const Tube& tube) {
    const std::uint32_t base = tube.joined ? 0 : plan.baseLidPoints(tube);
    const bool middle = tube.middleOfLid(true);
    LidPlace next{tube.firstVertex + tube.vertices - (tube.joined ? 0 : base + (middle ? 1 : 0)), 0,
                  tube.firstIndex + tube.indices - 3 * std::size_t{tube.joined ? 0 : middle ? base : base - 2}};
    const std::span<const ForkedBranch> branches = plan.branchesOf(tube);
    std::vector<LidPlace> lids(branches.size());
    for (std::size_t b = branches.size(); b-- > 0;) {
        next.points = branches[b].limb.lidPoints();
        next.vertex -= next.points + 1;
        next.index -= 3 * std::size_t{next.points};
        lids[b] = next;
    }
    return lids;
}

} // namespace stromar
