#pragma once
#include "stromar/mesh/StemChoice.h"
#include "stromar/tree/Tree.h"
#include <span>
#include <vector>

namespace stromar {

/// Of the branches of a generation's stems: those that are drawn, and how.
struct BranchesAbove {
    std::vector<bool> drawn;
    Thickening thickening;
};

/// The nodes at which the wood of a stem parts into branches nearly as thick as itself: where its segments end. Others grow out
/// of its side, by collars.
class CNodes {
public:
    /// Of a generation; of all its branches without `drawn`, which has to outlive it.
    CNodes(const CTree& tree, std::size_t generation, const std::vector<bool>* drawn = nullptr)
        : m_branches(tree.branchesAtNodes(generation) ? tree.generation(generation + 1).stems : std::span<const CStem>()), m_drawn(drawn) {}

    /// The branches, ascending, that part from a stem's first path at the end of a segment, counted from its base.
    std::vector<std::uint32_t> at(std::uint32_t stem, std::uint32_t position) const;

private:
    std::span<const CStem> m_branches;
    const std::vector<bool>* m_drawn;
};

} // namespace stromar
