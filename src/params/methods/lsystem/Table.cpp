#include "TableProof.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/util/Translatable.h"
#include <algorithm>

namespace stromar {

namespace {
using std::string_view;

constexpr Group kGrammar{N_("Grammar")};
constexpr Group kGroups[] = {kGrammar, Group::Tree, Group::Trunk, Group::Leaves, Group::Blossom, Group::Textures};
constexpr Invalidation kFromTrunk{Stage::Structure, 0};
constexpr Invalidation kLeavesOnly{Stage::Structure, Invalidation::kLeaves};

constexpr string_view kFirstGrammar = "#define r 0.86      // 0.5 .. 0.95   length of a branch, as a part of the wood below it\n"
                                      "#define w 0.55      // 0.4 .. 0.9    width, likewise\n"
                                      "axiom: !(7)F(1)/(90)A(1,6)\n"
                                      "A(l,b) -> !(b)F(l*r)[&&A(l*r,b*w)]/(137.5)[&&A(l*r,b*w)]/(137.5)A(l*r,b*0.75)\n";

bool writes(const CParams& params, string_view organ) { return lsystem(params).grammar.find(organ) != std::string::npos; }

/// Whether a turtle's turn without a number stands in some word. Comments may mislead it: then the value is not greyed.
bool hasBareTurn(string_view grammar) {
    int depth = 0;
    for (std::size_t i = 0; i < grammar.size(); ++i) {
        const char c = grammar[i], next = i + 1 < grammar.size() ? grammar[i + 1] : '\0';
        const bool startsLine = i == 0 || grammar[i - 1] == '\n';
        const bool isComment = c == '/' && next == '/' && i > 0 && (grammar[i - 1] == ' ' || startsLine);
        if (isComment || (startsLine && c == '#')) i = std::min(grammar.find('\n', i), grammar.size());
        if (c == '(' || c == ')') depth += c == '(' ? 1 : -1;
        const bool isArrow = c == '-' && (next == '>' || next == '-');
        if (!isComment && !isArrow && depth == 0 && string_view("+-&^\\/").find(c) != string_view::npos && next != '(') return true;
    }
    return false;
}

using Inactive = string_view (*)(const CParams&, int);
constexpr Inactive kNeedsTropism = [](const CParams& p, int) -> string_view {
    return lsystem(p).tropismBend != 0 ? "" : N_("Nothing bends: the strength of the tropism is 0.");
};
constexpr Inactive kNeedsBareTurns = [](const CParams& p, int) -> string_view {
    return hasBareTurn(lsystem(p).grammar) ? "" : N_("Every turn of the grammar has a number.");
};
constexpr Inactive kNeedsStemLeaves = [](const CParams& p, int) -> string_view {
    return lsystem(p).stemLeaves > 0 ? "" : N_("It places the leaves of stems: their Number is 0. Leaves that the grammar writes stand where it says.");
};

// clang-format off
constexpr ParamInfo kRows[] = {
    {.key = "Grammar", .label = N_("Grammar"), .group = kGrammar, .section = N_("Rules"), .field = field<&LSystemParams::grammar>,
     .defaultText = kFirstGrammar, .invalidates = kFromTrunk,
     .help = N_("The rules that the tree grows by: values, an axiom, and productions that rewrite every module of the word at once."), .block = true},
    {.key = "Derivations", .label = N_("Derivations"), .group = kGrammar, .section = N_("Rules"), .field = field<&LSystemParams::derivations>,
     .range = {0, 60}, .useful = {0, 20}, .step = 1, .defaults = {6}, .invalidates = kFromTrunk,
     .help = N_("How often the word is rewritten."), .atRandom = false, .demo = {.values = {1, 3, 5}}},
    {.key = "LengthUnit", .label = N_("Unit of length"), .group = kGrammar, .section = N_("Turtle"), .unit = Unit::Metre, .field = field<&LSystemParams::lengthUnit>,
     .range = {1e-6, 1000}, .useful = {0.01, 2}, .step = 0.01, .decimals = 3, .defaults = {1}, .invalidates = kFromTrunk,
     .help = N_("How long F(1) is."), .atRandom = false, .demo = {.values = {0.4, 0.7, 1}}},
    {.key = "WidthUnit", .label = N_("Unit of width"), .group = kGrammar, .section = N_("Turtle"), .unit = Unit::Metre, .field = field<&LSystemParams::widthUnit>,
     .range = {1e-6, 1000}, .useful = {0.001, 0.1}, .step = 0.001, .decimals = 4, .defaults = {0.03}, .invalidates = kFromTrunk,
     .help = N_("How thick wood of the width !(1) is: a diameter."), .demo = {.values = {0.01, 0.03, 0.06}}},
    {.key = "TurnAngle", .label = N_("Angle"), .group = kGrammar, .section = N_("Turtle"), .unit = Unit::Degree, .field = field<&LSystemParams::turnAngle>,
     .range = {-360, 360}, .useful = {0, 90}, .step = 0.5, .decimals = 2, .defaults = {22.5}, .invalidates = kFromTrunk,
     .help = N_("How far + - & ^ \\ / turn where they have no number."), .inactive = kNeedsBareTurns, .demo = {.values = {10, 22.5, 40}}},
    {.key = "TropismBend", .label = N_("Strength"), .group = kGrammar, .section = N_("Tropism"), .field = field<&LSystemParams::tropismBend>,
     .range = {-3.1415, 3.1415}, .useful = {-0.5, 0.5}, .step = 0.01, .decimals = 3, .defaults = {0}, .invalidates = kFromTrunk,
     .help = N_("How far every F bends towards the tropism's direction when it stands square to it, in radians."), .demo = {.values = {-0.3, 0, 0.3}}},
    {.key = "TropismX", .label = N_("Direction X"), .group = kGrammar, .section = N_("Tropism"), .field = field<&LSystemParams::tropismX>,
     .range = {-100, 100}, .useful = {-1, 1}, .step = 0.05, .decimals = 3, .defaults = {0}, .invalidates = kFromTrunk,
     .help = N_("Where stems bend to: gravity points down, light up, wind aside."), .inactive = kNeedsTropism, .demo = {"TropismBend=0.3", {-1, 0, 1}}},
    {.key = "TropismY", .label = N_("Direction Y"), .group = kGrammar, .section = N_("Tropism"), .field = field<&LSystemParams::tropismY>,
     .range = {-100, 100}, .useful = {-1, 1}, .step = 0.05, .decimals = 3, .defaults = {0}, .invalidates = kFromTrunk,
     .help = N_("Where stems bend to: gravity points down, light up, wind aside."), .inactive = kNeedsTropism, .demo = {"TropismBend=0.3", {-1, 0, 1}}},
    {.key = "TropismZ", .label = N_("Direction Z"), .group = kGrammar, .section = N_("Tropism"), .field = field<&LSystemParams::tropismZ>,
     .range = {-100, 100}, .useful = {-1, 1}, .step = 0.05, .decimals = 3, .defaults = {-1}, .invalidates = kFromTrunk,
     .help = N_("Where stems bend to: -1 is down."), .inactive = kNeedsTropism, .demo = {"TropismBend=0.3", {-1, 0, 1}}},
    {.key = "StemLeaves", .label = N_("Number"), .group = Group::Leaves, .section = N_("Placement"), .field = field<&LSystemParams::stemLeaves>,
     .range = {0, 5000}, .useful = {0, 40}, .step = 1, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("How many leaves a stem without branches bears, besides those that the grammar writes as ~L."), .demo = {"Derivations=2 LeafScale=0.3", {1, 4, 12}}},
    {.key = "LeafDownAngle", .label = N_("Down angle"), .group = Group::Leaves, .section = N_("Placement"), .unit = Unit::Degree, .field = field<&LSystemParams::leafDownAngle>,
     .range = {-180, 180}, .useful = {0, 90}, .step = 1, .decimals = 1, .defaults = {45}, .invalidates = kLeavesOnly,
     .help = N_("The angle between these leaves and their stem."), .inactive = kNeedsStemLeaves, .demo = {"Derivations=2 LeafScale=0.3 StemLeaves=8", {10, 45, 80}}},
    {.key = "LeafRotate", .label = N_("Rotation"), .group = Group::Leaves, .section = N_("Placement"), .unit = Unit::Degree, .field = field<&LSystemParams::leafRotate>,
     .range = {-360, 360}, .useful = {-180, 180}, .step = 1, .decimals = 1, .defaults = {137.5}, .invalidates = kLeavesOnly,
     .help = N_("The turn about the stem from one of these leaves to the next."), .inactive = kNeedsStemLeaves, .demo = {"Derivations=1 LeafScale=0.3 StemLeaves=10", {0, 90, 180}}},
};
// clang-format on

static_assert(rowsAreSane(kRows), "a row has no text, a bad range, a default out of range, or a twin");
static_assert(bytesDescribed(kRows, false) == sizeof(LSystemParams), "a field of LSystemParams has no row");

/// The base of a trunk is as the turtle draws it, and leaves stand as the grammar says, unless told otherwise.
constexpr CommonDefault kDefaults[] = {{"Flare", 0}, {"LeafBend", 0}};

bool hasLeaves(const CParams& params) { return lsystem(params).stemLeaves > 0 || writes(params, "~L"); }

string_view inactiveHere(const ParamRef& ref, const CParams& params) {
    const bool counts = ref.info->field == field<&LSystemParams::stemLeaves>;
    if (ref.info->group == Group::Leaves && !counts && !hasLeaves(params))
        return N_("The tree has no leaves: their Number is 0, and the grammar writes no ~L.");
    return {};
}

constexpr ParamBlock kBlock{
    .method = "l-system",
    .label = N_("L-system"),
    .help = N_("A grammar rewrites a word, and a turtle draws it. The Algorithmic Beauty of Plants, chapters 1 and 2."),
    .rows = kRows,
    .groups = kGroups,
    .make = &makeBlock<LSystemParams>,
    .equal = &equalBlocks<LSystemParams>,
    .commonDefaults = kDefaults,
    .hasLeaves = &hasLeaves,
    .hasBlossoms = [](const CParams& p) { return writes(p, "~B"); },
    .hasFruits = [](const CParams& p) { return writes(p, "~K"); },
    .inactive = &inactiveHere,
};
} // namespace

const ParamBlock& lsystemBlock() { return kBlock; }

} // namespace stromar
