#include "window/Display.h"
#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace stromar::display {

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
    surface.setFormat(surfaceFormat(0));
    surface.create();
    QOpenGLContext context;
    context.setFormat(surfaceFormat(0));
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

bool drawsInSoftware() {
    const QString& renderer = thisDisplay().renderer;
    return renderer.contains(QLatin1String("llvmpipe")) || renderer.contains(QLatin1String("softpipe")) ||
           renderer.contains(QLatin1String("SWR"));
}
} // namespace

QSurfaceFormat surfaceFormat(int samples) {
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

bool available(QString& why) {
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

int bestSamples() {
    const bool best = !drawsInSoftware() && thisDisplay().version >= std::pair(3, 3);
    return best ? kSamples : 0;
}

} // namespace stromar::display
