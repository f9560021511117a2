#include "stromar/texture/Draw.h"
#include "stromar/texture/Bark.h"
#include "stromar/texture/Leaf.h"
#include <functional>
#include <tuple>

namespace stromar {

namespace {
/// All books and what draws their pages.
const auto kBooks = std::tuple{std::pair{&barkBook(), &makeBark}, std::pair{&leafBook(), &makeLeaf}};

/// Calls use(book, draw, rest of the text) for the book that a text names; false when it names none.
template <typename Use>
bool withBook(std::string_view text, Use&& use) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return false;
    const std::string_view name = text.substr(0, colon), rest = text.substr(colon + 1);
    return std::apply(
        [&](const auto&... entry) {
            return ((entry.first->what == name && (use(*entry.first, entry.second, rest), true)) || ...);
        },
        kBooks);
}

[[noreturn]] void refuse(std::string_view recipe) {
    throw CError("'" + std::string(recipe) + "' is no recipe; it starts with bark: or leaf:");
}
} // namespace

bool isRecipe(std::string_view text) {
    return withBook(text, [](const auto&, const auto&, std::string_view) {});
}

void checkRecipe(std::string_view recipe) {
    if (!withBook(recipe, [](const auto& book, const auto&, std::string_view rest) { book.read(rest); }))
        refuse(recipe);
}

TextureMaps drawRecipe(std::string_view recipe, int size, const CProgress& progress) {
    TextureMaps maps;
    const auto draw = [&](const auto& book, const auto& make, std::string_view rest) {
        maps = make(book.read(rest), size, progress);
    };
    if (!withBook(recipe, draw)) refuse(recipe);
    return maps;
}

std::vector<std::string> plainRecipes(std::string_view wanted) {
    std::vector<std::string> all;
    const auto add = [&](const auto& book) {
        if (book.what != wanted) return;
        for (const std::string_view kind : book.kinds) all.push_back(std::string(book.what) + ":" + std::string(kind));
    };
    std::apply([&](const auto&... entry) { (add(*entry.first), ...); }, kBooks);
    return all;
}

} // namespace stromar
