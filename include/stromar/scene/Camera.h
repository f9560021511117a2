#pragma once
#include <osg/BoundingBox>
#include <osg/Matrixd>
#include <osg/Quat>
#include <osg/Vec2d>
#include <osg/Vec3d>
#include <osg/Vec3f>
#include <span>

namespace stromar {

/// Where the tree is seen from: a point that the view turns about, and the way there. Metres, z up. Places in the
/// window are −1 … 1, x to the right, y up.
class CCamera {
public:
    static constexpr double kFieldOfView = 30; ///< degrees, vertical: what it is at first

    /// Seen from this direction: 0 the front, 90 the right, in degrees; `pitch` 90 from above.
    void lookFrom(double yaw, double pitch);
    /// Moves so that the box fills the window; the direction stays.
    void frame(const osg::BoundingBoxd& box, double aspect);
    /// Moves so that the points just fill the window, with a margin of 2 %; the direction stays. There is one at least.
    void fit(std::span<const osg::Vec3f> points, double aspect);
    /// Degrees, vertical.
    void setFieldOfView(double degrees) { m_fieldOfView = degrees; }

    /// Turns with z upright. Degrees.
    void turn(double yaw, double pitch);
    /// Turns freely as if a ball around the tree were rolled from one place to another.
    void roll(const osg::Vec2d& from, const osg::Vec2d& to);
    /// Brings z upright again.
    void straighten();
    /// So that what lies in the distance of the centre follows the mouse.
    void pan(const osg::Vec2d& by, double aspect);
    /// Distance times this.
    void zoom(double factor);
    void setOrthographic(bool on) { m_orthographic = on; }
    bool orthographic() const { return m_orthographic; }

    /// As another one stands: the point it turns about, the distance to it, and its axes.
    void place(const osg::Vec3d& centre, double distance, const osg::Quat& axes);

    osg::Vec3d eye() const;
    /// From the camera's axes (x right, y up, −z ahead) to the world's.
    const osg::Quat& axes() const { return m_turn; }
    const osg::Vec3d& centre() const { return m_centre; }
    double distance() const { return m_distance; }
    osg::Vec3d forward() const { return m_turn * osg::Vec3d(0, 0, -1); }
    osg::Vec3d right() const { return m_turn * osg::Vec3d(1, 0, 0); }
    osg::Vec3d up() const { return m_turn * osg::Vec3d(0, 1, 0); }

    osg::Matrixd view() const;
    /// Near and far are only a first guess; the renderer fits them to the scene.
    osg::Matrixd projection(double aspect) const;
    /// Where a point is seen; z < 0 lies behind the eye.
    osg::Vec3d project(const osg::Vec3d& point, double aspect) const;
    /// A point seen at this place, nearer than everything, and the direction of the ray.
    std::pair<osg::Vec3d, osg::Vec3d> rayAt(const osg::Vec2d& place, double aspect) const;
    /// Metres from the middle of the window to its top, at the distance of the centre.
    double halfHeight() const;

private:
    void fitLevel(std::span<const osg::Vec3f> points, double aspect);

    osg::Vec3d m_centre{0, 0, 1};
    double m_distance = 10;
    osg::Quat m_turn; ///< from the camera's axes (x right, y up, −z ahead) to the world's
    double m_fieldOfView = kFieldOfView;
    bool m_orthographic = false;
};

} // namespace stromar
