#pragma once
#include "stromar/tree/Tree.h"
#include <span>
#include <vector>

namespace stromar {

/// How the base of a branch is drawn.
struct BranchFoot {
    double radius = 0;   ///< with which it is drawn at its base, metres; 0 when it is not
    bool coarse = false; ///< by so few points that nobody sees how narrow its collar is
};

/// How wide each branch's collar may be so that it keeps off those of its siblings, as a share of its usual width, 0..1: not less than
/// a branch needs that is not to stand on a stalk. That of a coarse one does not reach around its parent either, which may be a prism of
/// three sides. By stem of `branches`, as `feet` are; those of one parent follow each other. Time n log n in the stems.
std::vector<float> collarRoom(const CGeneration& branches, const CGeneration& parents, std::span<const BranchFoot> feet);

} // namespace stromar
