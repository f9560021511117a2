#include "stromar/tree/lsystem/Expression.h"
#include "stromar/util/Error.h"
#include "stromar/util/Random.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
using std::numbers::pi;
using Two = double (*)(double, double);

/// An operator or a function of one or two numbers; rand() reads its place besides.
struct Operation {
    std::string_view name;
    int operands;
    bool function;
    Two apply; ///< of one operand the second is 0
};

constexpr std::string_view kRand = "rand";
double truth(bool value) { return value ? 1 : 0; }

const std::array kOperations = {
    Operation{"+", 2, false, [](double a, double b) { return a + b; }},
    Operation{"-", 2, false, [](double a, double b) { return a - b; }},
    Operation{"*", 2, false, [](double a, double b) { return a * b; }},
    Operation{"/", 2, false, [](double a, double b) { return a / b; }},
    Operation{"^", 2, false, [](double a, double b) { return std::pow(a, b); }},
    Operation{"<", 2, false, [](double a, double b) { return truth(a < b); }},
    Operation{"<=", 2, false, [](double a, double b) { return truth(a <= b); }},
    Operation{">", 2, false, [](double a, double b) { return truth(a > b); }},
    Operation{">=", 2, false, [](double a, double b) { return truth(a >= b); }},
    Operation{"==", 2, false, [](double a, double b) { return truth(a == b); }},
    Operation{"!=", 2, false, [](double a, double b) { return truth(a != b); }},
    Operation{"&&", 2, false, [](double a, double b) { return truth(a != 0 && b != 0); }},
    Operation{"||", 2, false, [](double a, double b) { return truth(a != 0 || b != 0); }},
    Operation{"-", 1, false, [](double a, double) { return -a; }},
    Operation{"!", 1, false, [](double a, double) { return truth(a == 0); }},
    Operation{"sin", 1, true, [](double a, double) { return std::sin(a * pi / 180); }},
    Operation{"cos", 1, true, [](double a, double) { return std::cos(a * pi / 180); }},
    Operation{"tan", 1, true, [](double a, double) { return std::tan(a * pi / 180); }},
    Operation{"atan2", 2, true, [](double a, double b) { return std::atan2(a, b) * 180 / pi; }},
    Operation{"sqrt", 1, true, [](double a, double) { return std::sqrt(a); }},
    Operation{"abs", 1, true, [](double a, double) { return std::abs(a); }},
    Operation{"min", 2, true, [](double a, double b) { return std::min(a, b); }},
    Operation{"max", 2, true, [](double a, double b) { return std::max(a, b); }},
    Operation{"floor", 1, true, [](double a, double) { return std::floor(a); }},
    Operation{"exp", 1, true, [](double a, double) { return std::exp(a); }},
    Operation{"log", 1, true, [](double a, double) { return std::log(a); }},
    Operation{"pow", 2, true, [](double a, double b) { return std::pow(a, b); }},
    Operation{kRand, 2, true, nullptr},
};
constexpr std::uint8_t kNumber = 254, kFormal = 255;
constexpr std::size_t kMaxDepth = 64; // of the stack
} // namespace

void failAt(const TextPlace& place, std::string text) {
    throw CInputError({{Severity::Error, {}, place.line, place.column, std::move(text)}});
}

std::vector<std::string> expressionFunctions() {
    std::vector<std::string> names;
    for (const Operation& operation : kOperations)
        if (operation.function) names.emplace_back(operation.name);
    return names;
}

double CExpression::run(const ExpressionInput& input) const {
    std::array<double, kMaxDepth> stack;
    std::size_t top = 0;
    for (const Step& step : m_steps) {
        if (step.operation == kNumber)
            stack[top++] = step.number;
        else if (step.operation == kFormal)
            stack[top++] = input.formals[step.index];
        else {
            const Operation& operation = kOperations[step.operation];
            const double second = operation.operands == 2 ? stack[--top] : 0;
            double& first = stack[top - 1];
            first = operation.apply ? operation.apply(first, second)
                                    : first + (second - first) * (input.varied ? unitOf(hashCombine(input.place, step.index)) : 0.5);
        }
    }
    return stack[0];
}

/// From the tree to steps; what reads neither formals nor chance is computed now.
class CExpressionCompiler {
public:
    CExpressionCompiler(std::span<const std::string> formals, std::span<const NamedValue> constants, std::uint16_t& rands)
        : m_formals(formals), m_constants(constants), m_rands(rands) {}

    CExpression compile(const ExpressionNode& tree) {
        add(tree, 0);
        CExpression made;
        if (m_steps.size() == 1 && m_steps[0].operation == kNumber)
            made.m_constant = m_steps[0].number;
        else if (m_steps.size() == 1 && m_steps[0].operation == kFormal)
            made.m_formal = m_steps[0].index;
        else
            made.m_steps = std::move(m_steps);
        return made;
    }

private:
    using Step = CExpression::Step;

    void add(const ExpressionNode& node, std::size_t depth) {
        if (depth + 2 >= kMaxDepth)
            failAt(node.place, translated(NC_("stromar", "this expression is nested too deeply")));
        switch (node.kind) {
        case ExpressionNode::Kind::Number: m_steps.push_back({kNumber, 0, node.number}); return;
        case ExpressionNode::Kind::Name: return addName(node);
        default: return addOperation(node, depth);
        }
    }

    void addName(const ExpressionNode& node) {
        const auto formal = std::ranges::find(m_formals.rbegin(), m_formals.rend(), node.name);
        if (formal != m_formals.rend()) {
            const auto index = static_cast<std::uint16_t>(m_formals.rend() - formal - 1);
            m_steps.push_back({kFormal, index, 0});
            return;
        }
        const auto constant = std::ranges::find(m_constants.rbegin(), m_constants.rend(), node.name, &NamedValue::name);
        if (constant == m_constants.rend()) {
            std::vector<std::string> known(m_formals.begin(), m_formals.end());
            for (const NamedValue& value : m_constants) known.push_back(value.name);
            failAt(node.place,
                 translated(NC_("stromar", "'%1' is not defined here"), node.name) + suggestion(node.name, known));
        }
        m_steps.push_back({kNumber, 0, constant->value});
    }

    void addOperation(const ExpressionNode& node, std::size_t depth) {
        const bool function = node.kind == ExpressionNode::Kind::Call;
        const auto named = [&](const Operation& o) { return o.name == node.name && o.function == function; };
        const auto operands = static_cast<int>(node.operands.size());
        const auto found = std::ranges::find_if(
            kOperations, [&](const Operation& o) { return named(o) && (function || o.operands == operands); });
        if (found == kOperations.end())
            failAt(node.place, translated(NC_("stromar", "there is no function '%1'"), node.name) +
                                 suggestion(node.name, expressionFunctions()));
        if (found->operands != operands)
            failAt(node.place, translated(found->operands == 1 ? NC_("stromar", "%1() takes %2 number, not %3")
                                                             : NC_("stromar", "%1() takes %2 numbers, not %3"),
                                        found->name, found->operands, operands));
        const std::size_t first = m_steps.size();
        for (std::size_t i = 0; i < node.operands.size(); ++i) add(node.operands[i], depth + i);
        const bool constant = found->apply && m_steps.size() == first + node.operands.size() &&
                              std::all_of(m_steps.begin() + static_cast<std::ptrdiff_t>(first), m_steps.end(),
                                          [](const Step& s) { return s.operation == kNumber; });
        if (!constant) {
            const auto index = found->apply ? std::uint16_t{0} : m_rands++;
            m_steps.push_back({static_cast<std::uint8_t>(found - kOperations.begin()), index, 0});
            return;
        }
        const double a = m_steps[first].number, b = operands == 2 ? m_steps[first + 1].number : 0;
        m_steps.resize(first);
        m_steps.push_back({kNumber, 0, found->apply(a, b)});
        if (!std::isfinite(m_steps.back().number))
            failAt(node.place, translated(NC_("stromar", "this is no finite number")));
    }

    std::span<const std::string> m_formals;
    std::span<const NamedValue> m_constants;
    std::uint16_t& m_rands;
    std::vector<Step> m_steps;
};

CExpression compileExpression(const ExpressionNode& tree, std::span<const std::string> formals,
                              std::span<const NamedValue> constants, std::uint16_t& firstRand) {
    return CExpressionCompiler(formals, constants, firstRand).compile(tree);
}

} // namespace stromar
