#pragma once
#include "stromar/model/ExportModel.h"
#include "stromar/util/FileSet.h"
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace stromar {

enum class Pictures { None, Beside, Inside, AlwaysInside }; ///< what a format does with them by itself
enum class Maps { None, Normals, NormalsAndRoughness }; ///< pictures of the relief that it holds
enum class Channels { None, ColoursAndUvs, All }; ///< what vertices carry besides: vertex colours and a second UV; any attribute, bones and tables
/// Leaves are seen from both sides: not unless that is asked for; by triangles of their own for the back, as readers do not draw what is
/// seen from behind; as the material says so.
enum class Sides { One, Triangles, Material };

/// One row of the table of model files that can be written. Command line, window, manual and tests are loops over it.
struct Format {
    std::string_view ending; ///< with its dot
    std::string_view name;
    std::string_view upAxis; ///< "z" or "y"
    std::string_view losses; ///< what a user would miss, for people
    void (*write)(const ExportModel&, const std::filesystem::path&, CFileSet&);
    double bytesPerVertex; ///< about: the size before writing, and how far it is
    Pictures pictures = Pictures::Beside;
    bool objects = false; ///< readers keep objects apart, by their names
    bool lods = false;  ///< holds levels of detail in one file
    bool anyUp = false; ///< readers do not mind which axis is up
    Maps maps = Maps::None;
    bool opacity = false;  ///< opacity is a picture of its own
    bool embeds = false;   ///< can hold pictures, too
    Sides sides = Sides::One;
    Channels channels = Channels::None;
    bool instances = false; ///< holds one mesh at many places
};

std::span<const Format> formatTable();
/// By the ending of a path, case ignored; null when it cannot be written.
const Format* formatOf(const std::filesystem::path& path);
/// "cannot write '.obk', did you mean '.obj'? (.osg .osgt …)"
std::string unknownFormat(const std::filesystem::path& path);

} // namespace stromar
