#include "util/PictureDifference.h"
#include <gtest/gtest.h>
#include <vector>

namespace stromar::test {
namespace {

class PictureDifference : public ::testing::Test {
protected:
    static constexpr int kWidth = 100, kHeight = 60; // the last tiles are narrower

    std::uint8_t& channel(int x, int y, int c) { return other[std::size_t(4 * (y * kWidth + x) + c)]; }
    TileDifference worst(std::span<const PictureArea> unseen = {}) const {
        return worstTile({kWidth, kHeight, plain}, {kWidth, kHeight, other}, unseen);
    }

    const std::vector<std::uint8_t> plain = std::vector<std::uint8_t>(4 * kWidth * kHeight, 100);
    std::vector<std::uint8_t> other = plain;
};

TEST_F(PictureDifference, OfEqualPicturesIsNothing) { EXPECT_EQ(worst().mean, 0); }

TEST_F(PictureDifference, IsThatOfTheWorstTileHoweverLargeThePicture) {
    for (int y = 16; y < 24; ++y)
        for (int x = 40; x < 48; ++x)
            for (int c = 0; c < 3; ++c) channel(x, y, c) = 60;
    channel(0, 0, 0) = 255;
    EXPECT_EQ(worst().mean, 30) << "three of four channels";
    EXPECT_EQ(worst().x, 40);
    EXPECT_EQ(worst().y, 16);
}

TEST_F(PictureDifference, SeesTheLastPixel) {
    channel(kWidth - 1, kHeight - 1, 3) = 164;
    EXPECT_EQ(worst().mean, 1) << "one of 4 x 4 x 4";
    EXPECT_EQ(worst().x, 96);
    EXPECT_EQ(worst().y, 56);
}

TEST_F(PictureDifference, LeavesOutWhatIsNotToBeSeen) {
    for (int x = 10; x < 30; ++x) channel(x, 10, 0) = 200;
    const PictureArea row{10, 10, 20, 1}, shorter{10, 10, 19, 1};
    EXPECT_EQ(worst({&row, 1}).mean, 0);
    EXPECT_GT(worst({&shorter, 1}).mean, 0);
}

} // namespace
} // namespace stromar::test
