#include "OffscreenPainter.h"
#include <QOpenGLFramebufferObject>

namespace stromar {

COffscreenPainter::COffscreenPainter() : m_renderer(m_scene.root()) {}

COffscreenPainter::~COffscreenPainter() {
    if (!m_context || !m_context->makeCurrent(&m_surface)) return;
    m_renderer.detach();
    m_context->doneCurrent();
}

bool COffscreenPainter::start() {
    if (m_context) return m_renderer.attached();
    if (QString why; !CSceneRenderer::available(why)) return false;
    m_surface.setFormat(CSceneRenderer::surfaceFormat(0));
    m_surface.create();
    m_context = std::make_unique<QOpenGLContext>();
    m_context->setFormat(CSceneRenderer::surfaceFormat(0));
    if (!m_context->create() || !m_context->makeCurrent(&m_surface)) return false;
    m_renderer.attach();
    return true;
}

QImage COffscreenPainter::paint(const std::vector<ViewPart>& parts, const QString& bark, const QString& leaf,
                                const QSize& pixels, const ViewLook& look) {
    if (!start() || !m_context->makeCurrent(&m_surface)) return {};
    m_scene.show(parts);
    m_scene.setLook(look);
    for (auto [shown, wanted, surface] : {std::tuple{&m_bark, &bark, Surface::Bark}, {&m_leaf, &leaf, Surface::Leaf}})
        if (*shown != *wanted) {
            m_scene.setTexture(surface, wanted->toStdString());
            *shown = *wanted;
        }
    CCamera camera;
    camera.lookFrom(0, 5);
    const osg::BoundingBox box = m_scene.bounds();
    if (box.valid())
        camera.frame(osg::BoundingBoxd(osg::Vec3d(box._min), osg::Vec3d(box._max)),
                     double(pixels.width()) / pixels.height());
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(CSceneRenderer::bestSamples());
    QImage image;
    {
        QOpenGLFramebufferObject buffer(pixels, format);
        m_renderer.draw(buffer.handle(), pixels, camera);
        image = buffer.toImage();
    }
    m_context->doneCurrent();
    return image;
}

} // namespace stromar
