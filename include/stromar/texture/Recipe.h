#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace stromar {

/// sRGB, 0..255 each.
using Colour = std::array<int, 3>;

/// One row of a table of what a picture can be told. The same rows serve the command line, the window, files and tests.
template <typename Params>
struct RecipeParam {
    std::string_view key, label, help; ///< the last two marked for translation
    std::variant<int Params::*, double Params::*, Colour Params::*> field;
    double min = 0, max = 0;
};

/// What can be drawn by one kind of recipe: kinds, the values that suit each, and the rows of the table. `Params` has a
/// field `kind`, which has no row.
template <typename Params>
struct RecipeBook {
    std::string_view what; ///< "bark": how messages and files call it
    std::span<const std::string_view> kinds;
    std::span<const Params> usual; ///< by kind
    std::span<const RecipeParam<Params>> table;

    const Params& of(int kind) const { return usual[static_cast<std::size_t>(kind)]; }
    /// "furrowed seed=3 light=#a09080": a kind, then what differs from it. Throws CError, which says what is wrong.
    Params read(std::string_view text) const;
    std::string text(const Params& params) const;
    std::string valueText(const Params& params, const RecipeParam<Params>& row) const;
    /// Throws CError.
    void setValue(Params& params, const RecipeParam<Params>& row, const std::string& text) const;
};

} // namespace stromar
