#pragma once
#include "stromar/params/Curve.h"
#include "stromar/params/Params.h"
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stromar {

constexpr int kParamLevels = 4; ///< sets of values per level; generation 4 and deeper use the last

/// A tab of the window and a part of files and of the manual. A method may bring groups of its own.
struct Group {
    std::string_view name; ///< marked for translation

    constexpr bool operator==(const Group&) const = default;
    static const Group Tree, Trunk, Branches, Leaves, Blossom, Pruning, Textures;
};
inline constexpr Group Group::Tree{"Tree"}, Group::Trunk{"Trunk"}, Group::Branches{"Branches"}, Group::Leaves{"Leaves"},
    Group::Blossom{"Blossom"}, Group::Pruning{"Pruning"}, Group::Textures{"Textures"};

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

enum class ParamKind {
    Number, ///< a double, an angle or a whole number
    Choice, ///< a whole number whose words the row has
    Switch, ///< off and on
    Curve,  ///< control points
    Text    ///< a line, or a block of lines
};

/// What a row holds.
using ParamValue = std::variant<double, CCurve, std::string>;

/// Where a block's values lie in CParams; specialised for values of a level.
template <typename Block>
struct BlockPlace {
    static constexpr bool kPerLevel = false;
    static const Block& in(const CParams& params, int) {
        if constexpr (std::is_same_v<Block, CommonParams>)
            return params.common;
        else if constexpr (std::is_same_v<Block, TextParams>)
            return params.text;
        else
            return params.as<Block>();
    }
};

/// The member of a block that a row describes: field<&CommonParams::seed>.
struct ParamField {
    enum class Type { Real, Angle, Integer, Curve, Text };

    Type type;
    bool perLevel;
    std::size_t bytes;
    std::string_view member; ///< tells it from all others
    const void* (*at)(const CParams&, int level);

    constexpr bool operator==(const ParamField& other) const { return member == other.member; }
};

template <typename Block, typename Value, Value Block::*Member>
const void* memberIn(const CParams& params, int level) {
    return &(BlockPlace<Block>::in(params, level).*Member);
}
template <typename Value>
constexpr ParamField::Type typeOf() {
    using Type = ParamField::Type;
    if constexpr (std::is_same_v<Value, double>) return Type::Real;
    if constexpr (std::is_same_v<Value, Degrees>) return Type::Angle;
    if constexpr (std::is_same_v<Value, int>) return Type::Integer;
    if constexpr (std::is_same_v<Value, CCurve>) return Type::Curve;
    if constexpr (std::is_same_v<Value, std::string>) return Type::Text;
}
/// Its letters, because sanitizers make addresses of functions unknown to the compiler.
template <auto Member>
constexpr std::string_view memberName() {
    return __PRETTY_FUNCTION__;
}
template <auto Member>
struct FieldOf;
template <typename Block, typename Value, Value Block::*Member>
struct FieldOf<Member> {
    static constexpr ParamField value{typeOf<Value>(), BlockPlace<Block>::kPerLevel, sizeof(Value), memberName<Member>(),
                                      &memberIn<Block, Value, Member>};
};
template <auto Member>
inline constexpr ParamField field = FieldOf<Member>::value;

/// What the pictures beside a help text show: trees that differ in the one value.
struct DemoSettings {
    std::string_view settings{};    ///< `Key=value …` that the pictures have besides; `n` stands for the level
    std::array<double, 3> values{}; ///< all 0: spread over the useful range
    bool fromAbove = false;
    bool inWind = false;
};

/// One row of a table of parameters: everything the program knows about one value. Files, command line, window, manual,
/// undo, rebuilding and tests are loops over these rows.
struct ParamInfo {
    std::string_view key; ///< in files; a level's digit goes in front (`1DownAngle`)
    std::string_view label;
    std::string_view synonyms{}; ///< other words that it is looked for by (marked for translation)
    Group group;              ///< where it is shown; rows of a level: Trunk for 0, Branches for the others
    std::string_view section; ///< heading inside the group
    Unit unit = Unit::None;
    ParamField field;
    Range range{};  ///< what files may hold; of a curve its y
    Range useful{}; ///< what a slider covers; of a curve what its editor shows
    double step = 0;
    int decimals = 0; ///< shown in the window; files keep all
    std::array<double, kParamLevels> defaults{};
    std::string_view defaultText{}; ///< of curves and texts, as files have it
    Invalidation invalidates;
    std::string_view help;
    std::span<const std::string_view> words{};   ///< names of 0, 1, 2 …
    std::span<const std::string_view> aliases{}; ///< other keys accepted in files
    int firstLevel = 0;                          ///< 1: not for the trunk
    bool placesLeaves = false;                   ///< the level after the last stems' one gives it to the leaves
    bool atRandom = true;                        ///< whether randomising may move it
    /// Why it does nothing in this tree, beside what its method says; empty when it acts. Null: it always acts.
    std::string_view (*inactive)(const CParams&, int level) = nullptr;
    DemoSettings demo{}; ///< of its picture

    // Of a curve.
    Range over{0, 10};            ///< its x in files
    Range shownOver{0, 6};        ///< what its editor shows
    double overStep = 1;          ///< to which its editor snaps
    std::string_view overLabel{}; ///< what x is
    // Of a text.
    std::string_view recipes{}; ///< of a file: what is built in, recipes of pictures "bark" or "leaf", or "mesh"
    std::string_view whenEmpty{}; ///< of a file: what there is without one (marked for translation)
    bool block = false;         ///< of several lines, between """ in files
    bool shown = true;          ///< as a row of the panel

    constexpr bool perLevel() const { return field.perLevel; }
    constexpr bool integer() const { return field.type == ParamField::Type::Integer; }
    constexpr bool numeric() const { return field.type <= ParamField::Type::Integer; }
    constexpr ParamKind kind() const {
        if (field.type == ParamField::Type::Curve) return ParamKind::Curve;
        if (field.type == ParamField::Type::Text) return ParamKind::Text;
        return words.empty() ? ParamKind::Number : words.size() == 2 && words[0] == "off" ? ParamKind::Switch : ParamKind::Choice;
    }
    constexpr int lastLevel() const { return perLevel() ? kParamLevels - 1 : firstLevel; }
    /// Read, kept and written, but without any effect: no editor.
    constexpr bool unused() const { return numeric() && invalidates.stage == Stage::None; }
    constexpr bool file() const { return !recipes.empty(); }
    constexpr bool picture() const { return file() && recipes != "mesh"; }

    /// Of a number.
    double get(const CParams&, int level = 0) const;
    /// Clamps to the range (integers are rounded); false if it had to.
    bool set(CParams&, double value, int level = 0) const;
    /// The key as files have it: with the level's digit, if any.
    std::string keyOf(int level) const;
};

/// A value of a tree: a row and, for rows of a level, which.
struct ParamRef {
    const ParamInfo* info;
    int level = 0;

    std::string key() const { return info->keyOf(level); }
    // Of a number.
    double get(const CParams& p) const { return info->get(p, level); }
    bool set(CParams& p, double v) const { return info->set(p, v, level); }
    // Of any kind. What is set is clamped to the row's ranges; false if it had to be.
    ParamValue value(const CParams& p) const;
    bool setValue(CParams& p, const ParamValue& value) const;
    const CCurve& curve(const CParams& p) const { return *static_cast<const CCurve*>(info->field.at(p, level)); }
    const std::string& text(const CParams& p) const {
        return *static_cast<const std::string*>(info->field.at(p, level));
    }
    bool differs(const CParams& a, const CParams& b) const;
    Group group() const { return info->perLevel() && level == 0 ? Group::Trunk : info->group; }
    bool operator==(const ParamRef&) const = default;
};

using ParamValues = std::vector<std::pair<ParamRef, ParamValue>>;

/// A default that a method has for a value that all trees have.
struct CommonDefault {
    std::string_view key;
    double value;
};

/// The values of one way to grow a tree: its table and what it says about them.
struct ParamBlock {
    std::string_view method; ///< the word of `Method` in files
    std::string_view label, help;
    std::span<const ParamInfo> rows;
    std::span<const Group> groups; ///< in the order of the window, of files and of the manual; the common ones too
    std::any (*make)();            ///< its struct
    bool (*equal)(const std::any&, const std::any&);
    std::span<const CommonDefault> commonDefaults{};
    bool (*hasLeaves)(const CParams&) = nullptr; ///< null: it always may
    bool (*hasBlossoms)(const CParams&) = nullptr, (*hasFruits)(const CParams&) = nullptr; ///< besides their Number; null: none
    /// Why a row, its own or a common one, does nothing in this tree (marked for translation); empty when it may act.
    std::string_view (*inactive)(const ParamRef&, const CParams&) = nullptr;
    /// What a change of a row of the method redoes, where its table does not say it alone. Null: as the table says.
    Invalidation (*invalidation)(const ParamRef&, const CParams& before, const CParams& after) = nullptr;
};

/// The struct of a block, for ParamBlock::make and equal.
template <typename Block>
std::any makeBlock() {
    return Block{};
}
template <typename Block>
bool equalBlocks(const std::any& a, const std::any& b) {
    return *std::any_cast<Block>(&a) == *std::any_cast<Block>(&b);
}

/// What files without a method have.
const ParamBlock& weberPennBlock();
/// All ways to grow that are known, Weber and Penn's first.
std::span<const ParamBlock* const> paramBlocks();
/// Makes another known; once, before threads start. `block` has to live as long as the program.
void registerBlock(const ParamBlock& block);
/// Null when there is none of that name.
const ParamBlock* blockNamed(std::string_view method);

/// One tab of the window: a group, and for groups of levels which.
struct ParamPage {
    Group group;
    int level = 0;
    std::vector<ParamRef> rows; ///< section by section
};
/// All rows of a method and the common ones, as the window, files and the manual lay them out.
std::span<const ParamPage> pagesOf(const ParamBlock& block);
/// Every value of a tree of that method, page by page.
std::span<const ParamRef> allParams(const ParamBlock& block = weberPennBlock());
/// Those that are numbers, choices and switches.
std::span<const ParamRef> numberParams(const ParamBlock& block = weberPennBlock());
/// The rows of both tables, each once.
std::vector<const ParamInfo*> rowsOf(const ParamBlock& block);

ParamValue defaultOf(const ParamRef& ref, const ParamBlock& block);

/// The row of the variation (`…V`) of a value; null when it has none.
const ParamInfo* variationOf(const ParamInfo& info);
/// Why a value does nothing in this tree, in words (marked for translation); empty when it acts.
std::string_view inactiveReason(const ParamRef& ref, const CParams& params);

/// Whether a tree bears some: so many on a stem, or as its method says.
bool hasBlossoms(const CParams& params);
bool hasFruits(const CParams& params);

/// What has to be done again to turn the tree of `before` into that of `after`.
Invalidation invalidationOf(const CParams& before, const CParams& after);

std::string_view unitName(Unit unit);

} // namespace stromar
