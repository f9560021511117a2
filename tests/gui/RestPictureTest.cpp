#include "view/Viewport.h"
#include "WatchedApplication.h"
#include "WindowFixture.h"

namespace stromar {
namespace {

class RestPicture : public WindowFixture {
protected:
    void SetUp() override {
        test::CWatchedApplication::refine(true);
        WindowFixture::SetUp();
    }
    void TearDown() override { test::CWatchedApplication::refine(false); }
};

TEST_F(RestPicture, AViewThatRestsBecomesSmoothAndIsPlainAgainWhenItMoves) {
    const auto seen = [&] { return window.viewport().grab().toImage().convertToFormat(QImage::Format_RGB32); };
    // How far pixels are from the mean of their neighbours left and right: steps, and thin wood in dots.
    const auto roughness = [](const QImage& image) {
        double sum = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 1; x + 1 < image.width(); ++x)
                sum += std::abs(qGreen(image.pixel(x, y)) -
                                (qGreen(image.pixel(x - 1, y)) + qGreen(image.pixel(x + 1, y))) / 2.0);
        return sum;
    };
    ASSERT_TRUE(waitFor([&] { return !window.busy() && !window.viewport().refining(); }));
    const double smooth = roughness(seen());
    const int frames = window.viewport().framesDrawn();
    QTest::qWait(600);
    EXPECT_EQ(window.viewport().framesDrawn(), frames);
    EXPECT_FALSE(window.viewport().refining()) << "it rests";
    const double plain = roughness(window.viewport().grabFramebuffer().convertToFormat(QImage::Format_RGB32));
    EXPECT_LT(smooth, 0.8 * plain);
    window.viewport().lookFrom(20, 10);
    QTest::qWait(50);
    EXPECT_TRUE(window.viewport().refining());
    EXPECT_GT(roughness(seen()), 0.8 * plain) << "nothing old is shown";
}

} // namespace
} // namespace stromar
