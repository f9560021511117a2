#include "stromar/scene/SceneRenderer.h"
#include <algorithm>
#include <osg/DisplaySettings>
#include <osg/GLObjects>

namespace stromar {

CSceneRenderer::CSceneRenderer(CViewScene& scene) : m_scene(scene), m_viewer(new osgViewer::Viewer) {
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
    m_viewer->setSceneData(scene.root());
}

void CSceneRenderer::attach(int samples, int passes) {
    m_window = new osgViewer::GraphicsWindowEmbedded(0, 0, 16, 16);
    m_viewer->getCamera()->setGraphicsContext(m_window.get());
    m_viewer->getCamera()->setViewport(0, 0, 16, 16);
    m_viewer->realize();
    const unsigned context = m_window->getState()->getContextID();
    m_scene.startContext(samples, passes, osg::isGLExtensionOrVersionSupported(context, "GL_ARB_instanced_arrays", 3.3f));
}

void CSceneRenderer::detach() {
    if (!m_window) return;
    m_window->close();
    m_viewer->getCamera()->setGraphicsContext(nullptr);
    m_window = nullptr;
}

const osg::GLExtensions& CSceneRenderer::extensions() const {
    return *osg::GLExtensions::Get(m_window->getState()->getContextID(), true);
}

void CSceneRenderer::freeDeleted() { osg::flushAllDeletedGLObjects(m_window->getState()->getContextID()); }

void CSceneRenderer::draw(unsigned frameBuffer, int width, int height, const CCamera& camera,
                          const ViewPass& pass) {
    const double aspect = double(width) / std::max(1, height);
    m_window->resized(0, 0, width, height);
    m_window->setDefaultFboId(frameBuffer); // changes when a widget is resized or moved to another parent
    osg::Camera* eye = m_viewer->getCamera();
    eye->setViewport(0, 0, width, height);
    eye->setProjectionMatrix(camera.projection(aspect) *
                             osg::Matrixd::translate(2 * pass.pixel.x() / width, 2 * pass.pixel.y() / height, 0));
    eye->setViewMatrix(camera.view());
    const double pixel = 2 / (eye->getProjectionMatrix()(1, 1) * height);
    m_scene.setPass(pass, pixel, camera.orthographic() ? 1 : camera.distance());
    freeDeleted();
    extensions().glBindFramebuffer(GL_FRAMEBUFFER_EXT, frameBuffer); // the viewer binds it after others only
    m_viewer->frame();
    m_scene.finishFrame();
}

} // namespace stromar
