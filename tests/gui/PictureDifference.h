#pragma once
#include "util/PictureDifference.h"
#include <QImage>

namespace stromar {

/// Of two pictures of the same size.
inline test::TileDifference worstTile(const QImage& a, const QImage& b,
                                      std::span<const test::PictureArea> unseen = {}) {
    const auto bytes = [](const QImage& image) {
        return test::PictureBytes{image.width(), image.height(), {image.constBits(), std::size_t(image.sizeInBytes())}};
    };
    const QImage first = a.convertToFormat(QImage::Format_RGBA8888), second = b.convertToFormat(first.format());
    return test::worstTile(bytes(first), bytes(second), unseen);
}

} // namespace stromar
