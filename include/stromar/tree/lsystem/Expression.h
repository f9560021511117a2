#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stromar {

/// A place in a text; line and column count from 1, columns in bytes.
struct TextPlace {
    int line = 1, column = 1;
    bool operator==(const TextPlace&) const = default;
};

/// Throws CInputError with one error at this place of a text.
[[noreturn]] void failAt(const TextPlace& place, std::string text);

/// A node of an expression's syntax tree.
struct ExpressionNode {
    enum class Kind { Number, Name, Call, Unary, Binary };
    Kind kind;
    double number = 0;
    std::string name; ///< of a value, a function or an operator
    std::vector<ExpressionNode> operands;
    TextPlace place;
};

/// What a compiled expression reads: the numbers of its formal parameters, one after the other, and where it stands, for
/// rand(): a hash of seed, module and place.
struct ExpressionInput {
    std::span<const double> formals;
    std::uint64_t place = 0;
    bool varied = true; ///< false: rand() gives the middle of its range
};

/// An expression for a stack machine: a constant, one formal, or a list of steps. Angles of its functions in degrees.
class CExpression {
public:
    CExpression() = default;
    explicit CExpression(double constant) : m_constant(constant) {}

    double evaluate(const ExpressionInput& input) const {
        if (m_steps.empty()) return m_formal < 0 ? m_constant : input.formals[static_cast<std::size_t>(m_formal)];
        return run(input);
    }
    /// Its value, when it reads neither formals nor chance.
    std::optional<double> constant() const {
        return m_steps.empty() && m_formal < 0 ? std::optional(m_constant) : std::nullopt;
    }

private:
    friend class CExpressionCompiler;
    struct Step {
        std::uint8_t operation;
        std::uint16_t index = 0; ///< of a formal; which rand() of the expression
        double number = 0;
    };

    double run(const ExpressionInput& input) const;

    double m_constant = 0;
    int m_formal = -1;
    std::vector<Step> m_steps;
};

/// A value that expressions know by its name.
struct NamedValue {
    std::string name;
    double value;
};

/// Compiles a tree: names are formals (the last of a name counts) or constants. `firstRand` counts the rand() of what
/// belongs together. Throws CInputError, with places of the text.
CExpression compileExpression(const ExpressionNode& tree, std::span<const std::string> formals,
                              std::span<const NamedValue> constants, std::uint16_t& firstRand);

/// "sin", "cos", …: what expressions can call.
std::vector<std::string> expressionFunctions();

} // namespace stromar
