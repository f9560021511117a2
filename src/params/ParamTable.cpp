#include "stromar/params/ParamTable.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace stromar {

namespace {
using G = GlobalParams;
using L = LevelParams;
using std::string_view;

constexpr string_view kShapes[] = {N_("conical"), N_("spherical"),       N_("hemispherical"), N_("cylindrical"), N_("tapered-cylindrical"),
                                   N_("flame"),   N_("inverse-conical"), N_("tend-flame"),    N_("envelope")};
constexpr string_view kLeafShapes[] = {
    N_("oval"), N_("triangle"), N_("three-lobe-oak"), N_("three-lobe-maple"), N_("five-lobe-maple"), N_("three-leaflets"), N_("square"), N_("needles"),
    N_("lance"), N_("heart"), N_("pinnate"), N_("palmate"), N_("fan")};
constexpr string_view kLeafForms[] = {N_("card"), N_("outline")};
constexpr string_view kSwitch[] = {N_("off"), N_("on")};
constexpr string_view kMethods[] = {"weber-penn"};

constexpr string_view kLobeDepthAliases[] = {"LobesDepth"};
constexpr string_view kBaseSplitsAliases[] = {"BaseSplits", "nBaseSplits", "0BaseSplit"};
constexpr string_view kSegSplitsAliases[] = {"SegSplit"};
constexpr string_view kLengthAliases[] = {"Lenght"};
constexpr string_view kLengthVAliases[] = {"LenghtV"};
constexpr string_view kLeafBendAliases[] = {"Bend"};

constexpr Invalidation kFromTrunk{Stage::Structure, 0};
constexpr Invalidation kFromBranches{Stage::Structure, 1};
constexpr Invalidation kFromTwigs{Stage::Structure, 2};
constexpr Invalidation kFromOwnLevel{Stage::Structure, Invalidation::kOwnLevel};
constexpr Invalidation kLeavesOnly{Stage::Structure, Invalidation::kLeaves};
constexpr Invalidation kMeshOnly{Stage::Mesh, 0};
constexpr Invalidation kLeafMesh{Stage::Mesh, Invalidation::kLeaves};
constexpr Invalidation kNothing{Stage::None, 0};

// When a value does nothing. Whether its level has stems, and the tree leaves, is asked for all rows alike.
using Idle = string_view (*)(const CParams&, int);
constexpr Idle kNeedsBranches = [](const CParams& p, int) -> string_view {
    return p.global.levels > 1 ? "" : N_("The tree is a bare trunk: Levels of stems is 1.");
};
constexpr Idle kNeedsTwigs = [](const CParams& p, int) -> string_view {
    return p.global.levels > 2 ? "" : N_("It acts on stems of level 2 and deeper, and there are none.");
};
constexpr Idle kNeedsLobes = [](const CParams& p, int) -> string_view {
    return p.global.lobes > 0 ? "" : N_("The trunk has no lobes.");
};
constexpr Idle kNeedsLobeDepth = [](const CParams& p, int) -> string_view {
    return p.global.lobes > 0 && p.global.lobeDepth > 0 ? "" : N_("The trunk has no lobes, or they have no depth.");
};
constexpr Idle kNeedsRoots = [](const CParams& p, int) -> string_view {
    return p.global.roots > 0 ? "" : N_("The trunk has no roots.");
};
constexpr Idle kNeedsJoint = [](const CParams& p, int) -> string_view {
    return p.level[0].curveRes > 1 ? "" : N_("The trunk has only one segment, so there is no joint to split at.");
};
constexpr Idle kNeedsSplits = [](const CParams& p, int level) -> string_view {
    const bool splits = p.level[static_cast<std::size_t>(level)].segSplits > 0 || (level == 0 && p.global.baseSplits > 0);
    return splits ? "" : N_("These stems never split.");
};
constexpr Idle kNeedsAnySplits = [](const CParams& p, int) -> string_view {
    const auto splits = [](const LevelParams& level) { return level.segSplits > 0; };
    return std::ranges::any_of(p.level, splits) ? "" : N_("Nothing in this tree splits.");
};
constexpr Idle kNeedsOutline = [](const CParams& p, int) -> string_view {
    return p.global.leafForm != 0 ? "" : N_("A card shows what its texture shows: set Form to outline.");
};
constexpr Idle kNeedsCards = [](const CParams& p, int) -> string_view {
    return p.global.leafForm == 0 ? "" : N_("Only cards have several planes: set Form to card.");
};
constexpr Idle kNeedsTrunks = [](const CParams& p, int) -> string_view {
    return p.global.trunks > 1 ? "" : N_("The tree has only one trunk.");
};
constexpr Idle kNeedsSeasons = [](const CParams& p, int) -> string_view {
    return p.global.leaves != 0 || p.global.blossoms > 0 || p.global.fruits > 0
               ? ""
               : N_("The tree has no leaves, blossoms or fruits.");
};
constexpr Idle kNeedsBlossoms = [](const CParams& p, int) -> string_view {
    return p.global.blossoms > 0 ? "" : N_("The tree has no blossoms: their Number is 0.");
};
constexpr Idle kNeedsFruits = [](const CParams& p, int) -> string_view {
    return p.global.fruits > 0 ? "" : N_("The tree has no fruits: their Number is 0.");
};
constexpr Idle kNeedsPruning = [](const CParams& p, int) -> string_view {
    return p.global.pruneRatio > 0 ? "" : N_("Nothing is pruned: Strength is 0.");
};
constexpr Idle kNeedsEnvelope = [](const CParams& p, int) -> string_view {
    return p.global.pruneRatio > 0 || p.global.shape == 8
               ? ""
               : N_("Nothing is pruned, and the crown shape is not the envelope.");
};

// clang-format off
constexpr ParamInfo kParams[] = {
    // The tree as a whole
    {.key = "Shape", .label = N_("Crown shape"), .group = Group::Tree, .section = N_("Crown"), .field = &G::shape,
     .range = {0, 8}, .useful = {0, 8}, .step = 1, .defaults = {0}, .invalidates = kFromBranches,
     .help = N_("The outline of the crown: how long the branches are from its bottom to its top. "
             "'envelope' takes the outline of the pruning tab."),
     .words = kShapes,
     .idle = kNeedsBranches, .shown = {"Levels=2 1Length=0.35"}},
    {.key = "BaseSize", .label = N_("Bare trunk"), .group = Group::Tree, .section = N_("Crown"), .field = &G::baseSize,
     .range = {0, 1}, .useful = {0, 0.95}, .step = 0.01, .decimals = 3, .defaults = {0.25}, .invalidates = kFromBranches,
     .help = N_("The part of the tree's height, from the ground, that bears no branches."),
     .idle = kNeedsBranches, .shown = {.values = {0.1, 0.35, 0.7}}},
    {.key = "Scale", .label = N_("Height"), .group = Group::Tree, .section = N_("Size"), .unit = Unit::Metre, .field = &G::scale,
     .range = {0.01, 1000}, .useful = {0.5, 40}, .step = 0.5, .decimals = 2, .defaults = {10}, .invalidates = kFromTrunk,
     .help = N_("The height of the tree."),
     .shown = {.values = {4, 8, 16}}},
    {.key = "ScaleV", .label = N_("Height variation"), .group = Group::Tree, .section = N_("Size"), .unit = Unit::Metre,
     .field = &G::scaleV, .range = {0, 1000}, .useful = {0, 15}, .step = 0.5, .decimals = 2, .defaults = {0},
     .invalidates = kFromTrunk, .help = N_("How much taller or smaller a tree of another seed may be."),
     .shown = {"Scale=8", {0, 3, 6}}},
    {.key = "ZScale", .label = N_("Z scale"), .group = Group::Tree, .section = N_("Size"), .field = &G::zScale,
     .range = {-1000, 1000}, .useful = {0, 2}, .step = 0.1, .decimals = 2, .defaults = {1}, .invalidates = kNothing,
     .help = N_("Printed in the paper's tables but used by none of its formulas. Kept in files, without effect.")},
    {.key = "ZScaleV", .label = N_("Z scale variation"), .group = Group::Tree, .section = N_("Size"), .field = &G::zScaleV,
     .range = {-1000, 1000}, .useful = {0, 2}, .step = 0.1, .decimals = 2, .defaults = {0}, .invalidates = kNothing,
     .help = N_("Printed in the paper's tables but used by none of its formulas. Kept in files, without effect.")},
    {.key = "Levels", .label = N_("Levels of stems"), .group = Group::Tree, .section = N_("Size"), .field = &G::levels,
     .range = {1, 9}, .useful = {1, 4}, .step = 1, .defaults = {3}, .invalidates = {Stage::Structure, Invalidation::kLastLevel},
     .help = N_("1 grows a bare trunk, 2 adds branches, 3 branches on branches. The leaves sit on the last level."),
     .shown = {"3Branches=4 3Length=0.4", {1, 2, 3}}},
    {.key = "Ratio", .label = N_("Thickness"), .group = Group::Tree, .section = N_("Thickness"), .field = &G::ratio,
     .range = {0.0001, 1}, .useful = {0.002, 0.1}, .step = 0.001, .decimals = 4, .defaults = {0.05}, .invalidates = kFromTrunk,
     .help = N_("The radius of the trunk divided by its length."),
     .shown = {"Levels=2", {0.01, 0.03, 0.07}}},
    {.key = "RatioPower", .label = N_("Thinning"), .group = Group::Tree, .section = N_("Thickness"), .field = &G::ratioPower,
     .range = {-10, 10}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kFromBranches,
     .help = N_("How much thinner than its parent a shorter branch is. Higher values make finer branches."),
     .idle = kNeedsBranches, .shown = {"Levels=2 Ratio=0.04", {0.5, 1, 2}}},
    {.key = "MinRadius", .label = N_("Least radius"), .group = Group::Tree, .section = N_("Thickness"), .unit = Unit::Metre,
     .field = &G::minRadius, .range = {0, 1}, .useful = {0, 0.01}, .step = 0.0005, .decimals = 4, .defaults = {0.0005},
     .invalidates = kMeshOnly, .help = N_("No stem is drawn thinner than this, so that fine twigs stay visible."),
     .shown = {"Levels=2 Ratio=0.01 Scale=4", {0.0005, 0.01, 0.04}}},
    {.key = "AttractionUp", .label = N_("Attraction up"), .group = Group::Tree, .section = N_("Growth"), .field = &G::attractionUp,
     .range = {-100, 100}, .useful = {-10, 10}, .step = 0.1, .decimals = 2, .defaults = {0}, .invalidates = kFromTwigs,
     .help = N_("How strongly branches of level 2 and deeper bend up to the light. Negative values let them hang."),
     .idle = kNeedsTwigs, .shown = {"2CurveRes=6 2Length=0.8 2Branches=5 1Branches=10", {-4, 0, 4}}},
    {.key = "CloneHalving", .label = N_("Halve splitting"), .group = Group::Tree, .section = N_("Growth"), .field = &G::cloneHalving,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {1}, .invalidates = kFromTrunk,
     .help = N_("On: a stem that has split, and its clones, split half as often from then on."), .words = kSwitch,
     .idle = kNeedsAnySplits, .shown = {"Levels=2 1Branches=4 1Length=0.7 1DownAngle=12 1CurveRes=6 1SegSplits=1 1SplitAngle=35"}},
    {.key = "Seed", .label = N_("Seed"), .group = Group::Tree, .section = N_("Growth"), .field = &G::seed,
     .range = {-2147483647, 2147483647}, .useful = {0, 999}, .step = 1, .defaults = {13}, .invalidates = kFromTrunk,
     .help = N_("Every seed gives another tree of the same kind. The same seed always grows the same tree.")},
    {.key = "Season", .label = N_("Month"), .group = Group::Tree, .section = N_("Season"), .field = &G::season,
     .range = {0, 12}, .useful = {0, 12}, .step = 0.1, .decimals = 2, .defaults = {7}, .invalidates = kLeafMesh,
     .help = N_("The time of the year: 0 is New Year, 4.5 spring, 7 summer, 10 autumn. Leaves, their colour, blossoms and fruits follow."),
     .idle = kNeedsSeasons, .shown = {"Leaves=12 LeafScale=0.5 Levels=2", {4, 7, 10.3}}},
    {.key = "Evergreen", .label = N_("Evergreen"), .group = Group::Tree, .section = N_("Season"), .field = &G::evergreen,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("On: the leaves stay, and stay green, through the winter."), .words = kSwitch,
     .idle = kNeedsSeasons, .shown = {"Leaves=12 LeafScale=0.5 Levels=2 Season=1"}},
    {.key = "Trunks", .label = N_("Trunks"), .group = Group::Tree, .section = N_("Several trunks"), .field = &G::trunks,
     .range = {1, 200}, .useful = {1, 20}, .step = 1, .defaults = {1}, .invalidates = kFromTrunk,
     .help = N_("How many trunks rise from one base: shrubs, clumps of bamboo."),
     .shown = {"Levels=2 TrunksSpread=0.4 TrunksLean=15", {1, 3, 8}}},
    {.key = "TrunksSpread", .label = N_("Spread"), .group = Group::Tree, .section = N_("Several trunks"), .unit = Unit::Metre,
     .field = &G::trunksSpread, .range = {0, 100}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {0.2},
     .invalidates = kFromTrunk, .help = N_("How far from the middle the outermost trunk stands."),
     .idle = kNeedsTrunks, .shown = {"Levels=2 Trunks=5", {0.1, 0.6, 1.5}}},
    {.key = "TrunksLean", .label = N_("Lean"), .group = Group::Tree, .section = N_("Several trunks"), .unit = Unit::Degree,
     .field = &G::trunksLean, .range = {-90, 90}, .useful = {0, 60}, .step = 1, .decimals = 1, .defaults = {10},
     .invalidates = kFromTrunk, .help = N_("How far the outermost trunk leans outwards; the others less."),
     .idle = kNeedsTrunks, .shown = {"Levels=2 Trunks=5 TrunksSpread=0.2", {0, 20, 45}}},

    // The trunk's own values
    {.key = "0Scale", .label = N_("Radius factor"), .group = Group::Trunk, .section = N_("Thickness"), .field = &G::trunkScale,
     .range = {0.01, 100}, .useful = {0.2, 3}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kFromTrunk,
     .help = N_("Makes the trunk thicker or thinner than Thickness says, and the branches with it."),
     .shown = {"Levels=2", {0.5, 1, 2.5}}},
    {.key = "0ScaleV", .label = N_("Radius factor variation"), .group = Group::Trunk, .section = N_("Thickness"),
     .field = &G::trunkScaleV, .range = {0, 100}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0},
     .invalidates = kFromTrunk, .help = N_("How much the radius factor differs from seed to seed."),
     .shown = {"Levels=2", {0, 0.3, 0.6}}},
    {.key = "Flare", .label = N_("Flare"), .group = Group::Trunk, .section = N_("Thickness"), .field = &G::flare,
     .range = {-1, 20}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {0.5}, .invalidates = kFromTrunk,
     .help = N_("How much the trunk widens at the ground. 1 makes it twice as thick there."),
     .shown = {"Levels=1 Scale=3 Ratio=0.06 0Taper=0.5", {0, 0.8, 2.5}}},
    {.key = "Lobes", .label = N_("Lobes"), .group = Group::Trunk, .section = N_("Lobes"), .field = &G::lobes,
     .range = {0, 60}, .useful = {0, 12}, .step = 1, .defaults = {0}, .invalidates = kMeshOnly,
     .help = N_("The number of bulges around the trunk. Odd numbers look natural, even ones symmetric."),
     .shown = {"Levels=1 Scale=2 Ratio=0.15 LobeDepth=0.2 LobeFade=0", {0, 5, 9}, true}},
    {.key = "LobeDepth", .label = N_("Lobe depth"), .group = Group::Trunk, .section = N_("Lobes"), .field = &G::lobeDepth,
     .range = {0, 1}, .useful = {0, 0.4}, .step = 0.01, .decimals = 3, .defaults = {0}, .invalidates = kMeshOnly,
     .help = N_("How far the bulges stand out, as a part of the radius."), .aliases = kLobeDepthAliases,
     .idle = kNeedsLobes, .shown = {"Levels=1 Scale=2 Ratio=0.15 Lobes=5 LobeFade=0", {0, 0.1, 0.3}, true}},
    {.key = "LobeFade", .label = N_("Lobes fade"), .group = Group::Trunk, .section = N_("Lobes"), .field = &G::lobeFade,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kMeshOnly,
     .help = N_("1 lets the lobes end a little above the ground, 0 lets them run up the whole trunk."),
     .idle = kNeedsLobeDepth, .shown = {"Levels=1 Scale=2 Ratio=0.15 Lobes=5 LobeDepth=0.3 0Taper=0.5", {0, 0.5, 1}}},
    {.key = "Roots", .label = N_("Roots"), .group = Group::Trunk, .section = N_("Roots"), .field = &G::roots,
     .range = {0, 30}, .useful = {0, 9}, .step = 1, .defaults = {0}, .invalidates = kMeshOnly,
     .help = N_("The number of ridges that run from the trunk into the ground. High ones are buttresses."),
     .shown = {"Levels=1 Scale=4 Ratio=0.06", {0, 4, 8}, true}},
    {.key = "RootReach", .label = N_("Reach of roots"), .group = Group::Trunk, .section = N_("Roots"), .field = &G::rootReach,
     .range = {0, 20}, .useful = {0, 4}, .step = 0.1, .decimals = 2, .defaults = {1.2}, .invalidates = kMeshOnly,
     .help = N_("How far the roots reach out of the trunk on the ground, in radii of the trunk."),
     .idle = kNeedsRoots, .shown = {"Levels=1 Scale=4 Ratio=0.06 Roots=5", {0.5, 1.5, 3}, true}},
    {.key = "RootHeight", .label = N_("Height of roots"), .group = Group::Trunk, .section = N_("Roots"), .field = &G::rootHeight,
     .range = {0.001, 1}, .useful = {0.02, 0.4}, .step = 0.01, .decimals = 3, .defaults = {0.12}, .invalidates = kMeshOnly,
     .help = N_("Where the roots leave the trunk, as a part of its length."),
     .idle = kNeedsRoots, .shown = {"Levels=1 Scale=4 Ratio=0.06 Roots=5 RootReach=2", {0.05, 0.15, 0.4}}},
    {.key = "0BaseSplits", .label = N_("Splits at the base"), .group = Group::Trunk, .section = N_("Splitting"), .field = &G::baseSplits,
     .range = {0, 50}, .useful = {0, 6}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk,
     .help = N_("So many more trunks grow out of the end of the trunk's first segment."), .aliases = kBaseSplitsAliases,
     .idle = kNeedsJoint, .shown = {"Levels=1 0CurveRes=6 0SplitAngle=25", {0, 1, 3}}},

    // One value per level
    {.key = "Branches", .label = N_("Number"), .group = Group::Branches, .section = N_("Placement"), .field = &L::branches,
     .range = {0, 5000}, .useful = {0, 150}, .step = 1, .defaults = {0, 10, 5, 5}, .invalidates = kFromOwnLevel,
     .help = N_("The most branches of this level that one parent can bear."), .firstLevel = 1,
     .shown = {.values = {4, 12, 40}}},
    {.key = "Whorl", .label = N_("At one place"), .group = Group::Branches, .section = N_("Placement"), .field = &L::whorl,
     .range = {1, 100}, .useful = {1, 12}, .step = 1, .defaults = {1, 1, 1, 1}, .invalidates = kFromOwnLevel,
     .help = N_("How many branches leave their parent at the same height, all around it: 2 are opposite, more a whorl."),
     .firstLevel = 1, .shown = {"1Branches=24 nBranchDistV=0 1DownAngle=80", {1, 2, 6}}},
    {.key = "BranchDist", .label = N_("Spread along segments"), .group = Group::Branches, .section = N_("Placement"),
     .field = &L::branchDist, .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0, 1, 1, 1},
     .invalidates = kFromOwnLevel,
     .help = N_("1 spaces the branches evenly, 0 gathers them at the lower end of each segment of the parent, as whorls."),
     .firstLevel = 1,
     .shown = {"0CurveRes=4 1Branches=24 nBranchDistV=0", {0, 0.5, 1}}},
    {.key = "BranchDistV", .label = N_("Place variation"), .group = Group::Branches, .section = N_("Placement"),
     .field = &L::branchDistV, .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2,
     .defaults = {0, 0.25, 0.25, 0.25}, .invalidates = kFromOwnLevel,
     .help = N_("How far each branch is moved along its parent, as a part of the spacing."), .firstLevel = 1,
     .placesLeaves = true,
     .shown = {"1Rotate=180", {0, 0.3, 1}}},
    {.key = "DownAngle", .label = N_("Down angle"), .group = Group::Branches, .section = N_("Direction"), .unit = Unit::Degree,
     .field = &L::downAngle, .range = {-180, 180}, .useful = {0, 180}, .step = 1, .decimals = 1, .defaults = {0, 30, 30, 30},
     .invalidates = kFromOwnLevel, .help = N_("The angle between a branch and its parent. 90 stands off at a right angle."),
     .firstLevel = 1, .placesLeaves = true,
     .shown = {"1Rotate=180", {20, 60, 110}}},
    {.key = "DownAngleV", .label = N_("Down angle variation"), .group = Group::Branches, .section = N_("Direction"),
     .unit = Unit::Degree, .field = &L::downAngleV, .range = {-180, 180}, .useful = {-90, 90}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .invalidates = kFromOwnLevel,
     .help = N_("How much the down angle differs from branch to branch. "
             "Negative values are not random: they grade the angle along the parent, more at its base, less at its tip."),
     .firstLevel = 1, .placesLeaves = true,
     .shown = {"1Rotate=180 1DownAngle=60", {0, 40, -50}}},
    {.key = "Rotate", .label = N_("Rotation"), .group = Group::Branches, .section = N_("Direction"), .unit = Unit::Degree,
     .field = &L::rotate, .range = {-360, 360}, .useful = {-180, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 120, 120, 120}, .invalidates = kFromOwnLevel,
     .help = N_("The turn about the parent from one branch to the next. "
             "Negative values put the branches on alternate sides."),
     .firstLevel = 1, .placesLeaves = true,
     .shown = {"1DownAngle=85 1Branches=9", {30, 90, 140}, true}},
    {.key = "RotateV", .label = N_("Rotation variation"), .group = Group::Branches, .section = N_("Direction"),
     .unit = Unit::Degree, .field = &L::rotateV, .range = {-360, 360}, .useful = {0, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .invalidates = kFromOwnLevel, .help = N_("How much the rotation differs from branch to branch."),
     .firstLevel = 1, .placesLeaves = true,
     .shown = {"1DownAngle=85 1Branches=9 1Rotate=120", {0, 30, 120}, true}},
    {.key = "Length", .label = N_("Length"), .group = Group::Branches, .section = N_("Length"), .field = &L::length,
     .range = {0, 20}, .useful = {0, 2}, .step = 0.01, .decimals = 3, .defaults = {1, 0.5, 0.5, 0.5},
     .invalidates = kFromOwnLevel,
     .help = N_("The length as a part of the parent's length; for the trunk, of the tree's height."), .aliases = kLengthAliases,
     .shown = {.values = {0.15, 0.35, 0.7}}},
    {.key = "LengthV", .label = N_("Length variation"), .group = Group::Branches, .section = N_("Length"), .field = &L::lengthV,
     .range = {0, 20}, .useful = {0, 0.5}, .step = 0.01, .decimals = 3, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel, .help = N_("How much the length differs from stem to stem."), .aliases = kLengthVAliases,
     .shown = {"1Rotate=180", {0, 0.1, 0.3}}},
    {.key = "Taper", .label = N_("Taper"), .group = Group::Branches, .section = N_("Length"), .field = &L::taper,
     .range = {0, 3}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {1, 1, 1, 1}, .invalidates = kFromOwnLevel,
     .help = N_("The form of the stem: 0 a cylinder, 1 a cone, 2 a cylinder with a round end, 3 a chain of spheres."),
     .shown = {"Ratio=0.06 Flare=0 nCurveRes=8 1Branches=6 1Length=0.5", {0, 1, 2.6}}},
    {.key = "CurveRes", .label = N_("Segments"), .group = Group::Branches, .section = N_("Curvature"), .field = &L::curveRes,
     .range = {1, 200}, .useful = {1, 30}, .step = 1, .defaults = {3, 3, 1, 1}, .invalidates = kFromOwnLevel,
     .help = N_("The number of segments a stem consists of. More segments bend and split more finely."),
     .shown = {"nCurve=120", {1, 3, 12}}},
    {.key = "Curve", .label = N_("Curve"), .group = Group::Branches, .section = N_("Curvature"), .unit = Unit::Degree,
     .field = &L::curve, .range = {-3600, 3600}, .useful = {-180, 180}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel,
     .help = N_("How much the stem bends from base to tip. Positive values bend down, negative ones up."),
     .shown = {"nCurveRes=10", {-60, 0, 90}}},
    {.key = "CurveBack", .label = N_("Curve back"), .group = Group::Branches, .section = N_("Curvature"), .unit = Unit::Degree,
     .field = &L::curveBack, .range = {-3600, 3600}, .useful = {-180, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .invalidates = kFromOwnLevel,
     .help = N_("Unless 0, the lower half bends by Curve and the upper half by this: S-shaped stems."),
     .shown = {"nCurveRes=12 nCurve=60", {0, -60, -120}}},
    {.key = "CurveV", .label = N_("Curve variation"), .group = Group::Branches, .section = N_("Curvature"), .unit = Unit::Degree,
     .field = &L::curveV, .range = {-89, 3600}, .useful = {-60, 180}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel,
     .help = N_("Random bending, shared out over the segments. Negative values wind the stem into a helix of that angle."),
     .shown = {"nCurveRes=12", {0, 90, -40}}},
    {.key = "SegSplits", .label = N_("Splits per segment"), .group = Group::Branches, .section = N_("Splitting"),
     .field = &L::segSplits, .range = {0, 10}, .useful = {0, 2}, .step = 0.05, .decimals = 2, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel,
     .help = N_("How many clones split off at the end of each segment, on average. 1 forks at every one."),
     .aliases = kSegSplitsAliases,
     .shown = {"nCurveRes=5 nSplitAngle=35 1DownAngle=10 1Branches=5 1Length=0.6", {0, 0.5, 1}}},
    {.key = "SplitAngle", .label = N_("Split angle"), .group = Group::Branches, .section = N_("Splitting"), .unit = Unit::Degree,
     .field = &L::splitAngle, .range = {0, 180}, .useful = {0, 90}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel,
     .help = N_("How far each part leans away from the vertical after a split. Towards its tip it turns back again."),
     .idle = kNeedsSplits, .shown = {"nCurveRes=5 nSegSplits=0.5 1DownAngle=10 1Branches=5 1Length=0.6", {15, 30, 60}}},
    {.key = "SplitAngleV", .label = N_("Split angle variation"), .group = Group::Branches, .section = N_("Splitting"),
     .unit = Unit::Degree, .field = &L::splitAngleV, .range = {0, 180}, .useful = {0, 90}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .invalidates = kFromOwnLevel, .help = N_("How much the split angle differs from fork to fork."),
     .idle = kNeedsSplits, .shown = {"nCurveRes=5 nSegSplits=0.5 nSplitAngle=30 1DownAngle=10 1Branches=5 1Length=0.6", {0, 10, 30}}},

    // Leaves
    {.key = "Leaves", .label = N_("Number"), .group = Group::Leaves, .section = N_("Placement"), .field = &G::leaves,
     .range = {-5000, 5000}, .useful = {-50, 100}, .step = 1, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("The most leaves that a stem of the last level bears. Negative values put them in a fan at its tip."),
     .shown = {.values = {6, 16, -7}}},
    {.key = "LeafWhorl", .label = N_("At one place"), .group = Group::Leaves, .section = N_("Placement"), .field = &G::leafWhorl,
     .range = {1, 50}, .useful = {1, 8}, .step = 1, .defaults = {1}, .invalidates = kLeavesOnly,
     .help = N_("How many leaves leave a stem at the same place: 1 are alternate, 2 opposite, more a whorl."),
     .shown = {"2Rotate=90 2DownAngle=60 2BranchDistV=0", {1, 2, 4}}},
    {.key = "LeafQuality", .label = N_("Density"), .group = Group::Leaves, .section = N_("Placement"), .field = &G::leafQuality,
     .range = {0.001, 100}, .useful = {0.05, 2}, .step = 0.05, .decimals = 3, .defaults = {1}, .invalidates = kLeavesOnly,
     .help = N_("Fewer but larger leaves below 1, more and smaller ones above: the leaf area stays."),
     .shown = {.values = {0.4, 1, 2}}},
    {.key = "LeafBend", .label = N_("Turn to the light"), .group = Group::Leaves, .section = N_("Placement"), .field = &G::leafBend,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0.3}, .invalidates = kLeavesOnly,
     .help = N_("How far the leaves turn outwards and up to the light."), .aliases = kLeafBendAliases,
     .shown = {.values = {0, 0.5, 1}}},
    {.key = "LeafShape", .label = N_("Shape"), .group = Group::Leaves, .section = N_("Blade"), .field = &G::leafShape,
     .range = {0, 12}, .useful = {0, 12}, .step = 1, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("The kind of leaf: its outline where the form is 'outline'. A card shows what its texture shows."),
     .words = kLeafShapes,
     .idle = kNeedsOutline, .shown = {"1Branches=1 1DownAngle=90 1Length=0.05 1Curve=0 2DownAngle=0 Leaves=-1 LeafScale=0.8 LeafScaleX=0.9 LeafBend=0", {}, true}},
    {.key = "LeafForm", .label = N_("Form"), .group = Group::Leaves, .section = N_("Blade"), .field = &G::leafForm,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("A card is a rectangle with the leaf texture. An outline is cut to the shape and needs no transparency."),
     .words = kLeafForms,
     .shown = {"LeafShape=4 1Branches=1 1DownAngle=90 1Length=0.05 2DownAngle=0 Leaves=-1 LeafScale=0.8 LeafScaleX=0.9 LeafBend=0", {}, true}},
    {.key = "LeafPlanes", .label = N_("Planes"), .group = Group::Leaves, .section = N_("Blade"), .field = &G::leafPlanes,
     .range = {1, 6}, .useful = {1, 3}, .step = 1, .defaults = {1}, .invalidates = kLeafMesh,
     .help = N_("How many cards, turned about their length, make one leaf: 2 or 3 for tufts and twigs of needles."),
     .idle = kNeedsCards, .shown = {"LeafForm=0 LeafScaleX=0.3", {1, 2, 3}}},
    {.key = "LeafScale", .label = N_("Length"), .group = Group::Leaves, .section = N_("Blade"), .unit = Unit::Metre,
     .field = &G::leafScale, .range = {0.001, 50}, .useful = {0.02, 1}, .step = 0.01, .decimals = 3, .defaults = {0.2},
     .invalidates = kLeavesOnly, .help = N_("The length of a leaf."),
     .shown = {.values = {0.1, 0.2, 0.35}}},
    {.key = "LeafScaleX", .label = N_("Width"), .group = Group::Leaves, .section = N_("Blade"), .field = &G::leafScaleX,
     .range = {0.001, 100}, .useful = {0.05, 2}, .step = 0.05, .decimals = 2, .defaults = {0.5}, .invalidates = kLeavesOnly,
     .help = N_("The width of a leaf as a part of its length."),
     .shown = {.values = {0.2, 0.6, 1.2}}},
    {.key = "LeafStalk", .label = N_("Stalk"), .group = Group::Leaves, .section = N_("Blade"), .field = &G::leafStalk,
     .range = {0, 5}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("The length of the stalk between stem and blade, as a part of the leaf's length."),
     .shown = {.values = {0, 0.4, 1}}},
    {.key = "LeafFold", .label = N_("Fold"), .group = Group::Leaves, .section = N_("Blade"), .unit = Unit::Degree,
     .field = &G::leafFold, .range = {-80, 80}, .useful = {0, 45}, .step = 1, .decimals = 1, .defaults = {0},
     .invalidates = kLeafMesh, .help = N_("How far each half of a leaf is folded up along its midrib."),
     .shown = {"Leaves=-1 LeafScale=0.8 LeafForm=1 1Length=0.05 LeafScaleX=0.8 LeafBend=0", {0, 25, 60}}},
    {.key = "LeafRounding", .label = N_("Rounding"), .group = Group::Leaves, .section = N_("Shading"), .field = &G::leafRounding,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("Shades the leaves as if they were the surface of one round crown: softer light on dense crowns.")},

    // Blossoms and fruits
    {.key = "Blossoms", .label = N_("Number"), .group = Group::Blossom, .section = N_("Blossoms"), .field = &G::blossoms,
     .range = {0, 5000}, .useful = {0, 60}, .step = 1, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("The most blossoms that a stem of the last level bears. They stand where leaves could."),
     .shown = {"Leaves=0 BlossomScale=0.15 Season=4.5", {2, 8, 20}}},
    {.key = "BlossomScale", .label = N_("Size"), .group = Group::Blossom, .section = N_("Blossoms"), .unit = Unit::Metre,
     .field = &G::blossomScale, .range = {0.001, 50}, .useful = {0.01, 0.5}, .step = 0.01, .decimals = 3, .defaults = {0.05},
     .invalidates = kLeavesOnly, .help = N_("The length and width of a blossom, or of the cluster that its picture shows."),
     .idle = kNeedsBlossoms, .shown = {"Leaves=0 Blossoms=8 Season=4.5", {0.08, 0.15, 0.3}}},
    {.key = "BlossomUp", .label = N_("Upright"), .group = Group::Blossom, .section = N_("Blossoms"), .field = &G::blossomUp,
     .range = {-1, 1}, .useful = {-1, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("1 sets blossoms upright like candles, -1 lets them hang like catkins, 0 lets them stand like leaves."),
     .idle = kNeedsBlossoms, .shown = {"Leaves=0 Blossoms=6 Season=4.5 BlossomScale=0.3 BlossomTexture=\"leaf:candle\"", {-1, 0, 1}}},
    {.key = "BlossomPlanes", .label = N_("Planes"), .group = Group::Blossom, .section = N_("Blossoms"), .field = &G::blossomPlanes,
     .range = {1, 6}, .useful = {1, 3}, .step = 1, .defaults = {1}, .invalidates = kLeafMesh,
     .help = N_("How many cards, turned about their length, make one blossom: 2 or 3 for candles and catkins."),
     .idle = kNeedsBlossoms, .shown = {"Leaves=0 Blossoms=6 Season=4.5 BlossomScale=0.3", {1, 2, 3}}},
    {.key = "BlossomMonth", .label = N_("Month"), .group = Group::Blossom, .section = N_("Blossoms"), .field = &G::blossomMonth,
     .range = {0, 12}, .useful = {0, 12}, .step = 0.1, .decimals = 2, .defaults = {4.5}, .invalidates = kLeafMesh,
     .help = N_("When the tree is in full blossom; it begins and ends most of a month before and after."),
     .idle = kNeedsBlossoms, .shown = {"Leaves=0 Blossoms=8 Season=4.5 BlossomScale=0.15", {4, 4.5, 6}}},
    {.key = "Fruits", .label = N_("Number"), .group = Group::Blossom, .section = N_("Fruits"), .field = &G::fruits,
     .range = {0, 5000}, .useful = {0, 30}, .step = 1, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("The most fruits that a stem of the last level bears."),
     .shown = {"Leaves=0 FruitScale=0.1 Season=9", {1, 4, 12}}},
    {.key = "FruitScale", .label = N_("Length"), .group = Group::Blossom, .section = N_("Fruits"), .unit = Unit::Metre,
     .field = &G::fruitScale, .range = {0.001, 50}, .useful = {0.01, 0.3}, .step = 0.01, .decimals = 3, .defaults = {0.07},
     .invalidates = kLeavesOnly, .help = N_("The length of a ripe fruit."),
     .idle = kNeedsFruits, .shown = {"Leaves=0 Fruits=4 Season=9", {0.05, 0.1, 0.2}}},
    {.key = "FruitScaleX", .label = N_("Width"), .group = Group::Blossom, .section = N_("Fruits"), .field = &G::fruitScaleX,
     .range = {0.01, 100}, .useful = {0.2, 2}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kLeavesOnly,
     .help = N_("The width of a fruit as a part of its length: small for cones and pods."),
     .idle = kNeedsFruits, .shown = {"Leaves=0 Fruits=4 Season=9 FruitScale=0.2", {0.3, 0.7, 1.2}}},
    {.key = "FruitStalk", .label = N_("Stalk"), .group = Group::Blossom, .section = N_("Fruits"), .field = &G::fruitStalk,
     .range = {0, 20}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {0.3}, .invalidates = kLeafMesh,
     .help = N_("The length of the stalk that a fruit hangs on, as a part of its own length."),
     .idle = kNeedsFruits, .shown = {"Leaves=0 Fruits=4 Season=9 FruitScale=0.12", {0, 0.6, 1.5}}},
    {.key = "FruitMonth", .label = N_("Month"), .group = Group::Blossom, .section = N_("Fruits"), .field = &G::fruitMonth,
     .range = {0, 12}, .useful = {0, 12}, .step = 0.1, .decimals = 2, .defaults = {9}, .invalidates = kLeafMesh,
     .help = N_("When the fruits are ripe. They grow in the two months before and fall in the month after."),
     .idle = kNeedsFruits, .shown = {"Leaves=0 Fruits=4 Season=9 FruitScale=0.12", {9, 10, 10.8}}},

    // Pruning
    {.key = "PruneRatio", .label = N_("Strength"), .group = Group::Pruning, .section = N_("Envelope"), .field = &G::pruneRatio,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kFromBranches,
     .help = N_("0 leaves the branches alone, 1 shortens them until they stay inside the envelope."),
     .shown = {.values = {0, 0.6, 1}}},
    {.key = "PruneWidth", .label = N_("Width"), .group = Group::Pruning, .section = N_("Envelope"), .field = &G::pruneWidth,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaults = {0.5}, .invalidates = kFromBranches,
     .help = N_("The radius of the envelope at its widest place, as a part of the tree's height."),
     .idle = kNeedsPruning, .shown = {.values = {0.1, 0.25, 0.5}}},
    {.key = "PruneWidthPeak", .label = N_("Widest place"), .group = Group::Pruning, .section = N_("Envelope"),
     .field = &G::pruneWidthPeak, .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaults = {0.5},
     .invalidates = kFromBranches,
     .help = N_("Where the envelope is widest, from 0 at its bottom to 1 at its top."),
     .idle = kNeedsEnvelope, .shown = {.values = {0.2, 0.5, 0.8}}},
    {.key = "PrunePowerLow", .label = N_("Curve below"), .group = Group::Pruning, .section = N_("Envelope"),
     .field = &G::prunePowerLow, .range = {0.0001, 100}, .useful = {0.001, 3}, .step = 0.05, .decimals = 3,
     .defaults = {0.5}, .invalidates = kFromBranches,
     .help = N_("The envelope below its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow."),
     .idle = kNeedsEnvelope, .shown = {.values = {0.2, 1, 2.5}}},
    {.key = "PrunePowerHigh", .label = N_("Curve above"), .group = Group::Pruning, .section = N_("Envelope"),
     .field = &G::prunePowerHigh, .range = {0.0001, 100}, .useful = {0.001, 3}, .step = 0.05, .decimals = 3,
     .defaults = {0.5}, .invalidates = kFromBranches,
     .help = N_("The envelope above its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow."),
     .idle = kNeedsEnvelope, .shown = {.values = {0.2, 1, 2.5}}},

    // Textures
    {.key = "TextureWrapX", .label = N_("Bark repeats around"), .group = Group::Textures, .section = N_("Bark"),
     .field = &G::textureWrapX, .range = {0.001, 1000}, .useful = {0.5, 10}, .step = 0.5, .decimals = 2, .defaults = {1},
     .invalidates = kMeshOnly, .help = N_("How often the bark picture goes around the trunk; branches follow. Whole numbers leave no seam.")},
    {.key = "TextureWrapY", .label = N_("Bark repeats along"), .group = Group::Textures, .section = N_("Bark"),
     .field = &G::textureWrapY, .range = {0.001, 1000}, .useful = {0.5, 20}, .step = 0.5, .decimals = 2, .defaults = {1},
     .invalidates = kMeshOnly, .help = N_("How often the bark picture repeats from the trunk's base to its tip. Branches show it at the same scale.")},
};

constexpr TextInfo kTexts[] = {
    {"Species", N_("Species"), &TextParams::species, Group::Tree, N_("About"), Stage::None, N_("The name of the kind of tree.")},
    {"Author", N_("Author"), &TextParams::author, Group::Tree, N_("About"), Stage::None, N_("Who made the file.")},
    {"Description", N_("Description"), &TextParams::description, Group::Tree, N_("About"), Stage::None, N_("What the tree is like.")},
    {"Method", N_("Method"), &TextParams::method, Group::Tree, N_("About"), Stage::Structure,
     N_("How the tree is grown: weber-penn."), {}, false}, // there is only one
    {"LikedSeeds", N_("Liked seeds"), &TextParams::likedSeeds, Group::Tree, N_("Growth"), Stage::None,
     N_("Seeds worth finding again, separated by blanks."), {}, false}, // the window has a list of its own
    {"BarkTexture", N_("Bark texture"), &TextParams::barkTexture, Group::Textures, N_("Bark"), Stage::Material,
     N_("The picture on the stems; its path starts at the file's folder. A recipe as bark:furrowed seed=3 is drawn. Empty takes the built-in one."), "bark"},
    {"LeafTexture", N_("Leaf texture"), &TextParams::leafTexture, Group::Textures, N_("Leaves"), Stage::Material,
     N_("The picture on the leaves, transparent outside the blade. A recipe as leaf:oak seed=3 is drawn. Empty takes the built-in one."), "leaf"},
    {"BlossomTexture", N_("Blossom texture"), &TextParams::blossomTexture, Group::Textures, N_("Blossoms and fruits"), Stage::Material,
     N_("The picture on the blossoms. Empty draws leaf:blossom."), "leaf"},
    {"FruitTexture", N_("Fruit texture"), &TextParams::fruitTexture, Group::Textures, N_("Blossoms and fruits"), Stage::Material,
     N_("The skin of the fruits. Empty draws a red one."), "bark"},
};
// clang-format on

// The compiler proves the table before any test runs.
constexpr bool rowIsSane(const ParamInfo& p) {
    if (p.key.empty() || p.label.empty() || p.section.empty() || p.help.empty()) return false;
    if (p.step <= 0 || p.range.min >= p.range.max) return false;
    if (!p.range.contains(p.useful.min) || !p.range.contains(p.useful.max) || p.useful.min >= p.useful.max)
        return false;
    if (p.integer() != (p.decimals == 0)) return false;
    if (!p.words.empty() && p.range.max + 1 != static_cast<double>(p.words.size())) return false;
    for (int level = p.firstLevel; level <= p.lastLevel(); ++level)
        if (!p.range.contains(p.defaults[static_cast<std::size_t>(level)])) return false;
    return true;
}

constexpr bool rowsAreSane() {
    for (const ParamInfo& p : kParams) {
        if (!rowIsSane(p)) return false;
        for (const ParamInfo& q : kParams)
            if (&p != &q && (p.key == q.key || p.field == q.field)) return false;
    }
    return true;
}
static_assert(rowsAreSane(), "a row has no text, a bad range, a default out of range, or a twin");

constexpr std::size_t bytesDescribed(bool perLevel) {
    std::size_t bytes = 0;
    for (const ParamInfo& p : kParams)
        if (p.perLevel() == perLevel) bytes += p.integer() ? sizeof(int) : sizeof(double);
    return (bytes + sizeof(double) - 1) / sizeof(double) * sizeof(double); // with the padding behind
}
static_assert(bytesDescribed(false) == sizeof(GlobalParams), "a field of GlobalParams has no row");
static_assert(bytesDescribed(true) == sizeof(LevelParams), "a field of LevelParams has no row");
static_assert(std::size(kTexts) * sizeof(std::string) == sizeof(TextParams), "a field of TextParams has no row");

std::vector<ParamRef> collectParams() {
    std::vector<ParamRef> refs;
    const auto add = [&](Group group, int level) {
        for (const ParamInfo& p : kParams)
            if (p.perLevel() ? level >= p.firstLevel : p.group == group) refs.push_back({&p, p.perLevel() ? level : 0});
    };
    const auto addGlobals = [&](Group group) {
        for (const ParamInfo& p : kParams)
            if (!p.perLevel() && p.group == group) refs.push_back({&p, 0});
    };
    for (const Group group : kGroups)
        if (group == Group::Trunk)
            add(group, 0);
        else if (group == Group::Branches)
            for (int level = 1; level < kParamLevels; ++level) add(group, level);
        else
            addGlobals(group);
    return refs;
}
} // namespace

CParams::CParams() : global(), level(), text() {
    for (const ParamRef& ref : allParams()) ref.set(*this, ref.info->defaultOf(ref.level));
    text.species = "default";
    text.method = kMethods[0];
}

double ParamInfo::get(const CParams& params, int level) const {
    return std::visit(
        [&](auto member) -> double {
            if constexpr (requires { params.global.*member; })
                return params.global.*member;
            else
                return params.level[static_cast<std::size_t>(level)].*member;
        },
        field);
}

bool ParamInfo::set(CParams& params, double value, int level) const {
    double allowed = std::clamp(value, range.min, range.max);
    if (integer()) allowed = std::round(allowed);
    std::visit(
        [&](auto member) {
            if constexpr (requires { params.global.*member; })
                params.global.*member = static_cast<std::remove_reference_t<decltype(params.global.*member)>>(allowed);
            else {
                LevelParams& own = params.level[static_cast<std::size_t>(level)];
                own.*member = static_cast<std::remove_reference_t<decltype(own.*member)>>(allowed);
            }
        },
        field);
    return allowed == value;
}

std::string ParamInfo::keyOf(int level) const {
    return (perLevel() ? std::to_string(level) : std::string()) + std::string(key);
}

std::span<const ParamInfo> paramTable() { return kParams; }
std::span<const TextInfo> textTable() { return kTexts; }
std::span<const std::string_view> treeMethods() { return kMethods; }

std::span<const ParamRef> allParams() {
    static const std::vector<ParamRef> refs = collectParams();
    return refs;
}

const ParamInfo* variationOf(const ParamInfo& info) {
    const auto isVariation = [&](const ParamInfo& p) {
        return p.perLevel() == info.perLevel() && p.key.size() == info.key.size() + 1 && p.key.starts_with(info.key) &&
               p.key.ends_with('V');
    };
    const auto found = std::ranges::find_if(kParams, isVariation);
    return found == std::end(kParams) ? nullptr : found;
}

namespace {
string_view whyNoStems(const ParamRef& ref, const CParams& params) {
    const bool forLeaves = ref.info->placesLeaves && std::min(params.global.levels, kParamLevels - 1) == ref.level;
    if (ref.level >= params.global.levels && !forLeaves)
        return N_("The tree has no stems of this level: see Levels of stems.");
    const int last = std::min(ref.level, params.global.levels - 1);
    const bool counts = ref.info->field == ParamInfo::Field(&L::branches);
    for (int level = 1; level < last + (counts ? 0 : 1); ++level)
        if (params.level[static_cast<std::size_t>(level)].branches == 0)
            return N_("The tree has no stems of this level: a Number of branches is 0.");
    if (ref.level >= params.global.levels && params.global.leaves == 0)
        return N_("This level would place the leaves, and the tree has none.");
    return {};
}

string_view whyNoLeaves(const ParamRef& ref, const CParams& params) {
    if (params.global.levels < 2) return N_("Leaves grow on branches, and the tree is a bare trunk.");
    const bool counts = ref.info->field == ParamInfo::Field(&G::leaves);
    return params.global.leaves == 0 && !counts ? N_("The tree has no leaves: their Number is 0.") : string_view();
}
} // namespace

string_view whyIdle(const ParamRef& ref, const CParams& params) {
    string_view why;
    if (ref.info->perLevel()) why = whyNoStems(ref, params);
    if (ref.info->group == Group::Leaves) why = whyNoLeaves(ref, params);
    if (ref.info->group == Group::Blossom && params.global.levels < 2)
        why = N_("Blossoms and fruits grow on branches, and the tree is a bare trunk.");
    if (ref.info->group == Group::Pruning) why = kNeedsBranches(params, 0);
    if (why.empty() && ref.info->idle) why = ref.info->idle(params, ref.level);
    return why;
}

string_view groupName(Group group) {
    constexpr string_view kNames[] = {N_("Tree"), N_("Trunk"), N_("Branches"), N_("Leaves"), N_("Blossom"), N_("Pruning"), N_("Textures")};
    return kNames[static_cast<std::size_t>(group)];
}

string_view unitName(Unit unit) {
    constexpr string_view kNames[] = {"", "m", "°"};
    return kNames[static_cast<std::size_t>(unit)];
}

} // namespace stromar
