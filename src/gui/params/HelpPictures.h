#pragma once
#include "stromar/params/ParamTable.h"
#include <QImage>
#include <QPalette>
#include <QString>

namespace stromar {

/// Small trees side by side that show what a value does, each with its value below; null for what has no effect. Grown
/// and meshed like every tree, then drawn without OpenGL. Takes some milliseconds.
QImage helpPicture(const ParamRef& ref, const QPalette& palette, qreal ratio);
/// The same as an <img> of a tool tip; kept, so that it is drawn once.
QString helpPictureHtml(const ParamRef& ref, const QPalette& palette, qreal ratio);

} // namespace stromar
