#include "stromar/scene/Headless.h"
#include "stromar/util/Error.h"
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <algorithm>
#include <cstdlib>
#include <osg/GLExtensions>
#include <osg/GraphicsContext>
#include <utility>

namespace stromar {

class CHeadlessPainter::CContext {
public:
    virtual ~CContext() = default;
    virtual void makeCurrent() = 0;
};

/// Needs neither a display nor a window.
class CHeadlessPainter::CEglContext : public CContext {
public:
    CEglContext() {
        for (EGLDisplay display : displays())
            if (open(display)) return;
        throw CError("EGL cannot be used here");
    }
    ~CEglContext() override {
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (m_surface != EGL_NO_SURFACE) eglDestroySurface(m_display, m_surface);
        eglDestroyContext(m_display, m_context);
        eglTerminate(m_display);
    }
    void makeCurrent() override { eglMakeCurrent(m_display, m_surface, m_surface, m_context); }

private:
    static std::vector<EGLDisplay> displays() {
        const auto ofPlatform =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        std::vector<EGLDisplay> all;
        if (ofPlatform) all.push_back(ofPlatform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        all.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
        return all;
    }

    bool open(EGLDisplay display) {
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return false;
        constexpr EGLint kWanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        constexpr EGLint kTiny[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        eglBindAPI(EGL_OPENGL_API);
        if (!eglChooseConfig(display, kWanted, &config, 1, &count) || count == 0) return false;
        m_context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        if (m_context == EGL_NO_CONTEXT) return false;
        m_surface = eglCreatePbufferSurface(display, config, kTiny);
        m_display = display;
        return eglMakeCurrent(m_display, m_surface, m_surface, m_context) == EGL_TRUE;
    }

    EGLDisplay m_display = EGL_NO_DISPLAY;
    EGLContext m_context = EGL_NO_CONTEXT;
    EGLSurface m_surface = EGL_NO_SURFACE;
};

/// On the X server that DISPLAY names.
class CHeadlessPainter::CXContext : public CContext {
public:
    CXContext() {
        osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
        traits->width = traits->height = 16;
        traits->pbuffer = true;
        traits->readDISPLAY();
        m_context = std::getenv("DISPLAY") ? osg::GraphicsContext::createGraphicsContext(traits) : nullptr;
        if (!m_context || !m_context->realize() || !m_context->makeCurrent())
            throw CError("a picture needs OpenGL: install libegl1 and libgl1-mesa-dri, or run under xvfb-run");
    }
    void makeCurrent() override { m_context->makeCurrent(); }

private:
    osg::ref_ptr<osg::GraphicsContext> m_context;
};

namespace {
constexpr const char* kTooLarge = "the graphics card cannot draw a picture of this size";

/// Colour and depth of one size. The context is current.
class CFrameBuffer {
public:
    CFrameBuffer(const osg::GLExtensions& gl, int width, int height, int samples) : m_gl(gl) {
        gl.glGenFramebuffers(1, &m_frame);
        gl.glGenRenderbuffers(2, m_buffers);
        gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, m_frame);
        attach(0, GL_RGBA8, GL_COLOR_ATTACHMENT0_EXT, width, height, samples);
        attach(1, GL_DEPTH24_STENCIL8_EXT, GL_DEPTH_ATTACHMENT_EXT, width, height, samples);
        m_complete = gl.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
    }
    ~CFrameBuffer() {
        m_gl.glDeleteRenderbuffers(2, m_buffers);
        m_gl.glDeleteFramebuffers(1, &m_frame);
    }
    CFrameBuffer(const CFrameBuffer&) = delete;
    CFrameBuffer& operator=(const CFrameBuffer&) = delete;

    unsigned id() const { return m_frame; }
    bool complete() const { return m_complete; }

private:
    void attach(int i, unsigned format, unsigned as, int width, int height, int samples) {
        m_gl.glBindRenderbuffer(GL_RENDERBUFFER_EXT, m_buffers[i]);
        if (samples > 1)
            m_gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER_EXT, samples, format, width, height);
        else
            m_gl.glRenderbufferStorage(GL_RENDERBUFFER_EXT, format, width, height);
        m_gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, as, GL_RENDERBUFFER_EXT, m_buffers[i]);
    }

    const osg::GLExtensions& m_gl;
    unsigned m_frame = 0, m_buffers[2] = {0, 0};
    bool m_complete = false;
};

/// That a frame buffer can have; the context is current.
int mostSamples() {
    constexpr GLenum kMaxSamples = 0x8D57;
    GLint most = 1;
    glGetIntegerv(kMaxSamples, &most);
    return most;
}

template <typename First, typename Second, typename Base>
std::unique_ptr<Base> firstThatWorks() {
    try {
        return std::make_unique<First>();
    } catch (const CError&) {
        return std::make_unique<Second>();
    }
}
} // namespace

CHeadlessPainter::CHeadlessPainter(CViewScene& scene, int samples)
    : m_context(firstThatWorks<CEglContext, CXContext, CContext>()), m_renderer(scene), m_samples(samples) {
    m_context->makeCurrent();
    m_samples = std::clamp(mostSamples(), 1, samples);
    m_passes = std::min((samples + m_samples - 1) / m_samples, CPictureMean::kMost);
    m_renderer.attach(m_samples, m_passes);
}

CHeadlessPainter::~CHeadlessPainter() {
    m_context->makeCurrent();
    m_renderer.detach();
}

namespace {
/// Blending over nothing multiplies colours by their opacity; pictures have straight alpha.
void unpremultiply(Pixels& pixels) {
    for (auto& p : pixels) {
        const int cover = p[3];
        if (cover == 0 || cover == 255) continue;
        for (std::size_t c = 0; c < 3; ++c) p[c] = static_cast<std::uint8_t>(std::min(255, (p[c] * 255 + cover / 2) / cover));
    }
}
} // namespace

Pixels CHeadlessPainter::paint(const CCamera& camera, int width, int height) {
    Pixels pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const std::span<std::uint8_t> bytes(pixels.data()->data(), 4 * pixels.size());
    CPictureMean mean;
    for (int i = 0; i < m_passes; ++i) {
        ViewPass pass = ViewPass::of(i, m_passes);
        if (m_samples > 1) pass.alone = false, pass.sunDisc = true; // samples are enough for thin wood
        paintPass(camera, pass, width, height, pixels);
        if (m_passes > 1) mean.add(bytes);
    }
    if (m_passes > 1) mean.write(bytes);
    unpremultiply(pixels);
    return pixels;
}

void CHeadlessPainter::drawAll(std::span<const CCamera> cameras, int width, int height) {
    m_context->makeCurrent();
    const CFrameBuffer drawn(m_renderer.extensions(), width, height, m_samples);
    if (!drawn.complete()) throw CError(kTooLarge);
    for (const CCamera& camera : cameras) m_renderer.draw(drawn.id(), width, height, camera);
    glFinish();
}

void CHeadlessPainter::paintPass(const CCamera& camera, const ViewPass& pass, int width, int height, Pixels& pixels) {
    m_context->makeCurrent();
    const osg::GLExtensions& gl = m_renderer.extensions();
    const CFrameBuffer drawn(gl, width, height, m_samples), flat(gl, width, height, 1);
    if (!drawn.complete() || !flat.complete()) throw CError(kTooLarge);
    m_renderer.draw(drawn.id(), width, height, camera, pass);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, drawn.id());
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, flat.id());
    gl.glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, flat.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(pixels.begin() + y * width, pixels.begin() + (y + 1) * width,
                         pixels.begin() + (height - 1 - y) * width);
}

} // namespace stromar
