#pragma once
#include "stromar/app/ExportOptions.h"
#include <span>
#include <string>
#include <string_view>

namespace stromar {

/// A value of a choice, as setChoice() takes it.
struct ChosenValue {
    std::string_view key, value;
};

/// One row of the table of programs that trees are exported for: the first row of the export dialog, `--for` of the command line, and
/// the pages of the manual are loops over it.
struct Engine {
    std::string_view key, label;
    std::string_view ending; ///< of the format that it reads best
    std::span<const ChosenValue> values; ///< what differs from the defaults
    std::string_view notes;  ///< what to do after the import, one sentence or two, for people
};
std::span<const Engine> engineTable();
/// Null when there is none of that key.
const Engine* engineNamed(std::string_view key);

/// What an export is to be like, besides where it goes: what a settings file holds.
struct ExportSettings {
    std::string engine; ///< key; empty: none
    std::string ending; ///< of the format, with its dot; empty: the path says it
    ExportOptions options{};
    bool operator==(const ExportSettings&) const = default;
};

/// The defaults of an engine.
ExportSettings settingsFor(const Engine& engine);

/// Lines "key = value": the engine, the format, and what differs from the engine's defaults. Comments start with #.
std::string settingsText(const ExportSettings& settings);
/// `name` stands in messages for the file. Throws CInputError with every error (file, line, column).
ExportSettings parseSettings(const std::string& text, const std::string& name);
/// Throws CError when the file cannot be read, else as parseSettings().
ExportSettings readSettings(const std::filesystem::path& path);

} // namespace stromar
