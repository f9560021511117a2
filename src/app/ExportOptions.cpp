#include "stromar/app/ExportOptions.h"
#include "stromar/util/Error.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>

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
constexpr string_view kNormalMaps[] = {"gl", "dx"};
constexpr string_view kNormalMapNames[] = {N_("OpenGL: green is up"), N_("DirectX: green is down")};
constexpr string_view kPackedMaps[] = {"none", "orm", "unity"};
constexpr string_view kPackedMapNames[] = {N_("No"), N_("Occlusion, roughness, metal"), N_("Unity's mask map")};
constexpr string_view kTwoSided[] = {"format", "no", "yes"};
constexpr string_view kTwoSidedNames[] = {N_("As usual in the format"), N_("No: single faces"),
                                          N_("Yes: faces for both sides")};
constexpr string_view kLeafLights[] = {"none", "transmission"};
constexpr string_view kLeafLightNames[] = {N_("No"), N_("Comes through (diffuse transmission)")};
constexpr string_view kCollisions[] = {"none", "json", "unreal", "godot"};
constexpr string_view kCollisionNames[] = {N_("No"), N_("As a list of capsules beside the file"), N_("As Unreal looks for it: UCX_…"),
                                           N_("As Godot looks for it: …-colonly")};
constexpr string_view kCompressions[] = {"none", "quantize", "meshopt"};
constexpr string_view kCompressionNames[] = {N_("No"), N_("Quantised (KHR_mesh_quantization)"), N_("Quantised, then meshopt (EXT_meshopt_compression)")};
constexpr string_view kTextureFormats[] = {"png", "jpg"};
constexpr string_view kTextureFormatNames[] = {N_("PNG"), N_("JPEG where it can be")};
constexpr string_view kInstances[] = {"none", "leaves"};
constexpr string_view kInstancesNames[] = {N_("No"), N_("Leaves")};
constexpr string_view kObjects[] = {"levels", "materials"};
constexpr string_view kObjectsNames[] = {N_("By branch level"), N_("By material")};
constexpr string_view kAtlases[] = {"none", "leaves"};
constexpr string_view kAtlasNames[] = {N_("No"), N_("Leaves, blossoms and twigs")};
constexpr string_view kImpostors[] = {"none", "cross", "hemi-octahedral", "octahedral"};
constexpr string_view kImpostorNames[] = {N_("No"), N_("Cross of billboards"), N_("Views from above the horizon (hemi-octahedral)"), N_("Views from all sides (octahedral)")};
constexpr string_view kSecondUvs[] = {"none", "lightmap"};
constexpr string_view kSecondUvNames[] = {N_("No"), N_("Without overlap, for light maps")};
constexpr int kMaxBones = 256, kMaxTexture = 8192;

constexpr ExportChoice kChoices[] = {
    {.key = "model",
     .label = N_("Model"),
     .help = N_("Which model: the full one, or the simple one of the preview."),
     .words = kModels,
     .names = kModelNames,
     .field = &ExportOptions::model},
    {.key = "lod",
     .label = N_("Level of detail"),
     .help = N_("Of the full model: 0 is the finest, 1 to 3 have about 50, 12 and 4 % of its triangles."),
     .field = &ExportOptions::lod,
     .range = {0, kMaxLod}},
    {.key = "lods",
     .label = N_("All levels of detail"),
     .help = N_("All four levels of detail: inside one file, or a file for each, named after it."),
     .words = kLods,
     .names = kLodNames,
     .field = &ExportOptions::lods},
    {.key = "impostor",
     .label = N_("Impostor"),
     .help = N_("What stands for the tree when it is far: two crossed billboards as the last level of detail, or 8 × 8 views in an atlas "
                "beside the model (albedo, normal, depth), for a shader that shows the nearest."),
     .words = kImpostors,
     .names = kImpostorNames,
     .field = &ExportOptions::impostor},
    {.key = "scale",
     .label = N_("Scale"),
     .help = N_("The model's metres are multiplied by this: 100 writes centimetres."),
     .number = &ExportOptions::scale,
     .range = {1e-6, 1e6}},
    {.key = "objects",
     .label = N_("Objects"),
     .help = N_("Separate objects for trunk, branches and leaves, or one object per material: fewer draw calls."),
     .words = kObjects,
     .names = kObjectsNames,
     .field = &ExportOptions::objects},
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
    {.key = "texture-size",
     .label = N_("Max texture size"),
     .help = N_("Pixels that a picture may be wide or high: larger ones are halved until they are no larger; 0: as "
                "they are. PNG pictures only."),
     .field = &ExportOptions::textureSize,
     .range = {0, kMaxTexture},
     .whenZero = N_("as they are")},
    {.key = "texture-format",
     .label = N_("Texture format"),
     .help = N_("What pictures of bark colours are written as: JPEG has about a fifth of the bytes. Pictures with alpha, normals and roughness stay PNG."),
     .words = kTextureFormats,
     .names = kTextureFormatNames,
     .field = &ExportOptions::textureFormat},
    {.key = "atlas",
     .label = N_("Texture atlas"),
     .help = N_("One material and one texture for leaves, blossoms and twigs: fewer draw calls. PNG textures only."),
     .words = kAtlases,
     .names = kAtlasNames,
     .field = &ExportOptions::atlas},
    {.key = "second-uv",
     .label = N_("Second UV"),
     .help = N_("A second set of texture coordinates, in which no two triangles share a place: for light maps, in glTF and FBX files."),
     .words = kSecondUvs,
     .names = kSecondUvNames,
     .field = &ExportOptions::secondUv},
    {.key = "normal-maps",
     .label = N_("Normal maps"),
     .help = N_("Which way the green of normal maps points: up, as OpenGL, Blender, Unity and Godot have it, or down, "
                "as DirectX and Unreal."),
     .words = kNormalMaps,
     .names = kNormalMapNames,
     .field = &ExportOptions::normalMaps},
    {.key = "packed-maps",
     .label = N_("Packed maps"),
     .help = N_("One picture for several maps: occlusion, roughness and metal in red, green and blue, or Unity's mask "
                "map beside the file "
                "(metal, occlusion, detail, smoothness in alpha)."),
     .words = kPackedMaps,
     .names = kPackedMapNames,
     .field = &ExportOptions::packedMaps},
    {.key = "two-sided",
     .label = N_("Two-sided leaves"),
     .help = N_("Whether leaves have triangles of their own for their back, for programs that do not draw what is seen "
                "from behind."),
     .words = kTwoSided,
     .names = kTwoSidedNames,
     .field = &ExportOptions::twoSided},
    {.key = "leaf-light",
     .label = N_("Light through leaves"),
     .help = N_("Of glTF files: leaves with the light behind them are bright (KHR_materials_diffuse_transmission), in "
                "programs that know it; "
                "others show them as without it."),
     .words = kLeafLights,
     .names = kLeafLightNames,
     .field = &ExportOptions::leafLight},
    {.key = "compress",
     .label = N_("Compression"),
     .help = N_("Of glTF files: vertices in 16 and 8 bits, which most programs read, or these compressed by meshoptimizer as well, for web pages "
                "whose loader has its decoder."),
     .words = kCompressions,
     .names = kCompressionNames,
     .field = &ExportOptions::compression},
    {.key = "instances",
     .label = N_("Instances"),
     .help = N_("Of glTF and USD files: one mesh for all leaves of a kind and a list of places instead of a copy for each, for programs that know it "
                "(EXT_mesh_gpu_instancing, PointInstancer). Normals are not rounded, and each leaf has one tint."),
     .words = kInstances,
     .names = kInstancesNames,
     .field = &ExportOptions::instances},
    {.key = "occlusion",
     .label = N_("Ambient occlusion"),
     .help = N_("How much of the sky vertices see, in glTF files: as an attribute _OCCLUSION for shaders, or "
                "multiplied into the vertex "
                "colours (COLOR_0), which darkens the crown in programs that compute this light themselves."),
     .words = kOcclusions,
     .names = kOcclusionNames,
     .field = &ExportOptions::occlusion},
    {.key = "wind",
     .label = N_("Wind"),
     .help =
         N_("What lets the tree sway in another program: vertex attributes and a table for a shader, vertex colours as "
            "an engine "
            "reads them (COLOR_0 then tints the tree where they are not read), pictures of pivots for Unreal, or bones "
            "with clips of wind and growth."),
     .words = kWinds,
     .names = kWindNames,
     .field = &ExportOptions::wind},
    {.key = "collision",
     .label = N_("Collision"),
     .help = N_("What things bump into: a capsule for each thick stem, as a list beside the file (JSON), or also as "
                "meshes with the names that an "
                "engine looks for."),
     .words = kCollisions,
     .names = kCollisionNames,
     .field = &ExportOptions::collision},
    {.key = "bones",
     .label = N_("Bones"),
     .help = N_("How many of the thickest stems get a bone of their own; the others follow theirs. Only with bones."),
     .field = &ExportOptions::bones,
     .range = {1, kMaxBones},
     .counts = [](const ExportOptions& o) { return o.wind == static_cast<int>(ExportedWind::Bones); }},
    {.key = "displacement",
     .label = N_("Displacement"),
     .help = N_("The relief of the bark as triangles, in cells of so many metres: 0.02 for a trunk seen from near; 0: "
                "none. Only "
                "level of detail 0 gets it."),
     .number = &ExportOptions::displacement,
     .range = {0, 1}},
    {.key = "displacement-strength",
     .label = N_("Strength of displacement"),
     .help =
         N_("How deep displaced bark is: 1 is what the picture of its normals shows. Seen from near it may be more."),
     .number = &ExportOptions::displacementStrength,
     .range = {0, 10},
     .counts = [](const ExportOptions& o) { return o.displacement > 0; }},
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
     .range = {1e-4, 100},
     .counts = &isSolid},
};
} // namespace

std::span<const ExportChoice> exportChoices() { return kChoices; }

bool isSolid(const ExportOptions& options) { return options.watertight == static_cast<int>(ExportedWatertight::Voxel); }

bool isTwoSided(const ExportOptions& options, const Format& format) {
    const auto wanted = static_cast<ExportedTwoSided>(options.twoSided);
    return wanted == ExportedTwoSided::Yes || (wanted == ExportedTwoSided::Format && format.sides == Sides::Triangles);
}

double bytesPerVertex(const ExportOptions& options, const Format& format) {
    constexpr double kInstanced = 0.55, kSecondUv = 1.17; // of files of presets
    constexpr double kShares[] = {1, 0.6, 0.27}; // measured with the aspen
    static_assert(std::size(kShares) == std::size(kCompressions));
    const bool shared = options.instances != static_cast<int>(ExportedInstances::None);
    const bool unwrapped = options.secondUv != static_cast<int>(ExportedSecondUv::None);
    return (shared ? kInstanced : 1) * (unwrapped ? kSecondUv : 1) * kShares[options.compression] * format.bytesPerVertex;
}

std::string choiceText(const ExportOptions& options, const ExportChoice& choice) {
    if (choice.number) return numberText(options.*choice.number);
    const int value = options.*choice.field;
    return choice.words.empty() ? std::to_string(value) : std::string(choice.words[static_cast<std::size_t>(value)]);
}

void setChoice(ExportOptions& options, string_view key, string_view value) {
    const auto found = std::ranges::find(kChoices, key, &ExportChoice::key);
    if (found == std::end(kChoices)) {
        std::vector<std::string> keys;
        for (const ExportChoice& choice : kChoices) keys.emplace_back(choice.key);
        throw CError(translated(NC_("stromar", "there is no choice '%1'"), key) + suggestion(key, keys));
    }
    if (!found->words.empty()) {
        const auto word = std::ranges::find(found->words, value);
        std::vector<std::string> words(found->words.begin(), found->words.end());
        std::string all;
        for (const std::string& one : words) all += (all.empty() ? "" : ", ") + one;
        if (word == found->words.end())
            throw CError(translated(NC_("stromar", "'%1' is one of %2, not '%3'"), key, all, value) +
                         suggestion(value, words));
        options.*found->field = static_cast<int>(word - found->words.begin());
        return;
    }
    const auto number = parseNumber(std::string(value));
    if (!number || (found->field && *number != std::floor(*number)))
        throw CError(translated(found->field ? NC_("stromar", "'%1': '%2' is not a number without decimals")
                                             : NC_("stromar", "'%1': '%2' is not a number"),
                                key, value));
    if (*number < found->range.min || *number > found->range.max)
        throw CError(translated(NC_("stromar", "'%1' is between %2 and %3, not %4"), key, found->range.min,
                                found->range.max, value));
    if (found->number)
        options.*found->number = *number;
    else
        options.*found->field = static_cast<int>(*number);
}

string_view adviceOn(const ExportOptions& options, const Format& format) {
    const auto lods = static_cast<ExportedLods>(options.lods);
    if (lods == ExportedLods::InOneFile && (format.ending == ".glb" || format.ending == ".gltf"))
        return N_("Babylon.js shows one level of detail at a time, Blender and Godot all four on top of each other, others the finest alone: choose a "
                  "file for each");
    if (lods == ExportedLods::InOneFile && (format.ending == ".usda" || format.ending == ".usdz"))
        return N_("Levels of detail are variants of the set LOD, which three.js does not read: choose a file for each");
    return {};
}

namespace {
/// Pictures that the export would have to change, or to add.
bool changesPictures(const ExportOptions& options) {
    return options.textureSize > 0 || options.textureFormat != 0 || options.normalMaps != 0 || options.packedMaps != 0 || options.atlas != 0;
}

string_view secondUvConflict(const ExportOptions& options, const Format& format) {
    if (options.secondUv == static_cast<int>(ExportedSecondUv::None)) return {};
    if (format.channels == Channels::None) return N_("%1 holds one set of texture coordinates; choose glTF or FBX");
    if (isSolid(options)) return N_("one solid has no texture coordinates");
    const auto wind = static_cast<ExportedWind>(options.wind);
    if (wind == ExportedWind::Unity || wind == ExportedWind::PivotPainter) return N_("the second texture coordinates hold the wind already");
    if (options.instances != static_cast<int>(ExportedInstances::None)) return N_("instances share their texture coordinates");
    return {};
}

string_view impostorConflict(const ExportOptions& options, const Format& format) {
    const auto impostor = static_cast<ExportedImpostor>(options.impostor);
    if (impostor == ExportedImpostor::None) return {};
    if (isSolid(options)) return N_("one solid has no impostor");
    if (impostor != ExportedImpostor::Cross) return {};
    if (options.lods == static_cast<int>(ExportedLods::None)) return N_("crossed billboards are the last level of detail; choose all levels of detail");
    if (format.pictures == Pictures::None) return N_("%1 holds no textures, so no billboards");
    return {};
}
} // namespace

string_view conflictOf(const ExportOptions& options, const Format& format) {
    const auto lods = static_cast<ExportedLods>(options.lods);
    if (lods == ExportedLods::InOneFile && !format.lods)
        return N_("%1 cannot hold levels of detail; choose a file for each");
    const auto wind = static_cast<ExportedWind>(options.wind);
    if (wind != ExportedWind::None && format.channels == Channels::None)
        return N_("%1 cannot hold what moves in the wind; choose glTF");
    if ((wind == ExportedWind::Attributes || wind == ExportedWind::Bones) && format.channels != Channels::All)
        return N_("%1 holds colours and pivots of the wind, neither attributes nor bones; choose glTF");
    if (options.twoSided == static_cast<int>(ExportedTwoSided::Yes) && format.sides == Sides::Material)
        return N_("%1 shows leaves from both sides by itself");
    const bool simple = options.model == static_cast<int>(ExportedModel::Simple);
    if (simple && (lods != ExportedLods::None || options.lod > 0))
        return N_("levels of detail belong to the full model; the simple model has none");
    const bool moves = options.wind != static_cast<int>(ExportedWind::None);
    if (isSolid(options) && (moves || lods != ExportedLods::None || simple || options.lod > 0))
        return N_("one solid has no levels of detail and does not move in the wind");
    if (options.displacement > 0 && (isSolid(options) || simple || (lods == ExportedLods::None && options.lod > 0)))
        return N_("only the full model's level of detail 0 has displaced bark");
    if (options.occlusion == static_cast<int>(ExportedOcclusion::InColours)) {
        if (format.channels == Channels::None) return N_("%1 cannot hold vertex colours; choose glTF");
        if (options.wind == static_cast<int>(ExportedWind::CryEngine) || options.wind == static_cast<int>(ExportedWind::Unity))
            return N_("the colours of this wind hold the occlusion already");
    }
    if (options.leafLight != static_cast<int>(ExportedLeafLight::None) && format.channels != Channels::All)
        return N_("%1 does not know light through leaves; choose glTF");
    if (options.compression != static_cast<int>(ExportedCompression::None)) {
        if (format.channels != Channels::All) return N_("%1 cannot be compressed; choose glTF");
        if (moves) return N_("what moves in the wind cannot be compressed");
    }
    if (options.instances != static_cast<int>(ExportedInstances::None)) {
        if (!format.instances) return N_("%1 cannot hold instances; choose glTF or USD");
        if (moves) return N_("leaves that move in the wind cannot be instances");
        if (lods == ExportedLods::InOneFile) return N_("instances belong to one level of detail; choose a file for each");
    }
    for (const auto conflictIn : {impostorConflict, secondUvConflict})
        if (const std::string_view conflict = conflictIn(options, format); !conflict.empty()) return conflict;
    if (options.atlas != static_cast<int>(ExportedAtlas::None) && format.pictures == Pictures::None) return N_("%1 holds no textures, so no atlas");
    if (options.collision != static_cast<int>(ExportedCollision::None)) {
        if (!format.objects) return N_("%1 has no objects whose names an engine looks for; choose glTF or FBX");
        if (lods == ExportedLods::InOneFile) return N_("collision belongs to one level of detail; choose a file for each");
        if (isSolid(options)) return N_("one solid is its own collision");
    }
    const auto up = static_cast<ExportedUp>(options.up);
    const bool usual = up == ExportedUp::Format || (up == ExportedUp::Y) == (format.upAxis == "y");
    if (!usual && !format.anyUp)
        return format.upAxis == "y" ? N_("in %1 files y is always up") : N_("in %1 files z is always up");
    const auto textures = static_cast<ExportedTextures>(options.textures);
    if (textures == ExportedTextures::Refer && changesPictures(options))
        return N_("pictures that stay where they are cannot be changed; choose copies");
    const bool inside = textures == ExportedTextures::Embed;
    if (textures != ExportedTextures::Format && !inside && format.pictures == Pictures::AlwaysInside)
        return N_("%1 files have their pictures inside");
    if (inside && format.pictures < Pictures::Inside && !format.embeds)
        return N_("%1 cannot hold pictures; choose copies");
    return {};
}

std::string conflictText(const ExportOptions& options, const Format& format) {
    const std::string_view conflict = conflictOf(options, format);
    return conflict.empty() ? std::string() : translated(conflict, format.ending);
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
