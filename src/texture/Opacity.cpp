#include "stromar/texture/Opacity.h"
#include "stromar/texture/Srgb.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
/// A picture whose colours are weighted sums.
struct Weighted {
    int width, height;
    std::vector<std::array<float, 4>> sums; ///< red, green, blue, weight

    std::array<float, 4>& at(int x, int y) {
        return sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

void scale(std::array<float, 4>& sum, float by) {
    for (float& c : sum) c *= by;
}

Weighted halved(Weighted& large) {
    Weighted small{std::max(1, (large.width + 1) / 2), std::max(1, (large.height + 1) / 2), {}};
    small.sums.resize(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            for (std::size_t c = 0; c < 4; ++c) small.at(x / 2, y / 2)[c] += large.at(x, y)[c];
    for (auto& sum : small.sums) scale(sum, 0.25f);
    return small;
}

/// What has too little weight takes the rest from the smaller picture.
void fillFrom(Weighted& large, Weighted& small) {
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x) {
            auto& own = large.at(x, y);
            const float missing = 1 - std::min(1.0f, own[3]);
            if (missing <= 0) continue;
            const auto& other = small.at(x / 2, y / 2);
            for (std::size_t c = 0; c < 4; ++c) own[c] += missing * other[c];
        }
}

/// Of what a picture shows, what lies near, and further away the mean of more and more of it.
Weighted spread(Weighted picture) {
    std::vector<Weighted> levels{std::move(picture)};
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
    auto& all = levels.back().sums.front();
    if (all[3] > 0) scale(all, 1 / all[3]);
    for (std::size_t i = levels.size() - 1; i-- > 0;) fillFrom(levels[i], levels[i + 1]);
    return std::move(levels.front());
}

std::uint8_t rounded(double v) { return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0, 255.0))); }

/// What stands for each opacity of a picture, 0..1.
using OpacityMap = std::array<double, 256>;

OpacityMap scaled(double scale) {
    OpacityMap map;
    for (std::size_t i = 0; i < map.size(); ++i) map[i] = std::min(1.0, scale * double(i) / 255);
    return map;
}

/// As graphics cards draw a picture: between pixels opacity is interpolated, so that of one alone among gaps hardly anything is left. Of a
/// large picture a part of the pixels is looked at, evenly spread.
double coverage(const Pixels& pixels, int width, int height, const OpacityMap& map, double cut, double soft) {
    constexpr int kBetween = 3;     // samples of a pixel, each way
    constexpr int kMostLines = 1024; // looked at
    const auto at = [&](int x, int y) {
        return map[pixels[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) + static_cast<std::size_t>(std::clamp(x, 0, width - 1))][3]];
    };
    const int stepX = (width + kMostLines - 1) / kMostLines, stepY = (height + kMostLines - 1) / kMostLines;
    double sum = 0, seen = 0;
    for (int y = stepY / 2; y < height; y += stepY)
        for (int x = stepX / 2; x < width; x += stepX) {
            double near[3][3];
            bool none = true;
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) {
                    near[j][i] = at(x + i - 1, y + j - 1);
                    none = none && near[j][i] == 0;
                }
            seen += kBetween * kBetween;
            if (none) continue;
            for (int j = 0; j < kBetween; ++j)
                for (int i = 0; i < kBetween; ++i) {
                    const double u = (i + 0.5) / kBetween - 0.5, v = (j + 0.5) / kBetween - 0.5; // from the pixel's middle
                    const int side = u < 0 ? 0 : 2, row = v < 0 ? 0 : 2;
                    const double across = std::abs(u), down = std::abs(v);
                    const double opacity = (1 - down) * ((1 - across) * near[1][1] + across * near[1][side]) + down * ((1 - across) * near[row][1] + across * near[row][side]);
                    sum += coverOf(opacity, cut, soft);
                }
        }
    return sum / seen;
}

/// By what opacities have to be multiplied for the wanted coverage. The blades' own edges make it monotonous.
double scaleFor(const Pixels& pixels, int width, int height, double cut, double soft, double wanted) {
    const auto coverageAt = [&](double scale) { return coverage(pixels, width, height, scaled(scale), cut, soft); };
    if (coverageAt(1) == wanted) return 1;
    double low = 0.25, high = 8;
    for (int i = 0; i < 14; ++i) {
        const double middle = std::sqrt(low * high);
        (coverageAt(middle) < wanted ? low : high) = middle;
    }
    // The nearer of both sides: a few pixels can only be covered in steps.
    const auto error = [&](double scale) { return std::abs(coverageAt(scale) - wanted); };
    return error(low) < error(high) ? low : high;
}

/// The mean of the light; colours weigh as much as they cover.
Pixels halved(const Pixels& large, int width, int height) {
    const int w = std::max(1, width / 2), h = std::max(1, height / 2);
    Pixels small;
    small.reserve(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    const auto at = [&](int x, int y) -> const std::array<std::uint8_t, 4>& {
        return large[static_cast<std::size_t>(std::min(y, height - 1)) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(std::min(x, width - 1))];
    };
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const std::array four{at(2 * x, 2 * y), at(2 * x + 1, 2 * y), at(2 * x, 2 * y + 1), at(2 * x + 1, 2 * y + 1)};
            const int opacity = four[0][3] + four[1][3] + four[2][3] + four[3][3], least = opacity == 0 ? 1 : 0;
            std::array<float, 3> sums{};
            for (const auto& p : four)
                for (std::size_t c = 0; c < 3; ++c) sums[c] += float(p[3] + least) * linearOfByte(p[c]);
            const auto mean = [&](std::size_t c) { return byteOf(encodedOf(sums[c] / float(opacity + 4 * least))); };
            small.push_back({mean(0), mean(1), mean(2), static_cast<std::uint8_t>((opacity + 2) / 4)});
        }
    return small;
}

/// valueOf(pixel) → three channels, weightOf(pixel) → how much they count, 0..255; where the albedo is not opaque, take(pixel, channels).
template <typename ValueOf, typename WeightOf, typename Take>
void spreadMap(const Pixels& albedo, int width, int height, ValueOf&& valueOf, WeightOf&& weightOf, Take&& take) {
    Weighted picture{width, height, {}};
    for (std::size_t i = 0; i < albedo.size(); ++i) {
        const float weight = static_cast<float>(albedo[i][3] * weightOf(i)) / (255 * 255);
        const std::array<std::uint8_t, 3> own = valueOf(i);
        picture.sums.push_back({weight * own[0], weight * own[1], weight * own[2], weight});
    }
    const Weighted all = spread(std::move(picture));
    for (std::size_t i = 0; i < albedo.size(); ++i) {
        const auto& sum = all.sums[i];
        if (albedo[i][3] == 255 || sum[3] <= 0) continue;
        take(i, std::array{rounded(sum[0] / sum[3]), rounded(sum[1] / sum[3]), rounded(sum[2] / sum[3])});
    }
}
int allAlike(std::size_t) { return 255; }
} // namespace

void spreadColours(Pixels& pixels, int width, int height) {
    spreadMap(
        pixels, width, height, [&](std::size_t i) { return std::array{pixels[i][0], pixels[i][1], pixels[i][2]}; }, allAlike,
        [&](std::size_t i, const std::array<std::uint8_t, 3>& colour) { std::ranges::copy(colour, pixels[i].begin()); });
}

void spreadMaps(TextureMaps& maps) {
    const Pixels albedo = maps.albedo;
    for (Pixels* side : {&maps.albedo, &maps.back})
        if (!side->empty()) spreadColours(*side, maps.width, maps.height);
    spreadMap(
        albedo, maps.width, maps.height, [&](std::size_t i) { return maps.normal[i]; }, allAlike, [&](std::size_t i, const auto& normal) { maps.normal[i] = normal; });
    const auto spreadOne = [&](std::vector<std::uint8_t>& map, const auto& weightOf) {
        spreadMap(
            albedo, maps.width, maps.height, [&](std::size_t i) { return std::array<std::uint8_t, 3>{map[i]}; }, weightOf,
            [&](std::size_t i, const auto& value) { map[i] = value[0]; });
    };
    spreadOne(maps.roughness, allAlike);
    // Wood lets nothing through: what lies beside it is a gap between leaves.
    if (!maps.translucency.empty()) spreadOne(maps.translucency, [&](std::size_t i) { return int{maps.translucency[i]}; });
}

void setCoverage(Pixels& pixels, int width, int height, double wanted, double cut) {
    const auto mapFor = [&](double edge) { // which becomes the opacity of the cut; what is opaque, or is not there, stays so
        OpacityMap map = scaled(1);
        for (double& opacity : map) opacity = opacity < edge ? opacity / edge * cut : cut + (opacity - edge) / (1 - edge) * (1 - cut);
        return map;
    };
    double low = 0.02, high = 0.98;
    for (int i = 0; i < 10; ++i) {
        const double edge = (low + high) / 2;
        (coverage(pixels, width, height, mapFor(edge), cut, 0) > wanted ? low : high) = edge;
    }
    const OpacityMap map = mapFor((low + high) / 2);
    for (auto& p : pixels) p[3] = rounded(255 * map[p[3]]);
}

std::vector<Pixels> mipmapsKeepingCoverage(const Pixels& pixels, int width, int height, const std::optional<Softening>& softening, double cut) {
    const double wanted = coverage(pixels, width, height, scaled(1), cut, 0);
    std::vector<Pixels> levels{pixels};
    Pixels plain = pixels; // unscaled: errors do not add up
    while (width > 1 || height > 1) {
        plain = halved(plain, width, height);
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        const double soft = softening ? softening->at(1.0 / std::min(width, height)) : 0;
        const double scale = scaleFor(plain, width, height, cut, soft, wanted);
        levels.push_back(plain);
        for (auto& p : levels.back()) p[3] = rounded(p[3] * scale);
    }
    return levels;
}

} // namespace stromar
