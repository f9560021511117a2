#include "stromar/app/ExportOptions.h"
#include "stromar/util/Translatable.h"

namespace stromar {

namespace {
using std::string_view;

constexpr string_view kModels[] = {"full", "simple"};
constexpr string_view kLods[] = {"none", "one-file", "file-each"};
constexpr string_view kUps[] = {"format", "y", "z"};
constexpr string_view kTextures[] = {"format", "embed", "copy", "refer"};

constexpr string_view kWinds[] = {"none", "attributes", "cryengine", "unity", "pivot-painter", "bones"};

constexpr string_view kModelNames[] = {N_("Full model"), N_("Simple model")};
constexpr string_view kLodNames[] = {N_("No"), N_("In one file"), N_("A file for each")};
constexpr string_view kUpNames[] = {N_("As usual in the format"), N_("Y"), N_("Z")};
constexpr string_view kTextureNames[] = {N_("As usual in the format"), N_("Inside the file"), N_("Copies beside it"),
                                         N_("Where they are")};

constexpr string_view kWindNames[] = {N_("None"), N_("Attributes for a shader"), N_("CryEngine vertex colours"),
                                      N_("Unity Tree Creator colours"), N_("Unreal Pivot Painter 2 pictures"),
                                      N_("Bones with clips")};
constexpr string_view kWatertights[] = {"none", "voxel"};
constexpr string_view kWatertightNames[] = {N_("No"), N_("Remeshed in voxels")};
constexpr string_view kOcclusions[] = {"none", "attribute", "color"};
constexpr string_view kOcclusionNames[] = {N_("No"), N_("As an attribute"), N_("In the vertex colours")};
constexpr int kMaxBones = 256;

constexpr ExportChoice kChoices[] = {
    {.key = "model",
     .label = N_("Model"),
     .help = N_("Which model: the full one, or the simple one of the preview."),
     .words = kModels,
     .names = kModelNames,
     .field = &ExportOptions::model},
    {.key = "lod",
     .label = N_("Level of detail"),
     .help = N_("Of the full model: 0 is the finest, 1 to 3 have about 50, 25 and 10 % of its triangles."),
     .field = &ExportOptions::lod,
     .range = {0, kMaxLod}},
    {.key = "lods",
     .label = N_("All levels of detail"),
     .help = N_("All four levels of detail: inside one file, or a file for each, named after it."),
     .words = kLods,
     .names = kLodNames,
     .field = &ExportOptions::lods},
    {.key = "scale",
     .label = N_("Scale"),
     .help = N_("The model's metres are multiplied by this: 100 writes centimetres."),
     .number = &ExportOptions::scale,
     .range = {1e-6, 1e6}},
    {.key = "up",
     .label = N_("Up axis"),
     .help = N_("Which axis points up. 'format' takes what programs expect of the format."),
     .words = kUps,
     .names = kUpNames,
     .field = &ExportOptions::up},
    {.key = "textures",
     .label = N_("Textures"),
     .help = N_("Pictures inside the file, as copies beside it, or where they lie now. 'format' takes what is usual."),
     .words = kTextures,
     .names = kTextureNames,
     .field = &ExportOptions::textures},
    {.key = "occlusion",
     .label = N_("Ambient occlusion"),
     .help = N_("How much of the sky vertices see, in glTF files: as an attribute _OCCLUSION for shaders, or multiplied into the vertex "
                "colours (COLOR_0), which darkens the crown in programs that compute this light themselves."),
     .words = kOcclusions,
     .names = kOcclusionNames,
     .field = &ExportOptions::occlusion},
    {.key = "wind",
     .label = N_("Wind"),
     .help = N_("What lets the tree sway in another program: vertex attributes and a table for a shader, vertex colours as an engine "
                "reads them (COLOR_0 then tints the tree where they are not read), pictures of pivots for Unreal, or bones "
                "with clips of wind and growth."),
     .words = kWinds,
     .names = kWindNames,
     .field = &ExportOptions::wind},
    {.key = "bones",
     .label = N_("Bones"),
     .help = N_("How many of the thickest stems get a bone of their own; the others follow theirs. Only with bones."),
     .field = &ExportOptions::bones,
     .range = {1, kMaxBones}},
    {.key = "displacement",
     .label = N_("Displacement"),
     .help = N_("The relief of the bark as triangles, in cells of so many metres: 0.02 for a trunk seen from near; 0: none. Only "
                "level of detail 0 gets it."),
     .number = &ExportOptions::displacement,
     .range = {0, 1}},
    {.key = "displacement-strength",
     .label = N_("Strength of displacement"),
     .help = N_("How deep displaced bark is: 1 is what the picture of its normals shows. Seen from near it may be more."),
     .number = &ExportOptions::displacementStrength,
     .range = {0, 10}},
    {.key = "watertight",
     .label = N_("One solid"),
     .help = N_("For printing: all wood as one closed surface, without leaves. Of up to 5,000 stems."),
     .words = kWatertights,
     .names = kWatertightNames,
     .field = &ExportOptions::watertight,
     .argument = &ExportOptions::voxelSize},
    {.key = "voxel-size",
     .label = N_("Voxel size"),
     .help = N_("The edge of the cubes that a solid is made of, in metres of the tree. Thinner wood becomes as thick."),
     .number = &ExportOptions::voxelSize,
     .range = {1e-4, 100}},
};
} // namespace

std::span<const ExportChoice> exportChoices() { return kChoices; }

bool isSolid(const ExportOptions& options) { return options.watertight == static_cast<int>(ExportedWatertight::Voxel); }

string_view conflictOf(const ExportOptions& options, const Format& format) {
    const auto lods = static_cast<ExportedLods>(options.lods);
    if (lods == ExportedLods::InOneFile && !format.lods)
        return N_("%1 cannot hold levels of detail; choose a file for each");
    if (options.wind != static_cast<int>(ExportedWind::None) && !format.wind)
        return N_("%1 cannot hold what moves in the wind; choose glTF");
    const bool simple = options.model == static_cast<int>(ExportedModel::Simple);
    if (simple && (lods != ExportedLods::None || options.lod > 0))
        return N_("levels of detail belong to the full model; the simple model has none");
    const bool moves = options.wind != static_cast<int>(ExportedWind::None);
    if (isSolid(options) && (moves || lods != ExportedLods::None || simple || options.lod > 0))
        return N_("one solid has no levels of detail and does not move in the wind");
    if (options.displacement > 0 && (isSolid(options) || simple || (lods == ExportedLods::None && options.lod > 0)))
        return N_("only the full model's level of detail 0 has displaced bark");
    if (options.occlusion == static_cast<int>(ExportedOcclusion::InColours)) {
        if (!format.wind) return N_("%1 cannot hold vertex colours; choose glTF");
        if (options.wind == static_cast<int>(ExportedWind::CryEngine) || options.wind == static_cast<int>(ExportedWind::Unity))
            return N_("the colours of this wind hold the occlusion already");
    }
    const auto up = static_cast<ExportedUp>(options.up);
    const bool usual = up == ExportedUp::Format || (up == ExportedUp::Y) == (format.upAxis == "y");
    if (!usual && !format.anyUp)
        return format.upAxis == "y" ? N_("in %1 files y is always up") : N_("in %1 files z is always up");
    const auto textures = static_cast<ExportedTextures>(options.textures);
    if (textures == ExportedTextures::Embed && format.pictures != Pictures::Inside)
        return N_("%1 cannot hold pictures; choose copies");
    return {};
}

std::string conflictText(const ExportOptions& options, const Format& format) {
    std::string text(conflictOf(options, format));
    if (const std::size_t at = text.find("%1"); at != std::string::npos) text.replace(at, 2, format.ending);
    return text;
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
