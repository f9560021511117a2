#include "stromar/texture/Bark.h"
#include "stromar/util/Error.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace stromar {

namespace {
using std::string_view;
using B = BarkParams;

constexpr string_view kKinds[] = {N_("furrowed"), N_("plated"), N_("smooth"), N_("birch"),
                                  N_("willow"),   N_("cherry"), N_("palm")};

/// Values that suit each kind.
const BarkParams kBarks[] = {
    {.kind = 0,
     .ridges = 11,
     .stretch = 3.2,
     .crack = 0.45,
     .depth = 1,
     .grain = 0.6,
     .warp = 0.7,
     .light = {154, 140, 122},
     .dark = {50, 42, 36}},
    {.kind = 1,
     .ridges = 6,
     .stretch = 2.2,
     .crack = 0.28,
     .depth = 0.9,
     .grain = 0.7,
     .warp = 0.5,
     .light = {176, 118, 80},
     .dark = {66, 44, 34}},
    {.kind = 2,
     .ridges = 6,
     .spots = 60,
     .stretch = 0.4,
     .crack = 0.1,
     .depth = 0.3,
     .grain = 0.35,
     .warp = 0.5,
     .light = {172, 174, 158},
     .dark = {84, 86, 76}},
    {.kind = 3,
     .ridges = 5,
     .rings = 14,
     .spots = 90,
     .stretch = 0.3,
     .crack = 0.3,
     .depth = 0.4,
     .grain = 0.3,
     .warp = 0.4,
     .light = {232, 228, 218},
     .dark = {58, 48, 42}},
    {.kind = 4,
     .ridges = 8,
     .stretch = 4,
     .crack = 0.42,
     .depth = 0.9,
     .grain = 0.6,
     .warp = 1,
     .light = {142, 132, 112},
     .dark = {58, 50, 40}},
    {.kind = 5,
     .ridges = 4,
     .rings = 12,
     .spots = 70,
     .stretch = 0.3,
     .crack = 0.25,
     .depth = 0.45,
     .grain = 0.3,
     .warp = 0.3,
     .light = {138, 84, 66},
     .dark = {62, 36, 32}},
    {.kind = 6,
     .ridges = 20,
     .rings = 8,
     .stretch = 3,
     .crack = 0.4,
     .depth = 0.8,
     .grain = 0.8,
     .warp = 0.4,
     .light = {158, 142, 118},
     .dark = {76, 64, 50}},
};

constexpr BarkParam kTable[] = {
    {"seed", N_("Seed"), N_("Another bark of the same kind."), &B::seed, 0, 2147483647},
    {"ridges", N_("Ridges"), N_("How many ridges or plates stand side by side in the picture."), &B::ridges, 1, 64},
    {"stretch", N_("Length of ridges"), N_("How many times longer than wide they are."), &B::stretch, 0.1, 20},
    {"crack", N_("Cracks"), N_("How wide the furrows between them are, as a part of a ridge."), &B::crack, 0, 1},
    {"depth", N_("Depth"), N_("How deep the relief is."), &B::depth, 0, 3},
    {"grain", N_("Grain"), N_("How rough the surface is in detail."), &B::grain, 0, 1},
    {"warp", N_("Wandering"), N_("How crooked ridges and rings run."), &B::warp, 0, 3},
    {"rings", N_("Rings"), N_("How many bands run around the stem in the picture."), &B::rings, 0, 64},
    {"spots", N_("Spots"), N_("How many pores or eyes there are."), &B::spots, 0, 400},
    {"light", N_("Light colour"), N_("The colour of what stands out."), &B::light, 0, 255},
    {"dark", N_("Dark colour"), N_("The colour of what lies deep."), &B::dark, 0, 255},
};

std::string colourText(const Colour& c) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c[0], c[1], c[2]);
    return text;
}

std::string valueText(const BarkParams& bark, const BarkParam& row) {
    return std::visit(
        [&](auto member) -> std::string {
            if constexpr (std::is_same_v<decltype(member), Colour B::*>)
                return colourText(bark.*member);
            else
                return numberText(static_cast<double>(bark.*member));
        },
        row.field);
}

Colour colourFrom(const std::string& text) {
    unsigned value = 0;
    char rest = 0;
    if (text.size() != 7 || std::sscanf(text.c_str(), "#%6x%c", &value, &rest) != 1)
        throw CError("'" + text + "' is no colour; write it as #rrggbb");
    return {static_cast<int>(value >> 16), static_cast<int>(value >> 8 & 255), static_cast<int>(value & 255)};
}

void setValue(BarkParams& bark, const BarkParam& row, const std::string& text) {
    if (const auto* colour = std::get_if<Colour B::*>(&row.field)) {
        bark.*(*colour) = colourFrom(text);
        return;
    }
    const auto number = parseNumber(text);
    if (!number || *number < row.min || *number > row.max)
        throw CError("'" + std::string(row.key) + "' wants a number from " + numberText(row.min) + " to " +
                     numberText(row.max) + ", not '" + text + "'");
    if (const auto* whole = std::get_if<int B::*>(&row.field)) {
        if (*number != std::floor(*number)) throw CError("'" + std::string(row.key) + "' wants a whole number");
        bark.*(*whole) = static_cast<int>(*number);
    } else
        bark.*std::get<double B::*>(row.field) = *number;
}
} // namespace

std::span<const BarkParam> barkTable() { return kTable; }
std::span<const string_view> barkKinds() { return kKinds; }
BarkParams barkOf(int kind) { return kBarks[std::clamp(kind, 0, static_cast<int>(std::size(kBarks)) - 1)]; }

BarkParams barkFromText(string_view text) {
    std::istringstream words{std::string(text)};
    std::string word;
    words >> word;
    const auto kind = std::ranges::find(kKinds, word);
    if (kind == std::end(kKinds)) {
        const std::vector<std::string> known(std::begin(kKinds), std::end(kKinds));
        throw CError("there is no bark '" + word + "'" + suggestion(word, known));
    }
    BarkParams bark = barkOf(static_cast<int>(kind - std::begin(kKinds)));
    while (words >> word) {
        const std::size_t equals = word.find('=');
        const auto row = std::ranges::find(kTable, string_view(word).substr(0, equals), &BarkParam::key);
        if (equals == std::string::npos || row == std::end(kTable)) {
            std::vector<std::string> known;
            for (const BarkParam& p : kTable) known.emplace_back(p.key);
            throw CError("a bark has no '" + word + "'" + suggestion(word.substr(0, equals), known));
        }
        setValue(bark, *row, word.substr(equals + 1));
    }
    return bark;
}

std::string barkText(const BarkParams& bark) {
    const BarkParams usual = barkOf(bark.kind);
    std::string text(kKinds[static_cast<std::size_t>(bark.kind)]);
    for (const BarkParam& row : kTable)
        if (valueText(bark, row) != valueText(usual, row))
            text += " " + std::string(row.key) + "=" + valueText(bark, row);
    return text;
}

} // namespace stromar
