#pragma once
#include "stem/BarkScale.h"
#include "stem/LimbRings.h"
#include "stem/TubeTrial.h"

namespace stromar {

/// The branches of a generation's stems that part from them at forks: writes them into the plan of these.
class CBranchForks {
public:
    static constexpr double kTooManyPoints = 1.15; ///< times those that are needed at a fork

    /// `surface` is the stems'. What is given has to outlive it.
    CBranchForks(const CTree& tree, std::size_t generation, const MeshParams& params, const Detail& detail, const BranchesAbove& above,
                 const CStemSurface& surface)
        : m_detail(detail), m_branches(tree.generation(generation + 1)), m_branchSurface(tree, static_cast<int>(generation) + 1, params, detail, above.thickening),
          m_nodes(tree, generation, &above.drawn), m_trial(m_branches, m_branchSurface), m_surface(surface), m_bark(surface) {}

    const CNodes& nodes() const { return m_nodes; }
    const CStemSurface& branchSurface() const { return m_branchSurface; }

    /// Looks at a path of a stem; `joint`: of a tube that is forked itself.
    void startPath(const CGeneration& generation, const CStem& stem, const CPath& path, const BarkJoint* joint) { m_bark.start(generation, stem, path, joint); }
    /// `radius` as the stem is, in metres: not where a collar does for a thin branch.
    bool mayPart(const ForkNode& node, double radius) const;
    /// Branches have as many points as the common ring, and their branches: where that has far too many it gets what they need.
    std::uint32_t pointsAt(const ForkNode& node, double radius, std::uint32_t points) const;
    /// Tries the lowest rings of the branches, while they can still grow out of the side instead. `points` of the common ring.
    bool fold(const ForkRings& rings, std::uint32_t points);
    /// For when the branch's own generation is planned.
    void add(const ForkLimb& limb, std::uint32_t points, Tube& tube, MeshPlan& plan) const;

private:
    std::uint32_t pointsNeeded(const ForkNode& node, double radius) const;
    BarkJoint barkJointOf(const ForkLimb& limb, std::uint32_t points) const;
    double baseOf(const ForkLimb& limb) const { return m_branches.stems[limb.number].offset; }

    const Detail& m_detail;
    const CGeneration& m_branches;
    CStemSurface m_branchSurface;
    CNodes m_nodes;
    CTubeTrial m_trial;
    const CStemSurface& m_surface;
    CBarkScale m_bark; ///< of the path
};

/// What a branch was given by the plan of its parents; no points where it does not start at a fork.
ForkStart startOnParent(const MeshPlan& parents, const CStem& branch, std::uint32_t number);

} // namespace stromar
