#include "Smoother.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr int kMostHalvings = 8;
constexpr int kRingsPerSphere = 8;
constexpr double kRadiusTolerance = 0.03; // of the stem's radius
constexpr double kPi = 3.14159265358979323846;
} // namespace

void CSmoother::subdivide(const CStem& stem, const CSegment& segment, std::uint32_t position, int helixRings,
                          std::vector<double>& places) const {
    if (segment.helixRadius > 0) {
        for (int i = 1; i < helixRings; ++i) places.push_back(double(i) / helixRings);
        return;
    }
    if (!m_surface.uneven(stem)) return;
    std::vector<double> marks = sphereMarks(stem, position);
    marks.push_back(1);
    Place low = at(stem, segment, position, 0);
    for (const double mark : marks) {
        const Place high = at(stem, segment, position, mark);
        addWhereRadiusBends(stem, segment, position, low, high, 0, places);
        if (mark < 1 && places.size() < ringLimit(static_cast<int>(stem.curveRes))) places.push_back(mark);
        low = high;
    }
}

/// Where rings of the chain of spheres stand (taper above 2): evenly by angle on each sphere, their touching points
/// included. Chains too fine for kMostRings get none.
std::vector<double> CSmoother::sphereMarks(const CStem& stem, std::uint32_t position) {
    const double radius = stem.measures.radius, length = stem.measures.length;
    if (stem.taper <= 2 || radius <= 0) return {};
    const double spheres = length / (2 * radius);
    const int perSphere = static_cast<int>(std::min<double>(kRingsPerSphere, kMostRings / (spheres + 1) - 1));
    if (perSphere < 2) return {};
    const double low = length * position / stem.curveRes, high = length * (position + 1) / stem.curveRes;
    std::vector<double> marks;
    for (int s = static_cast<int>((length - low) / (2 * radius)); s >= 0; --s)
        for (int i = perSphere; i > 0; --i) {
            const double toTip = radius * (2 * s + 1 - std::cos(kPi * i / perSphere));
            const double t = (length - toTip - low) / (high - low);
            if (t > 1e-6 && t < 1 - 1e-6) marks.push_back(t);
        }
    return marks;
}

void CSmoother::addWhereRadiusBends(const CStem& stem, const CSegment& segment, std::uint32_t position, Place low,
                                    Place high, int depth, std::vector<double>& places) const {
    const std::size_t limit = ringLimit(static_cast<int>(stem.curveRes));
    if (depth == kMostHalvings || places.size() >= limit) return;
    const Place middle = at(stem, segment, position, (low.t + high.t) / 2);
    const double tolerance = kRadiusTolerance * stem.measures.radius + m_surface.minRadius() / 2;
    if (std::abs(middle.radius - (low.radius + high.radius) / 2) <= tolerance) return;
    addWhereRadiusBends(stem, segment, position, low, middle, depth + 1, places);
    if (places.size() < limit) places.push_back(middle.t);
    addWhereRadiusBends(stem, segment, position, middle, high, depth + 1, places);
}

} // namespace stromar
