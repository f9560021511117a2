#pragma once
#include "stromar/params/ParamTable.h"
#include <optional>
#include <string>
#include <string_view>

namespace stromar {

constexpr std::string_view kBlockMark = "\"\"\""; ///< stands before and after a text of several lines

/// Finds a key of a method, or one of its aliases.
std::optional<ParamRef> findParam(std::string_view key, const ParamBlock& block = weberPennBlock());

/// ", did you mean '1DownAngle'?", or nothing.
std::string keySuggestion(std::string_view key, const ParamBlock& block = weberPennBlock());

enum class SetResult { Done, Clamped, BadValue };

/// What was wrong with a value (Clamped, BadValue).
struct SetProblem {
    std::string text;
    std::size_t at = 0; ///< where in the value it begins
};

/// Sets a value from text: a number, for choices also the word, a curve's points, a text as it is. The tree has to be
/// of the method that the row belongs to.
SetResult setFromText(CParams& params, const ParamRef& ref, std::string_view value, SetProblem& problem);

/// The value on one line, as files have it; choices as numbers, texts quoted where they need it.
std::string valueText(const CParams& params, const ParamRef& ref);

/// ", did you mean 'l-system'? (weber-penn, l-system)" for a method that is not known.
std::string methodSuggestion(std::string_view method);

/// What a value is called in lists: "number", "integer", "choice", "switch", "curve", "text".
std::string_view kindName(const ParamInfo& info);
/// "0.5", "0:1, 3:0.4", or "0.5, 0.5, 0.3, 0.3" for rows with a value per level, "–" where the trunk has none.
std::string defaultsText(const ParamInfo& info, const ParamBlock& block);

/// The manual's page of a method's parameters, as Markdown.
std::string paramsAsMarkdown(const ParamBlock& block = weberPennBlock());
/// The same for a terminal.
std::string paramsAsText(const ParamBlock& block = weberPennBlock());

} // namespace stromar
