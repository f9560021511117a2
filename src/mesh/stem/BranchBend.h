#pragma once
#include "stem/PathSurface.h"

namespace stromar {

/// A branch as a limb of its parent's fork: its line leaves the parent's axis below the node on a parabola, its radius
/// goes over from the parent's, and its rings turn evenly, so that their points lie as the branch's own where these start. Metres; `along`
/// is counted on the parent.
class CBranchBend {
public:
    /// `common`: the ring where the limbs part, `reach` below the node. Its own line, which starts with the segment `first`, is met `above` the node.
    CBranchBend(const CStem& branch, const CSegment& first, const RingShape& common, double reach, double above);

    double node() const { return m_node; }
    /// Where the branch's own line starts.
    double end() const { return m_node + m_above; }
    /// `branch` looks at the branch's path.
    RingShape shapeAt(const CPathSurface& branch, double along) const;
    /// Turns the rings up to a place so that the branch's own has so many points there; which of them is the ring's first.
    std::int32_t turnTo(const CPathSurface& branch, double along, std::uint32_t points);

private:
    double m_node, m_below, m_above;
    glm::dvec3 m_corner, m_low, m_high; ///< of the parabola: the last two are ways from the first
    RingShape m_common;
    double m_twist = 0, m_twisted = 0; ///< radians, and where all of it is reached
};

} // namespace stromar
