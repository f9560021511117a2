#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "TableProof.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <array>

namespace stromar {

namespace {
using std::string_view;

constexpr string_view kShapes[] = {N_("conical"), N_("spherical"),       N_("hemispherical"), N_("cylindrical"), N_("tapered-cylindrical"),
                                   N_("flame"),   N_("inverse-conical"), N_("tend-flame"),    N_("envelope")};
constexpr string_view kAxes[] = {N_("stem"), N_("horizontal")};
constexpr string_view kSwitch[] = {N_("off"), N_("on")};

constexpr string_view kBaseSplitsAliases[] = {"BaseSplits", "nBaseSplits", "0BaseSplit"};
constexpr string_view kSegSplitsAliases[] = {"SegSplit"};
constexpr string_view kLengthAliases[] = {"Lenght"};
constexpr string_view kLengthVAliases[] = {"LenghtV"};

constexpr Invalidation kFromTrunk{Stage::Structure, 0};
constexpr Invalidation kFromBranches{Stage::Structure, 1};
constexpr Invalidation kFromTwigs{Stage::Structure, 2};
constexpr Invalidation kFromOwnLevel{Stage::Structure, Invalidation::kOwnLevel};
constexpr Invalidation kLeavesOnly{Stage::Structure, Invalidation::kLeaves};
constexpr Invalidation kNothing{Stage::None, 0};

// When a value does nothing. Whether its level has stems is asked for all rows alike.
using Inactive = string_view (*)(const CParams&, int);
constexpr Inactive kNeedsBranches = [](const CParams& p, int) -> string_view {
    return weberPenn(p).levels > 1 ? "" : N_("The tree is a bare trunk: Levels of stems is 1.");
};
constexpr Inactive kNeedsTwigs = [](const CParams& p, int) -> string_view {
    return weberPenn(p).levels > 2 ? "" : N_("It acts on stems of level 2 and deeper, and there are none.");
};
constexpr Inactive kNeedsAttraction = [](const CParams& p, int level) -> string_view {
    if (const string_view why = kNeedsTwigs(p, level); !why.empty()) return why;
    return weberPenn(p).attractionUp != 0 ? "" : N_("Nothing attracts the branches: Attraction up is 0.");
};
constexpr Inactive kNeedsJoint = [](const CParams& p, int) -> string_view {
    return weberPenn(p).level[0].curveRes > 1 ? "" : N_("The trunk has only one segment, so there is no joint to split at.");
};
constexpr Inactive kNeedsSplits = [](const CParams& p, int level) -> string_view {
    const WeberPennParams& w = weberPenn(p);
    const bool splits = w.level[static_cast<std::size_t>(level)].segSplits > 0 || (level == 0 && w.baseSplits > 0);
    return splits ? "" : N_("These stems never split.");
};
constexpr Inactive kNeedsAnySplits = [](const CParams& p, int) -> string_view {
    const auto splits = [](const LevelParams& level) { return level.segSplits > 0; };
    return std::ranges::any_of(weberPenn(p).level, splits) ? "" : N_("Nothing in this tree splits.");
};
constexpr Inactive kNeedsTrunks = [](const CParams& p, int) -> string_view {
    return weberPenn(p).trunks > 1 ? "" : N_("The tree has only one trunk.");
};
constexpr Inactive kNeedsPruning = [](const CParams& p, int) -> string_view {
    return weberPenn(p).pruneRatio > 0 ? "" : N_("Nothing is pruned: Strength is 0.");
};
constexpr Inactive kNeedsEnvelope = [](const CParams& p, int) -> string_view {
    return weberPenn(p).pruneRatio > 0 || weberPenn(p).shape == 8
               ? ""
               : N_("Nothing is pruned, and the crown shape is not the envelope.");
};

// clang-format off
constexpr ParamInfo kRows[] = {
    {.key = "Shape", .label = N_("Crown shape"), .group = Group::Tree, .section = N_("Crown"), .field = field<&WeberPennParams::shape>,
     .range = {0, 8}, .useful = {0, 8}, .step = 1, .defaults = {0}, .invalidates = kFromBranches,
     .help = N_("The outline of the crown: how long the branches are from its bottom to its top. "
             "'envelope' takes the outline of the pruning tab."),
     .words = kShapes,
     .inactive = kNeedsBranches, .demo = {"Levels=2 1Length=0.35"}},
    {.key = "BaseSize", .label = N_("Bare trunk"), .synonyms = N_("crown base height clear"), .group = Group::Tree, .section = N_("Crown"), .field = field<&WeberPennParams::baseSize>,
     .range = {0, 1}, .useful = {0, 0.95}, .step = 0.01, .decimals = 3, .defaults = {0.25}, .invalidates = kFromBranches,
     .help = N_("The part of the tree's height, from the ground, that bears no branches."),
     .inactive = kNeedsBranches, .demo = {.values = {0.1, 0.35, 0.7}}},
    {.key = "Scale", .label = N_("Height"), .group = Group::Tree, .section = N_("Size"), .unit = Unit::Metre, .field = field<&WeberPennParams::scale>,
     .range = {0.01, 1000}, .useful = {0.5, 40}, .step = 0.5, .decimals = 2, .defaults = {10}, .invalidates = kFromTrunk,
     .help = N_("The height of the tree."),
     .demo = {.values = {4, 8, 16}}},
    {.key = "ScaleV", .label = N_("Height variation"), .group = Group::Tree, .section = N_("Size"), .unit = Unit::Metre,
     .field = field<&WeberPennParams::scaleV>, .range = {0, 1000}, .useful = {0, 15}, .step = 0.5, .decimals = 2, .defaults = {0},
     .invalidates = kFromTrunk, .help = N_("How much taller or smaller a tree of another seed may be."),
     .demo = {"Scale=8", {0, 3, 6}}},
    {.key = "ZScale", .label = N_("Z scale"), .group = Group::Tree, .section = N_("Size"), .field = field<&WeberPennParams::zScale>,
     .range = {-1000, 1000}, .useful = {0, 2}, .step = 0.1, .decimals = 2, .defaults = {1}, .invalidates = kNothing,
     .help = N_("Printed in the paper's tables but used by none of its formulas. Kept in files, without effect.")},
    {.key = "ZScaleV", .label = N_("Z scale variation"), .group = Group::Tree, .section = N_("Size"), .field = field<&WeberPennParams::zScaleV>,
     .range = {-1000, 1000}, .useful = {0, 2}, .step = 0.1, .decimals = 2, .defaults = {0}, .invalidates = kNothing,
     .help = N_("Printed in the paper's tables but used by none of its formulas. Kept in files, without effect.")},
    {.key = "Levels", .label = N_("Levels of stems"), .synonyms = N_("order recursion generations"), .group = Group::Tree, .section = N_("Size"), .field = field<&WeberPennParams::levels>,
     .range = {1, 9}, .useful = {1, 4}, .step = 1, .defaults = {3}, .invalidates = {Stage::Structure, Invalidation::kLastLevel},
     .help = N_("1 grows a bare trunk, 2 adds branches, 3 branches on branches. The leaves sit on the last level."),
     .demo = {"3Branches=4 3Length=0.4", {1, 2, 3}}},
    {.key = "Ratio", .label = N_("Thickness"), .synonyms = N_("girth radius diameter width"), .group = Group::Tree, .section = N_("Thickness"), .field = field<&WeberPennParams::ratio>,
     .range = {0.0001, 1}, .useful = {0.002, 0.1}, .step = 0.001, .decimals = 4, .defaults = {0.05}, .invalidates = kFromTrunk,
     .help = N_("The radius of the trunk divided by its length."),
     .demo = {"Levels=2", {0.01, 0.03, 0.07}}},
    {.key = "RatioPower", .label = N_("Thinning"), .group = Group::Tree, .section = N_("Thickness"), .field = field<&WeberPennParams::ratioPower>,
     .range = {-10, 10}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kFromBranches,
     .help = N_("How much thinner than its parent a shorter branch is. Higher values make finer branches."),
     .inactive = kNeedsBranches, .demo = {"Levels=2 Ratio=0.04", {0.5, 1, 2}}},
    {.key = "AttractionUp", .label = N_("Attraction up"), .synonyms = N_("gravity droop weeping hang"), .group = Group::Tree, .section = N_("Growth"), .field = field<&WeberPennParams::attractionUp>,
     .range = {-100, 100}, .useful = {-10, 10}, .step = 0.1, .decimals = 2, .defaults = {0}, .invalidates = kFromTwigs,
     .help = N_("How strongly branches of level 2 and deeper bend up to the light. Negative values let them hang."),
     .inactive = kNeedsTwigs, .demo = {"2CurveRes=6 2Length=0.8 2Branches=5 1Branches=10", {-4, 0, 4}}},
    {.key = "AttractionAxis", .label = N_("Attraction axis"), .group = Group::Tree, .section = N_("Growth"), .field = field<&WeberPennParams::attractionAxis>,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {0}, .invalidates = kFromTwigs,
     .help = N_("What attraction turns a branch about. 'stem', as the paper prints it: its own axis, so that one that lies on its side stays. "
             "'horizontal': all hang, or reach up, alike."),
     .words = kAxes, .inactive = kNeedsAttraction,
     .demo = {"AttractionUp=-4 2CurveRes=6 2Length=0.8 2Branches=5 1Branches=10"}},
    {.key = "CloneHalving", .label = N_("Halve splitting"), .group = Group::Tree, .section = N_("Growth"), .field = field<&WeberPennParams::cloneHalving>,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {1}, .invalidates = kFromTrunk,
     .help = N_("On: a stem that has split, and its clones, split half as often from then on."), .words = kSwitch,
     .inactive = kNeedsAnySplits, .demo = {"Levels=2 1Branches=4 1Length=0.7 1DownAngle=12 1CurveRes=6 1SegSplits=1 1SplitAngle=35"}},
    {.key = "Trunks", .label = N_("Trunks"), .synonyms = N_("shrub clump multi-stem"), .group = Group::Tree, .section = N_("Several trunks"), .field = field<&WeberPennParams::trunks>,
     .range = {1, 200}, .useful = {1, 20}, .step = 1, .defaults = {1}, .invalidates = kFromTrunk,
     .help = N_("How many trunks rise from one base: shrubs, clumps of bamboo."), .atRandom = false,
     .demo = {"Levels=2 TrunksSpread=0.4 TrunksLean=15", {1, 3, 8}}},
    {.key = "TrunksSpread", .label = N_("Spread"), .group = Group::Tree, .section = N_("Several trunks"), .unit = Unit::Metre,
     .field = field<&WeberPennParams::trunksSpread>, .range = {0, 100}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {0.2},
     .invalidates = kFromTrunk, .help = N_("How far from the middle the outermost trunk stands."),
     .inactive = kNeedsTrunks, .demo = {"Levels=2 Trunks=5", {0.1, 0.6, 1.5}}},
    {.key = "TrunksLean", .label = N_("Lean"), .group = Group::Tree, .section = N_("Several trunks"), .unit = Unit::Degree,
     .field = field<&WeberPennParams::trunksLean>, .range = {-90, 90}, .useful = {0, 60}, .step = 1, .decimals = 1, .defaults = {10},
     .invalidates = kFromTrunk, .help = N_("How far the outermost trunk leans outwards; the others less."),
     .inactive = kNeedsTrunks, .demo = {"Levels=2 Trunks=5 TrunksSpread=0.2", {0, 20, 45}}},
    {.key = "0Scale", .label = N_("Radius factor"), .group = Group::Trunk, .section = N_("Thickness"), .field = field<&WeberPennParams::trunkScale>,
     .range = {0.01, 100}, .useful = {0.2, 3}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kFromTrunk,
     .help = N_("Makes the trunk thicker or thinner than Thickness says, and the branches with it."),
     .demo = {"Levels=2", {0.5, 1, 2.5}}},
    {.key = "0ScaleV", .label = N_("Radius factor variation"), .group = Group::Trunk, .section = N_("Thickness"),
     .field = field<&WeberPennParams::trunkScaleV>, .range = {0, 100}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0},
     .invalidates = kFromTrunk, .help = N_("How much the radius factor differs from seed to seed."),
     .demo = {"Levels=2", {0, 0.3, 0.6}}},
    {.key = "0BaseSplits", .label = N_("Splits at the base"), .group = Group::Trunk, .section = N_("Splitting"), .field = field<&WeberPennParams::baseSplits>,
     .range = {0, 50}, .useful = {0, 6}, .step = 1, .defaults = {0}, .invalidates = kFromTrunk,
     .help = N_("So many more trunks grow out of the end of the trunk's first segment."), .aliases = kBaseSplitsAliases,
     .inactive = kNeedsJoint, .demo = {"Levels=1 0CurveRes=6 0SplitAngle=25", {0, 1, 3}}},
    {.key = "Branches", .label = N_("Number"), .synonyms = N_("count density"), .group = Group::Branches, .section = N_("Placement"), .field = field<&LevelParams::branches>,
     .range = {0, 5000}, .useful = {0, 150}, .step = 1, .defaults = {0, 10, 5, 5}, .invalidates = kFromOwnLevel,
     .help = N_("The most branches of this level that one parent can bear."), .firstLevel = 1,
     .demo = {.values = {4, 12, 40}}},
    {.key = "Whorl", .label = N_("At one place"), .group = Group::Branches, .section = N_("Placement"), .field = field<&LevelParams::whorl>,
     .range = {1, 100}, .useful = {1, 12}, .step = 1, .defaults = {1, 1, 1, 1}, .invalidates = kFromOwnLevel,
     .help = N_("How many branches leave their parent at the same height, all around it: 2 are opposite, more a whorl."),
     .firstLevel = 1, .demo = {"1Branches=24 nBranchDistV=0 1DownAngle=80", {1, 2, 6}}},
    {.key = "BranchDist", .label = N_("Spread along segments"), .group = Group::Branches, .section = N_("Placement"),
     .field = field<&LevelParams::branchDist>, .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0, 1, 1, 1},
     .invalidates = kFromOwnLevel,
     .help = N_("1 spaces the branches evenly, 0 gathers them at the lower end of each segment of the parent, as whorls."),
     .firstLevel = 1,
     .demo = {"0CurveRes=4 1Branches=24 nBranchDistV=0", {0, 0.5, 1}}},
    {.key = "BranchDistV", .label = N_("Place variation"), .group = Group::Branches, .section = N_("Placement"),
     .field = field<&LevelParams::branchDistV>, .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2,
     .defaults = {0, 0.25, 0.25, 0.25}, .invalidates = kFromOwnLevel,
     .help = N_("How far each branch is moved along its parent, as a part of the spacing."), .firstLevel = 1,
     .placesLeaves = true,
     .demo = {"1Rotate=180", {0, 0.3, 1}}},
    {.key = "DownAngle", .label = N_("Down angle"), .synonyms = N_("pitch"), .group = Group::Branches, .section = N_("Direction"), .unit = Unit::Degree,
     .field = field<&LevelParams::downAngle>, .range = {-180, 180}, .useful = {0, 180}, .step = 1, .decimals = 1, .defaults = {0, 30, 30, 30},
     .invalidates = kFromOwnLevel, .help = N_("The angle between a branch and its parent. 90 stands off at a right angle."),
     .firstLevel = 1, .placesLeaves = true,
     .demo = {"1Rotate=180", {20, 60, 110}}},
    {.key = "DownAngleV", .label = N_("Down angle variation"), .group = Group::Branches, .section = N_("Direction"),
     .unit = Unit::Degree, .field = field<&LevelParams::downAngleV>, .range = {-180, 180}, .useful = {-90, 90}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .invalidates = kFromOwnLevel,
     .help = N_("How much the down angle differs from branch to branch. "
             "Negative values are not random: they grade the angle along the parent, more at its base, less at its tip."),
     .firstLevel = 1, .placesLeaves = true,
     .demo = {"1Rotate=180 1DownAngle=60", {0, 40, -50}}},
    {.key = "Rotate", .label = N_("Rotation"), .synonyms = N_("twist spiral phyllotaxis"), .group = Group::Branches, .section = N_("Direction"), .unit = Unit::Degree,
     .field = field<&LevelParams::rotate>, .range = {-360, 360}, .useful = {-180, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 120, 120, 120}, .invalidates = kFromOwnLevel,
     .help = N_("The turn about the parent from one branch to the next. "
             "Negative values put the branches on alternate sides."),
     .firstLevel = 1, .placesLeaves = true,
     .demo = {"1DownAngle=85 1Branches=9", {30, 90, 140}, true}},
    {.key = "RotateV", .label = N_("Rotation variation"), .group = Group::Branches, .section = N_("Direction"),
     .unit = Unit::Degree, .field = field<&LevelParams::rotateV>, .range = {-360, 360}, .useful = {0, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .invalidates = kFromOwnLevel, .help = N_("How much the rotation differs from branch to branch."),
     .firstLevel = 1, .placesLeaves = true,
     .demo = {"1DownAngle=85 1Branches=9 1Rotate=120", {0, 30, 120}, true}},
    {.key = "Length", .label = N_("Length"), .group = Group::Branches, .section = N_("Length"), .field = field<&LevelParams::length>,
     .range = {0, 20}, .useful = {0, 2}, .step = 0.01, .decimals = 3, .defaults = {1, 0.5, 0.5, 0.5},
     .invalidates = kFromOwnLevel,
     .help = N_("The length as a part of the parent's length; for the trunk, of the tree's height."), .aliases = kLengthAliases,
     .demo = {.values = {0.15, 0.35, 0.7}}},
    {.key = "LengthV", .label = N_("Length variation"), .group = Group::Branches, .section = N_("Length"), .field = field<&LevelParams::lengthV>,
     .range = {0, 20}, .useful = {0, 0.5}, .step = 0.01, .decimals = 3, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel, .help = N_("How much the length differs from stem to stem."), .aliases = kLengthVAliases,
     .demo = {"1Rotate=180", {0, 0.1, 0.3}}},
    {.key = "Taper", .label = N_("Taper"), .group = Group::Branches, .section = N_("Length"), .field = field<&LevelParams::taper>,
     .range = {0, 3}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {1, 1, 1, 1}, .invalidates = kFromOwnLevel,
     .help = N_("The form of the stem: 0 a cylinder, 1 a cone, 2 a cylinder with a round end, 3 a chain of spheres."),
     .demo = {"Ratio=0.06 Flare=0 nCurveRes=8 1Branches=6 1Length=0.5", {0, 1, 2.6}}},
    {.key = "CurveRes", .label = N_("Segments"), .group = Group::Branches, .section = N_("Curvature"), .field = field<&LevelParams::curveRes>,
     .range = {1, 200}, .useful = {1, 30}, .step = 1, .defaults = {3, 3, 1, 1}, .invalidates = kFromOwnLevel,
     .help = N_("The number of segments a stem consists of. More segments bend and split more finely."),
     .demo = {"nCurve=120", {1, 3, 12}}},
    {.key = "Curve", .label = N_("Curve"), .synonyms = N_("bend arch"), .group = Group::Branches, .section = N_("Curvature"), .unit = Unit::Degree,
     .field = field<&LevelParams::curve>, .range = {-3600, 3600}, .useful = {-180, 180}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel,
     .help = N_("How much the stem bends from base to tip. Positive values bend down, negative ones up."),
     .demo = {"nCurveRes=10", {-60, 0, 90}}},
    {.key = "CurveBack", .label = N_("Curve back"), .group = Group::Branches, .section = N_("Curvature"), .unit = Unit::Degree,
     .field = field<&LevelParams::curveBack>, .range = {-3600, 3600}, .useful = {-180, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .invalidates = kFromOwnLevel,
     .help = N_("Unless 0, the lower half bends by Curve and the upper half by this: S-shaped stems."),
     .demo = {"nCurveRes=12 nCurve=60", {0, -60, -120}}},
    {.key = "CurveV", .label = N_("Curve variation"), .group = Group::Branches, .section = N_("Curvature"), .unit = Unit::Degree,
     .field = field<&LevelParams::curveV>, .range = {-89, 3600}, .useful = {-60, 180}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel,
     .help = N_("Random bending, shared out over the segments. Negative values wind the stem into a helix of that angle."),
     .demo = {"nCurveRes=12", {0, 90, -40}}},
    {.key = "SegSplits", .label = N_("Splits per segment"), .synonyms = N_("fork clone"), .group = Group::Branches, .section = N_("Splitting"),
     .field = field<&LevelParams::segSplits>, .range = {0, 10}, .useful = {0, 2}, .step = 0.05, .decimals = 2, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel,
     .help = N_("How many clones split off at the end of each segment, on average. 1 forks at every one."),
     .aliases = kSegSplitsAliases,
     .demo = {"nCurveRes=5 nSplitAngle=35 1DownAngle=10 1Branches=5 1Length=0.6", {0, 0.5, 1}}},
    {.key = "SplitAngle", .label = N_("Split angle"), .group = Group::Branches, .section = N_("Splitting"), .unit = Unit::Degree,
     .field = field<&LevelParams::splitAngle>, .range = {0, 180}, .useful = {0, 90}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .invalidates = kFromOwnLevel,
     .help = N_("How far each part leans away from the vertical after a split. Towards its tip it turns back again."),
     .inactive = kNeedsSplits, .demo = {"nCurveRes=5 nSegSplits=0.5 1DownAngle=10 1Branches=5 1Length=0.6", {15, 30, 60}}},
    {.key = "SplitAngleV", .label = N_("Split angle variation"), .group = Group::Branches, .section = N_("Splitting"),
     .unit = Unit::Degree, .field = field<&LevelParams::splitAngleV>, .range = {0, 180}, .useful = {0, 90}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .invalidates = kFromOwnLevel, .help = N_("How much the split angle differs from fork to fork."),
     .inactive = kNeedsSplits, .demo = {"nCurveRes=5 nSegSplits=0.5 nSplitAngle=30 1DownAngle=10 1Branches=5 1Length=0.6", {0, 10, 30}}},
    {.key = "Leaves", .label = N_("Number"), .synonyms = N_("foliage count density"), .group = Group::Leaves, .section = N_("Placement"), .field = field<&WeberPennParams::leaves>,
     .range = {-5000, 5000}, .useful = {-50, 100}, .step = 1, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("The most leaves that a stem of the last level bears. Negative values put them in a fan at its tip."),
     .demo = {.values = {6, 16, -7}}},
    {.key = "PruneRatio", .label = N_("Strength"), .synonyms = N_("envelope crop shape"), .group = Group::Pruning, .section = N_("Envelope"), .field = field<&WeberPennParams::pruneRatio>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kFromBranches,
     .help = N_("0 leaves the branches alone, 1 shortens them until they stay inside the envelope."),
     .demo = {.values = {0, 0.6, 1}}},
    {.key = "PruneWidth", .label = N_("Width"), .group = Group::Pruning, .section = N_("Envelope"), .field = field<&WeberPennParams::pruneWidth>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaults = {0.5}, .invalidates = kFromBranches,
     .help = N_("The radius of the envelope at its widest place, as a part of the tree's height."),
     .inactive = kNeedsPruning, .demo = {.values = {0.1, 0.25, 0.5}}},
    {.key = "PruneWidthPeak", .label = N_("Widest place"), .group = Group::Pruning, .section = N_("Envelope"),
     .field = field<&WeberPennParams::pruneWidthPeak>, .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaults = {0.5},
     .invalidates = kFromBranches,
     .help = N_("Where the envelope is widest, from 0 at its bottom to 1 at its top."),
     .inactive = kNeedsEnvelope, .demo = {.values = {0.2, 0.5, 0.8}}},
    {.key = "PrunePowerLow", .label = N_("Curve below"), .group = Group::Pruning, .section = N_("Envelope"),
     .field = field<&WeberPennParams::prunePowerLow>, .range = {0.0001, 100}, .useful = {0.001, 3}, .step = 0.05, .decimals = 3,
     .defaults = {0.5}, .invalidates = kFromBranches,
     .help = N_("The envelope below its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow."),
     .inactive = kNeedsEnvelope, .demo = {.values = {0.2, 1, 2.5}}},
    {.key = "PrunePowerHigh", .label = N_("Curve above"), .group = Group::Pruning, .section = N_("Envelope"),
     .field = field<&WeberPennParams::prunePowerHigh>, .range = {0.0001, 100}, .useful = {0.001, 3}, .step = 0.05, .decimals = 3,
     .defaults = {0.5}, .invalidates = kFromBranches,
     .help = N_("The envelope above its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow."),
     .inactive = kNeedsEnvelope, .demo = {.values = {0.2, 1, 2.5}}},
};
// clang-format on

static_assert(rowsAreSane(kRows), "a row has no text, a bad range, a default out of range, or a twin");
static_assert(bytesDescribed(kRows, false) + kParamLevels * sizeof(LevelParams) == sizeof(WeberPennParams), "a field of WeberPennParams has no row");
static_assert(bytesDescribed(kRows, true) == sizeof(LevelParams), "a field of LevelParams has no row");

constexpr Group kGroups[] = {Group::Tree,    Group::Trunk,   Group::Branches, Group::Leaves,
                             Group::Blossom, Group::Pruning, Group::Textures};

string_view whyNoStems(const ParamRef& ref, const CParams& params) {
    const WeberPennParams& w = weberPenn(params);
    const bool forLeaves = ref.info->placesLeaves && std::min(w.levels, kParamLevels - 1) == ref.level;
    if (ref.level >= w.levels && !forLeaves) return N_("The tree has no stems of this level: see Levels of stems.");
    const int last = std::min(ref.level, w.levels - 1);
    const bool counts = ref.info->field == field<&LevelParams::branches>;
    for (int level = 1; level < last + (counts ? 0 : 1); ++level)
        if (w.level[static_cast<std::size_t>(level)].branches == 0)
            return N_("The tree has no stems of this level: a Number of branches is 0.");
    if (ref.level >= w.levels && w.leaves == 0) return N_("This level would place the leaves, and the tree has none.");
    return {};
}

string_view whyNoLeaves(const ParamRef& ref, const CParams& params) {
    if (weberPenn(params).levels < 2) return N_("Leaves grow on branches, and the tree is a bare trunk.");
    const bool counts = ref.info->field == field<&WeberPennParams::leaves>;
    return weberPenn(params).leaves == 0 && !counts ? N_("The tree has no leaves: their Number is 0.") : string_view();
}

string_view inactiveHere(const ParamRef& ref, const CParams& params) {
    if (ref.info->perLevel()) return whyNoStems(ref, params);
    if (ref.info->group == Group::Leaves) return whyNoLeaves(ref, params);
    if (ref.info->group == Group::Blossom && weberPenn(params).levels < 2)
        return N_("Blossoms and fruits grow on branches, and the tree is a bare trunk.");
    if (ref.info->group == Group::Pruning) return kNeedsBranches(params, 0);
    return {};
}

/// The first generation that a change of a level's value reaches, in a tree with so many levels.
Invalidation byLevel(const ParamInfo& p, int level, int levels) {
    if (level < levels) return {p.invalidates.stage, level};
    if (level == levels && p.placesLeaves) return {p.invalidates.stage, Invalidation::kLeaves};
    return {};
}

Invalidation invalidationHere(const ParamRef& ref, const CParams& before, const CParams& after) {
    const ParamInfo& p = *ref.info;
    const auto [fewer, more] = std::minmax(weberPenn(before).levels, weberPenn(after).levels);
    if (p.invalidates.generation == Invalidation::kOwnLevel) return byLevel(p, ref.level, more);
    if (p.invalidates.generation == Invalidation::kLastLevel) return {p.invalidates.stage, fewer};
    return p.invalidates;
}

constexpr ParamBlock kBlock{
    .method = "weber-penn",
    .label = N_("Weber and Penn"),
    .help = N_("Botanical values by level: trunk, branches, twigs. Creation and Rendering of Realistic Trees, SIGGRAPH 1995."),
    .rows = kRows,
    .groups = kGroups,
    .make = &makeBlock<WeberPennParams>,
    .equal = &equalBlocks<WeberPennParams>,
    .hasLeaves = [](const CParams& p) { return weberPenn(p).leaves != 0; },
    .inactive = &inactiveHere,
    .invalidation = &invalidationHere,
};
} // namespace

const ParamBlock& weberPennBlock() { return kBlock; }

} // namespace stromar
