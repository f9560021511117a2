#pragma once
#include "stromar/model/ExportModel.h"
#include "stromar/util/FileSet.h"
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace stromar {

enum class Pictures { None, Beside, Inside, AlwaysInside }; ///< what a format does with them by itself
/// What of a tree a format may hold, as its readers find it. A test exports a tree in every format and looks for each.
enum class Content : unsigned {
    TexCoords = 1, Normals = 2, Tangents = 4, Materials = 8, Pictures = 16, Opacity = 32, NormalMaps = 64, RoughnessMaps = 128, Tints = 256, Occlusion = 512
};
constexpr unsigned operator|(Content a, Content b) { return static_cast<unsigned>(a) | static_cast<unsigned>(b); }
constexpr unsigned operator|(unsigned a, Content b) { return a | static_cast<unsigned>(b); }

struct ContentInfo {
    Content content;
    std::string_view name; ///< as a user would miss it
    unsigned needs = 0;    ///< where one of these is lost, this goes without saying
};
/// One row for each.
std::span<const ContentInfo> contentTable();
enum class Channels { None, ColoursAndUvs, All }; ///< what vertices carry besides: vertex colours and a second UV; any attribute, bones and tables
/// Leaves are seen from both sides: not unless that is asked for; by triangles of their own for the back, as readers do not draw what is
/// seen from behind; as the material says so.
enum class Sides { One, Triangles, Material };

/// One row of the table of model files that can be written. Command line, window, manual and tests are loops over it.
struct Format {
    std::string_view ending; ///< with its dot
    std::string_view name;
    std::string_view upAxis; ///< "z" or "y"
    unsigned holds;          ///< Contents
    void (*write)(const ExportModel&, const std::filesystem::path&, CFileSet&);
    double bytesPerVertex; ///< about: the size before writing, and how far it is
    Pictures pictures = Pictures::Beside;
    bool objects = false; ///< readers keep objects apart, by their names
    bool lods = false;  ///< holds levels of detail in one file
    bool anyUp = false; ///< readers do not mind which axis is up
    std::string_view remark = {}; ///< what else its readers do otherwise than one would think, for people
    bool looseRoughness = false; ///< pictures of roughness lie beside the file, though no material names them
    bool opacity = false;  ///< opacity is a picture of its own
    bool embeds = false;   ///< can hold pictures, too
    Sides sides = Sides::One;
    Channels channels = Channels::None;
    bool instances = false; ///< holds one mesh at many places
    bool timeSamples = false; ///< holds meshes as they are at the moments of a motion

    bool has(Content content) const { return (holds & static_cast<unsigned>(content)) != 0; }
};

std::span<const Format> formatTable();
/// By the ending of a path, case ignored; null when it cannot be written.
const Format* formatOf(const std::filesystem::path& path);
/// What of a tree is not in its files, or read otherwise, in the user's language: "tangents, occlusion"; "nothing".
std::string lossesOf(const Format& format);
/// "cannot write '.obk', did you mean '.obj'? (.osg .osgt …)"
std::string unknownFormat(const std::filesystem::path& path);

} // namespace stromar
