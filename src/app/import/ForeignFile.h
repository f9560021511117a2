#pragma once
#include "stromar/app/Import.h"
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace stromar {

/// One value of a file of another program.
struct ForeignValue {
    std::string key;
    std::vector<std::string> items; ///< of a list, or one; words and numbers as they are written
    bool list = false;
    std::size_t at = 0; ///< byte of the text

    std::optional<double> number(std::size_t item = 0) const;
    bool isTrue() const { return !items.empty() && (items[0] == "True" || items[0] == "true" || number().value_or(0) != 0); }
};
using ForeignValues = std::vector<ForeignValue>;

inline const ForeignValue* valueOf(const ForeignValues& values, std::string_view key) {
    const auto found = std::ranges::find(values, key, &ForeignValue::key);
    return found == values.end() ? nullptr : &*found;
}

/// A text with a name, for messages with a place in it.
struct ForeignText {
    const std::string& text;
    const std::string& name;

    Message message(Severity severity, std::size_t at, std::string said) const;
    [[noreturn]] void fail(std::size_t at, std::string said) const { throw CInputError({message(Severity::Error, at, std::move(said))}); }
};

/// The pairs of a dictionary of literals, in Python's or JSON's way to write them, perhaps behind "name =". Nothing else may stand in the
/// file but comments and texts. Throws CInputError.
ForeignValues readLiterals(const ForeignText& text);
/// The parameters of a species in Arbaro's XML; its name as "species". Throws CInputError.
ForeignValues readArbaro(const ForeignText& text);

/// What a format knows besides its rows: values that depend on each other.
using ForeignRest = void (*)(const ForeignValues& values, CParams& params);

extern const std::span<const ImportRow> kArbaroRows, kSaplingRows, kTreeGenRows;
void finishArbaro(const ForeignValues& values, CParams& params);
void finishSapling(const ForeignValues& values, CParams& params);
void finishTreeGen(const ForeignValues& values, CParams& params);

} // namespace stromar
