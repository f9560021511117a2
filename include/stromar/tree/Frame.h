#pragma once
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace stromar {

/// Three unit vectors at right angles in world coordinates, as columns X Y Z; Z is the axis of a stem, segment or leaf.
using Frame = glm::dmat3;

/// Turns about the frame's own X: a positive angle carries Z towards −Y. Radians, here and below.
inline Frame rotatedX(const Frame& f, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {f[0], c * f[1] + s * f[2], c * f[2] - s * f[1]};
}
/// Turns about the frame's own Y: a positive angle carries Z towards X.
inline Frame rotatedY(const Frame& f, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * f[0] - s * f[2], f[1], c * f[2] + s * f[0]};
}
/// Turns about the frame's own Z.
inline Frame rotatedZ(const Frame& f, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * f[0] + s * f[1], c * f[1] - s * f[0], f[2]};
}
/// Turns a vector about a unit axis.
inline glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return c * v + s * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
}
/// Turns about a unit axis given in world coordinates.
inline Frame rotatedAbout(const Frame& f, const glm::dvec3& axis, double angle) {
    return {turned(f[0], axis, angle), turned(f[1], axis, angle), turned(f[2], axis, angle)};
}
/// Turns about the world's vertical.
inline Frame rotatedWorldZ(const Frame& f, double angle) { return rotatedAbout(f, {0, 0, 1}, angle); }

/// The angle between the frame's axis and the vertical, 0..π.
inline double declination(const Frame& f) { return std::acos(glm::clamp(f[2].z, -1.0, 1.0)); }

/// The frame carried by the smallest turn to a new axis (a unit vector).
inline Frame transported(const Frame& f, const glm::dvec3& axis) {
    const double cosine = glm::dot(f[2], axis);
    if (cosine < -1 + 1e-12) return rotatedX(f, std::numbers::pi);
    const glm::dvec3 normal = glm::cross(f[2], axis); // its length is the sine
    const auto carried = [&](const glm::dvec3& v) {
        return cosine * v + glm::cross(normal, v) + glm::dot(normal, v) / (1 + cosine) * normal;
    };
    return {carried(f[0]), carried(f[1]), axis};
}

} // namespace stromar
