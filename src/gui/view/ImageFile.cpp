#include "view/ImageFile.h"
#include <QFileInfo>
#include <QPainter>
#include <QSaveFile>

namespace stromar {

namespace {
QImage onWhite(const QImage& image) {
    QImage opaque(image.size(), QImage::Format_RGB32);
    opaque.fill(Qt::white);
    QPainter(&opaque).drawImage(0, 0, image);
    return opaque;
}
} // namespace

bool writeImage(const QImage& image, const QString& path) {
    QSaveFile file(path);
    const QByteArray format = QFileInfo(path).suffix().toLower().toLatin1();
    const bool opaque = format.startsWith("jp"); // has no alpha: what is transparent becomes white
    const QImage written = opaque && image.hasAlphaChannel() ? onWhite(image) : image;
    return file.open(QIODevice::WriteOnly) && written.save(&file, format.constData()) && file.commit();
}

} // namespace stromar
