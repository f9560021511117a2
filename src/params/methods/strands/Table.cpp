#include "TableProof.h"
#include "stromar/params/methods/strands/StrandsParams.h"
#include "stromar/util/Translatable.h"
#include <algorithm>

namespace stromar {

namespace {
using std::string_view;

constexpr Group kStrands{N_("Strands")};
constexpr Group kGroups[] = {kStrands, Group::Tree, Group::Trunk, Group::Leaves, Group::Blossom, Group::Textures};
constexpr Invalidation kFromTrunk{Stage::Structure, 0};
constexpr Invalidation kLeavesOnly{Stage::Structure, Invalidation::kLeaves};
constexpr Range kAnyX{-20000, 20000};
constexpr string_view kByOrder = N_("turns aside"), kByDepth = N_("splits below");
constexpr string_view kOver[] = {N_("order"), N_("height"), N_("rootLength"), N_("thickness")};
constexpr string_view kOverHelp =
    N_("What the curve runs over: the number of turns aside from the trunk (order), or the height in metres, the length from the root in metres, the thickness in centimetres of the branch that splits, at its base.");

using Inactive = string_view (*)(const CParams&, int);
constexpr Inactive kNeedsLeaves = [](const CParams& p, int) -> string_view {
    return strands(p).stemLeaves > 0 ? "" : N_("It places the leaves of twigs: their Number is 0.");
};

// clang-format off
constexpr ParamInfo kRows[] = {
    {.key = "Strands", .label = N_("Strands"), .group = kStrands, .section = N_("Trunk"), .field = field<&StrandsParams::strands>,
     .range = {1, 20000}, .useful = {1, 8000}, .step = 1, .defaults = {200}, .invalidates = kFromTrunk,
     .help = N_("How many strands the trunk has, S: each of them ends in a twig of its own, so a tree has as many twigs and 2S - 1 branches."), .demo = {.values = {10, 50, 200}}},
    {.key = "TrunkHeight", .label = N_("Height of the trunk"), .group = kStrands, .section = N_("Trunk"), .unit = Unit::Metre, .field = field<&StrandsParams::trunkHeight>,
     .range = {0.001, 1000}, .useful = {0.1, 15}, .step = 0.1, .decimals = 3, .defaults = {2}, .invalidates = kFromTrunk,
     .help = N_("How long the trunk is below its first split."), .demo = {.values = {1, 2, 4}}},
    {.key = "InheritedLength", .label = N_("Inherited length"), .group = kStrands, .section = N_("Trunk"), .unit = Unit::Metre, .field = field<&StrandsParams::inheritedLength>,
     .range = {0.001, 1000}, .useful = {0.1, 15}, .step = 0.1, .decimals = 3, .defaults = {2}, .invalidates = kFromTrunk,
     .help = N_("The length that the first branches inherit, L: every split hands a part of it on."), .demo = {.values = {1, 2, 4}}},
    {.key = "StrandThickness", .label = N_("Thickness of a strand"), .group = kStrands, .section = N_("Trunk"), .unit = Unit::Metre, .field = field<&StrandsParams::strandThickness>,
     .range = {0, 1}, .useful = {0.001, 0.05}, .step = 0.001, .decimals = 4, .defaults = {0.02}, .invalidates = kFromTrunk,
     .help = N_("How thick a branch of one strand is. One of S strands has the diameter d = this times the root of S, so that the wood above a split has the area of that below."), .demo = {.values = {0.01, 0.02, 0.04}}},
    {.key = "StrandShareG", .label = N_("Strands of the leader"), .group = kStrands, .section = N_("Shares"), .field = field<&StrandsParams::strandShareG>,
     .range = {0.5, 1}, .useful = {0.5, 1}, .step = 0.01, .decimals = 3, .defaultText = "0:0.65", .invalidates = kFromTrunk,
     .help = N_("The part of the strands that goes on in the leader at a split, k_s: it gets S1 = 1 + (k_s (S - 2) rounded up), the side branch the rest. 0.5 splits evenly, 1 makes a single axis with twigs."), .over = kAnyX, .shownOver = {0, 6}, .overLabel = kByOrder},
    {.key = "GravicentralismG", .label = N_("Turn of the leader"), .group = kStrands, .section = N_("Shares"), .field = field<&StrandsParams::gravicentralismG>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaultText = "0:0.4, 1:1", .invalidates = kFromTrunk,
     .help = N_("Gravicentralism, k_c: the leader turns aside by this times the split angle times the root of S2 / S, the side branch by the rest. 0 goes straight on, as many trunks do."), .over = kAnyX, .shownOver = {0, 6}, .overLabel = kByOrder},
    {.key = "SplitAngleG", .label = N_("Split angle"), .group = kStrands, .section = N_("Angles"), .unit = Unit::Degree, .field = field<&StrandsParams::splitAngleG>,
     .range = {0, 180}, .useful = {0, 120}, .step = 1, .decimals = 2, .defaultText = "0:50", .invalidates = kFromTrunk,
     .help = N_("The angle between leader and side branch at a split, α."), .over = kAnyX, .shownOver = {0, 6}, .overLabel = kByOrder},
    {.key = "PlaneTurnG", .label = N_("Turn of the plane"), .group = kStrands, .section = N_("Angles"), .unit = Unit::Degree, .field = field<&StrandsParams::planeTurnG>,
     .range = {0, 180}, .useful = {0, 180}, .step = 1, .decimals = 2, .defaultText = "0:90", .invalidates = kFromTrunk,
     .help = N_("How far the plane of a split is turned about the branch against the one before: 90 and 137.5 wind about it, 0 and 180 lie flat."), .over = kAnyX, .shownOver = {0, 6}, .overLabel = kByOrder},
    {.key = "GravimorphismG", .label = N_("Hanging"), .synonyms = N_("gravity droop weeping"), .group = kStrands, .section = N_("Angles"), .unit = Unit::Degree, .field = field<&StrandsParams::gravimorphismG>,
     .range = {0, 180}, .useful = {0, 60}, .step = 0.5, .decimals = 2, .defaultText = "0:4", .invalidates = kFromTrunk,
     .help = N_("Gravimorphism: how far every branch turns towards the ground after a split, until it hangs."), .over = kAnyX, .shownOver = {0, 6}, .overLabel = kByOrder},
    {.key = "LengthLeastG", .label = N_("Min length ratio"), .group = kStrands, .section = N_("Lengths"), .field = field<&StrandsParams::lengthLeastG>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaultText = "0:0.5", .invalidates = kFromTrunk,
     .help = N_("A branch inherits the length of the one below times the root of its part of the strands, but at least this part, k_m."), .over = kAnyX, .shownOver = {0, 6}, .overLabel = kByOrder},
    {.key = "LengthMostG", .label = N_("Max length ratio"), .group = kStrands, .section = N_("Lengths"), .field = field<&StrandsParams::lengthMostG>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaultText = "0:0.95", .invalidates = kFromTrunk,
     .help = N_("A branch inherits the length of the one below times the root of its part of the strands, but at most this part, k_M."), .over = kAnyX, .shownOver = {0, 6}, .overLabel = kByOrder},
    {.key = "LengthFactorG", .label = N_("Drawn length"), .group = kStrands, .section = N_("Lengths"), .field = field<&StrandsParams::lengthFactorG>,
     .range = {0, 100}, .useful = {0, 2}, .step = 0.05, .decimals = 3, .defaultText = "0:1", .invalidates = kFromTrunk,
     .help = N_("How much of the inherited length the branches above a split are drawn with, k_l; what they hand on stays the same."), .over = kAnyX, .shownOver = {0, 6}, .overLabel = kByOrder},
    {.key = "StrandVariation", .label = N_("Variation"), .group = kStrands, .section = N_("Variation"), .field = field<&StrandsParams::strandVariation>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kFromTrunk,
     .help = N_("How far angles stray from the curves, by the seed: 0 gives every tree the same form."), .demo = {"Seed=4", {0, 0.5, 1}}},
    {.key = "StrandShareW", .label = N_("Strands of the leader"), .group = kStrands, .section = N_("Factors by depth"), .field = field<&StrandsParams::strandShareW>,
     .range = {0, 100}, .useful = {0, 2}, .step = 0.05, .decimals = 3, .defaultText = "0:1", .invalidates = kFromTrunk,
     .help = N_("A factor of this value over the depth: how many splits lie below."), .over = kAnyX, .shownOver = {0, 12}, .overLabel = kByDepth},
    {.key = "SplitAngleW", .label = N_("Split angle"), .group = kStrands, .section = N_("Factors by depth"), .field = field<&StrandsParams::splitAngleW>,
     .range = {0, 100}, .useful = {0, 2}, .step = 0.05, .decimals = 3, .defaultText = "0:1", .invalidates = kFromTrunk,
     .help = N_("A factor of this value over the depth: how many splits lie below."), .over = kAnyX, .shownOver = {0, 12}, .overLabel = kByDepth},
    {.key = "PlaneTurnW", .label = N_("Turn of the plane"), .group = kStrands, .section = N_("Factors by depth"), .field = field<&StrandsParams::planeTurnW>,
     .range = {0, 100}, .useful = {0, 2}, .step = 0.05, .decimals = 3, .defaultText = "0:1", .invalidates = kFromTrunk,
     .help = N_("A factor of this value over the depth: how many splits lie below."), .over = kAnyX, .shownOver = {0, 12}, .overLabel = kByDepth},
    {.key = "GravimorphismW", .label = N_("Hanging"), .group = kStrands, .section = N_("Factors by depth"), .field = field<&StrandsParams::gravimorphismW>,
     .range = {0, 100}, .useful = {0, 2}, .step = 0.05, .decimals = 3, .defaultText = "0:1", .invalidates = kFromTrunk,
     .help = N_("A factor of this value over the depth: how many splits lie below."), .over = kAnyX, .shownOver = {0, 12}, .overLabel = kByDepth},
    {.key = "LengthLeastW", .label = N_("Min length ratio"), .group = kStrands, .section = N_("Factors by depth"), .field = field<&StrandsParams::lengthLeastW>,
     .range = {0, 100}, .useful = {0, 2}, .step = 0.05, .decimals = 3, .defaultText = "0:1", .invalidates = kFromTrunk,
     .help = N_("A factor of this value over the depth: how many splits lie below."), .over = kAnyX, .shownOver = {0, 12}, .overLabel = kByDepth},
    {.key = "LengthMostW", .label = N_("Max length ratio"), .group = kStrands, .section = N_("Factors by depth"), .field = field<&StrandsParams::lengthMostW>,
     .range = {0, 100}, .useful = {0, 2}, .step = 0.05, .decimals = 3, .defaultText = "0:1", .invalidates = kFromTrunk,
     .help = N_("A factor of this value over the depth: how many splits lie below."), .over = kAnyX, .shownOver = {0, 12}, .overLabel = kByDepth},
    {.key = "LengthFactorW", .label = N_("Drawn length"), .group = kStrands, .section = N_("Factors by depth"), .field = field<&StrandsParams::lengthFactorW>,
     .range = {0, 100}, .useful = {0, 2}, .step = 0.05, .decimals = 3, .defaultText = "0:1", .invalidates = kFromTrunk,
     .help = N_("A factor of this value over the depth: how many splits lie below."), .over = kAnyX, .shownOver = {0, 12}, .overLabel = kByDepth},
    {.key = "SplitAngleOver", .label = N_("Split angle"), .group = kStrands, .section = N_("What curves run over"), .field = field<&StrandsParams::splitAngleOver>,
     .range = {0, 3}, .useful = {0, 3}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk, .help = kOverHelp, .words = kOver, .atRandom = false, .demo = {"SplitAngleG=1:20,4:130", {0, 1, 2}}},
    {.key = "PlaneTurnOver", .label = N_("Turn of the plane"), .group = kStrands, .section = N_("What curves run over"), .field = field<&StrandsParams::planeTurnOver>,
     .range = {0, 3}, .useful = {0, 3}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk, .help = kOverHelp, .words = kOver, .atRandom = false, .demo = {"PlaneTurnG=2:0,4:137", {0, 1, 2}}},
    {.key = "GravimorphismOver", .label = N_("Hanging"), .group = kStrands, .section = N_("What curves run over"), .field = field<&StrandsParams::gravimorphismOver>,
     .range = {0, 3}, .useful = {0, 3}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk, .help = kOverHelp, .words = kOver, .atRandom = false, .demo = {"GravimorphismG=2:0,5:50", {0, 1, 2}}},
    {.key = "LengthLeastOver", .label = N_("Min length ratio"), .group = kStrands, .section = N_("What curves run over"), .field = field<&StrandsParams::lengthLeastOver>,
     .range = {0, 3}, .useful = {0, 3}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk, .help = kOverHelp, .words = kOver, .atRandom = false, .demo = {"LengthLeastG=1:0.9,4:0.3", {0, 1, 2}}},
    {.key = "LengthMostOver", .label = N_("Max length ratio"), .group = kStrands, .section = N_("What curves run over"), .field = field<&StrandsParams::lengthMostOver>,
     .range = {0, 3}, .useful = {0, 3}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk, .help = kOverHelp, .words = kOver, .atRandom = false, .demo = {"LengthMostG=1:0.6,4:1", {0, 1, 2}}},
    {.key = "LengthFactorOver", .label = N_("Drawn length"), .group = kStrands, .section = N_("What curves run over"), .field = field<&StrandsParams::lengthFactorOver>,
     .range = {0, 3}, .useful = {0, 3}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk, .help = kOverHelp, .words = kOver, .atRandom = false, .demo = {"LengthFactorG=1:0.5,4:2", {0, 1, 2}}},
    {.key = "GravicentralismOver", .label = N_("Turn of the leader"), .group = kStrands, .section = N_("What curves run over"), .field = field<&StrandsParams::gravicentralismOver>,
     .range = {0, 3}, .useful = {0, 3}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk, .help = kOverHelp, .words = kOver, .atRandom = false, .demo = {"GravicentralismG=1:0,4:1", {0, 1, 2}}},
    {.key = "StemLeaves", .label = N_("Number"), .group = Group::Leaves, .section = N_("Placement"), .field = field<&StrandsParams::stemLeaves>,
     .range = {0, 5000}, .useful = {0, 40}, .step = 1, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("How many leaves a twig of one strand bears."), .demo = {"LeafScale=0.3", {1, 4, 12}}},
    {.key = "LeafDownAngle", .label = N_("Down angle"), .group = Group::Leaves, .section = N_("Placement"), .unit = Unit::Degree, .field = field<&StrandsParams::leafDownAngle>,
     .range = {-180, 180}, .useful = {0, 90}, .step = 1, .decimals = 1, .defaults = {90}, .invalidates = kLeavesOnly,
     .help = N_("The angle between the leaves and their twig."), .inactive = kNeedsLeaves, .demo = {"LeafScale=0.3 StemLeaves=8", {10, 45, 90}}},
    {.key = "LeafRotate", .label = N_("Rotation"), .group = Group::Leaves, .section = N_("Placement"), .unit = Unit::Degree, .field = field<&StrandsParams::leafRotate>,
     .range = {-360, 360}, .useful = {-180, 180}, .step = 1, .decimals = 1, .defaults = {137.5}, .invalidates = kLeavesOnly,
     .help = N_("The turn about the twig from one leaf to the next."), .inactive = kNeedsLeaves, .demo = {"LeafScale=0.3 StemLeaves=10", {0, 90, 180}}},
};
// clang-format on

static_assert(rowsAreSane(kRows), "a row has no text, a bad range, a default out of range, or a twin");
static_assert(bytesDescribed(kRows, false) == sizeof(StrandsParams), "a field of StrandsParams has no row");

constexpr const ParamInfo* rowNamed(string_view key) {
    return std::ranges::find(kRows, key, &ParamInfo::key);
}
constexpr StrandValue valueOf(string_view byOrder, string_view byDepth, string_view over) {
    return {rowNamed(byOrder), byDepth.empty() ? nullptr : rowNamed(byDepth), over.empty() ? nullptr : rowNamed(over)};
}
/// By StrandValueId. The strands of a branch are whole numbers that growth has to nest: its share runs over orders alone.
constexpr StrandValue kValues[] = {
    valueOf("StrandShareG", "StrandShareW", ""),
    valueOf("SplitAngleG", "SplitAngleW", "SplitAngleOver"),
    valueOf("PlaneTurnG", "PlaneTurnW", "PlaneTurnOver"),
    valueOf("GravimorphismG", "GravimorphismW", "GravimorphismOver"),
    valueOf("LengthLeastG", "LengthLeastW", "LengthLeastOver"),
    valueOf("LengthMostG", "LengthMostW", "LengthMostOver"),
    valueOf("LengthFactorG", "LengthFactorW", "LengthFactorOver"),
    valueOf("GravicentralismG", "", "GravicentralismOver"),
};

/// The base of a trunk is as thick as its strands say, leaves stand as their angles say, and no seed turns the tree.
constexpr CommonDefault kDefaults[] = {{"Flare", 0}, {"LeafBend", 0}, {"Seed", 0}};

bool hasLeaves(const CParams& params) { return strands(params).stemLeaves > 0; }

string_view inactiveHere(const ParamRef& ref, const CParams& params) {
    if (ref.info->group == Group::Leaves && ref.info->field != field<&StrandsParams::stemLeaves> && !hasLeaves(params))
        return N_("The tree has no leaves: their Number is 0.");
    return {};
}

constexpr ParamBlock kBlock{
    .method = "strands",
    .label = N_("Strand model"),
    .help = N_("A trunk of strands that split again and again until each is a twig: drawn curves say how. Holton 1994."),
    .rows = kRows,
    .groups = kGroups,
    .make = &makeBlock<StrandsParams>,
    .equal = &equalBlocks<StrandsParams>,
    .commonDefaults = kDefaults,
    .hasLeaves = &hasLeaves,
    .inactive = &inactiveHere,
};
} // namespace

const ParamBlock& strandsBlock() { return kBlock; }

std::span<const StrandValue> strandValues() { return kValues; }

std::optional<CurveOver> overOf(const ParamInfo& curve, const CParams& params) {
    for (const StrandValue& value : kValues) {
        if (value.byDepth && value.byDepth->field == curve.field) return {};
        if (value.byOrder->field == curve.field)
            return value.over ? static_cast<CurveOver>(static_cast<int>(value.over->get(params))) : CurveOver::Order;
    }
    return {};
}

} // namespace stromar
