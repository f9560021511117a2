#pragma once
#include "stromar/params/ParamTable.h"
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace stromar {

/// What a key of a file or of `--set` names: a number or a text of the tree.
using ParamTarget = std::variant<ParamRef, const TextInfo*>;

/// Finds a key or one of its aliases.
std::optional<ParamTarget> findParam(std::string_view key);

/// ", did you mean '1DownAngle'?", or nothing.
std::string keySuggestion(std::string_view key);

enum class SetResult { Done, Clamped, BadValue };

/// Sets a value from text: a number, or for enums also the word. `problem` says what was wrong (Clamped, BadValue).
SetResult setFromText(CParams& params, const ParamTarget& target, std::string_view value, std::string& problem);

/// The value as files have it; enums as numbers, texts quoted where they need it.
std::string valueText(const CParams& params, const ParamTarget& target);

/// The manual's page of parameters, as Markdown.
std::string paramsAsMarkdown();
/// The same for a terminal.
std::string paramsAsText();

} // namespace stromar
