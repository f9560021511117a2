#pragma once
#include "stromar/mesh/twig/Twig.h"
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

/// Their wood, as wide from all sides on the average as it is, but a prism of one or two pieces for each path: to measure what it covers.
/// It has no texture coordinates. Of more than 100,000 paths some, which are wider, stand for all: less than 100 MB.
std::shared_ptr<const CMesh> woodOfTwigs(const std::vector<LeafyTwig>& twigs, const CTree& tree, double minRadius);

/// That of all other stems, a prism for each segment; of more than 100,000 some, which are wider, stand for all: less than 25 MB.
std::shared_ptr<const CMesh> woodBeside(const StemSet& twigs, const CTree& tree, double minRadius);

/// Finds what is seen of the crown and of its cards (Twig::crown, cards, cardFit).
void measureCrown(Twig& twig, const StemSet& twigs, const CTree& tree, const CrownOrgans& organs, const MeshParams& params, const CProgress& progress);

} // namespace stromar
