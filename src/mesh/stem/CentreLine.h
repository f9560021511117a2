#pragma once
#include "stem/StemSurface.h"
#include <vector>

namespace stromar {

/// The line through the middles of a path's rings: the segments' own centre lines, joined by rounded bends. Where a
/// stem forks, the lines of all its paths leave the segment below at one place, and each bends from there.
class CCentreLine {
public:
    /// Where a ring lies and how it is stretched to keep a mitred bend as wide as the stem.
    struct Place {
        glm::dvec3 centre;
        Frame frame; ///< the ring lies in its XY plane
        double stretch = 1;
        glm::dvec3 stretchAxis{0}; ///< unit, in that plane
    };

    CCentreLine(const CGeneration& generation, const CStemSurface& surface)
        : m_generation(generation), m_surface(surface) {}

    /// Looks at the first segments of a path, which are all that is asked for. Bends of more than `maxTurn` radians between rings are rounded; 0 rounds none.
    void start(const CStem& stem, const CPath& path, double maxTurn, std::uint32_t segments = kAllSegments);
    static constexpr std::uint32_t kAllSegments = ~std::uint32_t{0};

    /// On one of the path's segments, or on the one below its fork.
    Place at(std::uint32_t segment, double t) const;
    /// Appends where rings have to stand for the bends at both ends of a segment: 0 < t < 1, in rising order.
    void addBendRings(std::uint32_t segment, std::vector<double>& places) const;
    /// The turn at the lower end of a segment, radians.
    double turnBelow(std::uint32_t segment) const { return m_joints[segment - m_path->firstSegment].turn; }

    bool forksBelow(std::uint32_t segment) const { return m_joints[segment - m_path->firstSegment].kind == Kind::Fork; }
    /// How far below the lower end of a segment its paths part, metres.
    double forkReach(std::uint32_t segment) const { return m_joints[segment - m_path->firstSegment].below; }

    /// How far below a fork its paths part, and how far above it one runs straight again: of a segment of that length and the wood's radius
    /// above it, metres, and the sine of half the turn, the sharpest or the path's own.
    static double reachBelowFork(double length, double radius, double sine);
    static double reachAboveFork(double length, double radius, double sine);
    /// The sine of half the turn between two directions.
    static double halfSine(const glm::dvec3& low, const glm::dvec3& high);

    /// Rings that one bend takes at most, besides the one in its middle.
    static constexpr int kMaxBendRings = 6;

private:
    enum class Kind { None, Bend, Fork };
    struct Joint {
        Kind kind = Kind::None;
        double turn = 0;  ///< radians
        double below = 0, above = 0; ///< metres along the segments that are rounded; 0 = mitred
        int rings = 0;               ///< on each side
        glm::dvec3 axisBelow{0};
    };

    Frame frameOfFirst(const CStem& stem, const CPath& path) const;
    Joint jointAt(const CStem& stem, std::uint32_t i, double maxTurn) const;
    Joint forkAt(const CStem& stem, const CSegment& below, std::uint32_t i, Joint joint) const;
    double sharpestTurn(const CStem& stem, const CSegment& below) const;
    Place onBend(const Joint& joint, const Frame& above, const glm::dvec3& corner, double along) const;
    Place mitred(const Joint& joint, const Frame& above, const glm::dvec3& corner) const;

    const CGeneration& m_generation;
    const CStemSurface& m_surface;
    const CPath* m_path = nullptr;
    const CSegment* m_below = nullptr; ///< of the path's fork
    std::vector<Frame> m_frames; ///< of the segments, carried along the stem without a twist
    std::vector<Joint> m_joints; ///< at the lower end of each segment, and one without a bend at the tip
};

} // namespace stromar
