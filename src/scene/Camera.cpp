#include "stromar/scene/Camera.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <osg/Math>

namespace stromar {

namespace {
constexpr double kFitMargin = 0.98; // of the window that is filled
constexpr double kMaxPitch = 89.9;
constexpr double kOrthographicBack = 1000; // metres: nothing may lie behind an orthographic eye
constexpr double kNearest = 0.01, kFarthest = 20000;

osg::Quat turnOf(double yaw, double pitch) {
    const osg::Quat front(osg::PI_2, osg::X_AXIS); // looks along y
    return osg::Quat(-osg::DegreesToRadians(pitch), osg::X_AXIS) * front *
           osg::Quat(osg::DegreesToRadians(yaw), osg::Z_AXIS);
}

/// A place on a ball in the window, with a skirt outside of it.
osg::Vec3d onBall(const osg::Vec2d& place) {
    const double d = place.length();
    const double z = d < 0.7071 ? std::sqrt(1 - d * d) : 0.5 / d;
    osg::Vec3d point(place.x(), place.y(), z);
    point.normalize();
    return point;
}
} // namespace

void CCamera::lookFrom(double yaw, double pitch) { m_turn = turnOf(yaw, std::clamp(pitch, -90.0, 90.0)); }

double CCamera::halfHeight() const { return m_distance * std::tan(osg::DegreesToRadians(m_fieldOfView / 2)); }

void CCamera::frame(const osg::BoundingBoxd& box, double aspect) {
    m_centre = box.center();
    const double slope = std::tan(osg::DegreesToRadians(m_fieldOfView / 2));
    const osg::Vec3d across = right(), upright = up(), ahead = forward();
    double distance = kNearest;
    for (unsigned i = 0; i < 8; ++i) {
        const osg::Vec3d corner = box.corner(i) - m_centre;
        const double wide = std::abs(corner * across) / aspect, high = std::abs(corner * upright);
        const double nearer = m_orthographic ? 0 : -(corner * ahead);
        distance = std::max(distance, std::max(wide, high) / slope + nearer);
    }
    m_distance = 1.06 * distance;
}

/// Of an eye at e, in the camera's axes with z towards it, a point p is seen when |p.x − e.x| ≤ s·(e.z − p.z) with the
/// slope s of the window's sides: four planes, each of which the outermost point puts in its place.
void CCamera::fit(std::span<const osg::Vec3f> points, double aspect) {
    if (m_orthographic) return fitLevel(points, aspect);
    const double up = kFitMargin * std::tan(osg::DegreesToRadians(m_fieldOfView / 2)), aside = up * aspect;
    const osg::Quat back = m_turn.inverse();
    const double none = -std::numeric_limits<double>::infinity();
    double right = none, left = none, top = none, bottom = none;
    osg::BoundingBoxd box;
    for (const osg::Vec3f& point : points) {
        const osg::Vec3d p = back * osg::Vec3d(point);
        box.expandBy(osg::Vec3d(point));
        right = std::max(right, p.x() + aside * p.z());
        left = std::max(left, -p.x() + aside * p.z());
        top = std::max(top, p.y() + up * p.z());
        bottom = std::max(bottom, -p.y() + up * p.z());
    }
    const osg::Vec3d eye((right - left) / 2, (top - bottom) / 2,
                         std::max((right + left) / (2 * aside), (top + bottom) / (2 * up)));
    m_distance = std::max(kNearest, eye.z() - (back * osg::Vec3d(box.center())).z());
    m_centre = m_turn * (eye - osg::Vec3d(0, 0, m_distance));
}

/// Without perspective the window's half height alone counts.
void CCamera::fitLevel(std::span<const osg::Vec3f> points, double aspect) {
    const osg::Quat back = m_turn.inverse();
    osg::BoundingBoxd box;
    for (const osg::Vec3f& point : points) box.expandBy(back * osg::Vec3d(point));
    const double half = std::max(box.yMax() - box.yMin(), (box.xMax() - box.xMin()) / aspect) / 2;
    m_distance = std::max(kNearest, half / kFitMargin / std::tan(osg::DegreesToRadians(m_fieldOfView / 2)));
    m_centre = m_turn * box.center();
}

void CCamera::turn(double yaw, double pitch) {
    const double now = osg::RadiansToDegrees(std::asin(std::clamp(-forward().z(), -1.0, 1.0)));
    const double by = std::clamp(now + pitch, -kMaxPitch, kMaxPitch) - now;
    m_turn = osg::Quat(-osg::DegreesToRadians(by), osg::X_AXIS) * m_turn *
             osg::Quat(osg::DegreesToRadians(yaw), osg::Z_AXIS);
}

void CCamera::roll(const osg::Vec2d& from, const osg::Vec2d& to) {
    osg::Quat by;
    by.makeRotate(onBall(to), onBall(from)); // the camera goes the other way
    m_turn = by * m_turn;
}

void CCamera::straighten() {
    const osg::Vec3d ahead = forward();
    const double pitch = osg::RadiansToDegrees(std::asin(std::clamp(-ahead.z(), -1.0, 1.0)));
    const osg::Vec3d level = std::hypot(ahead.x(), ahead.y()) > 1e-3 ? ahead : up() * (ahead.z() < 0 ? 1 : -1);
    lookFrom(osg::RadiansToDegrees(std::atan2(-level.x(), level.y())), std::clamp(pitch, -kMaxPitch, kMaxPitch));
}

void CCamera::pan(const osg::Vec2d& by, double aspect) {
    m_centre -= right() * (by.x() * halfHeight() * aspect) + up() * (by.y() * halfHeight());
}

void CCamera::zoom(double factor) { m_distance = std::clamp(m_distance * factor, kNearest * 2, kFarthest / 4); }

void CCamera::place(const osg::Vec3d& centre, double distance, const osg::Quat& axes) {
    m_centre = centre;
    m_turn = axes;
    zoom(distance / m_distance);
}

osg::Vec3d CCamera::eye() const {
    return m_centre - forward() * (m_distance + (m_orthographic ? kOrthographicBack : 0));
}

osg::Matrixd CCamera::view() const { return osg::Matrixd::translate(-eye()) * osg::Matrixd::rotate(m_turn.inverse()); }

osg::Matrixd CCamera::projection(double aspect) const {
    if (!m_orthographic) return osg::Matrixd::perspective(m_fieldOfView, aspect, kNearest, kFarthest);
    const double half = halfHeight();
    return osg::Matrixd::ortho(-half * aspect, half * aspect, -half, half, 0, kFarthest);
}

osg::Vec3d CCamera::project(const osg::Vec3d& point, double aspect) const {
    const osg::Vec3d seen = point * view();
    if (seen.z() > -kNearest) return {0, 0, -1};
    const osg::Vec3d place = seen * projection(aspect);
    return {place.x(), place.y(), -seen.z()};
}

std::pair<osg::Vec3d, osg::Vec3d> CCamera::rayAt(const osg::Vec2d& place, double aspect) const {
    const osg::Vec3d offset = right() * (place.x() * halfHeight() * aspect) + up() * (place.y() * halfHeight());
    if (m_orthographic) return {eye() + offset, forward()};
    osg::Vec3d direction = forward() * m_distance + offset;
    direction.normalize();
    return {eye(), direction};
}

} // namespace stromar
