#pragma once
#include "stromar/scene/ViewScene.h"
#include <QOpenGLWidget>
#include <memory>
#include <osgGA/OrbitManipulator>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>

namespace stromar {

class CRedrawViewer;

/// Shows the tree. Left drag turns, right drag and wheel zoom, both buttons or the middle one pan, space recentres.
/// Draws only when something changed.
class CViewport : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit CViewport(QWidget* parent = nullptr);
    ~CViewport() override;

    /// OpenGL with its fixed functions, which OpenSceneGraph uses. For QSurfaceFormat::setDefaultFormat, before the
    /// QApplication, with 0 samples; the viewport itself takes more when a graphics card draws.
    static QSurfaceFormat surfaceFormat(int samples);

    /// Replaces the tree; the view stays.
    void show(const std::vector<ViewPart>& parts);
    using QOpenGLWidget::show;
    /// Empty on success, else what is wrong with the picture.
    QString setTexture(Surface surface, const QString& file);
    void setWireframe(bool on);
    /// Moves the camera so that the whole tree is seen from the front.
    void recentre();
    int framesDrawn() const { return m_frames; }
    /// Distance from the camera to what it turns about, metres.
    double distance() const { return m_orbit->getDistance(); }
    /// Where the camera looks from, for tests.
    osg::Vec3d eye() const;

signals:
    void drawn();
    /// OpenGL is missing or too old; the text is for the user.
    void unusable(const QString& why);

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void release();
    void applySize();
    osgGA::EventQueue* events() { return m_window ? m_window->getEventQueue() : nullptr; }

    CViewScene m_scene;
    osg::ref_ptr<CRedrawViewer> m_viewer;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> m_window;
    osg::ref_ptr<osgGA::OrbitManipulator> m_orbit;
    QMetaObject::Connection m_contextDies;
    QSize m_pixels;
    int m_frames = 0;
};

} // namespace stromar
