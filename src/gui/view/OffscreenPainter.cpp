#include "view/OffscreenPainter.h"
#include "window/Display.h"
#include <QOpenGLFramebufferObject>

namespace stromar {

COffscreenPainter::COffscreenPainter() : m_renderer(m_scene) {}

COffscreenPainter::~COffscreenPainter() {
    if (!m_context || !m_context->makeCurrent(&m_surface)) return;
    m_renderer.detach();
    m_context->doneCurrent();
}

bool COffscreenPainter::start() {
    if (m_renderer.attached()) return true;
    if (m_context) return attach();
    if (QString why; !display::available(why)) return false;
    m_surface.setFormat(display::surfaceFormat(0));
    m_surface.create();
    m_context = std::make_unique<QOpenGLContext>();
    m_context->setFormat(display::surfaceFormat(0));
    return m_context->create() && attach();
}

bool COffscreenPainter::attach() {
    if (!m_context->makeCurrent(&m_surface)) return false;
    m_renderer.attach(display::bestSamples());
    return true;
}

void COffscreenPainter::show(const ViewModel& view, const ViewLook& look) {
    m_scene.show(view.parts);
    m_scene.setLook(look);
    for (const Surface surface : kSurfaces)
        if (const auto& maps = view.surfaces[static_cast<std::size_t>(surface)]) m_scene.setSurface(surface, *maps);
}

QImage COffscreenPainter::draw(const QSize& pixels, const CCamera& camera) {
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(display::bestSamples());
    QImage image;
    {
        QOpenGLFramebufferObject buffer(pixels, format);
        if (!buffer.isValid()) return {};
        m_renderer.draw(buffer.handle(), pixels.width(), pixels.height(), camera);
        image = buffer.toImage();
    }
    m_context->doneCurrent();
    return image;
}

QImage COffscreenPainter::paint(const ViewModel& view, const QSize& pixels, const ViewLook& look) {
    if (!start() || !m_context->makeCurrent(&m_surface)) return {};
    show(view, look);
    CCamera camera;
    camera.lookFrom(0, 5);
    const osg::BoundingBox box = m_scene.bounds();
    if (box.valid())
        camera.frame(osg::BoundingBoxd(osg::Vec3d(box._min), osg::Vec3d(box._max)),
                     double(pixels.width()) / pixels.height());
    return draw(pixels, camera);
}

QImage COffscreenPainter::paint(const ViewModel& view, const QSize& pixels, const ViewLook& look, const CCamera& camera,
                                const std::shared_ptr<const WindPose>& pose, double seconds, double loop) {
    if (!start() || !m_context->makeCurrent(&m_surface)) return {};
    show(view, look);
    if (pose) m_scene.setPose(view.sway, pose, seconds, loop);
    return draw(pixels, camera);
}

void COffscreenPainter::rest() {
    if (!m_renderer.attached() || !m_context->makeCurrent(&m_surface)) return;
    m_scene.show({});
    {
        QOpenGLFramebufferObject buffer(16, 16); // OpenSceneGraph holds what it drew until it draws something else
        m_renderer.draw(buffer.handle(), 16, 16, CCamera());
    }
    m_renderer.detach();
    m_context->doneCurrent();
}

} // namespace stromar
