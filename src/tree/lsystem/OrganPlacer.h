#pragma once
#include "CommonValues.h"
#include "OrganSites.h"
#include "stromar/tree/lsystem/TurtleStems.h"
#include "stromar/util/Progress.h"

namespace stromar {

/// Places the organs of one kind on the stems of a word: those that it writes, and besides so many on every stem without
/// branches.
class COrganPlacer {
public:
    COrganPlacer(const CParams& params, const CTree& tree, Organ organ);

    /// Counts all; places those that are asked for.
    std::shared_ptr<const COrgans> grow(const OrganDemand& demand, const CProgress& progress) const;
    /// On a stem without branches, besides those of the word.
    static int perBearer(const CParams& params, Organ organ);

private:
    const CTurtleGeneration& generation(std::size_t g) const {
        return static_cast<const CTurtleGeneration&>(m_tree.generation(g));
    }
    std::span<const CTurtleGeneration::Written> writtenOn(std::size_t g, std::size_t stem) const;
    void countOn(std::size_t g, std::vector<std::uint32_t>& counts) const;
    std::uint64_t idOf(const OrganSite& site) const;
    CLeaf place(const OrganSite& site) const;
    CLeaf placeWritten(const CTurtleGeneration::Written& written, const OrganSite& site) const;
    CLeaf placeOnBearer(std::uint32_t i, const OrganSite& site) const;

    const CParams& m_params;
    const CTree& m_tree;
    Organ m_organ;
    OrganPose m_pose;
    int m_perBearer, m_whorl;
};

} // namespace stromar
