#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stromar {

/// Without blanks, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

/// The shortest decimal text that reads back as exactly `value`. Always a decimal point, whatever the locale.
std::string numberText(double value);

/// A finite number that fills the whole text (a leading + is fine); nothing otherwise. Independent of the locale.
std::optional<double> parseNumber(std::string_view text);

/// Where the first byte stands that is no UTF-8 (overlong forms, surrogates and too high codes are none), or npos.
std::size_t firstInvalidUtf8(std::string_view text);

/// One line of valid UTF-8: control characters but the tab become blanks, bytes that are no UTF-8 question marks.
std::string plainLine(std::string_view text);

/// Letters A–Z become a–z, the rest stays.
std::string lowerCase(std::string_view text);

/// The entry of `known` nearest to `word` (Levenshtein distance, case ignored), if it is near enough to be meant.
std::optional<std::string> nearestWord(std::string_view word, std::span<const std::string> known);

/// ", did you mean 'Scale'?", or nothing when no entry is near.
std::string suggestion(std::string_view word, std::span<const std::string> known);

} // namespace stromar
