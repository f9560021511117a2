#include "stromar/tree/lsystem/Grammar.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <set>

namespace stromar {

namespace {
constexpr std::string_view kOrganLetters = "LBK"; // after ~
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kSpellings = {
    {{"\u2212", "-"}, {"\u2192", "->"}, {"\u27f6", "->"}, {"\u03c9", "axiom"}}};

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isNameLetter(char c) { return isLetter(c) || isDigit(c) || c == '_'; }

/// Letters with their places in the text.
struct PlacedText {
    std::string letters;
    std::vector<TextPlace> places;
    std::vector<std::size_t> offsets;
    std::string comment; ///< after the last `//`

    void add(char c, const TextPlace& place, std::size_t offset) {
        letters += c;
        places.push_back(place);
        offsets.push_back(offset);
    }
};

/// The lines of a grammar: comments are gone, lines that start with a blank continue the one before, letters are spelt in
/// one way.
class CLineSplitter {
public:
    explicit CLineSplitter(std::string_view text) : m_text(text) {}

    std::vector<PlacedText> split() {
        while (m_at < m_text.size()) {
            const bool startOfLine = m_place.column == 1;
            if (startOfLine && (m_lines.empty() || !isBlank(m_text[m_at]))) m_lines.emplace_back();
            if (m_text.substr(m_at).starts_with("/*"))
                skipBlock();
            else if (startsLineComment())
                takeLineComment();
            else
                takeLetter();
        }
        return std::move(m_lines);
    }

private:
    bool startsLineComment() const {
        if (!m_text.substr(m_at).starts_with("//")) return false;
        const bool first = m_place.column == 1;
        const bool before = first || isBlank(m_text[m_at - 1]);
        const std::size_t next = m_at + 2;
        return first || (before && (next == m_text.size() || isBlank(m_text[next]) || m_text[next] == '\n'));
    }

    void takeLineComment() {
        const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
        m_lines.back().comment = trimmed(m_text.substr(m_at + 2, end - m_at - 2));
        while (m_at < end) step();
    }

    void skipBlock() {
        const TextPlace start = m_place;
        const std::size_t end = m_text.find("*/", m_at + 2);
        if (end == std::string_view::npos) failAt(start, translated(NC_("stromar", "this comment has no end")));
        const TextPlace place = m_place;
        m_lines.back().add(' ', place, m_at);
        while (m_at < end + 2) step();
        if (m_place.column == 1) m_place.column = 2; // what follows is no new line
    }

    void takeLetter() {
        for (const auto& [from, to] : kSpellings)
            if (m_text.substr(m_at).starts_with(from)) {
                for (const char c : to) m_lines.back().add(c, m_place, m_at);
                for (std::size_t i = 0; i < from.size(); ++i) step();
                return;
            }
        if (m_text[m_at] != '\n') m_lines.back().add(m_text[m_at], m_place, m_at);
        step();
    }

    void step() {
        if (m_text[m_at++] == '\n')
            m_place = {m_place.line + 1, 1};
        else
            ++m_place.column;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    TextPlace m_place;
    std::vector<PlacedText> m_lines;
};

/// Reads one line from left to right.
class CLineReader {
public:
    explicit CLineReader(const PlacedText& line) : m_line(line) {}

    void skipBlanks() {
        while (m_at < size() && isBlank(letter())) ++m_at;
    }
    bool atEnd() {
        skipBlanks();
        return m_at == size();
    }
    char peek() { return atEnd() ? '\0' : letter(); }
    bool sees(std::string_view word) {
        skipBlanks();
        return std::string_view(m_line.letters).substr(m_at).starts_with(word);
    }
    bool accept(std::string_view word) {
        if (!sees(word)) return false;
        m_at += word.size();
        return true;
    }
    void expect(std::string_view word) {
        if (!accept(word)) failAt(place(), translated(NC_("stromar", "expected '%1'"), word));
    }
    bool seesArrow() { return sees("->") || sees("-->"); }
    bool acceptArrow() { return accept("-->") || accept("->"); }
    char take() { return m_line.letters[m_at++]; }

    TextPlace place() {
        skipBlanks();
        if (m_at < size()) return m_line.places[m_at];
        if (m_line.places.empty()) return {};
        return {m_line.places.back().line, m_line.places.back().column + 1};
    }
    std::size_t at() const { return m_at; }
    void goTo(std::size_t at) { m_at = at; }
    std::size_t offset() {
        skipBlanks();
        return m_at < size() ? m_line.offsets[m_at] : m_line.offsets.back() + 1;
    }
    std::size_t offsetBefore() const { return m_line.offsets[m_at - 1] + 1; }

    std::string name() {
        skipBlanks();
        std::string name;
        while (m_at < size() && isNameLetter(letter())) name += take();
        return name;
    }

    // Expressions, from the weakest operator to the strongest.

    ExpressionNode expression() { return chain({"||"}, [this] { return conjunction(); }); }

private:
    using Kind = ExpressionNode::Kind;

    std::size_t size() const { return m_line.letters.size(); }
    char letter() const { return m_line.letters[m_at]; }

    std::string operatorOf(std::initializer_list<std::string_view> words) {
        if (seesArrow()) return {};
        for (const std::string_view word : words)
            if (accept(word)) return std::string(word);
        return {};
    }

    static ExpressionNode node(std::string name, std::vector<ExpressionNode> operands, const TextPlace& place) {
        const Kind kind = operands.size() == 1 ? Kind::Unary : Kind::Binary;
        return {kind, 0, std::move(name), std::move(operands), place};
    }

    template <typename Operand>
    ExpressionNode chain(std::initializer_list<std::string_view> words, Operand&& operand) {
        ExpressionNode left = operand();
        for (;;) {
            const TextPlace where = place();
            const std::string word = operatorOf(words);
            if (word.empty()) return left;
            std::vector<ExpressionNode> both;
            both.push_back(std::move(left));
            both.push_back(operand());
            left = node(word, std::move(both), where);
        }
    }

    ExpressionNode conjunction() {
        return chain({"&&"}, [this] { return comparison(); });
    }
    ExpressionNode comparison() {
        return chain({"<=", ">=", "==", "!=", "<", ">"}, [this] { return sum(); });
    }
    ExpressionNode sum() {
        return chain({"+", "-"}, [this] { return product(); });
    }
    ExpressionNode product() {
        return chain({"*", "/"}, [this] { return unary(); });
    }

    ExpressionNode unary() {
        const TextPlace where = place();
        if (accept("+")) return unary();
        for (const std::string_view word : {"-", "!"})
            if (!seesArrow() && accept(word)) return node(std::string(word), {unary()}, where);
        return power();
    }

    ExpressionNode power() {
        ExpressionNode base = primary();
        const TextPlace where = place();
        if (!accept("^")) return base;
        std::vector<ExpressionNode> both;
        both.push_back(std::move(base));
        both.push_back(unary()); // right-associative
        return node("^", std::move(both), where);
    }

    ExpressionNode primary() {
        const TextPlace where = place();
        const char c = peek();
        if (isDigit(c) || c == '.') return {Kind::Number, number(), {}, {}, where};
        if (accept("(")) {
            ExpressionNode inner = expression();
            if (!accept(")")) failAt(where, translated(NC_("stromar", "this bracket is not closed")));
            return inner;
        }
        if (!isLetter(c) && c != '_')
            failAt(where, translated(c == '\0' ? NC_("stromar", "a number is missing here")
                                             : NC_("stromar", "this is no number")));
        std::string word = name();
        if (!accept("(")) return {Kind::Name, 0, std::move(word), {}, where};
        ExpressionNode call{Kind::Call, 0, std::move(word), {}, where};
        if (accept(")")) return call;
        do call.operands.push_back(expression());
        while (accept(","));
        if (!accept(")")) failAt(where, translated(NC_("stromar", "the bracket of this call is not closed")));
        return call;
    }

    double number() {
        const TextPlace where = place();
        std::string digits;
        const auto takeWhile = [&](auto&& fits) {
            while (m_at < size() && fits(letter())) digits += take();
        };
        takeWhile([](char c) { return isDigit(c) || c == '.'; });
        if (m_at + 1 < size() && (letter() == 'e' || letter() == 'E')) {
            const char next = m_line.letters[m_at + 1];
            if (isDigit(next) || next == '-' || next == '+') {
                digits += take();
                digits += take();
                takeWhile(isDigit);
            }
        }
        const auto value = parseNumber(digits);
        if (!value) failAt(where, translated(NC_("stromar", "'%1' is no number"), digits));
        return *value;
    }

    const PlacedText& m_line;
    std::size_t m_at = 0;
};

class CGrammarParser {
public:
    CGrammarParser(std::string_view text, std::span<const NamedValue> others) : m_text(text), m_others(others) {}

    Grammar parse() {
        for (const PlacedText& line : CLineSplitter(m_text).split()) parseLine(line);
        if (m_grammar.axiom.empty()) failAt({1, 1}, translated(NC_("stromar", "the axiom is missing: axiom: …")));
        std::stable_partition(m_grammar.productions.begin(), m_grammar.productions.end(),
                              [](const Production& production) { return production.hasContext(); });
        warnOfDeadProductions();
        return std::move(m_grammar);
    }

private:
    void parseLine(const PlacedText& line) {
        CLineReader reader(line);
        if (reader.atEnd()) return;
        if (reader.accept("#define")) return parseDefine(reader, line.comment);
        if (reader.accept("#ignore")) return parseIgnored(reader);
        if (reader.peek() == '#')
            failAt(reader.place(), translated(NC_("stromar", "only #define and #ignore are known")));
        const TextPlace place = reader.place();
        if (const std::size_t start = reader.at(); reader.name() == "n" && reader.accept("="))
            failAt(place,
                 translated(
                     NC_("stromar", "the number of derivations is the value Derivations, not a line of the grammar")));
        else
            reader.goTo(start);
        if (reader.accept("axiom")) {
            reader.expect(":");
            if (!m_grammar.axiom.empty()) failAt(place, translated(NC_("stromar", "there is an axiom already")));
            m_grammar.axiom = parseWord(reader, {});
            if (m_grammar.axiom.empty()) failAt(place, translated(NC_("stromar", "the axiom is empty")));
            return;
        }
        parseProduction(reader, place);
    }

    void parseDefine(CLineReader& reader, const std::string& comment) {
        const TextPlace start = reader.place();
        GrammarDefine define{};
        define.name = reader.name();
        if (define.name.empty() || isDigit(define.name[0]))
            failAt(start, translated(NC_("stromar", "#define needs a name")));
        define.place = reader.place();
        define.offset = reader.offset();
        const ExpressionNode tree = reader.expression();
        define.length = trimmed(m_text.substr(define.offset, reader.offsetBefore() - define.offset)).size();
        if (!reader.atEnd()) failAt(reader.place(), translated(NC_("stromar", "nothing may follow the value")));
        std::uint16_t rands = 0;
        const auto value = compileExpression(tree, {}, m_values, rands).constant();
        if (!value) failAt(define.place, translated(NC_("stromar", "a value that is defined cannot depend on chance")));
        const bool negative = tree.kind == ExpressionNode::Kind::Unary && tree.name == "-" &&
                              tree.operands[0].kind == ExpressionNode::Kind::Number;
        define.isNumber = negative || tree.kind == ExpressionNode::Kind::Number;
        const auto other = std::ranges::find(m_others, define.name, &NamedValue::name);
        define.value = other != m_others.end() && define.isNumber ? other->value : *value;
        readRange(define, comment);
        m_values.push_back({define.name, define.value});
        m_grammar.defines.push_back(std::move(define));
    }

    /// "low .. high words"
    static void readRange(GrammarDefine& define, const std::string& comment) {
        define.low = std::min(0.0, 2 * define.value);
        define.high = define.value == 0 ? 1 : std::max(0.0, 2 * define.value);
        const std::size_t dots = comment.find("..");
        define.words = comment;
        if (dots == std::string::npos) return;
        const std::string_view rest = trimmed(std::string_view(comment).substr(dots + 2));
        const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
        const auto low = parseNumber(trimmed(std::string_view(comment).substr(0, dots))), high = parseNumber(rest.substr(0, end));
        if (!low || !high || *low >= *high) return;
        define.low = *low;
        define.high = *high;
        define.words = trimmed(rest.substr(end));
    }

    void parseIgnored(CLineReader& reader) {
        while (!reader.atEnd()) m_grammar.ignored[parseSymbol(reader)] = true;
    }

    Symbol parseSymbol(CLineReader& reader) {
        const TextPlace place = reader.place();
        const char c = reader.peek();
        if (c == '{' || c == '}' || c == '.')
            failAt(place, translated(NC_("stromar", "polygons { . } are not supported; use ~L for a leaf")));
        if (c == '~') {
            reader.take();
            const std::size_t organ = kOrganLetters.find(reader.peek());
            if (reader.atEnd() || organ == std::string_view::npos)
                failAt(place, translated(NC_("stromar", "after ~ stands L (leaf), B (blossom) or K (fruit)")));
            reader.take();
            return static_cast<Symbol>(kLeafSymbol + organ);
        }
        if (!isLetter(c) && kTurtleLetters.find(c) == std::string_view::npos)
            failAt(place, c == '\0' ? translated(NC_("stromar", "a letter is missing here"))
                                  : translated(NC_("stromar", "'%1' is no letter of a word"), std::string(1, c)));
        return static_cast<Symbol>(reader.take());
    }

    std::vector<SuccessorModule> parseWord(CLineReader& reader, std::span<const std::string> formals) {
        std::vector<SuccessorModule> word;
        std::vector<TextPlace> open;
        while (!reader.atEnd()) {
            SuccessorModule module{};
            module.place = reader.place();
            module.symbol = parseSymbol(reader);
            if (reader.accept("(")) {
                do module.numbers.push_back(compileExpression(reader.expression(), formals, m_values, m_rands));
                while (reader.accept(","));
                if (!reader.accept(")"))
                    failAt(module.place,
                         translated(NC_("stromar", "the bracket of this module's numbers is not closed")));
            }
            if (module.symbol == '[') open.push_back(module.place);
            if (module.symbol == ']') {
                if (open.empty()) failAt(module.place, translated(NC_("stromar", "there is no [ for this ]")));
                open.pop_back();
            }
            m_made.insert({module.symbol, module.numbers.size()});
            word.push_back(std::move(module));
        }
        if (!open.empty()) failAt(open.back(), translated(NC_("stromar", "there is no ] for this [")));
        return word;
    }

    std::vector<ModulePattern> parsePatterns(CLineReader& reader, std::vector<std::string>& formals) {
        std::vector<ModulePattern> patterns;
        while (!reader.atEnd() && !reader.seesArrow() && !reader.sees(":") && !reader.sees("<") && !reader.sees(">")) {
            ModulePattern pattern{parseSymbol(reader), 0, static_cast<std::uint16_t>(formals.size())};
            if (reader.accept("(")) {
                do {
                    const TextPlace place = reader.place();
                    formals.push_back(reader.name());
                    if (formals.back().empty() || isDigit(formals.back()[0]))
                        failAt(place, translated(NC_("stromar", "here stands the name of a parameter")));
                    ++pattern.numbers;
                } while (reader.accept(","));
                if (!reader.accept(")"))
                    failAt(reader.place(), translated(NC_("stromar", "expected ')' after the parameters")));
            }
            patterns.push_back(pattern);
        }
        return patterns;
    }

    /// "p1:"
    static void skipLabel(CLineReader& reader) {
        const std::size_t start = reader.at();
        if (reader.name().size() < 2 || !reader.accept(":")) reader.goTo(start);
    }

    void parseProduction(CLineReader& reader, const TextPlace& place) {
        skipLabel(reader);
        Production production{};
        production.condition = CExpression(1);
        production.place = place;
        m_rands = 0;
        std::vector<std::string> formals;
        std::vector<ModulePattern> first = parsePatterns(reader, formals);
        if (reader.accept("<")) {
            production.left = std::move(first);
            first = parsePatterns(reader, formals);
        }
        if (reader.accept(">")) production.right = parsePatterns(reader, formals);
        if (first.size() != 1)
            failAt(place, translated(NC_("stromar", "a production rewrites one module: A(x) : condition -> successor")));
        production.predecessor = first[0];
        if (formals.size() > kMaxFormals)
            failAt(place, translated(NC_("stromar", "a production has at most 32 parameters")));
        production.formals = static_cast<std::uint16_t>(formals.size());
        for (const std::vector<ModulePattern>* context : {&production.left, &production.right})
            for (const ModulePattern& pattern : *context)
                if (pattern.symbol == '[' || pattern.symbol == ']')
                    failAt(place, translated(NC_("stromar", "brackets in a context are not supported")));
        const auto compiled = [&](const ExpressionNode& tree) {
            return compileExpression(tree, formals, m_values, m_rands);
        };
        if (reader.accept(":")) {
            if (!reader.accept("*") && !reader.seesArrow()) production.condition = compiled(reader.expression());
            if (reader.accept(":")) production.probability = compiled(reader.expression());
        } else
            reader.accept("*");
        if (!reader.acceptArrow()) failAt(reader.place(), translated(NC_("stromar", "expected '->'")));
        if (reader.accept("(")) {
            production.probability = compiled(reader.expression());
            reader.expect(")");
        }
        production.successor = parseWord(reader, formals);
        for (const SuccessorModule& module : production.successor) production.numbers += module.numbers.size();
        production.heir = heirOf(production);
        m_grammar.productions.push_back(std::move(production));
    }

    static std::size_t heirOf(const Production& production) {
        const auto& successor = production.successor;
        std::size_t anywhere = successor.size();
        int depth = 0;
        for (std::size_t k = 0; k < successor.size(); ++k) {
            if (successor[k].symbol == '[') ++depth;
            if (successor[k].symbol == ']') --depth;
            if (successor[k].symbol != production.predecessor.symbol) continue;
            if (depth == 0) return k;
            anywhere = std::min(anywhere, k);
        }
        return anywhere;
    }

    void warnOfDeadProductions() {
        for (const Production& production : m_grammar.productions) {
            const ModulePattern& wanted = production.predecessor;
            if (m_made.contains({wanted.symbol, wanted.numbers})) continue;
            m_grammar.warnings.push_back(
                {Severity::Warning,
                 {},
                 production.place.line,
                 production.place.column,
                 translated(NC_("stromar", "this production never matches: no word has %1 with %2 numbers"),
                            symbolName(wanted.symbol), wanted.numbers)});
        }
    }

    std::string_view m_text;
    std::span<const NamedValue> m_others;
    std::vector<NamedValue> m_values;
    std::uint16_t m_rands = 0;
    std::set<std::pair<Symbol, std::size_t>> m_made; ///< modules that some word has
    Grammar m_grammar;
};
} // namespace

std::string symbolName(Symbol symbol) {
    if (symbol < kLeafSymbol) return std::string(1, static_cast<char>(symbol));
    return std::string("~") + kOrganLetters[static_cast<std::size_t>(symbol - kLeafSymbol)];
}

Grammar parseGrammar(std::string_view text, std::span<const NamedValue> defines) {
    return CGrammarParser(text, defines).parse();
}

} // namespace stromar
