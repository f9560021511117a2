#pragma once
#include "stromar/tree/Tree.h"
#include <vector>

namespace stromar {

/// A rod with round ends. Metres, z up.
struct Capsule {
    glm::dvec3 from, to; ///< the middles of its ends
    double radius;
};

/// What stands for the tree where things bump into it: its trunks and thick branches, down to an eighth of the thickest one's radius, at most
/// kMaxCapsules, the thickest first. A bent stem has several, one behind the other; none leaves its stem's axis by more than its radius.
std::vector<Capsule> collisionOf(const CTree& tree);

constexpr std::size_t kMaxCapsules = 64;

} // namespace stromar
