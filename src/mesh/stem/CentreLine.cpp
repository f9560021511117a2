#include "stem/CentreLine.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr double kMinTurn = 0.01;  // radians: below, a line is straight
constexpr double kOffAxis = 0.4;     // radii that a rounded bend may leave the corner: branches start on the axis
constexpr double kOfSegment = 0.4;   // of a segment that a bend at one of its ends may take
constexpr double kBehindFork = 0.55; // of a segment that a fork may take
constexpr double kLeastForkSine = 0.2; // of half the turn: straighter forks are rounded as far as those
constexpr double kMaxStretch = 2;   // of a mitred ring
} // namespace

double CCentreLine::halfSine(const glm::dvec3& low, const glm::dvec3& high) { return std::min(1.0, glm::distance(low, high) / 2); }

double CCentreLine::reachBelowFork(double length, double radius, double sine) {
    return std::min(kOfSegment * length, 2 * kOffAxis * radius / std::max(kLeastForkSine, sine));
}

double CCentreLine::reachAboveFork(double length, double radius, double sine) {
    return std::min(kBehindFork * length, 2 * kOffAxis * radius / std::max(kLeastForkSine, sine));
}

void CCentreLine::start(const CStem& stem, const CPath& path, double maxTurn, std::uint32_t segments) {
    const std::uint32_t count = segments < path.segmentCount ? segments + 1 : path.segmentCount; // with what the last one bends to
    m_path = &path;
    m_below = m_generation.segmentBelow(stem, path);
    m_joints.clear();
    m_frames.clear();
    m_frames.push_back(frameOfFirst(stem, path));
    for (std::uint32_t i = 1; i < count; ++i)
        m_frames.push_back(transported(m_frames.back(), m_generation.segments[path.firstSegment + i].frame[2]));
    for (std::uint32_t i = 0; i < count; ++i) m_joints.push_back(jointAt(stem, i, maxTurn));
    m_joints.emplace_back();
}

/// Carried from the stem's base through the paths that this one split from, so that all leave a fork alike.
Frame CCentreLine::frameOfFirst(const CStem& stem, const CPath& path) const {
    const Frame& own = m_generation.segments[path.firstSegment].frame;
    if (path.source < 0) return own;
    const CPath& source = m_generation.paths[stem.firstPath + static_cast<std::uint32_t>(path.source)];
    Frame frame = frameOfFirst(stem, source);
    for (std::uint32_t i = 1; i < path.firstPosition - source.firstPosition; ++i)
        frame = transported(frame, m_generation.segments[source.firstSegment + i].frame[2]);
    return transported(frame, own[2]);
}

CCentreLine::Joint CCentreLine::jointAt(const CStem& stem, std::uint32_t i, double maxTurn) const {
    const CSegment* below = i > 0 ? &m_generation.segments[m_path->firstSegment + i - 1] : m_below;
    if (!below) return {};
    const CSegment& above = m_generation.segments[m_path->firstSegment + i];
    Joint joint{.kind = below->forks ? Kind::Fork : Kind::Bend, .axisBelow = below->frame[2]};
    const double sine = halfSine(joint.axisBelow, above.frame[2]);
    joint.turn = 2 * std::asin(sine);
    if (below->helixRadius > 0 || above.helixRadius > 0) return joint;
    const int pieces = maxTurn > 0 ? std::min(kMaxBendRings, static_cast<int>(std::ceil(joint.turn / maxTurn))) : 0;
    joint.rings = (pieces + 1) / 2;
    if (joint.kind == Kind::Fork) return forkAt(stem, *below, i, joint);
    if (maxTurn <= 0 || joint.turn <= maxTurn || joint.turn < kMinTurn) return joint;
    const double radius = m_surface.woodRadius(stem, above, 0);
    const double tangent = sine / std::sqrt(std::max(1e-12, 1 - sine * sine));
    const double reach = std::min(kOfSegment * std::min(below->length, above.length), 2 * kOffAxis * radius / sine);
    if (reach >= 1.1 * radius * tangent) joint.below = joint.above = reach;
    return joint;
}

/// The paths of a fork part at one place, so how far below it they do depends on the one that turns most.
CCentreLine::Joint CCentreLine::forkAt(const CStem& stem, const CSegment& below, std::uint32_t i, Joint joint) const {
    const CSegment& above = m_generation.segments[m_path->firstSegment + i];
    const double radius = m_surface.woodRadius(stem, above, 0);
    joint.below = reachBelowFork(below.length, radius, sharpestTurn(stem, below));
    joint.above = reachAboveFork(above.length, radius, halfSine(joint.axisBelow, above.frame[2]));
    joint.rings = std::max(1, joint.rings);
    return joint;
}

/// Of the paths that part at the end of a segment: the sine of half the turn.
double CCentreLine::sharpestTurn(const CStem& stem, const CSegment& below) const {
    const auto end = static_cast<std::uint32_t>(&below - m_generation.segments.data()) + 1;
    double sine = 0;
    for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
        const CPath& path = m_generation.paths[stem.firstPath + p];
        const bool runsOn = path.firstSegment < end && end < path.firstSegment + path.segmentCount;
        const CSegment* above = runsOn ? &m_generation.segments[end]
                                : m_generation.segmentBelow(stem, path) == &below
                                    ? &m_generation.segments[path.firstSegment]
                                    : nullptr;
        if (above) sine = std::max(sine, halfSine(below.frame[2], above->frame[2]));
    }
    return sine;
}

CCentreLine::Place CCentreLine::at(std::uint32_t index, double t) const {
    const CSegment& segment = m_generation.segments[index];
    const double along = t * segment.length, left = segment.length - along;
    if (&segment == m_below) {
        if (left < m_joints[0].below) return onBend(m_joints[0], m_frames[0], segment.axisPoint(1), -left);
        return {segment.centre(t), transported(m_frames[0], segment.tangent(t))};
    }
    const std::uint32_t i = index - m_path->firstSegment;
    if (segment.helixRadius > 0) return {segment.centre(t), transported(m_frames[i], segment.tangent(t))};
    const Joint &low = m_joints[i], &high = m_joints[i + 1];
    if (along < low.above) return onBend(low, m_frames[i], segment.position, along);
    if (left < high.below) return onBend(high, m_frames[i + 1], m_generation.segments[index + 1].position, -left);
    if (t == 0 && low.kind == Kind::Fork) return {segment.position, transported(m_frames[i], low.axisBelow)};
    if (t == 0 && low.kind == Kind::Bend) return mitred(low, m_frames[i], segment.position);
    return {segment.axisPoint(t), m_frames[i]};
}

/// On the parabola that touches both segments `below` and `above` metres from their corner.
CCentreLine::Place CCentreLine::onBend(const Joint& joint, const Frame& above, const glm::dvec3& corner,
                                       double along) const {
    const double u = (along + joint.below) / (joint.below + joint.above), v = 1 - u;
    const glm::dvec3 low = joint.below * joint.axisBelow, high = joint.above * above[2];
    return {corner + u * u * high - v * v * low, transported(above, glm::normalize(v * low + u * high))};
}

/// The ring at half the angle, wider by 1/cos of it across the bend, so that the tube keeps its width.
CCentreLine::Place CCentreLine::mitred(const Joint& joint, const Frame& above, const glm::dvec3& corner) const {
    const glm::dvec3 sum = joint.axisBelow + above[2], across = above[2] - joint.axisBelow;
    const double cosine = glm::length(sum) / 2, bend = glm::length(across);
    if (cosine < 1e-6) return {corner, above};
    Place place{corner, transported(above, sum / (2 * cosine))};
    if (joint.turn > kMinTurn) {
        place.stretch = std::min(kMaxStretch, 1 / cosine);
        place.stretchAxis = across / bend;
    }
    return place;
}

void CCentreLine::addBendRings(std::uint32_t index, std::vector<double>& places) const {
    const double length = m_generation.segments[index].length;
    const Joint& low = m_joints[index - m_path->firstSegment];
    const Joint& high = m_joints[index - m_path->firstSegment + 1];
    if (low.above > 0)
        for (int i = 1; i <= low.rings; ++i) places.push_back(low.above / length * i / low.rings);
    if (high.below > 0)
        for (int i = high.rings; i > 0; --i) places.push_back(1 - high.below / length * i / high.rings);
}

} // namespace stromar
