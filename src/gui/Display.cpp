#include "SceneRenderer.h"
#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <osg/DisplaySettings>

namespace stromar {

namespace {
constexpr int kSamples = 4;

/// What this display can do.
struct Display {
    bool hasContext = false;
    std::pair<int, int> version{0, 0};
    QString renderer;
};

Display askDisplay() {
    QOffscreenSurface surface;
    surface.setFormat(CSceneRenderer::surfaceFormat(0));
    surface.create();
    QOpenGLContext context;
    context.setFormat(CSceneRenderer::surfaceFormat(0));
    if (!context.create() || !context.makeCurrent(&surface)) return {};
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const Display display{true,
                          {context.format().majorVersion(), context.format().minorVersion()},
                          QString::fromLatin1(name ? name : "")};
    context.doneCurrent();
    return display;
}

const Display& thisDisplay() {
    static const Display display = askDisplay();
    return display;
}
} // namespace

QSurfaceFormat CSceneRenderer::surfaceFormat(int samples) {
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

bool CSceneRenderer::available(QString& why) {
    const Display& display = thisDisplay();
    if (display.version >= std::pair(2, 1)) return true;
    why = display.hasContext
              ? QCoreApplication::translate("stromar::CViewport", "OpenGL 2.1 is needed to show the tree; this display "
                                                                  "has %1.%2. Files can still be edited and exported.")
                    .arg(display.version.first)
                    .arg(display.version.second)
              : QCoreApplication::translate("stromar::CViewport",
                                            "There is no OpenGL on this display, so the tree cannot be shown. Install "
                                            "your graphics driver. Files can still be edited and exported.");
    return false;
}

bool CSceneRenderer::drawsInSoftware() {
    const QString& renderer = thisDisplay().renderer;
    return renderer.contains(QLatin1String("llvmpipe")) || renderer.contains(QLatin1String("softpipe")) ||
           renderer.contains(QLatin1String("SWR"));
}

int CSceneRenderer::bestSamples() { return drawsInSoftware() ? 0 : kSamples; }

CSceneRenderer::CSceneRenderer(osg::Group* scene) : m_viewer(new osgViewer::Viewer) {
    osg::DisplaySettings::instance()->setVertexBufferHint(osg::DisplaySettings::VERTEX_BUFFER_OBJECT);
    m_viewer->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    m_viewer->setKeyEventSetsDone(0);
    m_viewer->setQuitEventSetsDone(false);
    m_viewer->setReleaseContextAtEndOfFrameHint(false);
    m_viewer->setLightingMode(osg::View::NO_LIGHT);
    osg::Camera* camera = m_viewer->getCamera();
    camera->setDrawBuffer(GL_COLOR_ATTACHMENT0); // a frame buffer object, not a window
    camera->setReadBuffer(GL_COLOR_ATTACHMENT0);
    camera->setClearColor(osg::Vec4(0, 0, 0, 0));
    m_viewer->setSceneData(scene);
}

void CSceneRenderer::attach() {
    m_window = new osgViewer::GraphicsWindowEmbedded(0, 0, 16, 16);
    m_viewer->getCamera()->setGraphicsContext(m_window.get());
    m_viewer->getCamera()->setViewport(0, 0, 16, 16);
    m_viewer->realize();
}

void CSceneRenderer::detach() {
    if (!m_window) return;
    m_window->close();
    m_viewer->getCamera()->setGraphicsContext(nullptr);
    m_window = nullptr;
}

void CSceneRenderer::draw(unsigned frameBuffer, const QSize& pixels, const CCamera& camera) {
    const double aspect = double(pixels.width()) / std::max(1, pixels.height());
    m_window->resized(0, 0, pixels.width(), pixels.height());
    m_window->setDefaultFboId(frameBuffer); // changes when a widget is resized or moved to another parent
    osg::Camera* eye = m_viewer->getCamera();
    eye->setViewport(0, 0, pixels.width(), pixels.height());
    eye->setProjectionMatrix(camera.projection(aspect));
    eye->setViewMatrix(camera.view());
    m_viewer->frame();
}

} // namespace stromar
