#pragma once
#include "stromar/texture/Bark.h"
#include "stromar/texture/Leaf.h"
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stromar {

/// A recipe of any book, for those who do not care which: "bark:birch seed=3", "leaf:oak".
class CRecipe {
public:
    enum class Type { Whole, Number, Tint };
    struct Row {
        std::string_view key, label, help; ///< the last two marked for translation
        Type type;
        double min, max; ///< of numbers
    };

    /// Throws CError, which says what is wrong.
    explicit CRecipe(std::string_view text);

    std::string text() const;
    std::span<const std::string_view> kinds() const;
    int kind() const;
    /// All other values become those that suit the kind.
    void setKind(int kind);
    std::vector<Row> rows() const;
    /// As texts have it: "3", "0.5", "#a09080".
    std::string value(std::size_t row) const;
    /// Throws CError.
    void setValue(std::size_t row, const std::string& value);
    /// How far the highest place lies above the deepest, in widths of the picture.
    double relief() const;
    TextureMaps draw(int size, const CProgress& progress) const;

private:
    std::variant<BarkParams, LeafParams> m_params;
};

/// Whether a text is a recipe, "bark:birch seed=3", and no path.
bool isRecipe(std::string_view text);

/// All recipes without own values of a book, "bark" or "leaf": "bark:furrowed", …
std::vector<std::string> plainRecipes(std::string_view book);

} // namespace stromar
