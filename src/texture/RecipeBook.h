#pragma once
#include "stromar/texture/Recipe.h"
#include "stromar/util/Error.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <type_traits>
#include <vector>

namespace stromar {

inline std::string colourText(const Colour& c) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c[0] & 255, c[1] & 255, c[2] & 255);
    return text;
}

inline Colour colourFrom(const std::string& text) {
    unsigned value = 0;
    char rest = 0;
    if (text.size() != 7 || std::sscanf(text.c_str(), "#%6x%c", &value, &rest) != 1)
        throw CError("'" + text + "' is no colour; write it as #rrggbb");
    return {static_cast<int>(value >> 16), static_cast<int>(value >> 8 & 255), static_cast<int>(value & 255)};
}

template <typename Params>
std::string RecipeBook<Params>::valueText(const Params& params, const RecipeParam<Params>& row) const {
    return std::visit(
        [&](auto member) -> std::string {
            if constexpr (std::is_same_v<decltype(member), Colour Params::*>)
                return colourText(params.*member);
            else
                return numberText(static_cast<double>(params.*member));
        },
        row.field);
}

template <typename Params>
void RecipeBook<Params>::setValue(Params& params, const RecipeParam<Params>& row, const std::string& value) const {
    if (const auto* colour = std::get_if<Colour Params::*>(&row.field)) {
        params.*(*colour) = colourFrom(value);
        return;
    }
    const auto number = parseNumber(value);
    if (!number || *number < row.min || *number > row.max)
        throw CError("'" + std::string(row.key) + "' wants a number from " + numberText(row.min) + " to " +
                     numberText(row.max) + ", not '" + value + "'");
    if (const auto* whole = std::get_if<int Params::*>(&row.field)) {
        if (*number != std::floor(*number)) throw CError("'" + std::string(row.key) + "' wants a whole number");
        params.*(*whole) = static_cast<int>(*number);
    } else
        params.*std::get<double Params::*>(row.field) = *number;
}

template <typename Params>
Params RecipeBook<Params>::read(std::string_view text) const {
    std::istringstream words{std::string(text)};
    std::string word;
    words >> word;
    const auto kind = std::ranges::find(kinds, word);
    if (kind == kinds.end()) {
        const std::vector<std::string> known(kinds.begin(), kinds.end());
        throw CError("there is no " + std::string(what) + " '" + word + "'" + suggestion(word, known));
    }
    Params params = of(static_cast<int>(kind - kinds.begin()));
    while (words >> word) {
        const std::size_t equals = word.find('=');
        const auto row = std::ranges::find(table, std::string_view(word).substr(0, equals), &RecipeParam<Params>::key);
        if (equals == std::string::npos || row == table.end()) {
            std::vector<std::string> known;
            for (const auto& p : table) known.emplace_back(p.key);
            throw CError("a " + std::string(what) + " has no '" + word + "'" +
                         suggestion(word.substr(0, equals), known));
        }
        setValue(params, *row, word.substr(equals + 1));
    }
    return params;
}

template <typename Params>
std::string RecipeBook<Params>::text(const Params& params) const {
    const Params& standard = of(params.kind);
    std::string all(kinds[static_cast<std::size_t>(params.kind)]);
    for (const auto& row : table)
        if (valueText(params, row) != valueText(standard, row))
            all += " " + std::string(row.key) + "=" + valueText(params, row);
    return all;
}

} // namespace stromar
