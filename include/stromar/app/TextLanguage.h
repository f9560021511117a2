#pragma once
#include "stromar/params/ParamTable.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Error.h"
#include "stromar/util/Progress.h"
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stromar {

/// What an editor has to know of the language that a block text is written in. Places are bytes of the text; lines count
/// from 1.
struct TextLanguage {
    std::string_view key;    ///< of the row that holds the text
    std::string_view suffix; ///< of files that hold such a text alone
    std::string_view files;  ///< what they are called, and their names: "Poems (*.poem)"; marked for translation

    enum class Token { Comment, Directive, Number, Name, Turtle, Organ, Bracket, Arrow };
    struct Span {
        std::size_t first, length; ///< in the line
        Token token;
    };
    /// How a line is coloured. `inComment`: whether a comment of several lines is open, before and after.
    std::vector<Span> (*spans)(std::string_view line, bool& inComment);

    /// What completes a word that was begun.
    std::vector<std::string> (*words)(const std::string& text);

    struct Fault {
        Severity severity;
        int line, column;
        std::string text;
    };
    /// What is wrong with a text; empty: nothing.
    std::vector<Fault> (*faults)(const std::string& text);

    /// A number of the text that a slider moves.
    struct Slider {
        std::string name, words;
        double value, low, high;
        std::size_t at, length; ///< of its letters
    };
    /// None for a text that is wrong.
    std::vector<Slider> (*sliders)(const std::string& text);

    /// One step of what the text describes.
    struct Step {
        std::string shown; ///< the beginning of its word
        std::size_t more;  ///< modules that are not shown
        std::vector<std::pair<int, std::size_t>> applied; ///< lines of the rules that lead to the next, and how often
    };
    /// Takes as long as growing the tree so far. Throws CCancelled, CError.
    Step (*step)(const CParams& params, int step, const CProgress& progress);
    std::string_view steps; ///< the row that says how many steps there are

    /// The line that wrote a stem.
    std::optional<int> (*lineOf)(const CParams& params, const CTree& tree, std::size_t generation, std::size_t stem);
    /// The segments that a line wrote, by generation.
    std::vector<std::vector<std::uint32_t>> (*writtenBy)(const CParams& params, const CTree& tree, int line);
};

/// Where a line and column of a text are, bytes.
std::size_t offsetOf(std::string_view text, int line, int column);

/// The language of a row's text; null: it has none.
const TextLanguage* languageOf(const ParamInfo& info);

} // namespace stromar
