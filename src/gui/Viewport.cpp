#include "Viewport.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <cmath>
#include <functional>
#include <osg/DisplaySettings>

namespace stromar {

/// A viewer whose wish to redraw becomes QWidget::update().
class CRedrawViewer : public osgViewer::Viewer {
public:
    std::function<void()> onRedraw;
    void requestRedraw() override {
        osgViewer::Viewer::requestRedraw();
        if (onRedraw) onRedraw();
    }
    void requestContinuousUpdate(bool on) override {
        osgViewer::Viewer::requestContinuousUpdate(on);
        if (on && onRedraw) onRedraw();
    }
};

namespace {
constexpr double kFieldOfView = 30; // degrees, vertical
constexpr int kSamples = 4;

/// Whether pictures are computed by the processor (llvmpipe …): then multisampling is far too slow.
bool drawsInSoftware() {
    QOffscreenSurface surface;
    surface.setFormat(CViewport::surfaceFormat(0));
    surface.create();
    QOpenGLContext context;
    context.setFormat(CViewport::surfaceFormat(0));
    if (!context.create() || !context.makeCurrent(&surface)) return true;
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QString renderer = QString::fromLatin1(name ? name : "");
    context.doneCurrent();
    return renderer.contains(QLatin1String("llvmpipe")) || renderer.contains(QLatin1String("softpipe")) ||
           renderer.contains(QLatin1String("SWR"));
}

unsigned osgButton(Qt::MouseButton button) {
    return button == Qt::LeftButton ? 1 : button == Qt::MiddleButton ? 2 : button == Qt::RightButton ? 3 : 0;
}

osg::Vec2 pixelOf(const QWidget& widget, const QPointF& at) {
    const qreal ratio = widget.devicePixelRatioF();
    return {static_cast<float>(at.x() * ratio), static_cast<float>(at.y() * ratio)};
}
} // namespace

QSurfaceFormat CViewport::surfaceFormat(int samples) {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CompatibilityProfile);
    format.setVersion(3, 3);
    format.setOption(QSurfaceFormat::DeprecatedFunctions); // without it Mesa gives a core context
    format.setDepthBufferSize(24);
    format.setSwapInterval(1);
    format.setSamples(samples);
    return format;
}

CViewport::CViewport(QWidget* parent)
    : QOpenGLWidget(parent), m_viewer(new CRedrawViewer), m_orbit(new osgGA::OrbitManipulator) {
    setFormat(surfaceFormat(drawsInSoftware() ? 0 : kSamples));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 200);
    osg::DisplaySettings::instance()->setVertexBufferHint(osg::DisplaySettings::VERTEX_BUFFER_OBJECT);
    m_viewer->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    m_viewer->setKeyEventSetsDone(0);
    m_viewer->setQuitEventSetsDone(false);
    m_viewer->setReleaseContextAtEndOfFrameHint(false);
    m_viewer->setRunFrameScheme(osgViewer::ViewerBase::ON_DEMAND);
    m_viewer->setLightingMode(osg::View::NO_LIGHT);
    m_viewer->onRedraw = [this] { update(); };
    osg::Camera* camera = m_viewer->getCamera();
    camera->setDrawBuffer(GL_COLOR_ATTACHMENT0); // a frame buffer object, not a window
    camera->setReadBuffer(GL_COLOR_ATTACHMENT0);
    m_orbit->setAllowThrow(false);
    m_orbit->setVerticalAxisFixed(true);
    m_orbit->setWheelZoomFactor(-0.1); // forward = nearer
    m_orbit->setAutoComputeHomePosition(false);
    m_viewer->setCameraManipulator(m_orbit, false);
    m_viewer->setSceneData(m_scene.root());
}

CViewport::~CViewport() {
    disconnect(m_contextDies); // else ~QOpenGLWidget calls into what is already destroyed
    m_viewer->onRedraw = nullptr;
    release();
}

void CViewport::release() {
    if (!m_window) return;
    makeCurrent();
    m_window->close();
    doneCurrent();
    m_viewer->getCamera()->setGraphicsContext(nullptr);
    m_window = nullptr;
}

void CViewport::initializeGL() {
    const QSurfaceFormat format = context()->format();
    if (format.version() < qMakePair(2, 1))
        emit unusable(
            tr("OpenGL 2.1 is needed to show the tree; this display has %1.%2. Files can still be edited and exported.")
                .arg(format.majorVersion())
                .arg(format.minorVersion()));
    m_window = new osgViewer::GraphicsWindowEmbedded(0, 0, width(), height());
    m_pixels = QSize();
    m_viewer->getCamera()->setGraphicsContext(m_window.get());
    disconnect(m_contextDies);
    m_contextDies = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
    applySize();
    m_viewer->realize();
}

void CViewport::applySize() {
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    if (pixels == m_pixels || !m_window) return;
    m_pixels = pixels;
    m_window->resized(0, 0, pixels.width(), pixels.height());
    m_window->getEventQueue()->windowResize(0, 0, pixels.width(), pixels.height());
    osg::Camera* camera = m_viewer->getCamera();
    camera->setViewport(0, 0, pixels.width(), pixels.height());
    camera->setProjectionMatrixAsPerspective(kFieldOfView, double(pixels.width()) / std::max(1, pixels.height()), 0.01,
                                             1000);
}

void CViewport::resizeGL(int, int) { applySize(); }

void CViewport::paintGL() {
    applySize();
    m_window->setDefaultFboId(
        defaultFramebufferObject()); // changes when the widget is resized or moved to another parent
    m_viewer->frame();
    ++m_frames;
    emit drawn();
    if (m_viewer->checkNeedToDoFrame()) update();
}

void CViewport::show(const std::vector<ViewPart>& parts) {
    m_scene.show(parts);
    update();
}

QString CViewport::setTexture(Surface surface, const QString& file) {
    update();
    return QString::fromStdString(m_scene.setTexture(surface, file.toStdString()));
}

void CViewport::setWireframe(bool on) {
    m_scene.setWireframe(on);
    update();
}

void CViewport::recentre() {
    osg::BoundingBox box = m_scene.bounds();
    if (!box.valid()) box = osg::BoundingBox(-1, -1, 0, 1, 1, 2);
    const osg::Vec3d middle = box.center(), half = (box._max - box._min) / 2;
    const double slope = std::tan(osg::DegreesToRadians(kFieldOfView / 2));
    const double aspect = double(width()) / std::max(1, height());
    const double across = std::max(half.x(), half.y());
    const double distance = 1.12 * std::max(half.z() / slope, across / (slope * aspect)) + across;
    const osg::Vec3d from = middle + osg::Vec3d(0, -1, 0.08) * distance;
    m_orbit->setHomePosition(from, middle, osg::Z_AXIS);
    m_viewer->home();
    update();
}

osg::Vec3d CViewport::eye() const {
    osg::Vec3d eye, centre, up;
    m_orbit->getTransformation(eye, centre, up);
    return eye;
}

void CViewport::mousePressEvent(QMouseEvent* event) {
    if (!events()) return;
    const osg::Vec2 at = pixelOf(*this, event->position());
    events()->mouseButtonPress(at.x(), at.y(), osgButton(event->button()));
    update();
}

void CViewport::mouseReleaseEvent(QMouseEvent* event) {
    if (!events()) return;
    const osg::Vec2 at = pixelOf(*this, event->position());
    events()->mouseButtonRelease(at.x(), at.y(), osgButton(event->button()));
    update();
}

void CViewport::mouseMoveEvent(QMouseEvent* event) {
    if (!events() || event->buttons() == Qt::NoButton) return;
    const osg::Vec2 at = pixelOf(*this, event->position());
    events()->mouseMotion(at.x(), at.y());
    update();
}

void CViewport::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void CViewport::wheelEvent(QWheelEvent* event) {
    if (!events() || event->angleDelta().y() == 0) return;
    events()->mouseScroll(event->angleDelta().y() > 0 ? osgGA::GUIEventAdapter::SCROLL_UP
                                                      : osgGA::GUIEventAdapter::SCROLL_DOWN);
    event->accept();
    update();
}

void CViewport::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space)
        recentre();
    else
        QOpenGLWidget::keyPressEvent(event);
}

} // namespace stromar
