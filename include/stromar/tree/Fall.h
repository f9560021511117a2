#pragma once
#include "stromar/tree/Wind.h"
#include <limits>

namespace stromar {

/// Where a tree is cut, and where to it falls.
struct Felling {
    double direction = 0; ///< degrees from x, counter-clockwise seen from above
    double height = 0;    ///< of the cut, metres

    bool operator==(const Felling&) const = default;
};

/// A tree that falls: a stiff body on a hinge at the cut, θ'' = (m·g·h/I)·sin θ from 1°, whose stems bend in the wind
/// of their own motion. It lies when the upper half of a trunk meets the ground, after one bounce; branches may pass
/// through it. Immutable, any thread.
class CFall {
public:
    CFall(std::shared_ptr<const CWindTable> table, const Felling& felling);

    const Felling& felling() const { return m_felling; }
    /// From the first crack until it lies.
    double seconds() const;
    double angleAt(double seconds) const; ///< radians from where it stood
    double speedAt(double seconds) const; ///< radians per second
    glm::dvec3 hinge() const { return m_hinge; }
    glm::dvec3 axis() const { return m_axis; } ///< unit, horizontal; it turns about this
    /// Whether what hangs at a node is above the cut.
    bool falls(std::size_t node) const { return m_falls[node]; }
    bool anythingFalls() const { return m_inertia > 0; }
    /// The same place on one side of the cut: between a node that falls and one that stands there is nothing.
    SwayPlace onOneSide(const SwayPlace& place, bool above) const;

    void pose(double seconds, WindPose& pose, const CProgress& progress) const;
    /// What the air that a stem moves through does to it, in the frame of the standing tree.
    CWindTable::Push pushAt(const WindStem& stem, double seconds) const { return pushOn(stem, speedAt(seconds)); }

private:
    struct TrunkCut {
        double along = std::numeric_limits<double>::infinity(); ///< from the stem's base; above it falls
        glm::dvec3 at{0};
        bool none() const { return along == std::numeric_limits<double>::infinity(); }
    };
    void cutTrunk(std::size_t stem);
    void hangBranches();
    void weigh();
    void simulate();
    double restAngle() const;
    void poseTrunk(const WindStem& own, const CWindTable::Push& push, double angle, std::vector<glm::vec4>& rows) const;
    CWindTable::Push pushOn(const WindStem& stem, double speed) const;

    std::shared_ptr<const CWindTable> m_table;
    Felling m_felling;
    glm::dvec3 m_hinge{0}, m_axis, m_direction;
    std::vector<bool> m_falls;                     ///< by node
    std::vector<SwayPlace> m_on;                   ///< by stem: where it hangs on its parent, on its side of the cut
    std::vector<TrunkCut> m_cuts;                  ///< by trunk
    double m_mass = 0, m_lever = 0, m_inertia = 0; ///< lever: height of the middle of mass above the hinge
    std::vector<float> m_angles, m_speeds;         ///< by time step
};

} // namespace stromar
