#pragma once
#include "stromar/tree/Tree.h"
#include <vector>

namespace stromar {

/// A twig and how many leaves the season has left on it.
struct LeafyTwig {
    std::uint32_t generation, stem, leaves;

    const CStem& of(const CTree& tree) const { return tree.generation(generation).stems[stem]; }
};

/// The twigs that bear some, in the order of generations and stems.
std::vector<LeafyTwig> leafyTwigs(const StemSet& twigs, const CTree& tree, const COrgans& leaves, double share);
double leavesOn(const std::vector<LeafyTwig>& twigs);

} // namespace stromar
