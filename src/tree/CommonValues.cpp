#include "CommonValues.h"
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr double kFruitsHang = -0.85;

/// The frame carried towards the plumb line: down for −1, up for 1.
Frame raised(const Frame& frame, double rise) {
    const glm::dvec3 axis = (1 - std::abs(rise)) * frame[2] + glm::dvec3(0, 0, rise);
    const double length = glm::length(axis);
    return length > 1e-9 ? transported(frame, axis / length) : frame;
}

/// Its direction on the ground; that of x where it has none.
glm::dvec2 horizontal(const glm::dvec3& v) { return v.x == 0 && v.y == 0 ? glm::dvec2(1, 0) : glm::dvec2(v); }

/// The frame turned outwards and up to the light by `bend` 0..1 (Weber & Penn §4.9).
Frame bentToLight(const Frame& frame, const glm::dvec3& position, double bend) {
    if (bend == 0) return frame;
    const glm::dvec3 n = frame[1];
    const glm::dvec2 from = horizontal(n), to = horizontal(position);
    const double outwards = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    const Frame turned = rotatedWorldZ(frame, bend * outwards);
    const glm::dvec3 m = turned[1];
    const double level = std::hypot(m.x, m.y);
    const glm::dvec3 axis = level > 1e-12 ? glm::dvec3(m.y, -m.x, 0) / level : turned[0];
    return rotatedAbout(turned, axis, bend * std::atan2(level, m.z));
}
} // namespace

Frame OrganPose::applied(const Frame& frame, const glm::dvec3& position) const {
    return bentToLight(rise != 0 ? raised(frame, rise) : frame, position, bend);
}

BaseForm baseFormOf(const CommonParams& g) {
    return {g.flare, g.lobes, g.lobeDepth, g.lobeFade, g.roots, g.rootReach, g.rootHeight};
}

OrganPose poseOf(const CommonParams& g, Organ organ) {
    const double length = g.leafScale / std::sqrt(g.leafQuality);
    switch (organ) {
    case Organ::Blossom: return {g.blossomScale, g.blossomScale, g.leafBend * (1 - std::abs(g.blossomUp)), g.blossomUp};
    case Organ::Fruit: return {g.fruitScale, g.fruitScale * g.fruitScaleX, 0, kFruitsHang};
    default: return {length, length * g.leafScaleX, g.leafBend, 0};
    }
}

} // namespace stromar
