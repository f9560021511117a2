#include "Commands.h"
#include "Description.h"
#include "stromar/texture/Bark.h"
#include <CLI/CLI.hpp>
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

/// Everything the command line can say.
struct Options {
    CommonOptions common;
    ModelOptions model;
    ExportOptions exported;
    std::string modelName = "full", variation = "on", output, seed;
    bool seedGiven = false;
    std::vector<std::string> recipe;
    int size = 1024;
    bool markdown = false, json = false;
    bool lodGiven = false;

    ListStyle style() const { return markdown ? ListStyle::Markdown : json ? ListStyle::Json : ListStyle::Text; }
    void finish() {
        common.varied = variation == "on";
        model.simple = modelName == "simple";
        if (seedGiven) common.settings.push_back("Seed=" + seed);
        if (model.simple && lodGiven)
            throw CUsageError("--lod belongs to the full model; the simple model has no levels of detail");
    }
};

/// "{full,simple}"
std::string joined(std::span<const std::string_view> words) {
    std::string all;
    for (const std::string_view word : words) all += (all.empty() ? "{" : ",") + std::string(word);
    return all + "}";
}

std::string barkKeys() {
    std::string all;
    for (const BarkParam& row : barkTable()) all += (all.empty() ? "" : ", ") + std::string(row.key);
    return all;
}

void addCommon(CLI::App& command, Options& options) {
    command.add_option("file", options.common.file, "The .tree file")->required()->type_name("FILE.tree");
    command.add_option("--seed", options.seed, "Short for --set Seed=N")->type_name("N");
    command.add_option("--set", options.common.settings, "Changes a parameter; may be given often")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option("--variation", options.variation, "off: every random number is its middle value")
        ->check(CLI::IsMember({"on", "off"}));
    command.add_option("--threads", options.common.threads, "How many threads; default: one per processor")
        ->check(CLI::Range(1, 1024));
    command.add_option("--max-vertices", options.common.mostVertices, "Refuse trees that may be larger")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command.add_flag("--quiet", options.common.quiet, "No warnings, no report");
}

void addModel(CLI::App& command, Options& options) {
    command.add_option("--model", options.modelName, "Which model")
        ->check(CLI::IsMember({"full", "simple"}))
        ->capture_default_str();
    command.add_option("--lod", options.model.lod, "Level of detail of the full model, 0 the finest")
        ->check(CLI::Range(0, 3));
}

/// A flag for each row of the table of choices.
void addExport(CLI::App& command, ExportOptions& options) {
    for (const ExportChoice& choice : exportChoices()) {
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
    if (name == "structure") printStructure(options.common, std::cout, progress);
    bool sound = true;
    if (name == "check") sound = checkMeshes(options.common, options.model, std::cout, progress);
    if (name == "export") exportTree(options.common, options.exported, options.output, progress);
    if (name == "texture") writeTexture(options.recipe, options.size, options.output, progress);
    if (name == "params") printParams(options.style(), std::cout);
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
    CLI::App* texture = app.add_subcommand("texture", "Draws a bark that can be laid side by side, with its relief");
    CLI::App* params = app.add_subcommand("params", "The table of parameters");
    CLI::App* formats = app.add_subcommand("formats", "What can be written, and what each format loses");
    for (CLI::App* command : {info, structure, checker, exporter}) addCommon(*command, options);
    for (CLI::App* command : {info, checker}) addModel(*command, options);
    addExport(*exporter, options.exported);
    exporter->add_option("-o,--output", options.output, "The model to write")->required()->type_name("OUT.ext");
    texture
        ->add_option("recipe", options.recipe,
                     "A kind, " + joined(barkKinds()) + ", and what differs from it: " + barkKeys())
        ->required()
        ->type_name("KIND KEY=VALUE");
    texture->add_option("--size", options.size, "Pixels of a side")->check(CLI::Range(16, 8192))->capture_default_str();
    texture->add_option("-o,--output", options.output, "The picture; its relief goes beside it")
        ->required()
        ->type_name("OUT.png");
    for (CLI::App* list : {params, formats}) {
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
