#pragma once
#include "stromar/scene/SceneRenderer.h"
#include "stromar/texture/Opacity.h"
#include <memory>
#include <span>

namespace stromar {

/// Draws pictures without a window: through EGL where there is one, else through an X server (perhaps Xvfb). One
/// thread.
class CHeadlessPainter {
public:
    /// `samples`: for smooth edges and soft shadows; 1 for none. What the card cannot do at once is drawn in several
    /// passes. Throws CError, which says what is needed.
    CHeadlessPainter(CViewScene& scene, int samples);
    ~CHeadlessPainter();

    /// Rows from the top; straight alpha. Throws CError when the graphics card has no room.
    Pixels paint(const CCamera& camera, int width, int height);
    /// Draws what each camera sees, in one pass as a window does, and forgets it; returns when the card has done all. Throws likewise.
    void drawAll(std::span<const CCamera> cameras, int width, int height);

private:
    void paintPass(const CCamera& camera, const ViewPass& pass, int width, int height, Pixels& pixels);
    class CContext;
    class CEglContext;
    class CXContext;

    std::unique_ptr<CContext> m_context;
    CSceneRenderer m_renderer;
    int m_samples; ///< of a pass
    int m_passes = 1;
};

} // namespace stromar
