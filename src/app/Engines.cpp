#include "stromar/app/Engines.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <sstream>
#include <vector>

namespace stromar {

namespace {
constexpr std::string_view kEngineKey = "for", kFormatKey = "format";

constexpr ChosenValue kUnreal[] = {{"lods", "file-each"}, {"objects", "materials"}, {"packed-maps", "orm"}, {"occlusion", "none"}, {"wind", "pivot-painter"}, {"collision", "unreal"}};
constexpr ChosenValue kUnity[] = {{"lods", "file-each"}, {"objects", "materials"}, {"packed-maps", "unity"}, {"occlusion", "none"}};
constexpr ChosenValue kGodot[] = {{"lods", "file-each"}, {"objects", "materials"}, {"packed-maps", "orm"}, {"occlusion", "none"}, {"collision", "godot"}};
constexpr ChosenValue kThree[] = {{"lods", "file-each"}, {"objects", "materials"}, {"texture-size", "512"}, {"occlusion", "none"}};

constexpr Engine kEngines[] = {
    {"unreal", N_("Unreal Engine"), ".glb", kUnreal,
     N_("Import the LOD0 file, then the others in the mesh editor under Level Of Detail; the pictures of pivots go to the material function "
        "PivotPainter2FoliageShader.")},
    {"unity", N_("Unity"), ".glb", kUnity,
     N_("With the package glTFast; put the four objects under one with an LOD Group; the mask maps beside the file belong into the HDRP material.")},
    {"godot", N_("Godot"), ".glb", kGodot, N_("Give each of the four meshes a visibility range.")},
    {"blender", N_("Blender"), ".glb", {}, N_("The attribute _OCCLUSION can be mixed into the material.")},
    {"three", N_("three.js"), ".glb", kThree, N_("Add the four scenes to one THREE.LOD.")},
};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// One line of a settings file.
struct Line {
    std::string_view key, value;
    int number, keyColumn, valueColumn;
};

std::string enginesText() {
    std::string all;
    for (const Engine& engine : kEngines) all += (all.empty() ? "" : ", ") + std::string(engine.key);
    return all;
}

/// Reads a text line by line and gathers what is wrong.
class CSettingsParser {
public:
    CSettingsParser(const std::string& text, std::string name) : m_name(std::move(name)) {
        std::istringstream stream(text);
        int number = 0;
        for (std::string line; std::getline(stream, line);) m_texts.push_back(std::move(line));
        for (const std::string& line : m_texts) split(line, ++number);
    }

    ExportSettings read() {
        for (const Line& line : m_lines) // whatever follows stands on top of it
            if (line.key == kEngineKey) takeEngine(line);
        for (const Line& line : m_lines)
            if (line.key != kEngineKey) take(line);
        std::ranges::stable_sort(m_errors, {}, &Message::line);
        if (!m_errors.empty()) throw CInputError(std::move(m_errors));
        return m_settings;
    }

private:
    void split(std::string_view line, int number) {
        const std::string_view said = trimmed(line.substr(0, line.find('#')));
        if (said.empty()) return;
        const auto columnOf = [&](std::string_view part) { return static_cast<int>(part.data() - line.data()) + 1; };
        const std::size_t equals = said.find('=');
        if (equals == std::string_view::npos) return fail(number, columnOf(said), "a line says 'key = value'");
        const std::string_view key = trimmed(said.substr(0, equals)), value = trimmed(said.substr(equals + 1));
        m_lines.push_back({key, value, number, columnOf(said), value.empty() ? columnOf(said) + static_cast<int>(equals) + 1 : columnOf(value)});
    }

    void fail(int line, int column, std::string text) { m_errors.push_back({Severity::Error, m_name, line, column, std::move(text)}); }

    void takeEngine(const Line& line) {
        if (const Engine* engine = engineNamed(line.value))
            m_settings = settingsFor(*engine);
        else
            fail(line.number, line.valueColumn, "'for' is one of " + enginesText() + ", not '" + std::string(line.value) + "'");
    }

    void take(const Line& line) {
        try {
            if (line.key != kFormatKey) return setChoice(m_settings.options, line.key, line.value);
            if (!formatOf(std::filesystem::path("model" + std::string(line.value)))) throw CError(unknownFormat("model" + std::string(line.value)));
            m_settings.ending = line.value;
        } catch (const CError& e) {
            fail(line.number, std::ranges::find(exportChoices(), line.key, &ExportChoice::key) == exportChoices().end() && line.key != kFormatKey
                                  ? line.keyColumn
                                  : line.valueColumn,
                 e.what());
        }
    }

    std::string m_name;
    std::vector<std::string> m_texts;
    std::vector<Line> m_lines;
    Messages m_errors;
    ExportSettings m_settings;
};
} // namespace

std::span<const Engine> engineTable() { return kEngines; }

const Engine* engineNamed(std::string_view key) {
    const auto found = std::ranges::find(kEngines, key, &Engine::key);
    return found == std::end(kEngines) ? nullptr : found;
}

ExportSettings settingsFor(const Engine& engine) {
    ExportSettings settings{std::string(engine.key), std::string(engine.ending), {}};
    for (const ChosenValue& chosen : engine.values) setChoice(settings.options, chosen.key, chosen.value);
    return settings;
}

std::string settingsText(const ExportSettings& settings) {
    const Engine* engine = engineNamed(settings.engine);
    const ExportSettings base = engine ? settingsFor(*engine) : ExportSettings();
    std::string text = "# export settings of Stromar\n";
    const auto add = [&](std::string_view key, std::string_view value) { text += std::string(key) + " = " + std::string(value) + "\n"; };
    if (engine) add(kEngineKey, engine->key);
    if (settings.ending != base.ending) add(kFormatKey, settings.ending);
    for (const ExportChoice& choice : exportChoices())
        if (const std::string value = choiceText(settings.options, choice); value != choiceText(base.options, choice)) add(choice.key, value);
    return text;
}

ExportSettings parseSettings(const std::string& text, const std::string& name) { return CSettingsParser(text, name).read(); }

ExportSettings readSettings(const std::filesystem::path& path) { return parseSettings(readFile(path), path.string()); }

} // namespace stromar
