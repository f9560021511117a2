#include "stromar/app/Collision.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr double kThin = 0.125; // of the thickest radius

double distanceTo(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 along = to - from;
    const double length = glm::dot(along, along);
    const double part = length > 0 ? std::clamp(glm::dot(point - from, along) / length, 0.0, 1.0) : 0;
    return glm::length(point - (from + part * along));
}

/// The thick part of a path as few capsules.
void addPath(std::span<const CSegment> segments, double thin, std::vector<Capsule>& capsules) {
    const auto thick = std::ranges::find_if(segments, [&](const CSegment& segment) { return segment.radiusEnd < thin; });
    segments = segments.first(static_cast<std::size_t>(thick - segments.begin()) + (thick != segments.end() && thick->radiusBase >= thin ? 1 : 0));
    for (std::size_t first = 0; first < segments.size();) {
        std::size_t last = first;
        const auto capsule = [&](std::size_t end) {
            return Capsule{segments[first].position, segments[end].axisPoint(1), (segments[first].radiusBase + segments[end].radiusEnd) / 2};
        };
        const auto fits = [&](std::size_t end) {
            const Capsule one = capsule(end);
            for (std::size_t i = first; i < end; ++i)
                if (distanceTo(segments[i].axisPoint(1), one.from, one.to) > one.radius) return false;
            return one.radius >= segments[first].radiusBase / 2; // not one of all thicknesses
        };
        while (last + 1 < segments.size() && fits(last + 1)) ++last;
        capsules.push_back(capsule(last));
        first = last + 1;
    }
}
} // namespace

std::vector<Capsule> collisionOf(const CTree& tree) {
    double thickest = 0;
    for (const auto& generation : tree.generations())
        for (const CStem& stem : generation->stems) thickest = std::max(thickest, stem.radius);
    std::vector<Capsule> capsules;
    for (const auto& generation : tree.generations())
        for (const CPath& path : generation->paths) addPath(generation->segmentsOf(path), kThin * thickest, capsules);
    std::ranges::stable_sort(capsules, std::greater(), &Capsule::radius);
    if (capsules.size() > kMaxCapsules) capsules.resize(kMaxCapsules);
    return capsules;
}

} // namespace stromar
