#include "stromar/app/ExportOptions.h"

namespace stromar {

namespace {
constexpr std::string_view kModels[] = {"full", "simple"};
constexpr std::string_view kLods[] = {"none", "one-file", "file-each"};
constexpr std::string_view kUps[] = {"format", "y", "z"};
constexpr std::string_view kTextures[] = {"format", "embed", "copy", "refer"};

constexpr std::string_view kModelNames[] = {"Full model", "Simple model"};
constexpr std::string_view kLodNames[] = {"No", "In one file", "A file for each"};
constexpr std::string_view kUpNames[] = {"As usual in the format", "Y", "Z"};
constexpr std::string_view kTextureNames[] = {"As usual in the format", "Inside the file", "Copies beside it",
                                              "Where they are"};

constexpr ExportChoice kChoices[] = {
    {.key = "model",
     .label = "Model",
     .help = "Which model: the full one, or the simple one of the preview.",
     .words = kModels,
     .names = kModelNames,
     .field = &ExportOptions::model},
    {.key = "lod",
     .label = "Level of detail",
     .help = "Of the full model: 0 is the finest, 1 to 3 have about 50, 25 and 10 % of its triangles.",
     .field = &ExportOptions::lod,
     .range = {0, 3}},
    {.key = "lods",
     .label = "All levels of detail",
     .help = "All four levels of detail: inside one file, or a file for each, named after it.",
     .words = kLods,
     .names = kLodNames,
     .field = &ExportOptions::lods},
    {.key = "scale",
     .label = "Scale",
     .help = "The model's metres are multiplied by this: 100 writes centimetres.",
     .number = &ExportOptions::scale,
     .range = {1e-6, 1e6}},
    {.key = "up",
     .label = "Up axis",
     .help = "Which axis points up. 'format' takes what programs expect of the format.",
     .words = kUps,
     .names = kUpNames,
     .field = &ExportOptions::up},
    {.key = "textures",
     .label = "Textures",
     .help = "Pictures inside the file, as copies beside it, or where they lie now. 'format' takes what is usual.",
     .words = kTextures,
     .names = kTextureNames,
     .field = &ExportOptions::textures},
};
} // namespace

std::span<const ExportChoice> exportChoices() { return kChoices; }

std::string conflictOf(const ExportOptions& options, const Format& format) {
    const std::string ending(format.ending);
    const auto lods = static_cast<ExportedLods>(options.lods);
    if (lods == ExportedLods::InOneFile && !format.lods)
        return ending + " cannot hold levels of detail; choose a file for each";
    const bool simple = options.model == static_cast<int>(ExportedModel::Simple);
    if (simple && (lods != ExportedLods::None || options.lod > 0))
        return "levels of detail belong to the full model; the simple model has none";
    const auto up = static_cast<ExportedUp>(options.up);
    const bool usual = up == ExportedUp::Format || (up == ExportedUp::Y) == (format.upAxis == "y");
    if (!usual && !format.anyUp) return "in " + ending + " files " + std::string(format.upAxis) + " is always up";
    const auto textures = static_cast<ExportedTextures>(options.textures);
    if (textures == ExportedTextures::Embed && format.pictures != Pictures::Inside)
        return ending + " cannot hold pictures; choose copies";
    return {};
}

std::vector<const Detail*> detailsOf(const ExportOptions& options) {
    if (options.model == static_cast<int>(ExportedModel::Simple)) return {&detailOf(Model::Simple)};
    if (options.lods == static_cast<int>(ExportedLods::None)) return {&detailOf(Model::Full, options.lod)};
    std::vector<const Detail*> all;
    for (const Detail& detail : detailTable())
        if (detail.model == Model::Full) all.push_back(&detail);
    return all;
}

} // namespace stromar
