#pragma once
#include "util/PictureDifference.h"
#include <array>
#include <cstdint>
#include <filesystem>
#include <png.h>
#include <vector>

namespace stromar::test {

struct Picture {
    unsigned width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    PictureBytes bytes() const { return {static_cast<int>(width), static_cast<int>(height), rgba}; }
    std::array<int, 4> mean(unsigned x0, unsigned y0, unsigned x1, unsigned y1) const {
        std::array<int, 4> sum{};
        for (unsigned y = y0; y < y1; ++y)
            for (unsigned x = x0; x < x1; ++x)
                for (unsigned c = 0; c < 4; ++c) sum[c] += rgba[4 * (y * width + x) + c];
        for (int& c : sum) c /= static_cast<int>((x1 - x0) * (y1 - y0));
        return sum;
    }
    std::size_t red(unsigned y0, unsigned y1) const { ///< pixels
        std::size_t count = 0;
        for (std::size_t i = 4 * std::size_t{y0} * width; i < 4 * std::size_t{y1} * width; i += 4)
            count += rgba[i] > rgba[i + 1] + 60 && rgba[i] > rgba[i + 2] + 60;
        return count;
    }
};

inline Picture readPng(const std::filesystem::path& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, path.c_str())) return {};
    image.format = PNG_FORMAT_RGBA;
    Picture picture{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
    png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr);
    return picture;
}

} // namespace stromar::test
