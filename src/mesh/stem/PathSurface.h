#pragma once
#include "stem/CentreLine.h"
#include "stem/RootFlare.h"
#include "stem/StemSurface.h"
#include <utility>

namespace stromar {

/// A ring in space. Angles count from the frame's X.
struct RingShape : CCentreLine::Place {
    double radius; ///< mean, at least the drawn floor
    double slope;  ///< change of the radius per metre along the stem
    double along;  ///< metres from the stem's base
    double lobeDepth;
    int lobes;
};

/// A place of a path, metres along its stem, as a segment and the part of it: from the segment below the path's fork, if it
/// starts at one, to its tip.
std::pair<std::uint32_t, double> placeAlong(const CGeneration& generation, const CStem& stem, const CPath& path, double along);

/// The wood of one path of a stem, as a function of the place along it and of the angle.
class CPathSurface {
public:
    CPathSurface(const CGeneration& generation, const CStemSurface& surface)
        : m_generation(generation), m_surface(surface), m_line(generation, surface) {}

    /// Looks at a path; `lobed`: with its bulges and roots. The rest as in CCentreLine::start().
    void start(const CStem& stem, const CPath& path, double maxTurn, bool lobed, std::uint32_t segments = CCentreLine::kAllSegments);

    /// At a place of one of the path's segments, or of the one below its fork. Without a slope.
    RingShape shapeAt(std::uint32_t segment, double t) const;
    /// Metres along the stem, from the last segment below the path's fork to its tip. With its slope.
    RingShape shapeAt(double along) const;

    /// `direction` is the cosine and the sine of the angle.
    glm::dvec3 pointAt(const RingShape& ring, double angle, glm::dvec2 direction) const;
    /// The surface is centre + r(angle, s)·outwards + s·axis; the normal is the product of its two tangents.
    glm::dvec3 normalAt(const RingShape& ring, double angle, glm::dvec2 direction) const;

    /// From the ring's centre to the surface.
    double radiusAt(const RingShape& ring, double angle) const;
    bool hasRootsAt(double along) const { return !m_roots.empty() && along < m_roots.height() * m_stem->length; }

    const CStem& stem() const { return *m_stem; }

private:
    double woodRadiusAt(double along) const;

    const CGeneration& m_generation;
    const CStemSurface& m_surface;
    CCentreLine m_line;
    const CStem* m_stem = nullptr;
    const CPath* m_path = nullptr;
    bool m_lobed = false;
    double m_floor = 0;
    CRootFlare m_roots;
};

} // namespace stromar
