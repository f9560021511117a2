#pragma once
#include <QString>
#include <QSurfaceFormat>

namespace stromar {

/// What this display can draw.
namespace display {

/// OpenGL with its fixed functions, which OpenSceneGraph uses.
QSurfaceFormat surfaceFormat(int samples);
/// Whether this display has the OpenGL that is needed; else `why` tells the user what is missing.
bool available(QString& why);
/// For multisampling and the best looks: 0 before OpenGL 3.3 and where pictures are computed by the processor (llvmpipe
/// …), which is far too slow for more.
int bestSamples();

} // namespace display
} // namespace stromar
