#pragma once
#include "StemSurface.h"
#include <algorithm>
#include <vector>

namespace stromar {

/// Decides where a segment needs rings between its ends: where the radius bends (flare, round ends, spheres) and along
/// a helix. At most ringLimit() per segment, so at most kMostRings along a path.
class CSmoother {
public:
    static constexpr int kHelixRings = 10;
    static constexpr int kMostRings = 1024;

    static std::size_t ringLimit(int curveRes) {
        return static_cast<std::size_t>(std::max(kHelixRings - 1, kMostRings / curveRes));
    }

    explicit CSmoother(const CStemSurface& surface) : m_surface(surface) {}

    /// Appends the places, 0 < t < 1, in rising order. `helixRings` per turn, kHelixRings at most.
    void subdivide(const CStem& stem, const CSegment& segment, std::uint32_t position, int helixRings,
                   std::vector<double>& places) const;

private:
    struct Place {
        double t, radius;
    };
    Place at(const CStem& stem, const CSegment& segment, std::uint32_t position, double t) const {
        return {t, m_surface.outerRadius(stem, segment, position, t)};
    }
    void addWhereRadiusBends(const CStem& stem, const CSegment& segment, std::uint32_t position, Place low, Place high,
                             int depth, std::vector<double>& places) const;
    static std::vector<double> sphereMarks(const CStem& stem, std::uint32_t position);

    const CStemSurface& m_surface;
};

} // namespace stromar
