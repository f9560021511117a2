#pragma once
#include "stem/Fork.h"

namespace stromar {

/// Where a path or a branch starts at a fork: what has been planned for it with what it parts from.
struct ForkStart {
    Ring common{}; ///< no points: it starts inside the wood, or by a collar
    ForkLimb limb; ///< places of a branch are counted from its own base
    std::uint32_t firstPoint = 0; ///< of the limb's, in the plan
};

/// Which is the first in the plan.
inline std::uint32_t addForkPoints(const std::vector<ForkPoint>& points, MeshPlan& plan) {
    plan.forkPoints.insert(plan.forkPoints.end(), points.begin(), points.end());
    return static_cast<std::uint32_t>(plan.forkPoints.size() - points.size());
}

/// Rings of a tube above a fork: those that are given, one that turns the seam back, and the first of its own.
inline void addLimbRings(const CGeneration& generation, const ForkStart& start, Tube& tube, MeshPlan& plan) {
    const auto ringAt = [&](double along, bool parted) {
        const auto [segment, t] = placeAlong(generation, generation.stems[tube.stem], generation.paths[tube.path], along);
        plan.rings.push_back({segment, start.common.points, t, parted});
    };
    const std::uint32_t given = start.limb.rings();
    plan.forks.push_back({static_cast<std::uint32_t>(plan.rings.size()) - tube.firstRing, given, start.firstPoint, start.limb.seam});
    tube.forkCount = static_cast<std::uint32_t>(plan.forks.size()) - tube.firstFork;
    plan.rings.push_back({start.common.segment, start.limb.share, start.common.t, true});
    for (std::uint32_t r = 1; r <= given; ++r) ringAt(start.limb.along[r], false);
    ringAt(start.limb.along.back(), true);
}

} // namespace stromar
