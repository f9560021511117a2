#pragma once
#include "stromar/scene/Camera.h"
#include "stromar/scene/ViewScene.h"
#include <osg/GLExtensions>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>

namespace stromar {

/// Draws a scene into frame buffer objects of an OpenGL context that somebody else owns and has made current. The
/// thread of that context.
class CSceneRenderer {
public:
    explicit CSceneRenderer(CViewScene& scene);

    /// Before the first picture, and after the context was replaced. `samples`: of the frame buffers; of so many pictures the mean will be shown.
    void attach(int samples, int passes = 1);
    /// Frees what lies on the graphics card.
    void detach();
    bool attached() const { return m_window.valid(); }
    const osg::GLExtensions& extensions() const;
    /// Frees what the graphics card holds of parts that the scene no longer has.
    void freeDeleted();
    void draw(unsigned frameBuffer, int width, int height, const CCamera& camera, const ViewPass& pass = {});

private:
    CViewScene& m_scene;
    osg::ref_ptr<osgViewer::Viewer> m_viewer;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> m_window;
};

} // namespace stromar
