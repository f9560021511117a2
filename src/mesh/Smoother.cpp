#include "Smoother.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr int kMostHalvings = 8;
constexpr double kRadiusTolerance = 0.03; // of the stem's radius
constexpr int kMostSpheres = 64;          // pieces of one segment to look at when the taper makes a chain
} // namespace

void CSmoother::subdivide(const CStem& stem, const CSegment& segment, std::uint32_t position,
                          std::vector<double>& places) const {
    if (segment.helixRadius > 0) {
        for (int i = 1; i < kHelixRings; ++i) places.push_back(double(i) / kHelixRings);
        return;
    }
    if (!m_surface.uneven(stem)) return;
    const int pieces = startPieces(stem, segment);
    for (int i = 0; i < pieces; ++i) {
        if (places.size() > kMostRings / stem.curveRes) return;
        const Place low = at(stem, segment, position, double(i) / pieces),
                    high = at(stem, segment, position, double(i + 1) / pieces);
        if (i > 0) places.push_back(low.t);
        addWhereRadiusBends(stem, segment, position, low, high, 0, places);
    }
}

int CSmoother::startPieces(const CStem& stem, const CSegment& segment) {
    if (stem.taper <= 2 || stem.measures.radius <= 0) return 1;
    return std::clamp(static_cast<int>(std::ceil(segment.length / stem.measures.radius)), 1, kMostSpheres);
}

void CSmoother::addWhereRadiusBends(const CStem& stem, const CSegment& segment, std::uint32_t position, Place low,
                                    Place high, int depth, std::vector<double>& places) const {
    if (depth == kMostHalvings || places.size() > kMostRings / stem.curveRes) return;
    const Place middle = at(stem, segment, position, (low.t + high.t) / 2);
    const double tolerance = kRadiusTolerance * stem.measures.radius + m_surface.minRadius() / 2;
    if (std::abs(middle.radius - (low.radius + high.radius) / 2) <= tolerance) return;
    addWhereRadiusBends(stem, segment, position, low, middle, depth + 1, places);
    places.push_back(middle.t);
    addWhereRadiusBends(stem, segment, position, middle, high, depth + 1, places);
}

} // namespace stromar
