#pragma once
#include "Grown.h"
#include "stromar/params/methods/weberpenn/TreeParams.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

/// The free part of a segment for its children: it starts at `start` (0..1) and holds `count` of them.
struct SegmentShare {
    std::uint32_t path;     ///< in the stem
    std::uint32_t segment;  ///< in the generation
    std::uint32_t position; ///< along the stem, from its base
    int count;
    double start;
};

/// Shares out `number` children over a stem's segments, path by path, low to high, by error diffusion from `error`
/// (Weber & Penn §4.3), and calls visit(SegmentShare) for every segment that gets some.
template <typename Visit>
void distribute(const CGrownGeneration& generation, const CStem& stem, double bare, double number, double error,
                Visit&& visit) {
    const double length = stem.length, segmentLength = length / generation.curveRes;
    if (length <= bare || number <= 0) return;
    for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
        const CPath& path = generation.paths[stem.firstPath + p];
        for (std::uint32_t s = 0; s < path.segmentCount; ++s) {
            const std::uint32_t position = path.firstPosition + s;
            const double bareShare = std::clamp(bare / segmentLength - position, 0.0, 1.0);
            const double density = generation.density[path.firstSegment + s];
            const double wanted = number * (1 - bareShare) * segmentLength / (length - bare) * density;
            const double count = std::floor(wanted + error + 0.5);
            error -= count - wanted;
            if (count < 1) continue;
            const double inParent = position == 0 ? std::min(1.0, stem.parentRadius / segmentLength) : 0.0;
            visit(SegmentShare{p, path.firstSegment + s, position, static_cast<int>(count),
                               std::max(bareShare, inParent)});
        }
    }
}

/// Where the i-th of a segment's children sits, 0..1 along it. `spread` is nBranchDist; `jitter` in −1..1 times the
/// spacing moves it.
inline double placeInSegment(const SegmentShare& share, int i, double spread, double jitter) {
    const double spacing = (1 - share.start) / share.count * spread;
    return std::clamp(share.start + spacing / 2 + i * spacing + jitter * spacing, share.start, 1.0);
}

/// The running turn of the children about their parent, path by path (Weber & Penn §4.1). Radians.
class CRotation {
public:
    explicit CRotation(double rotate) : m_rotate(rotate) {}

    void startPath(double phase) {
        m_phase = phase;
        m_running = 0;
        m_side = 1;
    }
    /// `variation` is var(nRotateV) of this child.
    double next(double variation) {
        if (m_rotate >= 0) return m_phase + (m_running += m_rotate + variation);
        const double turn = m_side * (std::numbers::pi + m_rotate + variation);
        m_side = -m_side;
        return m_phase + turn;
    }

private:
    double m_rotate, m_phase = 0, m_running = 0, m_side = 1;
};

/// The down angle of a child or leaf; `u` uniform in 0..1. Radians.
inline double downAngle(const LevelParams& level, const CCalculations& parentCalc, const StemMeasures& parent,
                        double offset, double u) {
    const double angle = level.downAngle.radians(), variation = level.downAngleV.radians();
    if (variation < 0) return parentCalc.gradedDownAngle(angle, variation, parent, offset);
    return angle + variation * (2 * u - 1);
}

} // namespace stromar
