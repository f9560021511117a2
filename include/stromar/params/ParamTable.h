#pragma once
#include "stromar/params/Params.h"
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace stromar {

enum class Group { Tree, Trunk, Branches, Leaves, Blossom, Pruning, Textures };
/// All, in the order of the window, of files and of the manual.
inline constexpr std::array kGroups{Group::Tree,    Group::Trunk,   Group::Branches, Group::Leaves,
                                    Group::Blossom, Group::Pruning, Group::Textures};
enum class Unit { None, Metre, Degree };

/// What has to be done again, in the order of the work. A stage includes all that follow.
enum class Stage { Structure, Mesh, Material, None };

/// The first stage and the first generation that a change makes invalid. Deeper generations follow.
struct Invalidation {
    static constexpr int kOwnLevel = -1;  ///< the level of the value
    static constexpr int kLastLevel = -2; ///< the first generation that only one of the two trees has
    static constexpr int kLeaves = 1000;  ///< the leaves alone
    static constexpr int kNone = 1001;    ///< nothing that grows

    Stage stage = Stage::None;
    int generation = 0;
    bool operator==(const Invalidation&) const = default;
};

struct Range {
    double min, max;
    constexpr bool contains(double v) const { return v >= min && v <= max; }
};

/// What the pictures beside a help text show: trees that differ in the one value.
struct Shown {
    std::string_view settings{};    ///< `Key=value …` that the pictures have besides; `n` stands for the level
    std::array<double, 3> values{}; ///< all 0: spread over the useful range
    bool fromAbove = false;
};

/// One row of the parameter table: everything the program knows about one number. Files, command line, window, manual,
/// undo, rebuilding and tests are loops over these rows.
struct ParamInfo {
    using Field = std::variant<double GlobalParams::*, int GlobalParams::*, double LevelParams::*, int LevelParams::*>;

    std::string_view key; ///< in files; a level's digit goes in front (`1DownAngle`)
    std::string_view label;
    Group group;              ///< where it is shown; rows of a level: Trunk for 0, Branches for the others
    std::string_view section; ///< heading inside the group
    Unit unit = Unit::None;
    Field field;
    Range range;  ///< what files may hold
    Range useful; ///< what a slider covers
    double step;
    int decimals = 0; ///< shown in the window; files keep all
    std::array<double, kParamLevels> defaults;
    Invalidation invalidates;
    std::string_view help;
    std::span<const std::string_view> words{};   ///< names of 0, 1, 2 …
    std::span<const std::string_view> aliases{}; ///< other keys accepted in files
    int firstLevel = 0;                          ///< 1: not for the trunk
    bool placesLeaves = false;                   ///< the level after the last stems' one gives it to the leaves
    /// Why it does nothing in this tree, beside what its level and group say; empty when it acts. Null: it always acts.
    std::string_view (*idle)(const CParams&, int level) = nullptr;
    Shown shown{}; ///< in its picture

    constexpr bool perLevel() const { return field.index() >= 2; }
    constexpr bool integer() const { return field.index() % 2 == 1; }
    constexpr int lastLevel() const { return perLevel() ? kParamLevels - 1 : firstLevel; }
    /// Read, kept and written, but without any effect: no editor.
    constexpr bool unused() const { return invalidates.stage == Stage::None; }

    double get(const CParams&, int level = 0) const;
    /// Clamps to the range (integers are rounded); false if it had to.
    bool set(CParams&, double value, int level = 0) const;
    /// The key as files have it: with the level's digit, if any.
    std::string keyOf(int level) const;
    double defaultOf(int level) const { return defaults[static_cast<std::size_t>(perLevel() ? level : 0)]; }
};

/// One row of the table of texts.
struct TextInfo {
    std::string_view key, label;
    std::string TextParams::*field;
    Group group;
    std::string_view section;
    Stage stage;
    std::string_view help;
    std::string_view recipes{}; ///< of a picture: which recipes are offered, "bark" or "leaf"
    bool shown = true;          ///< as a line of the panel

    constexpr bool path() const { return !recipes.empty(); }
};

std::span<const ParamInfo> paramTable();
std::span<const TextInfo> textTable();

/// A value of a tree: a row and, for rows of a level, which.
struct ParamRef {
    const ParamInfo* info;
    int level = 0;

    std::string key() const { return info->keyOf(level); }
    double get(const CParams& p) const { return info->get(p, level); }
    bool set(CParams& p, double v) const { return info->set(p, v, level); }
    Group group() const { return info->perLevel() && level == 0 ? Group::Trunk : info->group; }
    bool operator==(const ParamRef&) const = default;
};

/// Every number of a tree, group by group: the order of new files and of the manual.
std::span<const ParamRef> allParams();

/// The row of the variation (`…V`) of a value; null when it has none.
const ParamInfo* variationOf(const ParamInfo& info);
/// Why a value does nothing in this tree, in words (marked for translation); empty when it acts.
std::string_view whyIdle(const ParamRef& ref, const CParams& params);

/// What has to be done again to turn the tree of `before` into that of `after`.
Invalidation invalidationOf(const CParams& before, const CParams& after);

std::string_view groupName(Group group);
std::string_view unitName(Unit unit);

/// The names of ways to grow a tree that the key `Method` accepts.
std::span<const std::string_view> treeMethods();

} // namespace stromar
