#include "stromar/params/ParamText.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace stromar {

namespace {
struct KeyIndex {
    std::map<std::string, ParamTarget, std::less<>> targets;
    std::vector<std::string> keys; ///< without aliases
};

KeyIndex makeIndex() {
    KeyIndex index;
    for (const ParamRef& ref : allParams()) {
        index.keys.push_back(ref.key());
        index.targets.emplace(ref.key(), ref);
        const std::string digit = ref.info->perLevel() ? std::to_string(ref.level) : std::string();
        for (const std::string_view alias : ref.info->aliases) index.targets.emplace(digit + std::string(alias), ref);
    }
    for (const TextInfo& text : textTable()) {
        index.keys.emplace_back(text.key);
        index.targets.emplace(std::string(text.key), &text);
    }
    return index;
}

const KeyIndex& keyIndex() {
    static const KeyIndex index = makeIndex();
    return index;
}

std::optional<double> wordValue(const ParamInfo& info, std::string_view value) {
    const auto word = std::ranges::find(info.words, lowerCase(value));
    if (word == info.words.end()) return {};
    return static_cast<double>(word - info.words.begin());
}

std::string quoted(std::string_view value) { return "'" + std::string(value) + "'"; }

std::string notANumber(const ParamInfo& info, std::string_view value) {
    if (value.empty()) return "has no value";
    if (info.words.empty()) return "is not a number: " + quoted(value);
    const std::vector<std::string> words(info.words.begin(), info.words.end());
    return "has no choice " + quoted(value) + suggestion(value, words);
}

SetResult setNumber(CParams& params, const ParamRef& ref, std::string_view value, std::string& problem) {
    const ParamInfo& info = *ref.info;
    std::optional<double> number = wordValue(info, value);
    if (!number) number = parseNumber(value);
    if (!number) {
        problem = ref.key() + " " + notANumber(info, value);
        return SetResult::BadValue;
    }
    if (info.integer() && *number != std::floor(*number)) {
        problem = ref.key() + " must be a whole number, not " + std::string(value);
        return SetResult::BadValue;
    }
    if (ref.set(params, *number)) return SetResult::Done;
    problem = ref.key() + " must be from " + numberText(info.range.min) + " to " + numberText(info.range.max) +
              ", not " + std::string(value) + "; taken as " + numberText(ref.get(params));
    return SetResult::Clamped;
}

SetResult setText(CParams& params, const TextInfo& text, std::string_view value, std::string& problem) {
    if (text.field == &TextParams::method && std::ranges::find(treeMethods(), value) == treeMethods().end()) {
        const std::vector<std::string> known(treeMethods().begin(), treeMethods().end());
        problem = "this version cannot grow trees by the method " + quoted(value) + suggestion(value, known);
        return SetResult::BadValue;
    }
    params.text.*text.field = plainLine(value);
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

/// "0.5", or "0.5, 0.5, 0.3, 0.3" for rows with a value per level, "–" where the trunk has none.
std::string defaultsText(const ParamInfo& p) {
    std::string text;
    for (int level = 0; level <= p.lastLevel(); ++level)
        text += (level ? ", " : "") + (level < p.firstLevel ? std::string("–") : numberText(p.defaultOf(level)));
    return text;
}

std::string keyText(const ParamInfo& p) { return (p.perLevel() ? "n" : "") + std::string(p.key); }

std::string rangeText(const ParamInfo& p) {
    if (p.words.empty()) return numberText(p.range.min) + " … " + numberText(p.range.max);
    std::string text;
    for (std::size_t i = 0; i < p.words.size(); ++i)
        text += (i ? ", " : "") + std::to_string(i) + " " + std::string(p.words[i]);
    return text;
}

template <typename Row>
void forEachGroup(Row&& row) {
    for (const Group group : kGroups) row(group);
}

std::string groupTitle(Group group) {
    return group == Group::Branches ? "Every level: 0 the trunk, 1–3 the branches" : std::string(groupName(group));
}
} // namespace

std::optional<ParamTarget> findParam(std::string_view key) {
    const auto found = keyIndex().targets.find(key);
    return found == keyIndex().targets.end() ? std::nullopt : std::optional(found->second);
}

std::string keySuggestion(std::string_view key) { return suggestion(key, keyIndex().keys); }

SetResult setFromText(CParams& params, const ParamTarget& target, std::string_view value, std::string& problem) {
    if (const auto* ref = std::get_if<ParamRef>(&target)) return setNumber(params, *ref, value, problem);
    return setText(params, *std::get<const TextInfo*>(target), value, problem);
}

std::string valueText(const CParams& params, const ParamTarget& target) {
    if (const auto* ref = std::get_if<ParamRef>(&target)) return numberText(ref->get(params));
    return textValue(params.text.*std::get<const TextInfo*>(target)->field);
}

namespace {
/// The pictures that `stromar --help-pictures` draws, two in a row below their names.
std::string pictureTable(Group group) {
    std::vector<const ParamInfo*> shown;
    for (const ParamInfo& p : paramTable())
        if (p.group == group && !p.unused() && group != Group::Textures) shown.push_back(&p);
    if (shown.empty()) return {};
    std::string rows = "\n| | |\n|---|---|\n";
    for (std::size_t i = 0; i < shown.size(); i += 2) {
        std::string names = "|", pictures = "|";
        for (std::size_t k = i; k < i + 2; ++k) {
            names += k < shown.size() ? " **" + std::string(shown[k]->label) + "** |" : " |";
            pictures += k < shown.size() ? " ![" + std::string(shown[k]->label) + "](images/parameters/" +
                                               shown[k]->keyOf(1) + ".png) |"
                                         : " |";
        }
        rows += names + "\n" + pictures + "\n";
    }
    return rows;
}
} // namespace

std::string paramsAsMarkdown() {
    std::string page =
        "# Parameters\n\n"
        "Written by `stromar-cli params --markdown`. Lengths are in metres, angles in degrees. `n` in a key "
        "stands for the level, 0 to 3;\nlevel 3 also serves all deeper ones, and the level after the last "
        "stems' one places the leaves.\n";
    forEachGroup([&](Group group) {
        page += "\n## " + groupTitle(group) +
                "\n\n| Key | Name | Unit | Range | Default | Meaning |\n|---|---|---|---|---|---|\n";
        for (const ParamInfo& p : paramTable())
            if (p.group == group)
                page += "| `" + keyText(p) + "` | " + std::string(p.label) + " | " + std::string(unitName(p.unit)) +
                        " | " + rangeText(p) + " | " + defaultsText(p) + " | " + std::string(p.help) + " |\n";
        for (const TextInfo& t : textTable())
            if (t.group == group)
                page += "| `" + std::string(t.key) + "` | " + std::string(t.label) + " | | text | | " +
                        std::string(t.help) + " |\n";
        page += pictureTable(group);
    });
    return page;
}

std::string paramsAsText() {
    std::string page;
    const auto padded = [](std::string text, std::size_t width) {
        text.resize(std::max(width, text.size()), ' ');
        return text;
    };
    forEachGroup([&](Group group) {
        page += (page.empty() ? "" : "\n") + groupTitle(group) + "\n";
        for (const ParamInfo& p : paramTable())
            if (p.group == group)
                page += "  " + padded(keyText(p), 18) + padded(defaultsText(p), 26) + std::string(p.help) + "\n";
        for (const TextInfo& t : textTable())
            if (t.group == group) page += "  " + padded(std::string(t.key), 44) + std::string(t.help) + "\n";
    });
    return page;
}

} // namespace stromar
