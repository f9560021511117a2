#include "stem/CollarRoom.h"
#include "stem/Collar.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr double kOfRoom = 0.9;        // of the room between two collars that both may take
constexpr double kLeastSine = 0.2;    // of the angle to the parent
constexpr std::size_t kMostNear = 64; // siblings that are looked at

/// Where a branch leaves the wood of its parent, which is taken for a straight cylinder: an ellipse on the wall.
struct Footprint {
    std::uint32_t stem;
    double along, turn;         ///< of the middle: metres along the parent, radians about it
    double halfLength, halfWidth; ///< metres
    double parentRadius;
    CollarLimit limit;
};

Footprint footprintOf(const CGeneration& branches, const CGeneration& parents, std::uint32_t s, const BranchFoot& foot) {
    const CStem& stem = branches.stems[s];
    const CStem& parent = parents.stems[static_cast<std::size_t>(stem.parent)];
    const Frame& wood = parents.segmentAt(parent, stem.path, stem.position).frame;
    const glm::dvec3 way = branches.segments[stem.firstSegment].tangent(0);
    const double cosine = glm::dot(way, wood[2]), x = glm::dot(way, wood[0]), y = glm::dot(way, wood[1]);
    const double sine = std::max(kLeastSine, std::hypot(x, y));
    return {s, stem.offset + stem.parentRadius * cosine / sine, std::atan2(y, x), CCollarMaker::kAlong * foot.radius / sine,
            CCollarMaker::kAcross * foot.radius, stem.parentRadius, foot.limit};
}

/// Below 1 two of them overlap.
double apart(const Footprint& one, const Footprint& other) {
    const double turn = std::remainder(one.turn - other.turn, kTurn);
    const double across = turn * (one.parentRadius + other.parentRadius) / 2;
    return std::hypot((one.along - other.along) / (one.halfLength + other.halfLength), across / (one.halfWidth + other.halfWidth));
}

void shareRoom(std::vector<Footprint>& siblings, std::vector<float>& room) {
    std::ranges::sort(siblings, {}, &Footprint::along);
    double longest = 0;
    for (const Footprint& own : siblings) longest = std::max(longest, own.halfLength);
    for (std::size_t i = 0; i < siblings.size(); ++i) {
        const Footprint& own = siblings[i];
        double share = std::min(1.0, own.limit.around * own.parentRadius / own.halfWidth);
        const auto keepOff = [&](const Footprint& other) { share = std::min(share, std::max(own.limit.narrowest, kOfRoom * apart(own, other))); };
        const double far = own.halfLength + longest;
        for (std::size_t j = i + 1; j < std::min(siblings.size(), i + 1 + kMostNear) && siblings[j].along - own.along < far; ++j) keepOff(siblings[j]);
        for (std::size_t j = i; j-- > 0 && i - j <= kMostNear && own.along - siblings[j].along < far;) keepOff(siblings[j]);
        room[own.stem] = static_cast<float>(share);
    }
}
} // namespace

std::vector<float> collarRoom(const CGeneration& branches, const CGeneration& parents, std::span<const BranchFoot> feet) {
    std::vector<float> room(branches.stems.size(), 1);
    std::vector<Footprint> siblings;
    for (std::uint32_t s = 0; s < room.size(); ++s) {
        if (feet[s].radius > 0) siblings.push_back(footprintOf(branches, parents, s, feet[s]));
        if (s + 1 < room.size() && branches.stems[s + 1].parent == branches.stems[s].parent) continue;
        shareRoom(siblings, room);
        siblings.clear();
    }
    return room;
}

} // namespace stromar
