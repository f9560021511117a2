#include "stromar/texture/Draw.h"
#include <type_traits>

namespace stromar {

namespace {
using Params = std::variant<BarkParams, LeafParams>;

// The books, by what they hold.
const RecipeBook<BarkParams>& bookOf(const BarkParams&) { return barkBook(); }
const RecipeBook<LeafParams>& bookOf(const LeafParams&) { return leafBook(); }
TextureMaps drawn(const BarkParams& bark, int size, const CProgress& progress) {
    return makeBark(bark, size, progress);
}
TextureMaps drawn(const LeafParams& leaf, int size, const CProgress& progress) {
    return makeLeaf(leaf, size, progress);
}

/// Calls use(book, …) with the book that has this name; false when there is none.
template <std::size_t I = 0, typename Use>
bool withBook(std::string_view name, Use&& use) {
    if constexpr (I == std::variant_size_v<Params>)
        return false;
    else {
        const auto& book = bookOf(std::variant_alternative_t<I, Params>());
        if (book.what != name) return withBook<I + 1>(name, use);
        use(book);
        return true;
    }
}

std::string_view bookName(std::string_view text) {
    const std::size_t colon = text.find(':');
    return colon == std::string_view::npos ? std::string_view() : text.substr(0, colon);
}

template <typename Field>
CRecipe::Type typeOf(const Field& field) {
    return field.index() == 0 ? CRecipe::Type::Whole : field.index() == 1 ? CRecipe::Type::Number : CRecipe::Type::Tint;
}
} // namespace

CRecipe::CRecipe(std::string_view text) {
    const auto read = [&](const auto& book) { m_params = book.read(text.substr(book.what.size() + 1)); };
    if (!withBook(bookName(text), read))
        throw CError("'" + std::string(text) + "' is no recipe; it starts with bark: or leaf:");
}

std::string CRecipe::text() const {
    return std::visit(
        [](const auto& params) { return std::string(bookOf(params).what) + ":" + bookOf(params).text(params); },
        m_params);
}

std::span<const std::string_view> CRecipe::kinds() const {
    return std::visit([](const auto& params) { return bookOf(params).kinds; }, m_params);
}

int CRecipe::kind() const {
    return std::visit([](const auto& params) { return params.kind; }, m_params);
}

void CRecipe::setKind(int kind) {
    std::visit([&](auto& params) { params = bookOf(params).of(kind); }, m_params);
}

std::vector<CRecipe::Row> CRecipe::rows() const {
    std::vector<Row> rows;
    std::visit(
        [&](const auto& params) {
            for (const auto& row : bookOf(params).table)
                rows.push_back({row.key, row.label, row.help, typeOf(row.field), row.min, row.max});
        },
        m_params);
    return rows;
}

std::string CRecipe::value(std::size_t row) const {
    return std::visit([&](const auto& params) { return bookOf(params).valueText(params, bookOf(params).table[row]); },
                      m_params);
}

void CRecipe::setValue(std::size_t row, const std::string& value) {
    std::visit([&](auto& params) { bookOf(params).setValue(params, bookOf(params).table[row], value); }, m_params);
}

double CRecipe::relief() const {
    const auto* bark = std::get_if<BarkParams>(&m_params);
    return bark ? reliefOf(*bark) : kLeafRelief;
}

TextureMaps CRecipe::draw(int size, const CProgress& progress) const {
    return std::visit([&](const auto& params) { return drawn(params, size, progress); }, m_params);
}

bool isRecipe(std::string_view text) {
    return withBook(bookName(text), [](const auto&) {});
}

std::vector<std::string> plainRecipes(std::string_view book) {
    std::vector<std::string> all;
    withBook(book, [&](const auto& found) {
        for (const std::string_view kind : found.kinds) all.push_back(std::string(book) + ":" + std::string(kind));
    });
    return all;
}

} // namespace stromar
