#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace stromar {

namespace {
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kFormatKey = "Format", kMethodKey = "Method";
constexpr std::string_view kBlanks = " \t\r"; // what trimmed() takes away
constexpr std::size_t kMaxBytes = 16u << 20;

/// Columns count characters, not bytes; a byte-order mark is none.
int columnOf(std::string_view line, std::size_t byte) {
    std::string_view head = line.substr(0, byte);
    if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
    return 1 + static_cast<int>(
                   std::ranges::count_if(head, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// What a file of a method says, so that a reader that does not know the method refuses it.
int formatOf(const ParamBlock& block) { return &block == &weberPennBlock() ? 1 : CTreeFile::kFormat; }

/// Why the bytes are no text of ours, or nothing.
std::optional<std::string> whyNotText(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    if (text.size() >= 11 && text.substr(4, 7) == "<Kraut>")
        return translated(NC_("stromar", "this is a binary tree of the program Kraut, which uses the same file ending; it cannot be read here"));
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return translated(NC_("stromar", "this is UTF-16 text; save it as UTF-8"));
    const bool binary = std::ranges::any_of(text, [](char c) {
        return c == '\0' || (c > 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f');
    });
    if (binary || text.size() > kMaxBytes) return translated(NC_("stromar", "this is not a text file of parameters"));
    if (std::ranges::all_of(text, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }))
        return translated(NC_("stromar", "the file is empty"));
    return {};
}

/// Finds where the comment of a line starts: '#' at the start or after white space, outside a quoted value.
std::size_t commentStart(std::string_view line, std::size_t from) {
    for (std::size_t i = from; i < line.size(); ++i)
        if (line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) return i;
    return line.size();
}

std::string_view withoutEnding(std::string_view raw) { return raw.substr(0, raw.find_last_not_of("\r\n") + 1); }

/// Whether a line opens or closes a text of several lines with what is left of it: the mark, at most a comment.
bool isBlockMark(std::string_view rest) {
    rest = trimmed(withoutEnding(rest));
    if (!rest.starts_with(kBlockMark)) return false;
    rest = trimmed(rest.substr(kBlockMark.size()));
    return rest.empty() || rest.starts_with('#');
}

/// The line, with its ending, that a text begins with.
std::string_view firstLine(std::string_view text) {
    const std::size_t end = text.find('\n');
    return text.substr(0, end == std::string_view::npos ? text.size() : end + 1);
}

/// The bytes up to the end of the line that closes a text of several lines; npos when none does.
std::size_t blockLength(std::string_view text) {
    for (std::size_t length = 0; length < text.size();) {
        const std::string_view raw = firstLine(text.substr(length));
        length += raw.size();
        if (isBlockMark(raw)) return length;
    }
    return std::string_view::npos;
}

std::string_view keyOfLine(std::string_view content) {
    const std::size_t equals = content.find('=');
    return equals == std::string_view::npos ? std::string_view() : trimmed(content.substr(0, equals));
}

/// The end of a quoted text that begins at `begin` (behind its closing quote), or npos.
std::size_t quoteEnd(std::string_view line, std::size_t begin) {
    for (std::size_t i = begin + 1; i < line.size(); ++i) {
        if (line[i] != '"') continue;
        if (i + 1 < line.size() && line[i + 1] == '"')
            ++i;
        else
            return i + 1;
    }
    return std::string_view::npos;
}

std::string unquoted(std::string_view value) {
    if (!value.starts_with('"')) return std::string(value);
    std::string text;
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
        text += value[i];
        if (value[i] == '"') ++i;
    }
    return text;
}
} // namespace

std::string CTreeFile::Line::value() const {
    const std::string_view whole = std::string_view(raw).substr(valueBegin, valueEnd - valueBegin);
    if (!block) return unquoted(whole);
    std::string text;
    for (std::string_view rest = whole.substr(firstLine(whole).size()); !isBlockMark(firstLine(rest));) {
        const std::string_view line = firstLine(rest);
        text += (text.empty() && rest.data() == whole.data() + firstLine(whole).size() ? "" : "\n");
        text += withoutEnding(line);
        rest.remove_prefix(line.size());
    }
    return text;
}

std::pair<int, int> CTreeFile::Line::placeOf(std::size_t at) const {
    if (!block) return {number, columnOf(raw, valueBegin + at + (raw[valueBegin] == '"' ? 1 : 0))};
    const std::string text = value();
    const std::string_view before = std::string_view(text).substr(0, at);
    const std::size_t last = before.rfind('\n');
    const auto lines = static_cast<int>(std::ranges::count(before, '\n'));
    const std::string_view line = before.substr(last == std::string_view::npos ? 0 : last + 1);
    return {number + 1 + lines, columnOf(line, line.size())};
}

/// Reads the lines of one text; collects what is wrong.
class CTreeFile::CParser {
public:
    explicit CParser(std::string name) : m_name(std::move(name)) { m_file.m_name = m_name; }

    CTreeFile parse(std::string_view text) {
        if (const auto why = whyNotText(text))
            fail(0, 0, *why);
        else if (chooseMethod(text))
            parseLines(text);
        if (!m_errors.empty()) throw CInputError(std::move(m_errors));
        checkFormat();
        return std::move(m_file);
    }

private:
    /// The values that the file can have depend on its method, wherever that stands. False when it is not known.
    bool chooseMethod(std::string_view text) {
        for (int number = 1; !text.empty(); ++number) {
            const std::string_view raw = firstLine(text), content = withoutEnding(raw);
            text.remove_prefix(raw.size());
            const std::size_t equals = content.find('=');
            if (equals == std::string_view::npos || trimmed(content).starts_with('#')) continue;
            if (isBlockMark(content.substr(equals + 1))) {
                const std::size_t length = std::min(blockLength(text), text.size());
                number += static_cast<int>(std::ranges::count(text.substr(0, length), '\n'));
                text.remove_prefix(length);
            }
            std::string_view key = keyOfLine(content);
            if (key.starts_with(kByteOrderMark)) key.remove_prefix(kByteOrderMark.size());
            if (key != kMethodKey) continue;
            Line line{std::string(raw), number, std::string(kMethodKey)};
            if (!findValue(content, equals + 1, number, line)) return false;
            const ParamBlock* block = blockNamed(line.value());
            if (!block) return failed(number, columnOf(content, line.valueBegin), unknownMethod(line.value()));
            m_file.m_params = CParams(*block);
            return true;
        }
        return true;
    }

    static std::string unknownMethod(const std::string& method) {
        return translated(NC_("stromar", "this version cannot grow trees by the method '%1'"), method) + methodSuggestion(method);
    }

    void checkFormat() {
        const ParamBlock& block = m_file.m_params.block();
        const int wanted = formatOf(block);
        const std::string line = "'Format = " + std::to_string(wanted) + "'";
        Messages& warnings = m_file.m_warnings;
        const auto first = m_seen.find(std::string(kFormatKey));
        if (first == m_seen.end())
            warnings.insert(warnings.begin(), {Severity::Warning, m_name, 0, 0,
                                               translated(NC_("stromar", "no line %1; read as format %2"), line, wanted)});
        else if (m_format < wanted)
            warnings.insert(warnings.begin(),
                            {Severity::Warning, m_name, first->second, 1,
                             translated(NC_("stromar", "a file with the method '%1' says %2"), block.method, line)});
    }

    void parseLines(std::string_view text) {
        for (int number = 1; !text.empty();) {
            std::string_view raw = firstLine(text);
            if (opensBlock(withoutEnding(raw))) {
                const std::size_t length = blockLength(text.substr(raw.size()));
                if (length == std::string_view::npos)
                    return fail(number, columnOf(raw, raw.find(kBlockMark)),
                                translated(NC_("stromar", "the text is not closed: a line of three quotes is missing")));
                raw = text.substr(0, raw.size() + length);
                m_file.m_lines.push_back(parseBlock(raw, number));
            } else
                m_file.m_lines.push_back(parseLine(raw, number));
            text.remove_prefix(raw.size());
            number += static_cast<int>(std::ranges::count(raw, '\n'));
        }
    }

    /// A text of several lines: of rows that take some, and of keys that are not known.
    bool opensBlock(std::string_view content) const {
        const std::size_t equals = content.find('=');
        if (equals == std::string_view::npos || trimmed(content).starts_with('#')) return false;
        const auto ref = findParam(keyOfLine(content), m_file.m_params.block());
        return isBlockMark(content.substr(equals + 1)) && (!ref || ref->info->block);
    }

    Line parseBlock(std::string_view raw, int number) {
        Line line{std::string(raw), number, std::string(keyOfLine(firstLine(raw)))};
        for (std::string_view rest = raw; !rest.empty(); ++number) {
            const std::string_view content = firstLine(rest);
            if (const std::size_t bad = firstInvalidUtf8(content); bad != std::string_view::npos)
                fail(number, columnOf(content, bad), translated(NC_("stromar", "this character is not UTF-8")));
            rest.remove_prefix(content.size());
        }
        line.block = true;
        line.valueBegin = raw.find(kBlockMark);
        line.valueEnd = raw.rfind(kBlockMark) + kBlockMark.size();
        takeValue(firstLine(raw), raw.find_first_not_of(" \t\f"), line);
        return line;
    }

    Line parseLine(std::string_view raw, int number) {
        Line line{std::string(raw), number, {}};
        const std::size_t mark = number == 1 && raw.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
        const std::string_view content = withoutEnding(raw);
        if (const std::size_t bad = firstInvalidUtf8(content); bad != std::string_view::npos) {
            fail(number, columnOf(content, bad), translated(NC_("stromar", "this character is not UTF-8")));
            return line;
        }
        const std::size_t start = content.find_first_not_of(" \t\f", mark);
        if (start == std::string_view::npos || content[start] == '#') return line;
        const std::size_t equals = content.substr(0, commentStart(content, start)).find('=', start);
        if (equals == std::string_view::npos) {
            const std::string_view word = content.substr(start, content.find_first_of(" \t", start) - start);
            fail(number, columnOf(content, start),
                 translated(NC_("stromar", "this line is not 'Key = Value'")) + keySuggestion(word, m_file.m_params.block()));
            return line;
        }
        line.key = trimmed(content.substr(start, equals - start));
        if (!findValue(content, equals + 1, number, line)) return line;
        takeValue(content, start, line);
        return line;
    }

    bool findValue(std::string_view content, std::size_t from, int number, Line& line) {
        std::size_t begin = content.find_first_not_of(kBlanks, from);
        if (begin == std::string_view::npos) begin = content.size();
        std::size_t end = 0;
        if (begin < content.size() && content[begin] == '"') {
            end = quoteEnd(content, begin);
            if (end == std::string_view::npos)
                return failed(number, columnOf(content, begin), translated(NC_("stromar", "the quote is not closed")));
            const std::size_t rest = content.find_first_not_of(" \t", end);
            if (rest != std::string_view::npos && content[rest] != '#')
                return failed(number, columnOf(content, rest), translated(NC_("stromar", "nothing but a comment may follow the closing quote")));
        } else {
            const std::size_t stop = std::max(commentStart(content, begin), begin);
            end = begin + trimmed(content.substr(begin, stop - begin)).size();
        }
        line.valueBegin = begin;
        line.valueEnd = end;
        return true;
    }

    void takeValue(std::string_view content, std::size_t keyStart, const Line& line) {
        const int number = line.number, keyColumn = columnOf(content, keyStart);
        if (line.key.empty()) return fail(number, keyColumn, translated(NC_("stromar", "there is no key in front of '='")));
        const std::string value = line.value();
        if (line.key == kFormatKey) return takeFormat(value, number, keyColumn, columnOf(line.raw, line.valueBegin));
        if (line.key == kMethodKey) return static_cast<void>(isSecond(line.key, number, keyColumn));
        const ParamBlock& block = m_file.m_params.block();
        const auto ref = findParam(line.key, block);
        if (!ref) return warn(number, keyColumn, translated(NC_("stromar", "unknown key '%1' is kept"), line.key) + keySuggestion(line.key, block));
        if (isSecond(ref->key(), number, keyColumn)) return;
        SetProblem problem;
        const SetResult result = setFromText(m_file.m_params, *ref, value, problem);
        if (result == SetResult::Done) return;
        const auto [at, column] = ref->info->numeric() ? std::pair(number, columnOf(line.raw, line.valueBegin))
                                                       : line.placeOf(problem.at);
        if (result == SetResult::Clamped)
            warn(at, column, problem.text);
        else
            fail(at, column, problem.text);
    }

    void takeFormat(const std::string& value, int number, int keyColumn, int column) {
        if (isSecond(std::string(kFormatKey), number, keyColumn)) return;
        const auto format = parseNumber(value);
        if (!format || *format < 1 || *format != std::floor(*format))
            return fail(number, column, translated(NC_("stromar", "Format must be a whole number from 1, not '%1'"), value));
        m_format = static_cast<int>(*format);
        if (*format > kFormat)
            fail(number, column,
                 translated(NC_("stromar", "the file has format %1, but this version reads only up to %2; a newer Stromar is needed"), value, kFormat));
    }

    bool isSecond(const std::string& key, int number, int column) {
        const auto [first, isNew] = m_seen.emplace(key, number);
        if (!isNew)
            fail(number, column,
                 translated(NC_("stromar", "a second value for %1; the first is in line %2"), key, first->second));
        return !isNew;
    }

    void fail(int line, int column, std::string text) {
        m_errors.push_back({Severity::Error, m_name, line, column, std::move(text)});
    }
    bool failed(int line, int column, std::string text) {
        fail(line, column, std::move(text));
        return false;
    }
    void warn(int line, int column, std::string text) {
        m_file.m_warnings.push_back({Severity::Warning, m_name, line, column, std::move(text)});
    }

    std::string m_name;
    CTreeFile m_file;
    Messages m_errors;
    std::map<std::string, int> m_seen;
    int m_format = 1;
};

namespace {
std::string headingOf(const ParamPage& page) {
    const std::string name(page.group.name);
    return page.level > 0 ? name + " " + std::to_string(page.level) : name;
}

/// The value as a file holds it: perhaps several lines.
std::string writtenValue(const CParams& params, const ParamRef& ref, const std::string& lineEnd) {
    if (!ref.info->block || ref.text(params).empty()) return valueText(params, ref);
    std::string all = std::string(kBlockMark) + lineEnd;
    for (const char c : ref.text(params)) all += c == '\n' ? lineEnd : std::string(1, c);
    return all + lineEnd + std::string(kBlockMark);
}

/// In the letters that a file would have.
bool isChanged(const CParams& a, const CParams& b, const ParamRef& ref) {
    return ref.differs(a, b) && (ref.info->block || valueText(a, ref) != valueText(b, ref));
}

std::string writtenLine(const CParams& params, const ParamRef& ref, const std::string& lineEnd) {
    return ref.key() + " = " + writtenValue(params, ref, lineEnd) + lineEnd;
}

/// The last line with a value of the page, else the last of the file.
std::size_t lastLineOf(const ParamPage& page, const std::map<std::string, std::size_t>& lineOf,
                       std::size_t lineCount) {
    std::optional<std::size_t> last;
    for (const ParamRef& ref : page.rows)
        if (const auto at = lineOf.find(ref.key()); at != lineOf.end())
            last = std::max(last.value_or(0), at->second);
    return last.value_or(lineCount - 1);
}

std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line;
    return all;
}

std::string newFileText(const CParams& params) {
    std::string text = std::string(kFormatKey) + " = " + std::to_string(formatOf(params.block())) + "\n" +
                       std::string(kMethodKey) + " = " + std::string(params.block().method) + "\n";
    for (const ParamPage& page : pagesOf(params.block())) {
        text += "\n# " + headingOf(page) + "\n";
        for (const ParamRef& ref : page.rows) text += writtenLine(params, ref, "\n");
    }
    return text;
}
} // namespace

CTreeFile CTreeFile::read(const std::filesystem::path& path) {
    std::error_code unreadable; // reading says it better
    if (std::filesystem::is_directory(path, unreadable))
        throw CInputError({{Severity::Error, path.string(), 0, 0, translated(NC_("stromar", "this is a folder, not a .tree file"))}});
    CTreeFile file = parse(readFile(path), path.string());
    file.m_params.folder = path.parent_path();
    return file;
}

CTreeFile CTreeFile::parse(const std::string& text, const std::string& name) { return CParser(name).parse(text); }

ParamValues CTreeFile::givenValues() const {
    ParamValues values;
    for (const Line& line : m_lines)
        if (const auto ref = findParam(line.key, m_params.block())) values.emplace_back(*ref, ref->value(m_params));
    return values;
}

std::string CTreeFile::lines(const CParams& params, const std::vector<ParamRef>& refs) {
    std::string text;
    for (const ParamRef& ref : refs) text += writtenLine(params, ref, "\n");
    return text;
}

Message CTreeFile::errorAt(const ParamRef& ref, std::string text, std::size_t at) const {
    Message message{Severity::Error, m_name, 0, 0, std::move(text)};
    for (const Line& line : m_lines)
        if (const auto found = findParam(line.key, m_params.block()); found && *found == ref)
            std::tie(message.line, message.column) =
                ref.info->block ? line.placeOf(at) : std::pair(line.number, columnOf(line.raw, line.valueBegin));
    return message;
}

std::string CTreeFile::text(const CParams& params) const {
    const ParamBlock& block = params.block();
    if (m_lines.empty() || &block != &m_params.block()) return newFileText(params);
    std::vector<std::string> lines;
    std::map<std::string, std::size_t> lineOf;
    for (const Line& line : m_lines) {
        if (const auto ref = line.key.empty() ? std::nullopt : findParam(line.key, block))
            lineOf[ref->key()] = lines.size();
        lines.push_back(changedLine(line, params));
    }
    for (const ParamPage& page : pagesOf(block)) {
        std::string& last = lines[lastLineOf(page, lineOf, lines.size())];
        for (const ParamRef& ref : page.rows) {
            if (lineOf.contains(ref.key()) || !isChanged(params, m_params, ref)) continue;
            if (!last.ends_with('\n')) last += lineEnd();
            last += writtenLine(params, ref, lineEnd());
        }
    }
    return joined(lines);
}

std::string CTreeFile::lineEnd() const { return m_lines.front().raw.find("\r\n") != std::string::npos ? "\r\n" : "\n"; }

std::string CTreeFile::changedLine(const Line& line, const CParams& params) const {
    const auto ref = line.key.empty() ? std::nullopt : findParam(line.key, params.block());
    if (!ref || !isChanged(params, m_params, *ref)) return line.raw;
    std::string value = writtenValue(params, *ref, lineEnd());
    // A blank to '=' where the value was empty, and to a comment that stood right behind a quoted one.
    if (line.valueBegin == line.valueEnd && line.raw[line.valueBegin - 1] == '=') value.insert(0, " ");
    if (line.valueEnd < line.raw.size() && line.raw[line.valueEnd] == '#') value += " ";
    return std::string(line.raw).replace(line.valueBegin, line.valueEnd - line.valueBegin, value);
}

CTreeFile CTreeFile::write(const std::filesystem::path& path, const CParams& params) const {
    const std::string content = text(params);
    writeFile(path, content);
    return parse(content, path.string());
}

} // namespace stromar
