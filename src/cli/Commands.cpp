#include "Commands.h"
#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "stromar/app/Import.h"
#include "stromar/app/LeafMesh.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Prediction.h"
#include "stromar/mesh/check/Crossings.h"
#include "stromar/mesh/check/MeshCheck.h"
#include "stromar/mesh/VoxelMesh.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/TreeFile.h"
#include "stromar/texture/Draw.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

namespace stromar {

namespace {
using Json = nlohmann::ordered_json;

void say(const CommonOptions& common, const std::string& text) {
    if (!common.quiet) std::cerr << text << "\n";
}

void applySetting(CParams& params, const CommonOptions& common, const std::string& setting) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos) throw CUsageError("--set wants KEY=VALUE, not '" + setting + "'");
    const std::string key(trimmed(std::string_view(setting).substr(0, equals)));
    std::string value(trimmed(std::string_view(setting).substr(equals + 1)));
    if (key == "Method" && value != params.block().method)
        throw CUsageError("--set: a tree keeps the method of its file: it is '" + std::string(params.block().method) + "', not '" + value + "'");
    if (key == "Method") return;
    const auto ref = findParam(key, params.block());
    if (!ref) throw CUsageError("--set: there is no parameter '" + key + "'" + keySuggestion(key, params.block()));
    const bool fromFile = ref->info->kind() == ParamKind::Text && ref->info->block && value.starts_with('@');
    const std::string path = fromFile ? value.substr(1) : std::string();
    if (fromFile) value = readFile(path);
    SetProblem problem;
    const SetResult result = setFromText(params, *ref, value, problem);
    if (result == SetResult::BadValue) throw CUsageError("--set: " + (fromFile ? path + ": " : "") + problem.text);
    if (result == SetResult::Clamped) say(common, "--set: warning: " + problem.text);
}

/// Recipes and meshes are read when they are drawn, which may be late or never; a wrong one is told at once.
void tryFile(const ParamRef& ref, const CParams& params) {
    if (!ref.info->file()) return;
    if (ref.info->picture() && isRecipe(ref.text(params))) const CRecipe recipe(ref.text(params));
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind)
        if (&ref.text(params) == &(params.text.*kLeafMeshes[kind])) leafMeshOf(params, kind);
}

void refuseBadFiles(const CParams& params, const CTreeFile& file) {
    Messages faults;
    for (const ParamRef& ref : allParams(params.block())) {
        try {
            tryFile(ref, params);
        } catch (const CError& e) {
            if (ref.differs(params, file.params())) throw CUsageError("--set: " + ref.key() + ": " + e.what());
            faults.push_back(file.errorAt(ref, e.what()));
        }
    }
    if (!faults.empty()) throw CInputError(std::move(faults));
}

/// A grammar is read when a tree is grown; what is wrong with it is told at its place in the file.
void tellOfTexts(const CParams& params, const CTreeFile& file, const CommonOptions& common) {
    Messages errors;
    for (const ParamRef& ref : allParams(params.block())) {
        const TextLanguage* language = languageOf(*ref.info);
        if (!language) continue;
        const std::string& text = ref.text(params);
        for (const TextLanguage::Fault& fault : language->faults(text)) {
            const bool isSet = ref.differs(params, file.params());
            Message message = isSet ? Message{fault.severity, ref.key(), fault.line, fault.column, fault.text}
                                    : file.errorAt(ref, fault.text, offsetOf(text, fault.line, fault.column));
            message.severity = fault.severity;
            if (fault.severity == Severity::Error)
                errors.push_back(std::move(message));
            else
                say(common, message.toString());
        }
    }
    if (!errors.empty()) throw CInputError(std::move(errors));
}

CParams readParams(const CommonOptions& common) {
    const CTreeFile file = CTreeFile::read(common.file);
    for (const Message& warning : file.warnings()) say(common, warning.toString());
    CParams params = file.params();
    for (const std::string& setting : common.settings) applySetting(params, common, setting);
    refuseBadFiles(params, file);
    tellOfTexts(params, file, common);
    return params;
}

CTreeCreator creatorFor(const CommonOptions& common) {
    CTreeCreator creator(common.varied, common.limits);
    creator.setAge(common.age);
    return creator;
}

std::shared_ptr<const TreeModel> createModel(const CommonOptions& common, const Detail& detail, const CProgress& progress,
                                             CTreeCreator::Plans plans = CTreeCreator::Plans::Drop) {
    const CParams params = readParams(common);
    return creatorFor(common).create(params, detail, progress, plans);
}

template <typename Vector>
Json array(const Vector& v) {
    return Json::array({v.x, v.y, v.z});
}

Json generationInfo(const CTree& tree, std::size_t g) {
    const CGeneration& generation = tree.generation(g);
    double length = 0, radius = 0;
    for (const CStem& stem : generation.stems) {
        length += stem.length;
        radius += stem.radius;
    }
    return {{"generation", g},
            {"stems", generation.stems.size()},
            {"clones", generation.cloneCount()},
            {"segments", generation.segments.size()},
            {"length_sum", length},
            {"radius_sum", radius}};
}

Json boundsInfo(const TreeModel& model) {
    const std::optional<Bounds> all = model.bounds();
    return all ? Json{{"min", array(all->min)}, {"max", array(all->max)}} : Json();
}

/// Area of the drawn leaves as a part of all leaves': thinning costs what growth cannot make up for.
double leafAreaKept(const TreeModel& model) {
    if (const Twig* twig = model.twig.get())
        return std::min(1.0, model.cards->area() * twig->shownArea / twig->cardArea() / twig->allLeafArea);
    const double growth = model.detail->maxLeafGrowth;
    const auto all = double(model.tree->organs(Organ::Leaf)->total), drawn = double(model.leafCount());
    return drawn > 0 ? std::min(1.0, growth * growth * drawn / all) : all > 0 ? 0 : 1;
}

Json stemInfo(const CGeneration& generation, std::size_t g, std::size_t index, std::size_t leaves) {
    const CStem& stem = generation.stems[index];
    const CSegment& first = generation.segments[stem.firstSegment];
    return {{"generation", g},
            {"index", index},
            {"parent", stem.parent},
            {"path", stem.path},
            {"segment", stem.position},
            {"offset", stem.offset},
            {"length", stem.length},
            {"radius", stem.radius},
            {"base", array(first.position)},
            {"direction", array(first.frame[2])},
            {"segments", stem.segmentCount},
            {"clones", stem.pathCount - 1},
            {"leaves", leaves}};
}

Json predictedInfo(const Prediction& size) {
    return {{"stems", size.stems},
            {"segments", std::ceil(size.segments)},
            {"organs", size.organs},
            {"vertices", std::ceil(size.vertices)},
            {"bytes", std::ceil(size.bytes)}};
}

/// What the method knows of a segment, or of a stem at its base.
void addQuantities(Json& line, const TreeModel& model, const SegmentPlace& place, bool ofStem) {
    for (const SegmentQuantity& quantity : methodOf(model.params).quantities) {
        if (ofStem && !quantity.ofStem) continue;
        const double value = quantity.of(*model.tree, place);
        const bool whole = quantity.count && value == std::floor(value);
        line[std::string(quantity.name)] = whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
    }
}

/// The segments of a stem, path by path.
void printSegments(const TreeModel& model, std::size_t g, std::size_t index, std::ostream& out) {
    const CGeneration& generation = model.tree->generation(g);
    const CStem& stem = generation.stems[index];
    for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
        const CPath& path = generation.paths[stem.firstPath + p];
        for (std::uint32_t s = 0; s < path.segmentCount; ++s) {
            const CSegment& segment = generation.segments[path.firstSegment + s];
            Json line = {{"generation", g},
                         {"stem", index},
                         {"path", p},
                         {"index", path.firstPosition + s},
                         {"base", array(segment.position)},
                         {"end", array(segment.axisPoint(1))},
                         {"radius_base", segment.radiusBase},
                         {"radius_end", segment.radiusEnd}};
            addQuantities(line, model, {g, path.firstSegment + s}, false);
            out << line.dump() << "\n";
        }
    }
}

void printFaultsHead(std::ostream& out) {
    out << std::left << std::setw(12) << "mesh" << std::right << std::setw(10) << "surfaces" << std::setw(9)
        << "attached" << std::setw(12) << "vertices" << std::setw(12) << "triangles";
    for (const MeshCheck& check : meshChecks()) out << "  " << check.name;
    out << "\n";
}

void refuseUnlessPng(const std::string& path) {
    if (std::filesystem::path(path).extension() != ".png") throw CUsageError("pictures are written as .png");
}

/// One line of the table; false when something is wrong.
bool printFaults(const std::string& name, const MeshFaults& faults, std::ostream& out) {
    out << std::left << std::setw(12) << name << std::right << std::setw(10) << faults.surfaces << std::setw(9)
        << faults.attached << std::setw(12) << faults.vertices << std::setw(12) << faults.triangles;
    for (const MeshCheck& check : meshChecks())
        out << "  " << std::setw(static_cast<int>(check.name.size())) << faults.*check.count;
    out << "\n";
    return faults.sound();
}
} // namespace

void printInfo(const CommonOptions& common, const ModelOptions& options, std::ostream& out, const CProgress& progress) {
    const auto model = createModel(common, options.detail(), progress);
    Json generations = Json::array();
    for (std::size_t g = 0; g < model->tree->generationCount(); ++g)
        generations.push_back(generationInfo(*model->tree, g));
    const auto& ms = model->milliseconds;
    const Json info = {
        {"species", model->params.text.species},
        {"seed", model->params.common.seed},
        {"method", model->params.block().method},
        {"age", model->age},
        {"scale_tree", model->tree->height()},
        {"generations", generations},
        {"predicted", predictedInfo(predictSize(model->params, options.detail()))},
        {"leaves", model->tree->organs(Organ::Leaf)->total},
        {"model", options.simple ? "simple" : "full"},
        {"lod", options.lod},
        {"vertices", model->vertexCount()},
        {"triangles", model->triangleCount()},
        {"leaf_area_kept", leafAreaKept(*model)},
        {"bounds", boundsInfo(*model)},
        {"milliseconds", {{"structure", ms.structure}, {"smooth", ms.smooth}, {"mesh", ms.mesh}, {"total", ms.total}}},
        {"mesh_bytes", model->bytes()}};
    out << info.dump(2) << "\n";
}

void printStructure(const CommonOptions& common, bool segments, std::ostream& out, const CProgress& progress) {
    const auto model = createModel(common, detailOf(Model::Simple), progress);
    const CTree& tree = *model->tree;
    const COrgans& leaves = *tree.organs(Organ::Leaf);
    for (std::size_t g = 0; g < tree.generationCount(); ++g) {
        const CGeneration& generation = tree.generation(g);
        for (std::size_t s = 0; s < generation.stems.size(); ++s) {
            Json stem = stemInfo(generation, g, s, leaves.countOn(g, s));
            addQuantities(stem, *model, {g, generation.stems[s].firstSegment}, true);
            out << stem.dump() << "\n";
            if (segments) printSegments(*model, g, s, out);
            progress.poll();
        }
    }
}

bool checkMeshes(const CommonOptions& common, const ModelOptions& options, const ExportOptions& exported, std::ostream& out,
                 const CProgress& progress) {
    const auto model = createModel(common, options.detail(), progress, CTreeCreator::Plans::Keep);
    if (isSolid(exported)) {
        const auto solid = voxelMesh(*model->tree, meshParamsOf(model->params), exported.voxelSize, progress);
        printFaultsHead(out);
        const bool sound = printFaults(solid->name, checkSolid(*solid), out);
        out << (sound ? "all sound\n" : "something is wrong\n");
        return sound;
    }
    std::vector<StemMesh> all;
    for (std::size_t g = 0; g < model->stems.size(); ++g) all.push_back(planned(*model, g, all, progress));
    printFaultsHead(out);
    bool sound = true;
    for (std::size_t g = 0; g < all.size(); ++g) {
        if (model->stems[g]->vertexCount() == 0) continue; // cards show it
        const MeshFaults faults = checkStems(*model->tree, static_cast<int>(g), all[g], all);
        sound &= printFaults(g == 0 ? "trunk" : "branches " + std::to_string(g), faults, out);
    }
    const JoinedStems whole = joinStems(*model->tree, all, progress);
    sound &= printFaults("all wood", checkJoined(whole, all), out);
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) {
        const COrganMesh& leaves = *model->leaves(kind);
        if (leaves.count() > 0 || (kind == 0 && !model->cards))
            sound &= printFaults(leaves.name(), checkLeaves(*leaves.expanded(progress)), out);
    }
    if (model->cards) sound &= printFaults(model->cards->name, checkLeaves(*model->cards), out);
    out << whole.joined << " branches are one surface with their parents, " << whole.apart << " have a lid inside the wood, " << whole.withoutCollar
        << " start there without a collar\n";
    out << countCrossings(*model->tree, progress) << " pairs of stems that are not parent and child run through each other\n";
    out << (sound ? "all sound\n" : "something is wrong\n");
    return sound;
}

namespace {
/// Does the work of a motion; when someone stops it, says how much is there.
template <typename Work>
void tellWhatIsThere(const Motion& motion, const std::atomic<int>& there, const std::string& what, Work&& work) {
    try {
        work();
    } catch (const CCancelled&) {
        throw CError("cancelled: " + std::to_string(there) + " of " + std::to_string(motion.frames) + " " + what + " are written");
    }
}

void exportFrames(const CommonOptions& common, const CParams& params, const ExportOptions& options, const Motion& motion,
                  const std::string& path, const CProgress& progress) {
    std::atomic<int> there = 0;
    tellWhatIsThere(motion, there, "files", [&] {
        stromar::exportFrames(params, options, motion, common.age, common.varied, common.limits,
                              std::filesystem::path(common.file).parent_path(), path, [&](const auto&) { ++there; }, progress);
    });
    const auto count = static_cast<std::size_t>(motion.frames);
    if (motion.frames > 0)
        say(common, framePath(path, 0, count).string() + " to " + framePath(path, count - 1, count).filename().string() + ": " +
                        std::to_string(there) + " files");
    else
        say(common, path + ": in the wind");
}

void exportTimeSamples(const CommonOptions& common, const CParams& params, const ExportOptions& options, const Motion& motion,
                       const std::string& path, const CProgress& progress) {
    if (motion.frames == 0) throw CUsageError("--time-samples wants --frames, or the --seconds of a wind");
    stromar::exportTimeSamples(params, options, motion, common.age, common.varied, common.limits, std::filesystem::path(common.file).parent_path(), path,
                               progress);
    say(common, path + ": " + std::to_string(motion.frames) + " time samples");
}
} // namespace

void exportTree(const CommonOptions& common, const ExportOptions& options, const Motion& motion, bool timeSamples, const std::string& path,
                const CProgress& progress) {
    const Format* format = formatOf(path);
    if (!format) throw CUsageError(unknownFormat(path));
    if (const std::string conflict = conflictText(options, *format); !conflict.empty()) throw CUsageError(conflict);
    if (const std::string_view advice = adviceOn(options, *format); !advice.empty()) say(common, std::string(advice));
    const CParams params = readParams(common);
    const bool carriesWind = options.wind != static_cast<int>(ExportedWind::None);
    if (timeSamples) return exportTimeSamples(common, params, options, motion, path, progress);
    if (!carriesWind && (motion.frames > 0 || motion.sways())) return exportFrames(common, params, options, motion, path, progress);
    CTreeCreator creator = creatorFor(common);
    const auto lods = stromar::exportTree(creator, params, options, std::filesystem::path(common.file).parent_path(), path,
                                          progress, nullptr, motion);
    if (isSolid(options)) return say(common, path + ": the wood as one solid");
    for (const auto& lod : lods)
        say(common, path + ": " + std::string(lod->detail->name) + ", " + std::to_string(lod->vertexCount()) +
                        " vertices, " + std::to_string(lod->triangleCount()) + " triangles");
}

namespace {
constexpr double kCopiesInPicture = 2; // of a tree's mesh: its own, and the graphics card's

void writePicture(const Pixels& pixels, const RenderOptions& options, const std::filesystem::path& path, const CProgress& progress) {
    CFileSet files(progress);
    writePng(pixels, options.width, options.height, path, files);
    files.commit();
}

/// The trees of all files, of which each gets what the ones before it leave of what is allowed.
std::vector<RenderTree> createTrees(CommonOptions common, const Detail& detail, const CProgress& progress) {
    std::vector<std::string> all{common.file};
    all.insert(all.end(), common.others.begin(), common.others.end());
    std::vector<RenderTree> trees;
    for (const std::string& file : all) {
        common.file = file;
        try {
            trees.push_back({createModel(common, detail, progress), std::filesystem::path(file).parent_path()});
        } catch (const CTooLarge& e) {
            throw CError(file + ": " + e.what());
        }
        common.limits.vertices -= double(trees.back().model->vertexCount());
        common.limits.bytes -= kCopiesInPicture * double(trees.back().model->bytes());
    }
    return trees;
}
} // namespace

void renderTree(const CommonOptions& common, const ModelOptions& modelOptions, const RenderOptions& options, const Motion& motion,
                const std::string& path, const CProgress& progress) {
    refuseUnlessPng(path);
    if (!common.others.empty()) {
        if (motion.frames > 0 || motion.sways()) throw CUsageError("several trees stand still: wind and frames are for one");
        return writePicture(renderPicture(createTrees(common, modelOptions.detail(), progress), options, progress), options, path, progress);
    }
    const CParams params = readParams(common);
    CTreeCreator creator = creatorFor(common);
    std::atomic<int> there = 0;
    const auto write = [&](std::size_t i, const Pixels& pixels) {
        const auto place = motion.frames == 0 ? std::filesystem::path(path) : framePath(path, i, static_cast<std::size_t>(motion.frames));
        writePicture(pixels, options, place, progress);
        ++there;
    };
    tellWhatIsThere(motion, there, "pictures", [&] {
        renderMotion(creator, params, modelOptions.detail(), motion, common.age, std::filesystem::path(common.file).parent_path(),
                     options, write, progress);
    });
}

void writeTexture(const std::vector<std::string>& recipe, int size, const std::string& path,
                  const CProgress& progress) {
    std::string text;
    for (const std::string& word : recipe) text += (text.empty() ? "" : " ") + word;
    refuseUnlessPng(path);
    const CRecipe drawn = [&] {
        try {
            return CRecipe(text);
        } catch (const CError& e) {
            throw CUsageError(e.what());
        }
    }();
    CFileSet files(progress);
    writePngs(drawn.draw(size, progress), path, files);
    files.commit();
}

namespace {
Json numberInfo(const ParamInfo& p) {
    Json row = {{"min", p.range.min}, {"max", p.range.max}, {"step", p.step}};
    if (!p.words.empty()) row["words"] = std::vector<std::string>(p.words.begin(), p.words.end());
    return row;
}

Json paramInfo(const ParamRef& ref, const ParamBlock& block) {
    const ParamInfo& p = *ref.info;
    Json row = {{"key", ref.key()}, {"label", p.label}, {"group", ref.group().name}, {"unit", unitName(p.unit)}, {"type", kindName(p)}};
    const ParamValue value = defaultOf(ref, block);
    if (p.numeric()) {
        row.update(numberInfo(p));
        row["default"] = std::get<double>(value);
    } else if (p.kind() == ParamKind::Curve) {
        row.update(numberInfo(p));
        row["over"] = {{"label", p.overLabel}, {"min", p.over.min}, {"max", p.over.max}};
        row["default"] = std::get<CCurve>(value).text();
    } else {
        row["lines"] = p.block;
        row["default"] = std::get<std::string>(value);
    }
    row["help"] = p.help;
    return row;
}
} // namespace

void printParams(const std::string& method, ListStyle style, std::ostream& out) {
    const ParamBlock* block = blockNamed(method);
    if (!block) throw CUsageError("there is no method '" + method + "'" + methodSuggestion(method));
    if (style == ListStyle::Markdown) out << paramsAsMarkdown(*block);
    if (style == ListStyle::Text) out << paramsAsText(*block);
    if (style != ListStyle::Json) return;
    Json rows = Json::array();
    for (const ParamRef& ref : allParams(*block)) rows.push_back(paramInfo(ref, *block));
    out << rows.dump(2) << "\n";
}

void printMethods(ListStyle style, std::ostream& out) {
    Json rows = Json::array();
    for (const TreeMethod& method : treeMethods()) {
        const ParamBlock& block = *method.block;
        if (style == ListStyle::Json)
            rows.push_back({{"method", block.method}, {"label", block.label}, {"help", block.help}});
        else
            out << std::left << std::setw(14) << block.method << block.label << ": " << block.help << "\n";
    }
    if (style == ListStyle::Json) out << rows.dump(2) << "\n";
}

namespace {
std::string picturesOf(const Format& format) {
    switch (format.pictures) {
    case Pictures::None: return "none";
    case Pictures::Beside: return "beside";
    case Pictures::Inside:
    case Pictures::AlwaysInside: return "inside";
    }
    return {};
}

std::string windOf(const Format& format) {
    switch (format.channels) {
    case Channels::None: return "none";
    case Channels::ColoursAndUvs: return "colours and pivots";
    case Channels::All: return "all";
    }
    return {};
}

void printFormatsPage(std::ostream& out) {
    out << "# Formats\n\nWritten by `stromar-cli formats --markdown`. Lengths are metres unless a scale is chosen.\n\n"
           "| Ending | Format | Up | Pictures | Levels of detail | Wind | What is lost |\n|---|---|---|---|---|---|---|\n";
    for (const Format& format : formatTable())
        out << "| `" << format.ending << "` | " << format.name << " | " << format.upAxis
            << (format.anyUp ? ", or the other" : "") << " | " << picturesOf(format) << " | "
            << (format.lods ? "in one file" : "a file for each") << " | " << windOf(format) << " | " << lossesOf(format) << " |\n";
    out << "\nWind: what of `--wind` it can hold. Attributes give the exact pose, colours what their engine makes of them; bones are stiff pieces in\n"
           "place of arcs, and stems without one follow the nearest: [time and wind](time-and-wind.md#into-engines).\n";
}
} // namespace

void printFormats(ListStyle style, std::ostream& out) {
    if (style == ListStyle::Markdown) return printFormatsPage(out);
    Json rows = Json::array();
    for (const Format& format : formatTable()) {
        if (style == ListStyle::Json)
            rows.push_back({{"ending", format.ending},
                            {"name", format.name},
                            {"up_axis", format.upAxis},
                            {"pictures", picturesOf(format)},
                            {"lods_in_one_file", format.lods},
                            {"wind", windOf(format)},
                            {"loses", lossesOf(format)}});
        else
            out << format.ending << std::string(7 - format.ending.size(), ' ') << format.name << ", " << format.upAxis
                << " up; loses: " << lossesOf(format) << "\n";
    }
    if (style == ListStyle::Json) out << rows.dump(2) << "\n";
}

void importForeign(const std::string& foreign, const std::string& output, bool quiet, std::ostream& messages) {
    const ImportedTree tree = importTree(foreign);
    static_cast<void>(CTreeFile(tree.params.block()).write(output, tree.params));
    if (quiet) return;
    for (const Message& note : tree.notes) messages << note.toString() << "\n";
    messages << output << ": " << tree.params.text.species << ", of " << tree.format->name << "\n";
}

namespace {
std::string fateOf(const ImportRow& row) {
    if (!row.ours.empty()) return "`" + std::string(row.ours) + "`" + (row.note.empty() ? "" : "; " + std::string(row.note));
    return row.note.empty() ? "nothing of the form of a tree, or it decides how others are read" : "cannot be had: " + std::string(row.note);
}
} // namespace

void printImports(ListStyle style, std::ostream& out) {
    auto all = nlohmann::ordered_json::array();
    if (style == ListStyle::Markdown) out << "# Import\n\nWritten by `stromar-cli imports --markdown`. `n` stands for each level.\n";
    for (const ImportFormat& format : importTable()) {
        if (style == ListStyle::Markdown) out << "\n## " << format.name << " (`" << format.endings << "`)\n\n| there | here |\n|---|---|\n";
        for (const ImportRow& row : format.rows) {
            if (style == ListStyle::Json)
                all.push_back({{"program", format.key}, {"foreign", row.foreign}, {"parameter", row.ours}, {"note", row.note}});
            else if (style == ListStyle::Markdown)
                out << "| `" << row.foreign << "` | " << fateOf(row) << " |\n";
            else
                out << format.key << "  " << row.foreign << "  " << fateOf(row) << "\n";
        }
    }
    if (style == ListStyle::Json) out << all.dump(1) << "\n";
}

} // namespace stromar
