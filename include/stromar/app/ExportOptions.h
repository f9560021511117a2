#pragma once
#include "stromar/app/Formats.h"
#include "stromar/mesh/Detail.h"
#include "stromar/params/ParamTable.h"
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace stromar {

/// What a user can choose for one export. A plain value; what each means stands in the table.
struct ExportOptions {
    int model = 0, lod = 0, lods = 0, up = 0, textures = 0, wind = 0, bones = 64, watertight = 0, occlusion = 1, textureSize = 0,
        normalMaps = 0, packedMaps = 0, twoSided = 0, collision = 0, leafLight = 0, compression = 0, instances = 0, textureFormat = 0,
        objects = 0, atlas = 0, impostor = 0, secondUv = 0;
    std::filesystem::path sharedPictures{}; ///< a folder where copies of pictures lie once, named by their content; empty: beside the model
    double scale = 1, voxelSize = 0.02, displacement = 0, displacementStrength = 3;

    bool operator==(const ExportOptions&) const = default;
};

// The words of the table, by their place.
enum class ExportedModel { Full, Simple };
enum class ExportedLods { None, InOneFile, FileEach };
enum class ExportedUp { Format, Y, Z };
enum class ExportedTextures { Format, Embed, Copy, Refer };
enum class ExportedOcclusion { None, Attribute, InColours };
enum class ExportedWatertight { None, Voxel };
enum class ExportedTextureFormat { Png, Jpeg };
enum class ExportedNormalMaps { OpenGl, DirectX };
enum class ExportedPackedMaps { None, Orm, UnityMask };
enum class ExportedLeafLight { None, Transmission };
enum class ExportedInstances { None, Leaves };
enum class ExportedObjects { Levels, Materials };
enum class ExportedAtlas { None, Leaves };
enum class ExportedSecondUv { None, LightMap };
enum class ExportedImpostor { None, Cross, HemiOctahedral, Octahedral };
using ExportedCompression = ExportModel::Compression;
enum class ExportedCollision { None, Json, Unreal, Godot };
enum class ExportedTwoSided { Format, No, Yes };
enum class ExportedWind { None, Attributes, CryEngine, Unity, PivotPainter, Bones };

/// One row of the table of choices: the flags of the command line and the rows of the dialog are loops over it.
struct ExportChoice {
    std::string_view key, label, help;
    std::span<const std::string_view> words = {}; ///< of `field`; none: a number
    std::span<const std::string_view> names = {}; ///< the same for people
    int ExportOptions::*field = nullptr;
    double ExportOptions::*number = nullptr;
    Range range = {0, 0}; ///< of a number
    double ExportOptions::*argument = nullptr; ///< a number that may follow a word: another row's
    std::string_view whenZero = {};            ///< what the window says instead of 0
    bool (*counts)(const ExportOptions&) = nullptr; ///< whether it matters beside the other choices; null: always
};
std::span<const ExportChoice> exportChoices();

bool isSolid(const ExportOptions& options);
/// Whether leaves have triangles of their own for their back.
bool isTwoSided(const ExportOptions& options, const Format& format);

/// About: Format::bytesPerVertex with the compression and the instances that were chosen.
double bytesPerVertex(const ExportOptions& options, const Format& format);

/// Sets a choice by its key and a word or number. Throws CError, which says what is wrong.
void setChoice(ExportOptions& options, std::string_view key, std::string_view value);
/// The word or number that setChoice() takes.
std::string choiceText(const ExportOptions& options, const ExportChoice& choice);

/// What a user should know of a choice that the format can do; empty: nothing. Marked for translation.
std::string_view adviceOn(const ExportOptions& options, const Format& format);
/// Why a format cannot do what was chosen; empty when it can. Marked for translation; %1 stands for its ending.
std::string_view conflictOf(const ExportOptions& options, const Format& format);
/// The same in English, with the ending.
std::string conflictText(const ExportOptions& options, const Format& format);
/// The levels of detail that have to be made, the finest first.
std::vector<const Detail*> detailsOf(const ExportOptions& options);

} // namespace stromar
