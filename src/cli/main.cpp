#include "BatchCommand.h"
#include "Commands.h"
#include "Description.h"
#include "stromar/app/Engines.h"
#include "stromar/texture/Bark.h"
#include "stromar/texture/Leaf.h"
#include "stromar/util/Text.h"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <iostream>

namespace {
using namespace stromar;

enum ExitStatus { kDone = 0, kFailed = 1, kWrongUsage = 2 };

/// Stopping by Ctrl+C cancels the work, so that no temporary file stays behind.
const CProgress* g_running = nullptr;
void onSignal(int) {
    if (g_running) g_running->cancel();
}

constexpr std::pair<char, double> kMemoryUnits[] = {{'K', 1e3}, {'M', 1e6}, {'G', 1e9}};

/// "{full,simple}"
std::string joined(std::span<const std::string_view> words) {
    std::string all;
    for (const std::string_view word : words) all += (all.empty() ? "{" : ",") + std::string(word);
    return all + "}";
}

/// Everything the command line can say.
struct Options {
    CommonOptions common;
    ModelOptions model;
    BatchFlags batch;
    std::string foreign; ///< to import
    std::string part;    ///< of a batch
    ExportOptions exported;
    std::string ending; ///< of the model to write, where its name has none
    std::string modelName = "full", variation = "on", output, seed;
    bool seedGiven = false;
    std::vector<std::string> recipe;
    int size = 1024;
    RenderOptions rendered;
    Motion motion;
    std::string age, windStrength, windDirection, gusts, seconds, fps, fell;
    std::string pictureSize, season, memory, method = "weber-penn";
    bool segments = false, timeSamples = false;
    bool markdown = false, json = false;
    std::string from, backdrop;
    bool transparent = false;
    bool lodGiven = false;

    ListStyle style() const { return markdown ? ListStyle::Markdown : json ? ListStyle::Json : ListStyle::Text; }
    BatchFlags batchFlags() const {
        BatchFlags flags = batch;
        flags.quiet = common.quiet;
        flags.limits = common.limits;
        if (!part.empty()) readPart(flags);
        return flags;
    }
    void readPart(BatchFlags& flags) const {
        const std::size_t slash = part.find('/');
        const auto own = parseNumber(part.substr(0, slash)), all = slash == std::string::npos ? std::nullopt : parseNumber(part.substr(slash + 1));
        constexpr double kMostParts = 100'000;
        const bool right = own && all && *own >= 1 && *own <= *all && *all <= kMostParts && std::floor(*own) == *own && std::floor(*all) == *all;
        if (!right) throw CUsageError("--part wants I/N, 1/8 to 8/8 for eight parts, not '" + part + "'");
        flags.part = static_cast<int>(*own);
        flags.parts = static_cast<int>(*all);
    }
    void finish() {
        common.varied = variation == "on";
        model.simple = modelName == "simple";
        if (!season.empty()) {
            const auto named = std::ranges::find(seasonNames(), season, &SeasonName::name);
            common.settings.push_back("Season=" + (named == seasonNames().end() ? season : numberText(named->month)));
        }
        if (!pictureSize.empty()) readPictureSize();
        if (!from.empty()) readFrom();
        if (!backdrop.empty()) readBackdropName();
        if (transparent) rendered.backdrop = static_cast<int>(backdropNames().size()) - 1;
        if (!memory.empty()) readMemory();
        readClamped("--age", age, 0, 1, common.age);
        readMotion();
        if (seedGiven) common.settings.push_back("Seed=" + seed);
        if (model.simple && lodGiven)
            throw CUsageError("--lod belongs to the full model; the simple model has no levels of detail");
    }
    /// A number that is taken into its range with a warning.
    void readClamped(const char* flag, const std::string& text, double min, double max, double& value) const {
        if (text.empty()) return;
        const auto number = parseNumber(text);
        const std::string range = "from " + numberText(min) + " to " + numberText(max);
        if (!number) throw CUsageError(std::string(flag) + " wants a number " + range + ", not '" + text + "'");
        value = std::clamp(*number, min, max);
        if (value != *number && !common.quiet)
            std::cerr << flag << ": warning: it must be " << range << ", taken as " << numberText(value) << "\n";
    }
    void readMotion() {
        double degrees = 0;
        readClamped("--wind-strength", windStrength, 0, kMaxWindStrength, motion.wind.strength);
        readClamped("--wind-direction", windDirection, -360, 360, degrees);
        readClamped("--gusts", gusts, 0, 1, motion.wind.gusts);
        readClamped("--fps", fps, 0.1, 1000, motion.fps);
        readClamped("--seconds", seconds, 0.01, 3600, motion.seconds);
        if (!fell.empty()) {
            const std::size_t comma = fell.find(',');
            Felling& felling = motion.felling.emplace();
            readClamped("--fell", fell.substr(0, comma), -360, 360, felling.direction);
            if (comma != std::string::npos) readClamped("--fell", fell.substr(comma + 1), 0, 1000, felling.height);
        }
        motion.wind.direction = windDirection.empty() ? motion.wind.direction : stromar::windDirection(degrees);
        if (motion.frames == 0 && motion.seconds > 0)
            motion.frames = static_cast<int>(std::clamp(std::round(motion.seconds * motion.fps), 1.0, double(kMaxFrames)));
    }
    /// A number of megabytes, or with a letter: 500M, 2.5G.
    void readMemory() {
        const auto unit = std::ranges::find(kMemoryUnits, memory.back(), &std::pair<char, double>::first);
        const bool named = unit != std::end(kMemoryUnits);
        const auto number = parseNumber(std::string_view(memory).substr(0, memory.size() - (named ? 1 : 0)));
        if (!number || *number <= 0) throw CUsageError("--max-memory wants a size as 500M or 2.5G, not '" + memory + "'");
        common.limits.bytes = *number * (named ? unit->second : 1e6);
    }
    void readBackdropName() {
        const auto named = std::ranges::find(backdropNames(), backdrop);
        if (named != backdropNames().end())
            rendered.backdrop = static_cast<int>(named - backdropNames().begin());
        else if (backdrop.find('.') != std::string::npos)
            rendered.backdropPicture = backdrop;
        else
            throw CUsageError("--backdrop wants one of " + joined(backdropNames()) + " or a picture, not '" + backdrop + "'");
    }
    void readFrom() {
        const std::size_t comma = from.find(',');
        const auto azimuth = parseNumber(std::string_view(from).substr(0, comma)),
                   elevation = comma == std::string::npos ? 0 : parseNumber(std::string_view(from).substr(comma + 1));
        if (!azimuth || !elevation || std::abs(*elevation) > 90)
            throw CUsageError("--from wants AZIMUTH,ELEVATION in degrees, the elevation from -90 to 90");
        rendered.from.emplace(*azimuth, *elevation);
    }
    void readPictureSize() {
        const std::size_t cross = pictureSize.find('x');
        const auto width = parseNumber(std::string_view(pictureSize).substr(0, cross)),
                   height = cross == std::string::npos ? width
                                                       : parseNumber(std::string_view(pictureSize).substr(cross + 1));
        const auto fits = [](const std::optional<double>& side) { return side && *side >= 16 && *side <= 8192; };
        if (!fits(width) || !fits(height)) throw CUsageError("--size wants WxH, each from 16 to 8192 pixels");
        rendered.width = static_cast<int>(*width);
        rendered.height = static_cast<int>(*height);
    }
};

/// "bark:{furrowed,…} with seed, ridges …"
template <typename Params>
std::string described(const RecipeBook<Params>& book) {
    std::string keys;
    for (const auto& row : book.table) keys += (keys.empty() ? "" : ", ") + std::string(row.key);
    return std::string(book.what) + ":" + joined(book.kinds) + " with " + keys;
}

void addResources(CLI::App& command, Options& options) {
    command.add_option("--threads", options.common.threads, "How many threads; default: one per processor")
        ->check(CLI::Range(1, 1024));
    command.add_option("--max-vertices", options.common.limits.vertices, "Refuse trees that may be larger")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command
        .add_option("--max-memory", options.memory,
                    "Refuse trees that may take more memory while they are made; default: half of what is free")
        ->type_name("SIZE");
    command.add_flag("--quiet", options.common.quiet, "No warnings, no report");
}

void addCommon(CLI::App& command, Options& options) {
    command.add_option("file", options.common.file, "The .tree file")->required()->type_name("FILE.tree");
    command.add_option("--seed", options.seed, "Short for --set Seed=N")->type_name("N");
    command.add_option("--set", options.common.settings, "Changes a parameter; may be given often")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option("--variation", options.variation, "off: every random number is its middle value")
        ->check(CLI::IsMember({"on", "off"}));
    command.add_option("--age", options.age, "How old the tree is, 0 to 1 of its life; default: 1, grown")->type_name("A");
    addResources(command, options);
}

void addModel(CLI::App& command, Options& options) {
    command.add_option("--model", options.modelName, "Which model")
        ->check(CLI::IsMember({"full", "simple"}))
        ->capture_default_str();
    command.add_option("--lod", options.model.lod, "Level of detail of the full model, 0 the finest")
        ->check(CLI::Range(0, kMaxLod));
}

/// A word, and perhaps its number.
void addWordAndNumber(CLI::App& command, const ExportChoice& choice, ExportOptions& options) {
    const auto read = [&options, &choice](const std::vector<std::string>& given) {
        const auto word = std::ranges::find(choice.words, given[0]);
        const auto number = given.size() > 1 ? parseNumber(given[1]) : options.*choice.argument;
        const std::string name = "--" + std::string(choice.key);
        if (word == choice.words.end()) throw CUsageError(name + " is one of " + joined(choice.words));
        if (!number || !(*number > 0)) throw CUsageError(name + " " + given[0] + ": '" + given[1] + "' is no size in metres");
        options.*choice.field = static_cast<int>(word - choice.words.begin());
        options.*choice.argument = *number;
    };
    command.add_option_function<std::vector<std::string>>("--" + std::string(choice.key), read, std::string(choice.help))
        ->expected(1, 2)
        ->option_text(joined(choice.words) + " [SIZE]");
}

/// Flags for what export and check can make of a tree.
void addSolid(CLI::App& command, ExportOptions& options) {
    for (const ExportChoice& choice : exportChoices())
        if (choice.argument) addWordAndNumber(command, choice, options);
}

/// A flag for each row of the table of choices.
void addExport(CLI::App& command, ExportOptions& options) {
    addSolid(command, options);
    for (const ExportChoice& choice : exportChoices()) {
        if (choice.argument) continue;
        const std::string flag = "--" + std::string(choice.key), help(choice.help);
        if (choice.number)
            command.add_option(flag, options.*choice.number, help)
                ->check(CLI::Range(choice.range.min, choice.range.max));
        else if (choice.words.empty())
            command.add_option(flag, options.*choice.field, help)
                ->check(CLI::Range(static_cast<int>(choice.range.min), static_cast<int>(choice.range.max)));
        else {
            std::vector<std::pair<std::string, int>> words;
            for (const std::string_view word : choice.words) words.emplace_back(word, static_cast<int>(words.size()));
            command.add_option(flag, options.*choice.field, help)
                ->transform(CLI::Transformer(words))
                ->option_text(joined(choice.words));
        }
    }
}

/// Choices that others stand on top of: they are taken while the line is read, the flags after it.
void addEngines(CLI::App& command, Options& options) {
    std::vector<std::string_view> keys;
    for (const Engine& engine : engineTable()) keys.push_back(engine.key);
    const auto take = [&options](const ExportSettings& settings) {
        options.exported = settings.options;
        options.ending = settings.ending;
    };
    CLI::Option* engine = command
                              .add_option_function<std::string>(
                                  "--for",
                                  [take](const std::string& key) {
                                      const Engine* found = engineNamed(key);
                                      if (!found) throw CLI::ValidationError("--for", "there is no engine '" + key + "'");
                                      take(settingsFor(*found));
                                  },
                                  "The defaults of a program that the model is for; other flags change them")
                              ->option_text(joined(keys))
                              ->trigger_on_parse();
    command
        .add_option_function<std::string>(
            "--settings", [take](const std::string& file) { take(readSettings(file)); },
            "The choices of a file, as the export dialog saves it; other flags change them")
        ->type_name("FILE")
        ->trigger_on_parse()
        ->excludes(engine);
}

void addBatch(CLI::App& command, Options& options) {
    command.add_option("plan", options.batch.plan, "Which trees, seeds, ages, seasons, levels of detail and formats")->required()->type_name("PLAN.json");
    command.add_option("--jobs", options.batch.jobs, "How many trees are made side by side")->check(CLI::Range(1, 1024))->capture_default_str();
    command.add_flag("--force", options.batch.force, "Also what is there and unchanged");
    command.add_flag("--dry-run", options.batch.dryRun, "Writes nothing; lists the models, their sizes and the time");
    command.add_option("--part", options.part, "Of the trees every N-th, from the I-th on: parts run side by side, on several machines")->type_name("I/N");
    command.add_flag("--merge", options.batch.merge, "Writes nothing but manifest.json, of what all parts have made; fails when a model is missing");
    addResources(command, options);
}

/// Growth or wind in many pictures or files.
void addMotion(CLI::App& command, Options& options, const std::string& what) {
    command.add_option("--frames", options.motion.frames, "So many " + what + ", numbered: the tree grows up to its age, or sways in the wind")
        ->check(CLI::Range(1, kMaxFrames))
        ->type_name("N");
    command.add_option("--wind-strength", options.windStrength, "The wind: 0.3 a breeze, 1 a strong gale")->type_name("S");
    command.add_option("--wind-direction", options.windDirection, "Where it blows to: degrees, 0 to the right, 90 away from the viewer")
        ->type_name("DEG");
    command.add_option("--gusts", options.gusts, "How much of it comes and goes, 0 to 1; default: 0.3")->type_name("G");
    command.add_option("--fell", options.fell, "Fells the tree: where it falls to, in degrees, and the height of the cut in metres; default: at the ground")
        ->type_name("DEG[,HEIGHT]");
    command.add_option("--seconds", options.seconds, "How long the wind's loop is; default: as long as its frames")->type_name("T");
    command.add_option("--fps", options.fps, "Frames of a second; default: 25")->type_name("F");
}

/// The names of a table's rows.
template <typename Rows>
std::vector<std::string_view> namesOf(const Rows& rows) {
    std::vector<std::string_view> names;
    for (const auto& row : rows) names.push_back(row.name);
    return names;
}

std::vector<std::pair<std::string, int>> numbered(std::span<const std::string_view> words) {
    std::vector<std::pair<std::string, int>> all;
    for (const std::string_view word : words) all.emplace_back(word, static_cast<int>(all.size()));
    return all;
}

void addRender(CLI::App& command, Options& options) {
    const std::vector<std::string_view> views = namesOf(renderViews());
    command.add_option("others", options.common.others, "More trees, which stand in a row with the first")->type_name("FILE.tree");
    command.add_option("-o,--output", options.output, "The picture to write")->required()->type_name("OUT.png");
    command.add_option("--size", options.pictureSize, "Pixels; default: 800x800")->type_name("WxH");
    command.add_option("--view", options.rendered.view, "From where")
        ->transform(CLI::Transformer(numbered(views)))
        ->option_text(joined(views));
    command.add_option("--season", options.season, "A season, " + joined(namesOf(seasonNames())) + ", or a month")
        ->type_name("NAME");
    command.add_option("--from", options.from, "From where else: degrees around the tree (0 the front) and above level")
        ->type_name("AZIMUTH,ELEVATION");
    command.add_flag("--fit", options.rendered.fit, "The tree just fills the picture");
    command.add_option("--displacement", options.rendered.displacement.cell,
                       "The relief of the bark as triangles, in cells of so many metres; only level of detail 0")
        ->check(CLI::Range(0.0, 1.0))
        ->type_name("SIZE");
    command.add_option("--displacement-strength", options.rendered.displacement.strength,
                       "How deep it is: 1 is what the picture of the bark's normals shows; default: 3")
        ->check(CLI::Range(0.0, 10.0))
        ->type_name("S");
    command.add_option("--focal-length", options.rendered.focalLength, "Millimetres, for a picture 24 mm high; default: 45")
        ->check(CLI::Range(8.0, 1000.0));
    command.add_option("--backdrop", options.backdrop, "What is behind the tree; or a picture, .png or .jpg, or an HDRI panorama, .hdr, that lights it")
        ->option_text(joined(backdropNames()) + "|FILE");
    for (const LightRow& row : lightTable())
        command.add_option(std::string(row.flag), options.rendered.light.*row.field, std::string(row.help))
            ->check(CLI::Range(row.range.min, row.range.max));
    command.add_option("--samples", options.rendered.samples, "For smooth edges and soft shadows; 1 is fast, 64 beautiful")->check(CLI::Range(1, 256));
    command.add_flag("--transparent", options.transparent, "As --backdrop none");
}

/// The exit status.
int run(const CLI::App& app, Options& options) {
    const CLI::App& command = *app.get_subcommands().front();
    const std::string& name = command.get_name();
    options.lodGiven = command.get_option_no_throw("--lod") && command.count("--lod") > 0;
    options.seedGiven = command.get_option_no_throw("--seed") && command.count("--seed") > 0;
    options.finish();
    const CProgress progress(options.common.threads);
    g_running = &progress;
    if (name == "info") printInfo(options.common, options.model, std::cout, progress);
    if (name == "structure") printStructure(options.common, options.segments, std::cout, progress);
    bool sound = true;
    if (name == "check") sound = checkMeshes(options.common, options.model, options.exported, std::cout, progress);
    if (name == "export") {
        if (std::filesystem::path(options.output).extension().empty()) options.output += options.ending;
        exportTree(options.common, options.exported, options.motion, options.timeSamples, options.output, progress);
    }
    if (name == "render") renderTree(options.common, options.model, options.rendered, options.motion, options.output, progress);
    if (name == "texture") writeTexture(options.recipe, options.size, options.output, progress);
    if (name == "import") importForeign(options.foreign, options.output, options.common.quiet, std::cerr);
    if (name == "imports") printImports(options.style(), std::cout);
    if (name == "batch") sound = runBatchCommand(options.batchFlags(), std::cout, progress);
    if (name == "params") printParams(options.method, options.style(), std::cout);
    if (name == "methods") printMethods(options.style(), std::cout);
    if (name == "formats") printFormats(options.style(), std::cout);
    if (name == "man") printManPage(app, std::cout);
    if (name == "completion") printCompletion(app, std::cout);
    if (!std::cout.flush()) throw CError("cannot write to standard output");
    g_running = nullptr;
    return sound ? kDone : kFailed;
}

void setUp(CLI::App& app, Options& options) {
    app.require_subcommand(1);
    CLI::App* info = app.add_subcommand("info", "Counts, sizes and times of a tree, as JSON");
    CLI::App* structure = app.add_subcommand("structure", "Every stem, as JSON lines");
    CLI::App* checker = app.add_subcommand("check", "Looks for faults in the meshes; fails when there are any");
    CLI::App* exporter = app.add_subcommand("export", "Writes a model; the ending of its name says the format");
    CLI::App* renderer = app.add_subcommand("render", "Draws a picture of a tree, without a window");
    CLI::App* texture =
        app.add_subcommand("texture", "Draws a bark that can be laid side by side, or a leaf, with their relief");
    CLI::App* batch = app.add_subcommand("batch", "Writes many models: trees, seeds, ages, seasons, levels of detail, formats");
    CLI::App* import = app.add_subcommand("import", "Makes a .tree file of one of another program, and tells what changed");
    CLI::App* imports = app.add_subcommand("imports", "What can be imported, and what becomes of each value");
    CLI::App* params = app.add_subcommand("params", "The table of parameters");
    CLI::App* methods = app.add_subcommand("methods", "The ways to grow a tree");
    CLI::App* formats = app.add_subcommand("formats", "What can be written, and what each format loses");
    for (CLI::App* command : {info, structure, checker, exporter, renderer}) addCommon(*command, options);
    for (CLI::App* command : {info, checker, renderer}) addModel(*command, options);
    structure->add_flag("--segments", options.segments, "Behind each stem a line for each of its segments");
    params->add_option("--method", options.method, "Of which way to grow")->type_name("NAME")->capture_default_str();
    methods->add_flag("--json", options.json, "As JSON");
    addRender(*renderer, options);
    addMotion(*renderer, options, "pictures");
    addEngines(*exporter, options);
    addExport(*exporter, options.exported);
    addSolid(*checker, options.exported);
    addBatch(*batch, options);
    addMotion(*exporter, options, "files");
    exporter->add_flag("--time-samples", options.timeSamples, "Of USD files: all frames in one file, as time samples of its meshes");
    exporter->add_option("-o,--output", options.output, "The model to write")->required()->type_name("OUT.ext");
    texture
        ->add_option("recipe", options.recipe,
                     "What to draw, and what differs from it: " + described(barkBook()) + "; or " +
                         described(leafBook()))
        ->required()
        ->type_name("BOOK:KIND KEY=VALUE");
    texture->add_option("--size", options.size, "Pixels of a side")->check(CLI::Range(16, 8192))->capture_default_str();
    texture->add_option("-o,--output", options.output, "The picture; its relief goes beside it")
        ->required()
        ->type_name("OUT.png");
    import->add_option("file", options.foreign, "A tree of Arbaro (.xml), Sapling (.py) or tree-gen (.py, .json)")->required()->type_name("FOREIGN");
    import->add_option("-o,--output", options.output, "The file to write")->required()->type_name("OUT.tree");
    import->add_flag("--quiet", options.common.quiet, "No messages but errors");
    for (CLI::App* list : {params, formats, imports}) {
        CLI::Option* markdown = list->add_flag("--markdown", options.markdown, "As a page of the manual");
        list->add_flag("--json", options.json, "As JSON")->excludes(markdown);
    }
    // For packages: made when the program is built.
    app.add_subcommand("man", "The manual page")->group("");
    app.add_subcommand("completion", "Completion for bash")->group("");
}
} // namespace

int main(int argc, char** argv) {
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    CLI::App app("Grows trees from .tree files and writes them as models.", "stromar-cli");
    Options options;
    setUp(app, options);
    try {
        app.parse(argc, argv);
        return run(app, options);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? kDone : kWrongUsage;
    } catch (const CUsageError& e) {
        std::cerr << "stromar-cli: " << e.what() << "\n";
        return kWrongUsage;
    } catch (const std::exception& e) {
        std::cerr << "stromar-cli: " << e.what() << "\n";
        return kFailed;
    }
}
