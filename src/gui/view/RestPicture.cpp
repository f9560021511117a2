#include "view/RestPicture.h"

namespace stromar {

namespace {
constexpr std::chrono::milliseconds kRest{350}; // without a change

std::span<const std::uint8_t> bytesOf(const QImage& image) {
    return {image.constBits(), static_cast<std::size_t>(image.sizeInBytes())};
}
void writeMean(const CPictureMean& mean, QImage& image) {
    mean.write({image.bits(), static_cast<std::size_t>(image.sizeInBytes())});
}
} // namespace

CRestPicture::CRestPicture(std::function<QImage(const ViewPass&)> draw, QObject* parent)
    : QObject(parent), m_draw(std::move(draw)), m_timer(this) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &CRestPicture::addPass);
}

void CRestPicture::restart() {
    m_image = {};
    m_mean.clear();
    m_timer.start(kRest);
}

void CRestPicture::addPass() {
    QImage pass = m_draw(ViewPass::of(m_mean.count(), kPasses));
    if (pass.isNull()) return;
    m_mean.add(bytesOf(pass));
    if (m_mean.count() > 1) {
        m_image = std::move(pass);
        writeMean(m_mean, m_image);
        emit refined();
    }
    if (m_mean.count() < kPasses) m_timer.start(0);
}

QImage smoothPicture(int passes, const std::function<QImage(const ViewPass&)>& draw) {
    CPictureMean mean;
    QImage image;
    for (int i = 0; i < passes; ++i) {
        image = draw(ViewPass::of(i, passes));
        if (image.isNull()) return {};
        mean.add(bytesOf(image));
    }
    writeMean(mean, image);
    return image;
}

} // namespace stromar
