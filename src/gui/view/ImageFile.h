#pragma once
#include <QImage>
#include <QString>

namespace stromar {

/// Writes a picture in the format of the path's ending. All of it or, when that fails, none: then the old file stays.
bool writeImage(const QImage& image, const QString& path);

} // namespace stromar
