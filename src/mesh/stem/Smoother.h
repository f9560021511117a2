#pragma once
#include "stem/StemSurface.h"
#include <algorithm>
#include <vector>

namespace stromar {

/// Decides where a segment needs rings between its ends: where the radius bends (flare, round ends, spheres) and along
/// a helix. At most ringLimit() per segment, so about kMaxRings along a path.
class CSmoother {
public:
    static constexpr int kHelixRings = 10;
    static constexpr int kMaxRings = 1024;

    /// For a segment that is this part of its stem.
    static std::size_t ringLimit(double part) {
        return static_cast<std::size_t>(std::max<double>(kHelixRings - 1, kMaxRings * part + 1e-6));
    }

    explicit CSmoother(const CStemSurface& surface) : m_surface(surface) {}

    /// Appends the places, 0 < t < 1, in rising order. `helixRings` per turn, kHelixRings at most.
    void subdivide(const CStem& stem, const CSegment& segment, int helixRings, std::vector<double>& places) const;

private:
    struct Place {
        double t, radius;
    };
    Place at(const CStem& stem, const CSegment& segment, double t) const {
        return {t, m_surface.outerRadius(stem, segment, t)};
    }
    void addWhereRadiusBends(const CStem& stem, const CSegment& segment, Place low, Place high, int depth,
                             std::vector<double>& places) const;
    static std::vector<double> sphereMarks(const CStem& stem, const CSegment& segment);

    const CStemSurface& m_surface;
};

} // namespace stromar
