#include "stem/Smoother.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
constexpr int kMaxHalvings = 8;
constexpr int kRingsPerSphere = 8;
constexpr double kRadiusTolerance = 0.03; // of the stem's radius
} // namespace

void CSmoother::subdivide(const CStem& stem, const CSegment& segment, int helixRings,
                          std::vector<double>& places) const {
    if (segment.helixRadius > 0) {
        for (int i = 1; i < helixRings; ++i) places.push_back(double(i) / helixRings);
        return;
    }
    if (!m_surface.uneven(stem)) return;
    std::vector<double> marks = sphereMarks(stem, segment);
    marks.push_back(1);
    Place low = at(stem, segment, 0);
    for (const double mark : marks) {
        const Place high = at(stem, segment, mark);
        addWhereRadiusBends(stem, segment, low, high, 0, places);
        if (mark < 1 && places.size() < ringLimit(segment.length / stem.length)) places.push_back(mark);
        low = high;
    }
}

/// Where rings of the chain of spheres stand (taper above 2): evenly by angle on each sphere, their touching points
/// included. Chains too fine for kMaxRings get none.
std::vector<double> CSmoother::sphereMarks(const CStem& stem, const CSegment& segment) {
    const double radius = stem.radius, length = stem.length;
    if (stem.profile.form != RadiusProfile::Form::Spheres || stem.profile.depth <= 0 || radius <= 0) return {};
    const double spheres = length / (2 * radius);
    const int perSphere = static_cast<int>(std::min<double>(kRingsPerSphere, kMaxRings / (spheres + 1) - 1));
    if (perSphere < 2) return {};
    const double low = segment.start, high = segment.end();
    std::vector<double> marks;
    for (int s = static_cast<int>((length - low) / (2 * radius)); s >= 0; --s)
        for (int i = perSphere; i > 0; --i) {
            const double toTip = radius * (2 * s + 1 - std::cos(std::numbers::pi * i / perSphere));
            const double t = (length - toTip - low) / (high - low);
            if (t > 1e-6 && t < 1 - 1e-6) marks.push_back(t);
        }
    return marks;
}

void CSmoother::addWhereRadiusBends(const CStem& stem, const CSegment& segment, Place low, Place high, int depth,
                                    std::vector<double>& places) const {
    const std::size_t limit = ringLimit(segment.length / stem.length);
    if (depth == kMaxHalvings || places.size() >= limit) return;
    const Place middle = at(stem, segment, (low.t + high.t) / 2);
    const double tolerance = kRadiusTolerance * stem.radius + m_surface.minRadius() / 2;
    if (std::abs(middle.radius - (low.radius + high.radius) / 2) <= tolerance) return;
    addWhereRadiusBends(stem, segment, low, middle, depth + 1, places);
    if (places.size() < limit) places.push_back(middle.t);
    addWhereRadiusBends(stem, segment, middle, high, depth + 1, places);
}

} // namespace stromar
