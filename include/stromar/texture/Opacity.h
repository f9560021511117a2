#pragma once
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Softening.h"
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
/// Likewise in all maps but the heights, where the albedo is transparent.
void spreadMaps(TextureMaps& maps);

/// Changes opacities between nothing and opaque so that, cut, they cover a part of the picture: hairs thinner than a pixel are drawn too wide
/// or not at all. Linear in the pixels.
void setCoverage(Pixels& pixels, int width, int height, double wanted, double cut = kAlphaCut);

/// The picture and its halves down to one pixel. Each covers as much as the first, as it is drawn: leaves do not fade away in the distance.
/// Without softening they are for engines, which draw what is above the cut.
std::vector<Pixels> mipmapsKeepingCoverage(const Pixels& pixels, int width, int height, const std::optional<Softening>& softening = {}, double cut = kAlphaCut);

} // namespace stromar
