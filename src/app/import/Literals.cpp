#include "ForeignFile.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <cctype>

namespace stromar {

namespace {
constexpr int kMaxDepth = 16;
constexpr std::size_t kMaxItems = 10'000;

/// Reads literals one after the other; never more than the text holds.
class CLiteralParser {
public:
    explicit CLiteralParser(const ForeignText& source) : m_source(source), m_text(source.text) {}

    ForeignValues read() {
        if (m_text.starts_with("\xEF\xBB\xBF")) m_at = 3;
        skipTexts();
        skipName();
        if (!take('{')) fail(translated(NC_("stromar", "a dictionary {…} with the values of a tree is wanted here")));
        readPairs(1, true);
        skipBlank();
        if (m_at < m_text.size()) fail(translated(NC_("stromar", "nothing but comments may follow the values")));
        return std::move(m_values);
    }

private:
    [[noreturn]] void fail(std::string why) const { m_source.fail(std::min(m_at, m_text.size()), std::move(why)); }
    char here() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }

    void skipBlank() {
        for (; m_at < m_text.size(); ++m_at) {
            if (here() == '#')
                m_at = std::min(m_text.find('\n', m_at), m_text.size() - 1);
            else if (!std::isspace(static_cast<unsigned char>(here())))
                return;
        }
    }
    bool take(char c) {
        skipBlank();
        if (here() != c || m_at >= m_text.size()) return false;
        ++m_at;
        return true;
    }

    /// A text that stands by itself is a comment.
    void skipTexts() {
        for (skipBlank(); here() == '"' || here() == '\''; skipBlank()) readText();
    }
    void skipName() {
        const std::size_t start = m_at;
        while (std::isalnum(static_cast<unsigned char>(here())) || here() == '_') ++m_at;
        if (m_at > start && !take('=')) fail(translated(NC_("stromar", "'=' is wanted behind the name")));
    }

    std::string readText() {
        const char quote = here();
        const std::string triple(3, quote);
        const std::size_t start = m_at;
        if (m_text.compare(m_at, 3, triple) == 0) {
            const std::size_t end = m_text.find(triple, m_at + 3);
            if (end == std::string::npos) fail(translated(NC_("stromar", "this text is not closed")));
            m_at = end + 3;
            return m_text.substr(start + 3, end - start - 3);
        }
        std::string text;
        for (++m_at; m_at < m_text.size() && here() != quote && here() != '\n'; ++m_at) {
            if (here() == '\\' && m_at + 1 < m_text.size()) ++m_at;
            text += here();
        }
        if (here() != quote || m_at >= m_text.size()) {
            m_at = start;
            fail(translated(NC_("stromar", "this text is not closed")));
        }
        ++m_at;
        return text;
    }

    /// A number or a word.
    std::string readWord() {
        const std::size_t start = m_at;
        while (std::isalnum(static_cast<unsigned char>(here())) || here() == '_' || here() == '.' || here() == '-' || here() == '+') ++m_at;
        const std::string word = m_text.substr(start, m_at - start);
        constexpr std::string_view kWords[] = {"True", "False", "None", "true", "false", "null"};
        if (!parseNumber(word) && std::ranges::find(kWords, word) == std::end(kWords)) {
            m_at = start;
            fail(word.empty()
                     ? translated(NC_("stromar", "a value is wanted here"))
                     : translated(NC_("stromar",
                                      "'%1' is no value: only numbers, texts, True, False, None and lists are read"),
                                  word));
        }
        return word;
    }

    /// Lists in lists become one.
    void readItems(char close, ForeignValue& value, int depth) {
        value.list = true;
        while (!take(close)) {
            readValue(value, depth);
            if (take(',')) continue;
            if (!take(close))
                fail(translated(NC_("stromar", "'%1' or '%2' is wanted here"), ",", std::string(1, close)));
            return;
        }
    }

    void readValue(ForeignValue& value, int depth) {
        if (depth > kMaxDepth) fail(translated(NC_("stromar", "lists are nested too deep")));
        if (value.items.size() > kMaxItems) fail(translated(NC_("stromar", "this list is too long")));
        skipBlank();
        if (take('[')) return readItems(']', value, depth + 1);
        if (take('(')) return readItems(')', value, depth + 1);
        if (take('{')) return readPairs(depth + 1, false);
        value.items.push_back(here() == '"' || here() == '\'' ? readText() : readWord());
    }

    void readPairs(int depth, bool kept) {
        if (depth > kMaxDepth) fail(translated(NC_("stromar", "dictionaries are nested too deep")));
        while (!take('}')) {
            ForeignValue value;
            skipBlank();
            value.at = m_at;
            if (here() != '"' && here() != '\'') fail(translated(NC_("stromar", "a name in quotes is wanted here")));
            value.key = readText();
            if (!take(':')) fail(translated(NC_("stromar", "':' is wanted here")));
            readValue(value, depth);
            if (kept || depth == 2) m_values.push_back(std::move(value)); // some keep theirs one deeper
            if (take(',')) continue;
            if (!take('}')) fail(translated(NC_("stromar", "'%1' or '%2' is wanted here"), ",", "}"));
            return;
        }
    }

    const ForeignText& m_source;
    const std::string& m_text;
    std::size_t m_at = 0;
    ForeignValues m_values;
};
} // namespace

ForeignValues readLiterals(const ForeignText& text) { return CLiteralParser(text).read(); }

} // namespace stromar
