#include "stromar/app/Import.h"
#include "ForeignFile.h"
#include "stromar/params/ParamText.h"
#include "stromar/params/ParamTable.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <cctype>
#include <cmath>

namespace stromar {

/// How the files of a program are read.
struct ForeignReader {
    ForeignValues (*read)(const ForeignText&);
    bool (*knows)(const ForeignValues&); ///< whether values are of this program
    ForeignRest finish;
};

namespace {
bool hasOne(const ForeignValues& values, std::initializer_list<const char*> keys) {
    return std::ranges::any_of(keys, [&](const char* key) { return valueOf(values, key) != nullptr; });
}

constexpr ForeignReader kArbaro{readArbaro, [](const ForeignValues&) { return true; }, finishArbaro};
constexpr ForeignReader kSapling{readLiterals, [](const ForeignValues& values) { return hasOne(values, {"ratioPower", "curveRes"}); }, finishSapling};
constexpr ForeignReader kTreeGen{readLiterals, [](const ForeignValues& values) { return hasOne(values, {"g_scale", "ratio_power", "curve_res"}); }, finishTreeGen};

const ImportFormat kFormats[] = {
    {"arbaro", N_("Arbaro, XML"), ".xml", kArbaroRows, &kArbaro},
    {"sapling", N_("Sapling Tree Gen of Blender, presets"), ".py", kSaplingRows, &kSapling},
    {"tree-gen", N_("tree-gen of Blender, presets"), ".py .json", kTreeGenRows, &kTreeGen},
};

/// Fills a tree with the values of a file and gathers what is lost.
class CImporter {
public:
    CImporter(const ForeignText& text, const ForeignValues& values, const ImportFormat& format) : m_text(text), m_values(values), m_format(format) {}

    ImportedTree run(ForeignRest finish) {
        for (const ForeignValue& value : m_values)
            if (value.key != "species") take(value);
        finish(m_values, m_tree.params);
        for (const ParamRef& ref : numberParams()) ref.set(m_tree.params, ref.get(m_tree.params)); // keeps to its range
        m_tree.format = &m_format;
        return std::move(m_tree);
    }

private:
    void note(const ForeignValue& value, const std::string& said) { m_tree.notes.push_back(m_text.message(Severity::Warning, value.at, said)); }

    /// "nCurve" stands for "curve" with a list, and for "2Curve".
    const ImportRow* rowOf(const ForeignValue& value, int& level) const {
        level = -1;
        for (const ImportRow& row : m_format.rows)
            if (row.foreign == value.key) return &row;
        for (const ImportRow& row : m_format.rows) {
            if (!row.foreign.starts_with('n')) continue;
            const std::string_view name = row.foreign.substr(1);
            if (value.key.size() == name.size() + 1 && std::isdigit(static_cast<unsigned char>(value.key[0])) && value.key.ends_with(name)) {
                level = value.key[0] - '0';
                return &row;
            }
            if (lowerCase(name.substr(0, 1)) + std::string(name.substr(1)) == value.key) return &row;
        }
        return nullptr;
    }

    void take(const ForeignValue& value) {
        int level = -1;
        const ImportRow* row = rowOf(value, level);
        if (!row) return note(value, translated(NC_("stromar", "'%1' is not known and left out"), value.key));
        if (row->ours.empty()) {
            if (!row->note.empty() && !isNeutral(value, *row)) note(value, translated(NC_("stromar", "'%1' cannot be had: %2"), value.key, translated(row->note)));
            return;
        }
        const bool perLevel = row->ours.starts_with('n');
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            const int at = level >= 0 ? level : static_cast<int>(i);
            if (perLevel && at >= kParamLevels) break;
            const std::string key = perLevel ? std::to_string(at) + std::string(row->ours.substr(1)) : std::string(row->ours);
            if (const auto ref = findParam(key, m_tree.params.block())) set(*ref, value, i, *row); // the trunk has fewer
            if (!perLevel) break;
        }
    }

    void set(const ParamRef& ref, const ForeignValue& value, std::size_t item, const ImportRow& row) {
        const auto theirs = value.number(item);
        if (!theirs) return note(value, translated(NC_("stromar", "'%1' wants a number, not '%2'; it is left out"), value.key, value.items[item]));
        const double ours = row.value ? row.value(*theirs) : *theirs;
        if (!row.note.empty() && ours != *theirs && *theirs != row.neutral)
            note(value, translated(NC_("stromar", "'%1' becomes %2 = %3: %4"), value.key, ref.key(), numberText(ours), translated(row.note)));
        if (!ref.set(m_tree.params, ours))
            note(value, translated(NC_("stromar", "%1 is %2: %3 is out of its range"), ref.key(), ref.get(m_tree.params), ours));
    }

    static bool isNeutral(const ForeignValue& value, const ImportRow& row) {
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            const auto number = value.number(i);
            if (number ? std::abs(*number - row.neutral) > 1e-6 : value.items[i] != "False" && value.items[i] != "None" && value.items[i] != "false") return false;
        }
        return true;
    }

    const ForeignText& m_text;
    const ForeignValues& m_values;
    const ImportFormat& m_format;
    ImportedTree m_tree{CParams(), nullptr, {}};
};

/// "quaking_aspen" → "Quaking aspen".
std::string speciesOf(const ForeignValues& values, const std::string& name) {
    const ForeignValue* given = valueOf(values, "species");
    std::string species = given && !given->items[0].empty() ? given->items[0] : std::filesystem::path(name).stem().string();
    std::ranges::replace(species, '_', ' ');
    if (!species.empty()) species[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(species[0])));
    return plainLine(species);
}
} // namespace

std::optional<double> ForeignValue::number(std::size_t item) const {
    if (item >= items.size()) return {};
    if (items[item] == "True" || items[item] == "true") return 1;
    if (items[item] == "False" || items[item] == "false") return 0;
    return parseNumber(items[item]);
}

Message ForeignText::message(Severity severity, std::size_t at, std::string said) const {
    at = std::min(at, text.size());
    const auto line = static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) + 1;
    const std::size_t start = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    return {severity, name, line, static_cast<int>(start == std::string::npos ? at : at - start - 1) + 1, plainLine(said)};
}

std::span<const ImportFormat> importTable() { return kFormats; }

bool mayImport(const std::filesystem::path& file) {
    const std::string ending = lowerCase(file.extension().string());
    return !ending.empty() && std::ranges::any_of(kFormats, [&](const ImportFormat& format) { return (std::string(format.endings) + " ").find(ending + " ") != std::string::npos; });
}

ImportedTree parseForeign(const std::string& text, const std::string& name) {
    const ForeignText source{text, name};
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    const bool xml = first != std::string::npos && text[first] == '<';
    const ForeignValues values = xml ? readArbaro(source) : readLiterals(source);
    for (const ImportFormat& format : kFormats) {
        const ForeignReader& reader = *format.reader;
        if ((reader.read == readArbaro) != xml || !reader.knows(values)) continue;
        ImportedTree tree = CImporter(source, values, format).run(reader.finish);
        tree.params.text.species = speciesOf(values, name);
        tree.params.text.description = "Imported from " + std::string(format.name.substr(0, format.name.find(','))) + ".";
        return tree;
    }
    source.fail(0, translated(NC_("stromar", "these are no values of a tree that is known here")));
}

ImportedTree importTree(const std::filesystem::path& file) {
    if (std::error_code problem; std::filesystem::file_size(file, problem) > kMaxForeignBytes && !problem)
        throw CError(translated(NC_("stromar", "%1: a file of more than 1 MB is no preset of a tree"), file.string()));
    return parseForeign(readFile(file), file.string());
}

} // namespace stromar
