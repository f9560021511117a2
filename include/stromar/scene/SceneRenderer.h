#pragma once
#include "Camera.h"
#include <QSize>
#include <QSurfaceFormat>
#include <osg/Group>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>

namespace stromar {

/// Draws a scene into frame buffer objects of an OpenGL context that somebody else owns. The thread of that context.
class CSceneRenderer {
public:
    explicit CSceneRenderer(osg::Group* scene);

    /// With the context current: before the first picture, and after the context was replaced.
    void attach();
    /// With the context current: frees what lies on the graphics card.
    void detach();
    bool attached() const { return m_window.valid(); }
    void draw(unsigned frameBuffer, const QSize& pixels, const CCamera& camera);

    /// OpenGL with its fixed functions, which OpenSceneGraph uses.
    static QSurfaceFormat surfaceFormat(int samples);
    /// Whether this display has the OpenGL that is needed; else `why` tells the user what is missing.
    static bool available(QString& why);
    /// Whether pictures are computed by the processor (llvmpipe …): then multisampling is far too slow.
    static bool drawsInSoftware();
    /// 0, or more where a graphics card draws.
    static int bestSamples();

private:
    osg::ref_ptr<osgViewer::Viewer> m_viewer;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> m_window;
};

} // namespace stromar
