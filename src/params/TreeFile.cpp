#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace stromar {

namespace {
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kFormatKey = "Format";
constexpr std::string_view kBlanks = " \t\r"; // what trimmed() takes away
constexpr std::size_t kMostBytes = 16u << 20;

/// Columns count characters, not bytes; a byte-order mark is none.
int columnOf(std::string_view line, std::size_t byte) {
    std::string_view head = line.substr(0, byte);
    if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
    return 1 + static_cast<int>(
                   std::ranges::count_if(head, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Why the bytes are no text of ours, or nothing.
std::optional<std::string> whyNotText(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    if (text.size() >= 11 && text.substr(4, 7) == "<Kraut>")
        return "this is a binary tree of the program Kraut, which uses the same file ending; it cannot be read here";
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "this is UTF-16 text; save it as UTF-8";
    const bool binary = std::ranges::any_of(text, [](char c) {
        return c == '\0' || (c > 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f');
    });
    if (binary || text.size() > kMostBytes) return "this is not a text file of parameters";
    if (std::ranges::all_of(text, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }))
        return "the file is empty";
    return {};
}

/// Finds where the comment of a line starts: '#' at the start or after white space, outside a quoted value.
std::size_t commentStart(std::string_view line, std::size_t from) {
    for (std::size_t i = from; i < line.size(); ++i)
        if (line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) return i;
    return line.size();
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

/// Reads the lines of one text; collects what is wrong.
class CTreeFile::CParser {
public:
    explicit CParser(std::string name) : m_name(std::move(name)) { m_file.m_name = m_name; }

    CTreeFile parse(std::string_view text) {
        if (const auto why = whyNotText(text))
            fail(0, 0, *why);
        else
            parseLines(text);
        if (!m_errors.empty()) throw CInputError(std::move(m_errors));
        if (!m_seen.contains(std::string(kFormatKey)))
            m_file.m_warnings.insert(m_file.m_warnings.begin(),
                                     {Severity::Warning, m_name, 0, 0, "no line 'Format = 1'; read as format 1"});
        return std::move(m_file);
    }

private:
    void parseLines(std::string_view text) {
        for (int number = 1; !text.empty(); ++number) {
            const std::size_t end = text.find('\n');
            const std::string_view raw = text.substr(0, end == std::string_view::npos ? text.size() : end + 1);
            text.remove_prefix(raw.size());
            m_file.m_lines.push_back(parseLine(raw, number));
        }
    }

    Line parseLine(std::string_view raw, int number) {
        Line line{std::string(raw), {}, 0, 0};
        const std::size_t mark = number == 1 && raw.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
        const std::string_view content = raw.substr(0, raw.find_last_not_of("\r\n") + 1);
        if (const std::size_t bad = firstInvalidUtf8(content); bad != std::string_view::npos) {
            fail(number, columnOf(content, bad), "this character is not UTF-8");
            return line;
        }
        const std::size_t start = content.find_first_not_of(" \t\f", mark);
        if (start == std::string_view::npos || content[start] == '#') return line;
        const std::size_t equals = content.substr(0, commentStart(content, start)).find('=', start);
        if (equals == std::string_view::npos) {
            const std::string_view word = content.substr(start, content.find_first_of(" \t", start) - start);
            fail(number, columnOf(content, start), "this line is not 'Key = Value'" + keySuggestion(word));
            return line;
        }
        line.key = trimmed(content.substr(start, equals - start));
        if (!findValue(content, equals + 1, number, line)) return line;
        takeValue(content, start, number, line);
        return line;
    }

    bool findValue(std::string_view content, std::size_t from, int number, Line& line) {
        std::size_t begin = content.find_first_not_of(kBlanks, from);
        if (begin == std::string_view::npos) begin = content.size();
        std::size_t end = 0;
        if (begin < content.size() && content[begin] == '"') {
            end = quoteEnd(content, begin);
            if (end == std::string_view::npos)
                return failed(number, columnOf(content, begin), "the quote is not closed");
            const std::size_t rest = content.find_first_not_of(" \t", end);
            if (rest != std::string_view::npos && content[rest] != '#')
                return failed(number, columnOf(content, rest), "nothing but a comment may follow the closing quote");
        } else {
            const std::size_t stop = std::max(commentStart(content, begin), begin);
            end = begin + trimmed(content.substr(begin, stop - begin)).size();
        }
        line.valueBegin = begin;
        line.valueEnd = end;
        return true;
    }

    void takeValue(std::string_view content, std::size_t keyStart, int number, const Line& line) {
        const int keyColumn = columnOf(content, keyStart), column = columnOf(content, line.valueBegin);
        if (line.key.empty()) return fail(number, keyColumn, "there is no key in front of '='");
        const std::string value = unquoted(content.substr(line.valueBegin, line.valueEnd - line.valueBegin));
        if (line.key == kFormatKey) return takeFormat(value, number, keyColumn, column);
        const auto target = findParam(line.key);
        if (!target) return warn(number, keyColumn, "unknown key '" + line.key + "' is kept" + keySuggestion(line.key));
        const std::string mainKey = std::holds_alternative<ParamRef>(*target)
                                        ? std::get<ParamRef>(*target).key()
                                        : std::string(std::get<const TextInfo*>(*target)->key);
        if (isSecond(mainKey, number, keyColumn)) return;
        std::string problem;
        switch (setFromText(m_file.m_params, *target, value, problem)) {
        case SetResult::Done: break;
        case SetResult::Clamped: warn(number, column, problem); break;
        case SetResult::BadValue: fail(number, column, problem); break;
        }
    }

    void takeFormat(const std::string& value, int number, int keyColumn, int column) {
        if (isSecond(std::string(kFormatKey), number, keyColumn)) return;
        const auto format = parseNumber(value);
        if (!format || *format < 1 || *format != std::floor(*format))
            return fail(number, column, "Format must be a whole number from 1, not '" + value + "'");
        if (*format > kFormat)
            fail(number, column,
                 "the file has format " + value + ", but this version reads only up to " + std::to_string(kFormat) +
                     "; a newer Stromar is needed");
    }

    bool isSecond(const std::string& key, int number, int column) {
        const auto [first, isNew] = m_seen.emplace(key, number);
        if (!isNew)
            fail(number, column,
                 "a second value for " + key + "; the first is in line " + std::to_string(first->second));
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
};

namespace {
/// The groups of a file as a writer lays them out: a heading and its values.
struct FileGroup {
    std::string heading;
    std::vector<ParamTarget> values;
};

std::string headingOf(const ParamRef& ref) {
    const std::string name(groupName(ref.group()));
    return ref.group() == Group::Branches ? name + " " + std::to_string(ref.level) : name;
}

std::vector<FileGroup> makeFileGroups() {
    std::vector<FileGroup> groups;
    for (const ParamRef& ref : allParams()) {
        if (groups.empty() || groups.back().heading != headingOf(ref)) groups.push_back({headingOf(ref), {}});
        groups.back().values.emplace_back(ref);
    }
    for (const TextInfo& text : textTable()) {
        const auto group = std::ranges::find(groups, groupName(text.group), &FileGroup::heading);
        const auto behindTexts =
            std::ranges::find_if(group->values, [](const ParamTarget& t) { return t.index() == 0; });
        group->values.insert(behindTexts, &text);
    }
    return groups;
}

const std::vector<FileGroup>& fileGroups() {
    static const std::vector<FileGroup> groups = makeFileGroups();
    return groups;
}

std::string keyOf(const ParamTarget& target) {
    if (const auto* ref = std::get_if<ParamRef>(&target)) return ref->key();
    return std::string(std::get<const TextInfo*>(target)->key);
}

bool differs(const CParams& a, const CParams& b, const ParamTarget& target) {
    return valueText(a, target) != valueText(b, target);
}

/// The last line with a value of the group, else the last of the file.
std::size_t lastLineOf(const FileGroup& group, const std::map<std::string, std::size_t>& lineOf,
                       std::size_t lineCount) {
    std::optional<std::size_t> last;
    for (const ParamTarget& target : group.values)
        if (const auto at = lineOf.find(keyOf(target)); at != lineOf.end())
            last = std::max(last.value_or(0), at->second);
    return last.value_or(lineCount - 1);
}

std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line;
    return all;
}

std::string newFileText(const CParams& params) {
    std::string text = "Format = " + std::to_string(CTreeFile::kFormat) + "\n";
    for (const FileGroup& group : fileGroups()) {
        text += "\n# " + group.heading + "\n";
        for (const ParamTarget& target : group.values) text += keyOf(target) + " = " + valueText(params, target) + "\n";
    }
    return text;
}
} // namespace

CTreeFile CTreeFile::read(const std::filesystem::path& path) {
    std::error_code unreadable; // reading says it better
    if (std::filesystem::is_directory(path, unreadable))
        throw CInputError({{Severity::Error, path.string(), 0, 0, "this is a folder, not a .tree file"}});
    return parse(readFile(path), path.string());
}

CTreeFile CTreeFile::parse(const std::string& text, const std::string& name) { return CParser(name).parse(text); }

Message CTreeFile::errorAt(const ParamTarget& target, std::string text) const {
    Message message{Severity::Error, m_name, 0, 0, std::move(text)};
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const auto found = m_lines[i].key.empty() ? std::nullopt : findParam(m_lines[i].key);
        if (!found || keyOf(*found) != keyOf(target)) continue;
        message.line = static_cast<int>(i) + 1;
        message.column = columnOf(m_lines[i].raw, m_lines[i].valueBegin);
    }
    return message;
}

std::string CTreeFile::text(const CParams& params) const {
    if (m_lines.empty()) return newFileText(params);
    std::vector<std::string> lines;
    std::map<std::string, std::size_t> lineOf;
    for (const Line& line : m_lines) {
        if (const auto target = line.key.empty() ? std::nullopt : findParam(line.key))
            lineOf[keyOf(*target)] = lines.size();
        lines.push_back(changedLine(line, params));
    }
    const std::string lineEnd = m_lines.front().raw.ends_with("\r\n") ? "\r\n" : "\n";
    for (const FileGroup& group : fileGroups()) {
        std::string& last = lines[lastLineOf(group, lineOf, lines.size())];
        for (const ParamTarget& target : group.values) {
            if (lineOf.contains(keyOf(target)) || !differs(params, m_params, target)) continue;
            if (!last.ends_with('\n')) last += lineEnd;
            last += keyOf(target) + " = " + valueText(params, target) + lineEnd;
        }
    }
    return joined(lines);
}

std::string CTreeFile::changedLine(const Line& line, const CParams& params) const {
    const auto target = line.key.empty() ? std::nullopt : findParam(line.key);
    if (!target || !differs(params, m_params, *target)) return line.raw;
    std::string value = valueText(params, *target);
    if (line.valueBegin == line.valueEnd) { // keep a blank to '=' and to a comment
        if (line.raw[line.valueBegin - 1] == '=') value.insert(0, " ");
        if (line.valueEnd < line.raw.size() && line.raw[line.valueEnd] == '#') value += " ";
    }
    return std::string(line.raw).replace(line.valueBegin, line.valueEnd - line.valueBegin, value);
}

CTreeFile CTreeFile::write(const std::filesystem::path& path, const CParams& params) const {
    const std::string content = text(params);
    writeFile(path, content);
    return parse(content, path.string());
}

} // namespace stromar
