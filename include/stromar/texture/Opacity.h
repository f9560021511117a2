#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace stromar {

using Pixels = std::vector<std::array<std::uint8_t, 4>>; ///< colour and opacity, row by row

/// More opaque is drawn, less is not: in the viewport and in the files that say so.
constexpr double kAlphaCut = 0.4;

/// Gives transparent pixels the colours of the opaque ones around them, so that smaller pictures and filters do not mix
/// in what lies outside. Opacity stays. Linear in the pixels.
void spreadColours(Pixels& pixels, int width, int height);

/// A picture that is seen large has hard edges; one of a few pixels covers a part of each. In between it becomes softer by steps of the same
/// ratio: where a pixel shows this part of the picture's side, from `from` to `to`.
struct Softening {
    double from, to;
    /// 0 hard … 1 soft.
    double at(double footprint) const;
};
/// Of a picture of one leaf, or of many, which are small in it.
constexpr Softening softeningOf(bool manyLeaves) { return manyLeaves ? Softening{1.0 / 64, 1.0 / 8} : Softening{0.12, 0.37}; }
/// How much of a pixel an opacity covers, 0..1: hard by the cut, soft as much as it says.
double coverOf(double opacity, double cut, double soft);

/// Changes opacities between nothing and opaque so that, cut, they cover a part of the picture: hairs thinner than a pixel are drawn too wide
/// or not at all. Linear in the pixels.
void setCoverage(Pixels& pixels, int width, int height, double wanted, double cut = kAlphaCut);

/// The picture and its halves down to one pixel. Each covers as much as the first, as it is drawn: leaves do not fade away in the distance.
/// Without softening they are for engines, which draw what is above the cut.
std::vector<Pixels> mipmapsKeepingCoverage(const Pixels& pixels, int width, int height, const std::optional<Softening>& softening = {}, double cut = kAlphaCut);

} // namespace stromar
