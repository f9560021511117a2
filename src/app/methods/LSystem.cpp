#include "LSystem.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/tree/lsystem/LSystemBuilder.h"
#include "stromar/tree/lsystem/TurtleStems.h"
#include "stromar/util/Translatable.h"
#include <algorithm>

namespace stromar {

namespace {
using Token = TextLanguage::Token;
constexpr std::size_t kShownModules = 400;
constexpr int kShownDigits = 4;
constexpr std::string_view kArrows[] = {"-->", "->", "\u2192", "\u27f6"};
constexpr std::string_view kDirectives[] = {"#define", "#ignore", "axiom", "\u03c9"};

bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Cuts a line of a grammar into what is coloured alike.
class CLineScanner {
public:
    CLineScanner(std::string_view line, bool& inComment) : m_line(line), m_inComment(inComment) {}

    std::vector<TextLanguage::Span> scan() {
        while (m_at < m_line.size()) step();
        return std::move(m_spans);
    }

private:
    std::string_view rest() const { return m_line.substr(m_at); }

    void take(std::size_t length, Token token) {
        m_spans.push_back({m_at, length, token});
        m_at += length;
    }
    template <typename Fits>
    std::size_t run(Fits&& fits) const {
        std::size_t end = m_at;
        while (end < m_line.size() && fits(m_line[end])) ++end;
        return end - m_at;
    }
    bool takeOneOf(std::span<const std::string_view> words, Token token) {
        for (const std::string_view word : words)
            if (rest().starts_with(word)) return take(word.size(), token), true;
        return false;
    }

    void takeBlockComment() {
        const std::size_t end = rest().find("*/", m_inComment ? 0 : 2);
        m_inComment = end == std::string_view::npos;
        take(m_inComment ? rest().size() : end + 2, Token::Comment);
    }
    bool startsLineComment() const {
        const bool blankBefore = m_at == 0 || m_line[m_at - 1] == ' ' || m_line[m_at - 1] == '\t';
        const bool blankBehind = m_at + 2 >= m_line.size() || m_line[m_at + 2] == ' ';
        return rest().starts_with("//") && blankBefore && (m_at == 0 || blankBehind);
    }

    void step() {
        const char c = m_line[m_at];
        if (m_inComment || rest().starts_with("/*")) return takeBlockComment();
        if (startsLineComment()) return take(rest().size(), Token::Comment);
        if (takeOneOf(kDirectives, Token::Directive) || takeOneOf(kArrows, Token::Arrow)) {
            m_inDefine = m_inDefine || m_line.substr(0, m_at).ends_with("#define");
            return;
        }
        if (c == '(' || c == ')') m_depth += c == '(' ? 1 : -1;
        if (isDigit(c)) return take(run([](char x) { return isDigit(x) || x == '.'; }), Token::Number);
        const bool isExpression = m_depth > 0 || m_inDefine;
        if (isLetter(c) && isExpression) return take(run([](char x) { return isLetter(x) || isDigit(x); }), Token::Name);
        if (c == '~') return take(std::min<std::size_t>(2, rest().size()), Token::Organ);
        if (c == '[' || c == ']') return take(1, Token::Bracket);
        if (!isExpression && kTurtleLetters.find(c) != std::string_view::npos) return take(1, Token::Turtle);
        ++m_at;
    }

    std::string_view m_line;
    bool& m_inComment;
    std::size_t m_at = 0;
    int m_depth = 0; ///< of parentheses
    bool m_inDefine = false;
    std::vector<TextLanguage::Span> m_spans;
};

std::vector<TextLanguage::Span> spansOf(std::string_view line, bool& inComment) {
    return CLineScanner(line, inComment).scan();
}

/// Nothing for a text that is wrong.
std::optional<Grammar> readGrammar(const std::string& text) {
    try {
        return parseGrammar(text);
    } catch (const CInputError&) {
        return {};
    }
}

std::vector<TextLanguage::Fault> faultsOf(const std::string& text) {
    std::vector<TextLanguage::Fault> faults;
    const auto add = [&](const Messages& messages) {
        for (const Message& m : messages) faults.push_back({m.severity, m.line, m.column, m.text});
    };
    try {
        add(parseGrammar(text).warnings);
    } catch (const CInputError& e) {
        add(e.messages());
    }
    return faults;
}

/// The names of defines are read from the lines themselves: the text may be wrong elsewhere.
std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words = expressionFunctions();
    for (const std::string_view word : {"#define", "#ignore", "axiom:"}) words.emplace_back(word);
    for (std::size_t organ = 0; organ < kOrgans.size(); ++organ) words.push_back(symbolName(static_cast<Symbol>(kLeafSymbol + organ)));
    constexpr std::string_view kDefine = "#define ";
    for (std::size_t at = text.find(kDefine); at != std::string::npos; at = text.find(kDefine, at + 1)) {
        const std::size_t start = text.find_first_not_of(' ', at + kDefine.size());
        std::size_t end = std::min(start, text.size());
        while (end < text.size() && (isLetter(text[end]) || isDigit(text[end]))) ++end;
        if (start < end) words.push_back(text.substr(start, end - start));
    }
    std::ranges::sort(words);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
}

std::vector<TextLanguage::Slider> slidersOf(const std::string& text) {
    std::vector<TextLanguage::Slider> sliders;
    if (const auto grammar = readGrammar(text))
        for (const GrammarDefine& define : grammar->defines)
            if (define.isNumber)
                sliders.push_back({define.name, define.words, define.value, define.low, define.high, define.offset, define.length});
    return sliders;
}

TextLanguage::Step stepOf(const CParams& params, int step, const CProgress& progress) {
    const Grammar grammar = grammarOf(params);
    const CWord word = wordOf(params, grammar, step, true, progress);
    TextLanguage::Step shown{word.text(0, kShownModules, kShownDigits), word.size() - std::min(word.size(), kShownModules), {}};
    const auto seed = static_cast<std::uint64_t>(static_cast<std::int64_t>(params.common.seed));
    const std::vector<std::size_t> applied = CRewriter(grammar, seed).applied(word, progress);
    for (std::size_t p = 0; p < applied.size(); ++p)
        if (applied[p] > 0) shown.applied.emplace_back(grammar.productions[p].place.line, applied[p]);
    std::ranges::sort(shown.applied);
    return shown;
}

const CTurtleGeneration& drawnGeneration(const CTree& tree, std::size_t generation) {
    return static_cast<const CTurtleGeneration&>(tree.generation(generation));
}

std::optional<int> lineOfStem(const CParams& params, const CTree& tree, std::size_t generation, std::size_t stem) {
    const auto grammar = readGrammar(lsystem(params).grammar);
    const CTurtleGeneration& drawn = drawnGeneration(tree, generation);
    const std::uint16_t writer = drawn.writers[drawn.stems[stem].firstSegment];
    if (!grammar) return {};
    if (writer == kNoProduction) return grammar->axiom.front().place.line;
    return writer < grammar->productions.size() ? std::optional(grammar->productions[writer].place.line) : std::nullopt;
}

std::vector<std::vector<std::uint32_t>> segmentsWrittenBy(const CParams& params, const CTree& tree, int line) {
    std::vector<std::vector<std::uint32_t>> written(tree.generationCount());
    const auto grammar = readGrammar(lsystem(params).grammar);
    if (!grammar) return written;
    const auto isOfLine = [&](std::uint16_t writer) {
        if (writer == kNoProduction) return grammar->axiom.front().place.line == line;
        return writer < grammar->productions.size() && grammar->productions[writer].place.line == line;
    };
    for (std::size_t g = 0; g < written.size(); ++g) {
        const auto& writers = drawnGeneration(tree, g).writers;
        for (std::uint32_t s = 0; s < writers.size(); ++s)
            if (isOfLine(writers[s])) written[g].push_back(s);
    }
    return written;
}

constexpr TextLanguage kLanguage{
    .key = "Grammar",
    .suffix = "l",
    .files = N_("L-systems (*.l *.lsys)"),
    .spans = &spansOf,
    .words = &wordsOf,
    .faults = &faultsOf,
    .sliders = &slidersOf,
    .step = &stepOf,
    .steps = "Derivations",
    .lineOf = &lineOfStem,
    .writtenBy = &segmentsWrittenBy,
};
} // namespace

const TextLanguage& lsystemLanguage() { return kLanguage; }

} // namespace stromar
