#pragma once
#include "stromar/tree/lsystem/Expression.h"
#include "stromar/util/Error.h"
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace stromar {

/// Letters of words, as numbers: those of one byte are themselves, organs (`~L`) follow.
using Symbol = std::uint8_t;
constexpr Symbol kLeafSymbol = 128, kBlossomSymbol = 129, kFruitSymbol = 130;
/// What the turtle understands, beside organs. Other letters draw nothing.
inline constexpr std::string_view kTurtleLetters = "Ff+-&^\\/|$!%[]";
/// "F", "~L"
std::string symbolName(Symbol symbol);

/// `#define name value // low .. high words`
struct GrammarDefine {
    std::string name;
    double value;
    TextPlace place;           ///< of its value
    std::size_t offset, length; ///< of the value's letters in the text
    bool isNumber;             ///< not an expression: a slider may rewrite it
    double low, high;          ///< what the comment says, else guessed: 0 … twice the value
    std::string words;         ///< of the comment
};

/// A module of a word to be: its letter and what its numbers are.
struct SuccessorModule {
    Symbol symbol;
    std::vector<CExpression> numbers;
    TextPlace place;
};

/// A module as a production looks for it: its letter and so many numbers, the first of them this formal parameter.
struct ModulePattern {
    Symbol symbol;
    std::uint8_t numbers;
    std::uint16_t firstFormal;
};

constexpr std::size_t kMaxFormals = 32; ///< of one production

/// `left < predecessor > right : condition → (probability) successor`
struct Production {
    std::vector<ModulePattern> left, right;
    ModulePattern predecessor;
    CExpression condition{1};
    std::optional<CExpression> probability;
    std::vector<SuccessorModule> successor;
    std::uint16_t formals = 0; ///< how many
    std::size_t numbers = 0;   ///< of all modules of the successor
    /// The first module of the predecessor's letter outside brackets, else anywhere: what it grows into. The successor's
    /// size where there is none.
    std::size_t heir = 0;
    TextPlace place;

    bool hasContext() const { return !left.empty() || !right.empty(); }
};

/// A parametric L-system (Prusinkiewicz & Lindenmayer, "The Algorithmic Beauty of Plants", chapters 1 and 2).
struct Grammar {
    std::vector<GrammarDefine> defines;
    std::vector<SuccessorModule> axiom;
    std::vector<Production> productions; ///< those with context first
    std::array<bool, 256> ignored{};      ///< by context
    Messages warnings;
};

/// Reads a grammar. The numbers of defines may be others than those of the text, by name. Throws CInputError, whose
/// messages have lines and columns of the text.
Grammar parseGrammar(std::string_view text, std::span<const NamedValue> defines = {});

} // namespace stromar
