#pragma once
#include "stromar/params/Params.h"
#include "stromar/util/Error.h"
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace stromar {

/// What becomes of a value of another program. Keys with "n" in front are of each level: an item of a list there, a digit in front here.
struct ImportRow {
    std::string_view foreign; ///< its name there
    std::string_view ours;    ///< the parameter; empty: it cannot be had
    std::string_view note{};  ///< what changes on the way, or is lost, marked N_; empty: nothing
    double (*value)(double) = nullptr; ///< ours from theirs; null: the same number
    double neutral = 0;       ///< at this value nothing is lost
};

struct ForeignReader;

/// One row of the table of programs whose trees can be read: command line, window, manual and tests are loops over it.
struct ImportFormat {
    std::string_view key, name;
    std::string_view endings; ///< ".py .json"
    std::span<const ImportRow> rows;
    const ForeignReader* reader; ///< how its files are read
};
std::span<const ImportFormat> importTable();

/// Whether the ending of a file is one of the table.
bool mayImport(const std::filesystem::path& file);

/// A tree of another program.
struct ImportedTree {
    CParams params;
    const ImportFormat* format;
    Messages notes; ///< what was changed or could not be had, with its place
};

/// Reads a file as data: nothing in it is run. `name` stands in messages. Throws CInputError (file, line, column) for what is cut, nested
/// too deep, or of no program of the table.
ImportedTree parseForeign(const std::string& text, const std::string& name);
/// Throws CError, too, when it cannot be read or has more than kMaxForeignBytes.
ImportedTree importTree(const std::filesystem::path& file);

constexpr std::size_t kMaxForeignBytes = 1'000'000;

} // namespace stromar
