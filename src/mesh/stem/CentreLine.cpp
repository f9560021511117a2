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
constexpr double kMaxStretch = 2;   // of a mitred ring
constexpr double kForkOffAxis = 0.3; // of reach × half sine, what the curve behind a fork leaves the axis
} // namespace

void CCentreLine::start(const CStem& stem, const CPath& path, double maxTurn) {
    m_path = &path;
    m_joints.clear();
    m_frames.clear();
    m_frames.push_back(frameOfFirst(stem, path));
    for (std::uint32_t i = 1; i < path.segmentCount; ++i)
        m_frames.push_back(transported(m_frames.back(), m_generation.segments[path.firstSegment + i].frame[2]));
    for (std::uint32_t i = 0; i < path.segmentCount; ++i) m_joints.push_back(jointAt(stem, i, maxTurn));
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
    const CSegment* below = i > 0 ? &m_generation.segments[m_path->firstSegment + i - 1]
                                  : m_generation.segmentBelow(stem, *m_path);
    if (!below) return {};
    const CSegment& above = m_generation.segments[m_path->firstSegment + i];
    Joint joint{.kind = below->forks ? Kind::Fork : Kind::Bend, .axisBelow = below->frame[2]};
    const double sine = std::min(1.0, glm::distance(joint.axisBelow, above.frame[2]) / 2); // of half the turn
    joint.turn = 2 * std::asin(sine);
    const bool helix = below->helixRadius > 0 || above.helixRadius > 0;
    if (maxTurn <= 0 || joint.turn <= maxTurn || joint.turn < kMinTurn || helix) return joint;
    const double radius = m_surface.woodRadius(stem, above, 0);
    const int pieces = std::min(kMaxBendRings, static_cast<int>(std::ceil(joint.turn / maxTurn)));
    if (joint.kind == Kind::Fork) {
        const double reach = std::min(kBehindFork * above.length, kOffAxis * radius / (kForkOffAxis * sine));
        if (reach < 1.5 * radius * joint.turn) return joint;
        joint.reach = reach;
        joint.rings = std::max(2, pieces);
    } else {
        const double tangent = sine / std::sqrt(std::max(1e-12, 1 - sine * sine));
        const double reach = std::min(kOfSegment * std::min(below->length, above.length), 2 * kOffAxis * radius / sine);
        if (reach < 1.1 * radius * tangent) return joint;
        joint.reach = reach;
        joint.rings = (pieces + 1) / 2;
    }
    return joint;
}

CCentreLine::Place CCentreLine::at(std::uint32_t index, double t) const {
    const CSegment& segment = m_generation.segments[index];
    const std::uint32_t i = index - m_path->firstSegment;
    if (segment.helixRadius > 0) return {segment.centre(t), transported(m_frames[i], segment.tangent(t))};
    const Joint &low = m_joints[i], &high = m_joints[i + 1];
    const double along = t * segment.length, left = segment.length - along;
    if (low.kind == Kind::Fork && (along < low.reach || t == 0))
        return behindFork(low, m_frames[i], segment.position, along);
    if (low.kind == Kind::Bend && along < low.reach) return onBend(low, m_frames[i], segment.position, along);
    if (high.kind == Kind::Bend && left < high.reach)
        return onBend(high, m_frames[i + 1], m_generation.segments[index + 1].position, -left);
    if (t == 0 && low.kind == Kind::Bend) return mitred(low, m_frames[i], segment.position);
    return {segment.axisPoint(t), m_frames[i]};
}

/// On the parabola that touches both segments `reach` metres from their corner.
CCentreLine::Place CCentreLine::onBend(const Joint& joint, const Frame& above, const glm::dvec3& corner,
                                       double along) const {
    const double u = (along + joint.reach) / (2 * joint.reach), v = 1 - u;
    const glm::dvec3 centre = corner + joint.reach * (u * u * above[2] - v * v * joint.axisBelow);
    return {centre, transported(above, glm::normalize(v * joint.axisBelow + u * above[2]))};
}

/// On the cubic that leaves the fork along the segment below and reaches this one's axis `reach` metres behind it.
CCentreLine::Place CCentreLine::behindFork(const Joint& joint, const Frame& above, const glm::dvec3& fork,
                                           double along) const {
    if (joint.reach == 0) return {fork, transported(above, joint.axisBelow)};
    const double u = along / joint.reach, v = 1 - u, third = joint.reach / 3;
    const glm::dvec3 first = third * joint.axisBelow, last = joint.reach * above[2], second = last - third * above[2];
    const glm::dvec3 centre = fork + 3 * v * v * u * first + 3 * v * u * u * second + u * u * u * last;
    const glm::dvec3 axis = v * v * first + 2 * v * u * (second - first) + u * u * (last - second);
    return {centre, transported(above, glm::normalize(axis))};
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
    if (low.reach > 0)
        for (int i = 1; i <= low.rings; ++i) places.push_back(low.reach / length * i / low.rings);
    if (high.kind == Kind::Bend && high.reach > 0)
        for (int i = high.rings; i > 0; --i) places.push_back(1 - high.reach / length * i / high.rings);
}

} // namespace stromar
