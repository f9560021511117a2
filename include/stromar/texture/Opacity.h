#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace stromar {

using Pixels = std::vector<std::array<std::uint8_t, 4>>; ///< colour and opacity, row by row

/// More opaque is drawn, less is not: in the viewport and in the files that say so.
constexpr double kAlphaCut = 0.4;

/// Gives transparent pixels the colours of the opaque ones around them, so that smaller pictures and filters do not mix
/// in what lies outside. Opacity stays. Linear in the pixels.
void spreadColours(Pixels& pixels, int width, int height);

/// The picture and its halves down to one pixel. In each the same part of the pixels is more opaque than `cut` as in
/// the first: leaves do not fade away in the distance.
std::vector<Pixels> mipmapsKeepingCoverage(const Pixels& pixels, int width, int height, double cut = kAlphaCut);

} // namespace stromar
