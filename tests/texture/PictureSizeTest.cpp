#include "stromar/texture/PictureSize.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

std::string big(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> 8 * i & 0xFF);
    return text;
}

std::string pngHead(std::uint32_t width, std::uint32_t height, int bits) {
    return "\x89PNG\r\n\x1A\n" + big(13, 4) + "IHDR" + big(width, 4) + big(height, 4) + big(static_cast<std::uint32_t>(bits), 1);
}

/// With a segment of 300 bytes before the frame, as cameras write.
std::string jpegHead(std::uint32_t width, std::uint32_t height) {
    return "\xFF\xD8\xFF\xE1" + big(300, 2) + std::string(298, '\xC0') + "\xFF\xC2" + big(17, 2) + big(8, 1) + big(height, 2) + big(width, 2);
}

std::string hdrHead(const std::string& size) { return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n"; }

struct Head {
    const char* name;
    std::string bytes;
    const char* refusal; ///< "": it is let through
};

class PictureSizeTest : public ::testing::TestWithParam<Head> {};

INSTANTIATE_TEST_SUITE_P(
    Heads, PictureSizeTest,
    ::testing::Values(Head{"a.png", pngHead(8192, 8192, 8), ""}, Head{"b.png", pngHead(60000, 60000, 8), "60000 x 60000 pixels is too large; it would take 14400 MB"},
                      Head{"deep.png", pngHead(10000, 10000, 16), "it would take 800 MB"}, Head{"flat.png", pngHead(10000, 10000, 8), ""},
                      Head{"a.jpg", jpegHead(6000, 4000), ""}, Head{"b.jpg", jpegHead(65535, 65535), "65535 x 65535"},
                      Head{"a.hdr", hdrHead("-Y 2048 +X 4096"), ""}, Head{"b.hdr", hdrHead("-Y 100000 +X 200000"), "200000 x 100000"},
                      Head{"c.hdr", hdrHead("-Y 1e300 +X 1e300"), "too large"}, Head{"cut.png", pngHead(60000, 60000, 8).substr(0, 14), ""},
                      Head{"cut.jpg", jpegHead(65535, 65535).substr(0, 9), ""}, Head{"text.png", "no picture", ""}, Head{"none.png", "", ""}),
    [](const ::testing::TestParamInfo<Head>& head) { return std::to_string(head.index); });

TEST_P(PictureSizeTest, IsToldByTheHeadOfTheFile) {
    const CTemporaryFolder folder;
    const auto file = folder.path() / GetParam().name;
    writeFile(file, GetParam().bytes);
    std::string refusal;
    try {
        refuseHugePicture(file);
    } catch (const CError& e) {
        refusal = e.what();
    }
    if (*GetParam().refusal == 0) EXPECT_EQ(refusal, "");
    else EXPECT_NE(refusal.find(GetParam().refusal), std::string::npos) << refusal;
    EXPECT_TRUE(refusal.empty() || refusal.starts_with(file.string()));
}

} // namespace
} // namespace stromar::test
