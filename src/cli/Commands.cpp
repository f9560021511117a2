#include "Commands.h"
#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "stromar/mesh/MeshCheck.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/TreeFile.h"
#include "stromar/texture/Draw.h"
#include "stromar/util/Text.h"
#include <algorithm>
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
    const std::string value(trimmed(std::string_view(setting).substr(equals + 1)));
    const auto target = findParam(key);
    if (!target) throw CUsageError("--set: there is no parameter '" + key + "'" + keySuggestion(key));
    std::string problem;
    const SetResult result = setFromText(params, *target, value, problem);
    if (result == SetResult::BadValue) throw CUsageError("--set: " + problem);
    if (result == SetResult::Clamped) say(common, "--set: warning: " + problem);
}

/// Recipes are read when they are drawn, which may be late or never; a wrong one is told at once.
void refuseBadRecipes(const CParams& params, const CTreeFile& file) {
    Messages faults;
    for (const TextInfo& text : textTable()) {
        const std::string& value = params.text.*text.field;
        if (!text.path() || !isRecipe(value)) continue;
        try {
            const CRecipe recipe(value);
        } catch (const CError& e) {
            if (value != file.params().text.*text.field)
                throw CUsageError("--set: " + std::string(text.key) + ": " + e.what());
            faults.push_back(file.errorAt(&text, e.what()));
        }
    }
    if (!faults.empty()) throw CInputError(std::move(faults));
}

CParams readParams(const CommonOptions& common) {
    const CTreeFile file = CTreeFile::read(common.file);
    for (const Message& warning : file.warnings()) say(common, warning.toString());
    CParams params = file.params();
    for (const std::string& setting : common.settings) applySetting(params, common, setting);
    refuseBadRecipes(params, file);
    return params;
}

std::shared_ptr<const TreeModel> createModel(const CommonOptions& common, const Detail& detail,
                                             const CProgress& progress) {
    const CParams params = readParams(common);
    return CTreeCreator(common.varied, common.mostVertices).create(params, detail, progress);
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
    const auto meshes = model.meshes();
    if (meshes.empty()) return nullptr;
    Bounds all = meshes.front()->bounds();
    for (const auto& mesh : meshes) {
        const Bounds own = mesh->bounds();
        all = {glm::min(all.min, own.min), glm::max(all.max, own.max)};
    }
    return {{"min", array(all.min)}, {"max", array(all.max)}};
}

std::size_t meshBytes(const TreeModel& model) {
    std::size_t bytes = 0;
    for (const auto& mesh : model.meshes()) bytes += mesh->bytes();
    return bytes;
}

/// Area of the drawn leaves as a part of all leaves': thinning costs what growth cannot make up for.
double leafAreaKept(const TreeModel& model) {
    if (const Twig* twig = model.twig.get())
        return std::min(1.0, model.cards->area() * twig->shownArea / twig->cardArea() / twig->allLeafArea);
    const double all = double(model.tree->leaves().size());
    const double drawn = double(model.leaves()->vertexCount() / verticesPerOrgan(meshParamsOf(model.params), Organ::Leaf, *model.detail));
    return drawn > 0 ? std::min(1.0, kMostLeafGrowth * kMostLeafGrowth * drawn / all) : all > 0 ? 0 : 1;
}

/// Leaves by generation and stem.
std::vector<std::vector<std::size_t>> leafCounts(const CTree& tree) {
    std::vector<std::vector<std::size_t>> counts;
    for (const auto& generation : tree.generations()) counts.emplace_back(generation->stems.size(), 0);
    for (const CLeaf& leaf : tree.leaves()) ++counts[leaf.generation][leaf.stem];
    return counts;
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

void printFaultsHead(std::ostream& out) {
    out << std::left << std::setw(12) << "mesh" << std::right << std::setw(10) << "surfaces" << std::setw(9)
        << "collars" << std::setw(12) << "vertices" << std::setw(12) << "triangles";
    for (const MeshCheck& check : meshChecks()) out << "  " << check.name;
    out << "\n";
}

void refuseUnlessPng(const std::string& path) {
    if (std::filesystem::path(path).extension() != ".png") throw CUsageError("pictures are written as .png");
}

/// One line of the table; false when something is wrong.
bool printFaults(const std::string& name, const MeshFaults& faults, std::ostream& out) {
    out << std::left << std::setw(12) << name << std::right << std::setw(10) << faults.surfaces << std::setw(9)
        << faults.collars << std::setw(12) << faults.vertices << std::setw(12) << faults.triangles;
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
        {"seed", model->params.global.seed},
        {"method", model->params.text.method},
        {"scale_tree", model->tree->height()},
        {"generations", generations},
        {"leaves", model->tree->leaves().size()},
        {"model", options.simple ? "simple" : "full"},
        {"lod", options.lod},
        {"vertices", model->vertexCount()},
        {"triangles", model->triangleCount()},
        {"leaf_area_kept", leafAreaKept(*model)},
        {"bounds", boundsInfo(*model)},
        {"milliseconds", {{"structure", ms.structure}, {"smooth", ms.smooth}, {"mesh", ms.mesh}, {"total", ms.total}}},
        {"mesh_bytes", meshBytes(*model)}};
    out << info.dump(2) << "\n";
}

void printStructure(const CommonOptions& common, std::ostream& out, const CProgress& progress) {
    const auto model = createModel(common, detailOf(Model::Simple), progress);
    const CTree& tree = *model->tree;
    const std::vector<std::vector<std::size_t>> leaves = leafCounts(tree);
    for (std::size_t g = 0; g < tree.generationCount(); ++g) {
        const CGeneration& generation = tree.generation(g);
        for (std::size_t s = 0; s < generation.stems.size(); ++s) {
            out << stemInfo(generation, g, s, leaves[g][s]).dump() << "\n";
            progress.poll();
        }
    }
}

bool checkMeshes(const CommonOptions& common, const ModelOptions& options, std::ostream& out,
                 const CProgress& progress) {
    const auto model = createModel(common, options.detail(), progress);
    const auto all = meshAllStems(*model->tree, meshParamsOf(model->params), options.detail(), progress);
    printFaultsHead(out);
    bool sound = true;
    for (std::size_t g = 0; g < all.size(); ++g) {
        if (model->stems[g]->vertexCount() == 0) continue; // cards show it
        const MeshFaults faults = checkStems(*model->tree, static_cast<int>(g), all[g], g > 0 ? &all[g - 1] : nullptr);
        sound &= printFaults(all[g].mesh->name, faults, out);
    }
    for (const auto& leaves : {model->leaves(), model->cards})
        if (leaves && (leaves != model->leaves() || !model->cards || leaves->vertexCount() > 0))
            sound &= printFaults(leaves->name, checkLeaves(*leaves), out);
    out << (sound ? "all sound\n" : "something is wrong\n");
    return sound;
}

void exportTree(const CommonOptions& common, const ExportOptions& options, const std::string& path,
                const CProgress& progress) {
    const Format* format = formatOf(path);
    if (!format) throw CUsageError(unknownFormat(path));
    if (const std::string conflict = conflictText(options, *format); !conflict.empty()) throw CUsageError(conflict);
    const CParams params = readParams(common);
    CTreeCreator creator(common.varied, common.mostVertices);
    std::vector<std::shared_ptr<const TreeModel>> lods;
    for (const Detail* detail : detailsOf(options)) lods.push_back(creator.create(params, *detail, progress));
    exportModels(lods, options, std::filesystem::path(common.file).parent_path(), path, progress);
    for (const auto& lod : lods)
        say(common, path + ": " + std::string(lod->detail->name) + ", " + std::to_string(lod->vertexCount()) +
                        " vertices, " + std::to_string(lod->triangleCount()) + " triangles");
}

void renderTree(const CommonOptions& common, const ModelOptions& modelOptions, const RenderOptions& options,
                const std::string& path, const CProgress& progress) {
    refuseUnlessPng(path);
    const auto model = createModel(common, modelOptions.detail(), progress);
    const Pixels pixels =
        renderPicture(*model, std::filesystem::path(common.file).parent_path(), options, progress);
    CFileSet files(progress);
    writePng(pixels, options.width, options.height, path, files);
    files.commit();
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

void printParams(ListStyle style, std::ostream& out) {
    if (style == ListStyle::Markdown) out << paramsAsMarkdown();
    if (style == ListStyle::Text) out << paramsAsText();
    if (style != ListStyle::Json) return;
    Json rows = Json::array();
    for (const ParamRef& ref : allParams()) {
        const ParamInfo& p = *ref.info;
        Json row = {{"key", ref.key()},
                    {"label", p.label},
                    {"group", groupName(ref.group())},
                    {"unit", unitName(p.unit)},
                    {"type", p.integer() ? "integer" : "number"},
                    {"min", p.range.min},
                    {"max", p.range.max},
                    {"step", p.step},
                    {"default", p.defaultOf(ref.level)},
                    {"help", p.help}};
        if (!p.words.empty()) row["words"] = std::vector<std::string>(p.words.begin(), p.words.end());
        rows.push_back(row);
    }
    for (const TextInfo& text : textTable())
        rows.push_back({{"key", text.key},
                        {"label", text.label},
                        {"group", groupName(text.group)},
                        {"type", "text"},
                        {"help", text.help}});
    out << rows.dump(2) << "\n";
}

namespace {
std::string picturesOf(const Format& format) {
    switch (format.pictures) {
    case Pictures::None: return "none";
    case Pictures::Beside: return "beside";
    case Pictures::Inside: return "inside";
    }
    return {};
}

void printFormatsPage(std::ostream& out) {
    out << "# Formats\n\nWritten by `stromar-cli formats --markdown`. Lengths are metres unless a scale is chosen.\n\n"
           "| Ending | Format | Up | Pictures | Levels of detail | What is lost |\n|---|---|---|---|---|---|\n";
    for (const Format& format : formatTable())
        out << "| `" << format.ending << "` | " << format.name << " | " << format.upAxis
            << (format.anyUp ? ", or the other" : "") << " | " << picturesOf(format) << " | "
            << (format.lods ? "in one file" : "a file for each") << " | " << format.losses << " |\n";
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
                            {"loses", format.losses}});
        else
            out << format.ending << std::string(7 - format.ending.size(), ' ') << format.name << ", " << format.upAxis
                << " up; loses: " << format.losses << "\n";
    }
    if (style == ListStyle::Json) out << rows.dump(2) << "\n";
}

} // namespace stromar
