#pragma once
#include "work/TreeCreatorThread.h"
#include "stromar/scene/SceneRenderer.h"
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <memory>

namespace stromar {

/// Pictures of trees without a window: thumbnails. The GUI thread.
class COffscreenPainter {
public:
    COffscreenPainter();
    ~COffscreenPainter();

    /// The whole tree from the front. Null when there is no OpenGL.
    QImage paint(const ViewModel& view, const QSize& pixels, const ViewLook& look);
    /// From another place, and perhaps in a pose of the wind.
    QImage paint(const ViewModel& view, const QSize& pixels, const ViewLook& look, const CCamera& camera,
                 const std::shared_ptr<const WindPose>& pose = nullptr, double seconds = 0, double loop = 0);
    /// Frees all that lies on the graphics card until the next picture.
    void rest();

private:
    bool start();
    bool attach();
    void show(const ViewModel& view, const ViewLook& look);
    QImage draw(const QSize& pixels, const CCamera& camera);

    CViewScene m_scene;
    CSceneRenderer m_renderer;
    QOffscreenSurface m_surface;
    std::unique_ptr<QOpenGLContext> m_context;
};

} // namespace stromar
