#pragma once
#include "view/Navigation.h"
#include "view/RestPicture.h"
#include "view/ViewOverlay.h"
#include "stromar/scene/SceneRenderer.h"
#include <QOpenGLFramebufferObject>
#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

namespace stromar {

/// Shows the tree. The mouse moves the view as the table of mouse maps says; a click picks. Draws only when something
/// changed.
class CViewport : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit CViewport(QWidget* parent = nullptr);
    ~CViewport() override;

    /// Replaces the tree; the view stays. A model that stood in for the one before is gone.
    void show(const std::vector<ViewPart>& parts);
    /// When what stands in for a tree that is too slow is drawn in its place: while the view moves, or also until the tree rests.
    enum class StandIn { InMotion, UntilRest };
    void setStandIn(const std::vector<ViewPart>& parts, StandIn when = StandIn::InMotion);
    bool drawsStandIn() const { return m_wantsStandIn && m_scene.hasStandIn() && (m_standIn == StandIn::UntilRest ? hurries() : moves()); }
    using QOpenGLWidget::show;
    /// As CViewScene::showBeside().
    void showBeside(const std::vector<TreeBeside>& others);
    /// The tree in the wind, as CViewScene::setPose(). Shadows follow in each picture where drawing is quick, else now and then.
    void setPose(const std::shared_ptr<const ModelSway>& sway, const std::shared_ptr<const WindPose>& pose, double seconds, double loop);
    void endSway();
    /// An arrow on the ground that can be dragged: degrees from x, counter-clockwise from above.
    void showWindArrow(std::optional<double> degrees);
    void setSurface(Surface surface, const SurfaceMaps& maps);
    void setLook(const ViewLook& look);
    const ViewLook& look() const { return m_scene.look(); }
    void tint(int generation);
    int tinted() const { return m_scene.tinted(); }
    void setNavigation(const Navigation& navigation) { m_navigation = &navigation; }
    /// Free turning instead of turning with z upright.
    void setTrackball(bool on);
    void setOrthographic(bool on);
    /// While on, a drag of the left button measures instead of moving the view: between points of the tree, else of the upright
    /// plane through the middle of the view. Off, the measure goes.
    void setMeasuring(bool on);

    const CCamera& camera() const { return m_camera; }
    const CViewScene& scene() const { return m_scene; }
    CViewOverlay& overlay() { return *m_overlay; }
    /// The whole tree from the front.
    void recentre();
    /// The whole tree, from where it is seen.
    void frame();
    /// Something lies on so many pixels at the lower edge: trees are framed above it.
    void setCovered(int pixels) { m_covered = pixels; }
    /// As it was seen before.
    void setCamera(const CCamera& camera);
    /// Metres from the middle of the view; the direction stays.
    void moveTo(double distance);
    /// Degrees: 0 the front, 90 the right; 90 from above.
    void lookFrom(double yaw, double pitch);
    /// The tree with its backdrop, without the overlay, as smooth as so many passes make it. Null when there is no
    /// OpenGL, or no room for it.
    QImage picture(const QSize& pixels, const ViewLook& look, const CCamera& camera, int passes = 1);
    /// A tree and its pictures.
    struct TreeLook {
        const std::vector<ViewPart>* parts;
        std::vector<std::pair<Surface, const SurfaceMaps*>> surfaces;
    };
    /// The view with another tree, as large as the widget; `instead` is the one that it shows, which is there again after it.
    QImage pictureOf(const TreeLook& tree, const TreeLook& instead);
    int framesDrawn() const { return m_frames; }
    /// Whether shadows still have to follow the tree.
    bool settling() const { return m_settle.isActive(); }
    /// Whether the picture of a view that rests becomes smoother.
    bool refining() const { return m_rest.busy(); }

signals:
    void drawn();
    /// Camera, tree or light.
    void viewChanged();
    void contextLost();
    void picked(const std::optional<stromar::ViewHit>& hit);
    /// A handle was dragged; all changes of one drag have the same gesture.
    void guideDragged(std::size_t handle, const glm::dvec2& to, int gesture);
    void guideReleased();
    void windDragged(double degrees);

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void release();
    void moveView(ViewMotion motion, const QPointF& from, const QPointF& to);
    void pick(const QPointF& at);
    osg::Vec3d measuredPoint(const QPointF& at) const;
    void measureTo(const QPointF& at);
    void changed();
    void redraw();
    bool moves() const;
    bool hurries() const; ///< a hand waits for the next picture
    void adaptToHand();
    QImage restPass(const ViewPass& pass);
    std::unique_ptr<QOpenGLFramebufferObject> makeBuffer(const QSize& pixels);
    QImage draw(QOpenGLFramebufferObject& buffer, const CCamera& camera, const ViewPass& pass);

    CViewScene m_scene;
    CCamera m_camera;
    CSceneRenderer m_renderer;
    CViewOverlay* m_overlay;
    CRestPicture m_rest;
    std::unique_ptr<QOpenGLFramebufferObject> m_restBuffer; ///< of its passes
    const Navigation* m_navigation;
    QMetaObject::Connection m_contextDies;
    QTimer m_settle; ///< runs while the tree changes: shadows follow when it rests
    QPointF m_pressed, m_last;
    std::optional<std::size_t> m_handle; ///< that is being dragged
    int m_gesture = 0;
    bool m_windHeld = false; ///< the arrow is being dragged
    bool m_wipeHeld = false; ///< the line between before and after
    std::size_t m_organVertices = 0; ///< of leaves in a picture that moves
    bool m_wantsStandIn = false;     ///< pictures that move are too slow with the tree itself
    StandIn m_standIn = StandIn::InMotion;
    QElapsedTimer m_sinceMoved, m_sinceShown, m_sincePaint;
    bool m_measuring = false;
    int m_posesSinceShadows = 0;
    qint64 m_frameNs = 0; ///< how long the last paintGL() took
    bool m_click = false; ///< the mouse has not moved since a button went down
    bool m_trackball = false;
    bool m_lost = false;
    int m_frames = 0, m_covered = 0;
};

} // namespace stromar
