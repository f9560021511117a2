#include "stromar/params/ParamText.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace stromar {

namespace {
struct KeyIndex {
    std::map<std::string, ParamRef, std::less<>> refs;
    std::vector<std::string> keys; ///< without aliases

    explicit KeyIndex(const ParamBlock& block) {
        for (const ParamRef& ref : allParams(block)) {
            keys.push_back(ref.key());
            refs.emplace(ref.key(), ref);
            const std::string digit = ref.info->perLevel() ? std::to_string(ref.level) : std::string();
            for (const std::string_view alias : ref.info->aliases) refs.emplace(digit + std::string(alias), ref);
        }
    }
};

const KeyIndex& keyIndex(const ParamBlock& block) {
    static std::mutex mutex;
    static std::map<const ParamBlock*, std::unique_ptr<const KeyIndex>> indices;
    const std::lock_guard lock(mutex);
    std::unique_ptr<const KeyIndex>& index = indices[&block];
    if (!index) index = std::make_unique<const KeyIndex>(block);
    return *index;
}

std::optional<double> wordValue(const ParamInfo& info, std::string_view value) {
    const auto word = std::ranges::find(info.words, lowerCase(value), lowerCase);
    if (word == info.words.end()) return {};
    return static_cast<double>(word - info.words.begin());
}

std::string notANumber(const ParamRef& ref, std::string_view value) {
    const ParamInfo& info = *ref.info;
    if (value.empty()) return translated(NC_("stromar", "%1 has no value"), ref.key());
    if (info.words.empty()) return translated(NC_("stromar", "%1 is not a number: '%2'"), ref.key(), value);
    const std::vector<std::string> words(info.words.begin(), info.words.end());
    return translated(NC_("stromar", "%1 has no choice '%2'"), ref.key(), value) + suggestion(value, words);
}

SetResult setNumber(CParams& params, const ParamRef& ref, std::string_view value, SetProblem& problem) {
    const ParamInfo& info = *ref.info;
    std::optional<double> number = wordValue(info, value);
    if (!number) number = parseNumber(value);
    if (!number) {
        problem.text = notANumber(ref, value);
        return SetResult::BadValue;
    }
    if (info.integer() && *number != std::floor(*number)) {
        problem.text = translated(NC_("stromar", "%1 must be a whole number, not %2"), ref.key(), value);
        return SetResult::BadValue;
    }
    if (ref.set(params, *number)) return SetResult::Done;
    problem.text = translated(NC_("stromar", "%1 must be from %2 to %3, not %4; taken as %5"), ref.key(),
                              info.range.min, info.range.max, value, ref.get(params));
    return SetResult::Clamped;
}

SetResult setCurve(CParams& params, const ParamRef& ref, std::string_view value, SetProblem& problem) {
    CCurve::Fault fault;
    const auto curve = CCurve::parse(value, fault);
    if (!curve) {
        problem = {ref.key() + ": " + fault.text, fault.at};
        return SetResult::BadValue;
    }
    if (ref.setValue(params, *curve)) return SetResult::Done;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < curve->points().size(); ++i, begin = value.find(',', begin) + 1) {
        const auto& [x, y] = curve->points()[i];
        const bool xFits = ref.info->over.contains(x);
        if (xFits && ref.info->range.contains(y)) continue;
        const Range& range = xFits ? ref.info->range : ref.info->over;
        problem.text =
            translated(NC_("stromar", "%1: the %2 of point %3 must be from %4 to %5, not %6; taken as the nearest"),
                       ref.key(), xFits ? "y" : "x", i + 1, range.min, range.max, xFits ? y : x);
        problem.at = value.find_first_not_of(" \t", begin);
        break;
    }
    return SetResult::Clamped;
}

/// Lines of valid UTF-8.
std::string plainBlock(std::string_view text) {
    std::string all;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        const bool ends = end != std::string_view::npos;
        std::string_view line = text.substr(begin, ends ? end - begin : end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        all += plainLine(line) + (ends ? "\n" : "");
        begin = ends ? end + 1 : text.size();
    }
    return all;
}

SetResult setText(CParams& params, const ParamRef& ref, std::string_view value, SetProblem& problem) {
    std::string text = ref.info->block ? plainBlock(value) : plainLine(value);
    for (std::size_t begin = 0; ref.info->block && begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (trimmed(std::string_view(text).substr(begin, end - begin)) == kBlockMark) {
            problem = {
                translated(NC_("stromar", "%1 must not hold a line of three quotes: it would end the text in a file"),
                           ref.key()),
                begin};
            return SetResult::BadValue;
        }
        begin = end + 1;
    }
    ref.setValue(params, std::move(text));
    return SetResult::Done;
}

bool needsQuotes(std::string_view text) {
    return text.empty() || trimmed(text) != text || text.find('#') != std::string_view::npos || text.starts_with('"');
}

std::string textValue(std::string_view value) {
    const std::string text = plainLine(value);
    if (!needsQuotes(text)) return text;
    std::string quotedText = "\"";
    for (const char c : text) quotedText += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quotedText + "\"";
}

std::string keyText(const ParamInfo& p) { return (p.perLevel() ? "n" : "") + std::string(p.key); }

std::string rangeText(const ParamInfo& p) {
    if (p.kind() == ParamKind::Text) return p.block ? "lines of text" : "text";
    if (p.kind() == ParamKind::Curve)
        return "curve: " + std::string(p.overLabel) + " " + numberText(p.over.min) + " … " + numberText(p.over.max) + ", value " +
               numberText(p.range.min) + " … " + numberText(p.range.max);
    if (p.words.empty()) return numberText(p.range.min) + " … " + numberText(p.range.max);
    std::string text;
    for (std::size_t i = 0; i < p.words.size(); ++i)
        text += (i ? ", " : "") + std::to_string(i) + " " + std::string(p.words[i]);
    return text;
}

/// The rows of a group as a page lists them: section by section.
std::vector<const ParamInfo*> rowsIn(const ParamBlock& block, const Group& group) {
    std::vector<const ParamInfo*> rows;
    for (const ParamPage& page : pagesOf(block))
        for (const ParamRef& ref : page.rows)
            if (ref.info->group == group && std::ranges::find(rows, ref.info) == rows.end()) rows.push_back(ref.info);
    return rows;
}

std::string titleOf(const Group& group) {
    return group == Group::Branches ? "Every level: 0 the trunk, 1–3 the branches" : std::string(group.name);
}
} // namespace

std::optional<ParamRef> findParam(std::string_view key, const ParamBlock& block) {
    const KeyIndex& index = keyIndex(block);
    const auto found = index.refs.find(key);
    return found == index.refs.end() ? std::nullopt : std::optional(found->second);
}

std::string keySuggestion(std::string_view key, const ParamBlock& block) {
    return suggestion(key, keyIndex(block).keys);
}

SetResult setFromText(CParams& params, const ParamRef& ref, std::string_view value, SetProblem& problem) {
    problem = {};
    switch (ref.info->kind()) {
    case ParamKind::Curve: return setCurve(params, ref, value, problem);
    case ParamKind::Text: return setText(params, ref, value, problem);
    default: return setNumber(params, ref, value, problem);
    }
}

std::string valueText(const CParams& params, const ParamRef& ref) {
    switch (ref.info->kind()) {
    case ParamKind::Curve: return ref.curve(params).text();
    case ParamKind::Text: return textValue(ref.text(params));
    default: return numberText(ref.get(params));
    }
}

std::string methodSuggestion(std::string_view method) {
    std::vector<std::string> known;
    std::string all;
    for (const ParamBlock* block : paramBlocks()) {
        known.emplace_back(block->method);
        all += (all.empty() ? "" : ", ") + known.back();
    }
    return suggestion(method, known) + " (" + translated(NC_("stromar", "known: %1"), all) + ")";
}

std::string_view kindName(const ParamInfo& info) {
    switch (info.kind()) {
    case ParamKind::Choice: return "choice";
    case ParamKind::Switch: return "switch";
    case ParamKind::Curve: return "curve";
    case ParamKind::Text: return "text";
    default: return info.integer() ? "integer" : "number";
    }
}

std::string defaultsText(const ParamInfo& p, const ParamBlock& block) {
    if (!p.numeric()) return p.block ? std::string() : std::string(p.defaultText);
    std::string text;
    for (int level = 0; level <= (p.perLevel() ? p.lastLevel() : 0); ++level)
        text += (level ? ", " : "") + (level < p.firstLevel ? std::string("–")
                                                            : numberText(std::get<double>(defaultOf({&p, level}, block))));
    return text;
}

namespace {
/// The pictures that `stromar --help-pictures` draws, two in a row below their names.
std::string pictureTable(const std::vector<const ParamInfo*>& rows) {
    std::vector<const ParamInfo*> shown;
    for (const ParamInfo* p : rows)
        if (p->numeric() && !p->unused() && p->group != Group::Textures) shown.push_back(p);
    if (shown.empty()) return {};
    std::string table = "\n| | |\n|---|---|\n";
    for (std::size_t i = 0; i < shown.size(); i += 2) {
        std::string names = "|", pictures = "|";
        for (std::size_t k = i; k < i + 2; ++k) {
            names += k < shown.size() ? " **" + std::string(shown[k]->label) + "** |" : " |";
            pictures += k < shown.size() ? " ![" + std::string(shown[k]->label) + "](images/parameters/" +
                                               shown[k]->keyOf(1) + ".png) |"
                                         : " |";
        }
        table += names + "\n" + pictures + "\n";
    }
    return table;
}
} // namespace

std::string paramsAsMarkdown(const ParamBlock& block) {
    const bool isFirst = &block == paramBlocks().front();
    const std::string method = isFirst ? std::string() : " --method " + std::string(block.method);
    std::string page = "# Parameters" + (isFirst ? std::string() : " of " + std::string(block.label) + "s") +
                       "\n\nWritten by `stromar-cli params" + method +
                       " --markdown`. Lengths are in metres, angles in degrees.";
    if (std::ranges::any_of(block.rows, &ParamInfo::perLevel))
        page += " `n` in a key stands for the level, 0 to 3;\nlevel 3 also serves all deeper ones, and the level after the "
                "last stems' one places the leaves.";
    page += "\n";
    for (const Group& group : block.groups) {
        const std::vector<const ParamInfo*> rows = rowsIn(block, group);
        if (rows.empty()) continue;
        page += "\n## " + titleOf(group) +
                "\n\n| Key | Name | Unit | Range | Default | Meaning |\n|---|---|---|---|---|---|\n";
        for (const ParamInfo* p : rows)
            page += "| `" + keyText(*p) + "` | " + std::string(p->label) + " | " + std::string(unitName(p->unit)) +
                    " | " + rangeText(*p) + " | " + defaultsText(*p, block) + " | " + std::string(p->help) + " |\n";
        page += pictureTable(rows);
    }
    return page;
}

std::string paramsAsText(const ParamBlock& block) {
    std::string page;
    const auto padded = [](std::string text, std::size_t width) {
        text.resize(std::max(width, text.size()), ' ');
        return text;
    };
    for (const Group& group : block.groups) {
        const std::vector<const ParamInfo*> rows = rowsIn(block, group);
        if (rows.empty()) continue;
        page += (page.empty() ? "" : "\n") + titleOf(group) + "\n";
        for (const ParamInfo* p : rows)
            page += "  " + padded(keyText(*p), 18) + padded(defaultsText(*p, block), 26) + std::string(p->help) + "\n";
    }
    return page;
}

} // namespace stromar
