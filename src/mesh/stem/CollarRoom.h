#pragma once
#include "stromar/tree/Tree.h"
#include <limits>
#include <span>
#include <vector>

namespace stromar {

/// How narrow a collar may be.
struct CollarLimit {
    double narrowest = 0.6; ///< share of its usual width: with less a branch would stand on a stalk
    double around = std::numeric_limits<double>::infinity(); ///< how far it may reach around to each side, radii of the parent
};

/// How the base of a branch is drawn.
struct BranchFoot {
    double radius = 0; ///< with which it is drawn at its base, metres; 0 when it is not
    CollarLimit limit;
};

/// How wide each branch's collar may be so that it keeps off those of its siblings, as a share of its usual width, 0..1. By stem of
/// `branches`, as `feet` are; those of one parent follow each other. Time n log n in the stems.
std::vector<float> collarRoom(const CGeneration& branches, const CGeneration& parents, std::span<const BranchFoot> feet);

} // namespace stromar
