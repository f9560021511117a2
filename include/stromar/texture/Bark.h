#pragma once
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Progress.h"
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace stromar {

/// sRGB, 0..255 each.
using Colour = std::array<int, 3>;

/// What a bark looks like. A plain value; what each means stands in the table.
struct BarkParams {
    int kind = 0, seed = 1, ridges = 8, rings = 0, spots = 0;
    double stretch = 4, crack = 0.35, depth = 1, grain = 0.5, warp = 0.5;
    Colour light{150, 138, 122}, dark{62, 52, 44};

    bool operator==(const BarkParams&) const = default;
};

/// One row of the table of bark parameters.
struct BarkParam {
    std::string_view key, label, help; ///< the last two marked for translation
    std::variant<int BarkParams::*, double BarkParams::*, Colour BarkParams::*> field;
    double min = 0, max = 0;
    std::span<const std::string_view> words{};
};
std::span<const BarkParam> barkTable();

/// furrowed, plated, smooth … each with values that suit it.
std::span<const std::string_view> barkKinds();
BarkParams barkOf(int kind);

/// "furrowed seed=3 ridges=9 light=#a09080": a kind, then what differs from it. Throws CError, which says what is
/// wrong.
BarkParams barkFromText(std::string_view text);
std::string barkText(const BarkParams& bark);

/// Draws a square picture that can be laid side by side in both directions. The same values give the same bytes for any
/// number of threads; another size shows the same bark. Cost: about two microseconds per pixel and thread.
TextureMaps makeBark(const BarkParams& bark, int size, const CProgress& progress);

} // namespace stromar
