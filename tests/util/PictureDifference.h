#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ostream>
#include <span>

namespace stromar::test {

/// Rows of pixels: red, green, blue and opacity, a byte each.
struct PictureBytes {
    int width = 0, height = 0;
    std::span<const std::uint8_t> rgba;
};

struct PictureArea {
    int x = 0, y = 0, width = 0, height = 0;
    bool contains(int px, int py) const { return px >= x && px < x + width && py >= y && py < y + height; }
};

struct TileDifference {
    double mean = 0;  ///< of the channels, 0..255
    int x = 0, y = 0; ///< the tile's upper left corner
    friend std::ostream& operator<<(std::ostream& out, const TileDifference& tile) {
        return out << "differs by " << tile.mean << " in the tile at " << tile.x << ", " << tile.y;
    }
};

/// A few pixels: what is wrong in one place fills a tile, and no mean over the whole picture hides it.
inline constexpr int kTileSide = 8;

/// One version of the software OpenGL draws the same bytes on all x86 processors: this is room for the rounding of
/// another version. The smallest fault to be caught, a spruce's trunk 1.5 times too thick, changes a tile by 10.
inline constexpr double kMaxTileDifference = 5;

/// The tile in which two pictures of the same size differ most; what lies in `unseen` does not count.
inline TileDifference worstTile(const PictureBytes& a, const PictureBytes& b,
                                std::span<const PictureArea> unseen = {}) {
    TileDifference worst;
    for (int top = 0; top < a.height; top += kTileSide)
        for (int left = 0; left < a.width; left += kTileSide) {
            int sum = 0, seen = 0;
            for (int y = top; y < std::min(top + kTileSide, a.height); ++y)
                for (int x = left; x < std::min(left + kTileSide, a.width); ++x) {
                    if (std::ranges::any_of(unseen, [&](const PictureArea& area) { return area.contains(x, y); }))
                        continue;
                    ++seen;
                    const std::size_t pixel = 4 * (std::size_t(y) * std::size_t(a.width) + std::size_t(x));
                    for (std::size_t c = pixel; c < pixel + 4; ++c) sum += std::abs(int(a.rgba[c]) - int(b.rgba[c]));
                }
            if (seen > 0 && sum / (4.0 * seen) > worst.mean) worst = {sum / (4.0 * seen), left, top};
        }
    return worst;
}

} // namespace stromar::test
