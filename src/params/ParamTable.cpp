#include "stromar/params/ParamTable.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace stromar {

namespace {
using G = GlobalParams;
using L = LevelParams;
using std::string_view;

constexpr string_view kShapes[] = {"conical", "spherical",       "hemispherical", "cylindrical", "tapered-cylindrical",
                                   "flame",   "inverse-conical", "tend-flame",    "envelope"};
constexpr string_view kLeafShapes[] = {
    "oval", "triangle", "three-lobe-oak", "three-lobe-maple", "five-lobe-maple", "three-leaflets", "square", "needles"};
constexpr string_view kLeafForms[] = {"card", "outline"};
constexpr string_view kSwitch[] = {"off", "on"};
constexpr string_view kMethods[] = {"weber-penn"};

constexpr string_view kLobeDepthAliases[] = {"LobesDepth"};
constexpr string_view kBaseSplitsAliases[] = {"BaseSplits", "nBaseSplits", "0BaseSplit"};
constexpr string_view kSegSplitsAliases[] = {"SegSplit"};
constexpr string_view kLengthAliases[] = {"Lenght"};
constexpr string_view kLengthVAliases[] = {"LenghtV"};
constexpr string_view kLeafBendAliases[] = {"Bend"};

constexpr Obsolete kFromTrunk{Stage::Structure, 0};
constexpr Obsolete kFromBranches{Stage::Structure, 1};
constexpr Obsolete kFromTwigs{Stage::Structure, 2};
constexpr Obsolete kFromOwnLevel{Stage::Structure, Obsolete::kOwnLevel};
constexpr Obsolete kLeavesOnly{Stage::Structure, Obsolete::kLeaves};
constexpr Obsolete kMeshOnly{Stage::Mesh, 0};
constexpr Obsolete kLeafMesh{Stage::Mesh, Obsolete::kLeaves};
constexpr Obsolete kNothing{Stage::None, 0};

// clang-format off
constexpr ParamInfo kParams[] = {
    // The tree as a whole
    {.key = "Shape", .label = "Crown shape", .group = Group::Tree, .section = "Crown", .field = &G::shape,
     .range = {0, 8}, .useful = {0, 8}, .step = 1, .defaults = {0}, .obsolete = kFromBranches,
     .help = "The outline of the crown: how long the branches are from its bottom to its top. "
             "'envelope' takes the outline of the pruning tab.",
     .words = kShapes},
    {.key = "BaseSize", .label = "Bare trunk", .group = Group::Tree, .section = "Crown", .field = &G::baseSize,
     .range = {0, 1}, .useful = {0, 0.95}, .step = 0.01, .decimals = 3, .defaults = {0.25}, .obsolete = kFromBranches,
     .help = "The part of the tree's height, from the ground, that bears no branches."},
    {.key = "Scale", .label = "Height", .group = Group::Tree, .section = "Size", .unit = Unit::Metre, .field = &G::scale,
     .range = {0.01, 1000}, .useful = {0.5, 40}, .step = 0.5, .decimals = 2, .defaults = {10}, .obsolete = kFromTrunk,
     .help = "The height of the tree."},
    {.key = "ScaleV", .label = "Height variation", .group = Group::Tree, .section = "Size", .unit = Unit::Metre,
     .field = &G::scaleV, .range = {0, 1000}, .useful = {0, 15}, .step = 0.5, .decimals = 2, .defaults = {0},
     .obsolete = kFromTrunk, .help = "How much taller or smaller a tree of another seed may be."},
    {.key = "ZScale", .label = "Z scale", .group = Group::Tree, .section = "Size", .field = &G::zScale,
     .range = {-1000, 1000}, .useful = {0, 2}, .step = 0.1, .decimals = 2, .defaults = {1}, .obsolete = kNothing,
     .help = "Printed in the paper's tables but used by none of its formulas. Kept in files, without effect."},
    {.key = "ZScaleV", .label = "Z scale variation", .group = Group::Tree, .section = "Size", .field = &G::zScaleV,
     .range = {-1000, 1000}, .useful = {0, 2}, .step = 0.1, .decimals = 2, .defaults = {0}, .obsolete = kNothing,
     .help = "Printed in the paper's tables but used by none of its formulas. Kept in files, without effect."},
    {.key = "Levels", .label = "Levels of stems", .group = Group::Tree, .section = "Size", .field = &G::levels,
     .range = {1, 9}, .useful = {1, 4}, .step = 1, .defaults = {3}, .obsolete = {Stage::Structure, Obsolete::kLastLevel},
     .help = "1 grows a bare trunk, 2 adds branches, 3 branches on branches. The leaves sit on the last level."},
    {.key = "Ratio", .label = "Thickness", .group = Group::Tree, .section = "Thickness", .field = &G::ratio,
     .range = {0.0001, 1}, .useful = {0.002, 0.1}, .step = 0.001, .decimals = 4, .defaults = {0.05}, .obsolete = kFromTrunk,
     .help = "The radius of the trunk divided by its length."},
    {.key = "RatioPower", .label = "Thinning", .group = Group::Tree, .section = "Thickness", .field = &G::ratioPower,
     .range = {-10, 10}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {1}, .obsolete = kFromBranches,
     .help = "How much thinner than its parent a shorter branch is. Higher values make finer branches."},
    {.key = "MinRadius", .label = "Least radius", .group = Group::Tree, .section = "Thickness", .unit = Unit::Metre,
     .field = &G::minRadius, .range = {0, 1}, .useful = {0, 0.01}, .step = 0.0005, .decimals = 4, .defaults = {0.0005},
     .obsolete = kMeshOnly, .help = "No stem is drawn thinner than this, so that fine twigs stay visible."},
    {.key = "AttractionUp", .label = "Attraction up", .group = Group::Tree, .section = "Growth", .field = &G::attractionUp,
     .range = {-100, 100}, .useful = {-10, 10}, .step = 0.1, .decimals = 2, .defaults = {0}, .obsolete = kFromTwigs,
     .help = "How strongly branches of level 2 and deeper bend up to the light. Negative values let them hang."},
    {.key = "CloneHalving", .label = "Halve splitting", .group = Group::Tree, .section = "Growth", .field = &G::cloneHalving,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {1}, .obsolete = kFromTrunk,
     .help = "On: a stem that has split, and its clones, split half as often from then on.", .words = kSwitch},
    {.key = "Seed", .label = "Seed", .group = Group::Tree, .section = "Growth", .field = &G::seed,
     .range = {-2147483647, 2147483647}, .useful = {0, 999}, .step = 1, .defaults = {13}, .obsolete = kFromTrunk,
     .help = "Every seed gives another tree of the same kind. The same seed always grows the same tree."},

    // The trunk's own values
    {.key = "0Scale", .label = "Radius factor", .group = Group::Trunk, .section = "Thickness", .field = &G::trunkScale,
     .range = {0.01, 100}, .useful = {0.2, 3}, .step = 0.05, .decimals = 2, .defaults = {1}, .obsolete = kFromTrunk,
     .help = "Makes the trunk thicker or thinner than Thickness says, and the branches with it."},
    {.key = "0ScaleV", .label = "Radius factor variation", .group = Group::Trunk, .section = "Thickness",
     .field = &G::trunkScaleV, .range = {0, 100}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0},
     .obsolete = kFromTrunk, .help = "How much the radius factor differs from seed to seed."},
    {.key = "Flare", .label = "Flare", .group = Group::Trunk, .section = "Thickness", .field = &G::flare,
     .range = {-1, 20}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {0.5}, .obsolete = kFromTrunk,
     .help = "How much the trunk widens at the ground. 1 makes it twice as thick there."},
    {.key = "Lobes", .label = "Lobes", .group = Group::Trunk, .section = "Lobes", .field = &G::lobes,
     .range = {0, 60}, .useful = {0, 12}, .step = 1, .defaults = {0}, .obsolete = kMeshOnly,
     .help = "The number of bulges around the trunk. Odd numbers look natural, even ones symmetric."},
    {.key = "LobeDepth", .label = "Lobe depth", .group = Group::Trunk, .section = "Lobes", .field = &G::lobeDepth,
     .range = {0, 1}, .useful = {0, 0.4}, .step = 0.01, .decimals = 3, .defaults = {0}, .obsolete = kMeshOnly,
     .help = "How far the bulges stand out, as a part of the radius.", .aliases = kLobeDepthAliases},
    {.key = "LobeFade", .label = "Lobes fade", .group = Group::Trunk, .section = "Lobes", .field = &G::lobeFade,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {1}, .obsolete = kMeshOnly,
     .help = "1 lets the lobes end a little above the ground, 0 lets them run up the whole trunk."},
    {.key = "0BaseSplits", .label = "Splits at the base", .group = Group::Trunk, .section = "Splitting", .field = &G::baseSplits,
     .range = {0, 50}, .useful = {0, 6}, .step = 1, .defaults = {0}, .obsolete = kFromTrunk,
     .help = "So many more trunks grow out of the end of the trunk's first segment.", .aliases = kBaseSplitsAliases},

    // One value per level
    {.key = "Branches", .label = "Number", .group = Group::Branches, .section = "Placement", .field = &L::branches,
     .range = {0, 5000}, .useful = {0, 150}, .step = 1, .defaults = {0, 10, 5, 5}, .obsolete = kFromOwnLevel,
     .help = "The most branches of this level that one parent can bear.", .firstLevel = 1},
    {.key = "BranchDist", .label = "Spread along segments", .group = Group::Branches, .section = "Placement",
     .field = &L::branchDist, .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0, 1, 1, 1},
     .obsolete = kFromOwnLevel,
     .help = "1 spaces the branches evenly, 0 gathers them at the lower end of each segment of the parent, as whorls.",
     .firstLevel = 1},
    {.key = "BranchDistV", .label = "Place variation", .group = Group::Branches, .section = "Placement",
     .field = &L::branchDistV, .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2,
     .defaults = {0, 0.25, 0.25, 0.25}, .obsolete = kFromOwnLevel,
     .help = "How far each branch is moved along its parent, as a part of the spacing.", .firstLevel = 1,
     .placesLeaves = true},
    {.key = "DownAngle", .label = "Down angle", .group = Group::Branches, .section = "Direction", .unit = Unit::Degree,
     .field = &L::downAngle, .range = {-180, 180}, .useful = {0, 180}, .step = 1, .decimals = 1, .defaults = {0, 30, 30, 30},
     .obsolete = kFromOwnLevel, .help = "The angle between a branch and its parent. 90 stands off at a right angle.",
     .firstLevel = 1, .placesLeaves = true},
    {.key = "DownAngleV", .label = "Down angle variation", .group = Group::Branches, .section = "Direction",
     .unit = Unit::Degree, .field = &L::downAngleV, .range = {-180, 180}, .useful = {-90, 90}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .obsolete = kFromOwnLevel,
     .help = "How much the down angle differs from branch to branch. "
             "Negative values are not random: they grade the angle along the parent, more at its base, less at its tip.",
     .firstLevel = 1, .placesLeaves = true},
    {.key = "Rotate", .label = "Rotation", .group = Group::Branches, .section = "Direction", .unit = Unit::Degree,
     .field = &L::rotate, .range = {-360, 360}, .useful = {-180, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 120, 120, 120}, .obsolete = kFromOwnLevel,
     .help = "The turn about the parent from one branch to the next. "
             "Negative values put the branches on alternate sides.",
     .firstLevel = 1, .placesLeaves = true},
    {.key = "RotateV", .label = "Rotation variation", .group = Group::Branches, .section = "Direction",
     .unit = Unit::Degree, .field = &L::rotateV, .range = {-360, 360}, .useful = {0, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .obsolete = kFromOwnLevel, .help = "How much the rotation differs from branch to branch.",
     .firstLevel = 1, .placesLeaves = true},
    {.key = "Length", .label = "Length", .group = Group::Branches, .section = "Length", .field = &L::length,
     .range = {0, 20}, .useful = {0, 2}, .step = 0.01, .decimals = 3, .defaults = {1, 0.5, 0.5, 0.5},
     .obsolete = kFromOwnLevel,
     .help = "The length as a part of the parent's length; for the trunk, of the tree's height.", .aliases = kLengthAliases},
    {.key = "LengthV", .label = "Length variation", .group = Group::Branches, .section = "Length", .field = &L::lengthV,
     .range = {0, 20}, .useful = {0, 0.5}, .step = 0.01, .decimals = 3, .defaults = {0, 0, 0, 0},
     .obsolete = kFromOwnLevel, .help = "How much the length differs from stem to stem.", .aliases = kLengthVAliases},
    {.key = "Taper", .label = "Taper", .group = Group::Branches, .section = "Length", .field = &L::taper,
     .range = {0, 3}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {1, 1, 1, 1}, .obsolete = kFromOwnLevel,
     .help = "The form of the stem: 0 a cylinder, 1 a cone, 2 a cylinder with a round end, 3 a chain of spheres."},
    {.key = "CurveRes", .label = "Segments", .group = Group::Branches, .section = "Curvature", .field = &L::curveRes,
     .range = {1, 200}, .useful = {1, 30}, .step = 1, .defaults = {3, 3, 1, 1}, .obsolete = kFromOwnLevel,
     .help = "The number of segments a stem consists of. More segments bend and split more finely."},
    {.key = "Curve", .label = "Curve", .group = Group::Branches, .section = "Curvature", .unit = Unit::Degree,
     .field = &L::curve, .range = {-3600, 3600}, .useful = {-180, 180}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .obsolete = kFromOwnLevel,
     .help = "How much the stem bends from base to tip. Positive values bend down, negative ones up."},
    {.key = "CurveBack", .label = "Curve back", .group = Group::Branches, .section = "Curvature", .unit = Unit::Degree,
     .field = &L::curveBack, .range = {-3600, 3600}, .useful = {-180, 180}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .obsolete = kFromOwnLevel,
     .help = "Unless 0, the lower half bends by Curve and the upper half by this: S-shaped stems."},
    {.key = "CurveV", .label = "Curve variation", .group = Group::Branches, .section = "Curvature", .unit = Unit::Degree,
     .field = &L::curveV, .range = {-89, 3600}, .useful = {-60, 180}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .obsolete = kFromOwnLevel,
     .help = "Random bending, shared out over the segments. Negative values wind the stem into a helix of that angle."},
    {.key = "SegSplits", .label = "Splits per segment", .group = Group::Branches, .section = "Splitting",
     .field = &L::segSplits, .range = {0, 10}, .useful = {0, 2}, .step = 0.05, .decimals = 2, .defaults = {0, 0, 0, 0},
     .obsolete = kFromOwnLevel,
     .help = "How many clones split off at the end of each segment, on average. 1 forks at every one.",
     .aliases = kSegSplitsAliases},
    {.key = "SplitAngle", .label = "Split angle", .group = Group::Branches, .section = "Splitting", .unit = Unit::Degree,
     .field = &L::splitAngle, .range = {0, 180}, .useful = {0, 90}, .step = 1, .decimals = 1, .defaults = {0, 0, 0, 0},
     .obsolete = kFromOwnLevel,
     .help = "How far each part leans away from the vertical after a split. Towards its tip it turns back again."},
    {.key = "SplitAngleV", .label = "Split angle variation", .group = Group::Branches, .section = "Splitting",
     .unit = Unit::Degree, .field = &L::splitAngleV, .range = {0, 180}, .useful = {0, 90}, .step = 1, .decimals = 1,
     .defaults = {0, 0, 0, 0}, .obsolete = kFromOwnLevel, .help = "How much the split angle differs from fork to fork."},

    // Leaves
    {.key = "Leaves", .label = "Number", .group = Group::Leaves, .section = "Placement", .field = &G::leaves,
     .range = {-5000, 5000}, .useful = {-50, 100}, .step = 1, .defaults = {0}, .obsolete = kLeavesOnly,
     .help = "The most leaves that a stem of the last level bears. Negative values put them in a fan at its tip."},
    {.key = "LeafQuality", .label = "Density", .group = Group::Leaves, .section = "Placement", .field = &G::leafQuality,
     .range = {0.001, 100}, .useful = {0.05, 2}, .step = 0.05, .decimals = 3, .defaults = {1}, .obsolete = kLeavesOnly,
     .help = "Fewer but larger leaves below 1, more and smaller ones above: the leaf area stays."},
    {.key = "LeafBend", .label = "Turn to the light", .group = Group::Leaves, .section = "Placement", .field = &G::leafBend,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0.3}, .obsolete = kLeavesOnly,
     .help = "How far the leaves turn outwards and up to the light.", .aliases = kLeafBendAliases},
    {.key = "LeafShape", .label = "Shape", .group = Group::Leaves, .section = "Blade", .field = &G::leafShape,
     .range = {0, 7}, .useful = {0, 7}, .step = 1, .defaults = {0}, .obsolete = kLeafMesh,
     .help = "The kind of leaf: its outline where the form is 'outline'. A card shows what its texture shows.",
     .words = kLeafShapes},
    {.key = "LeafForm", .label = "Form", .group = Group::Leaves, .section = "Blade", .field = &G::leafForm,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {0}, .obsolete = kLeafMesh,
     .help = "A card is a rectangle with the leaf texture. An outline is cut to the shape and needs no transparency.",
     .words = kLeafForms},
    {.key = "LeafScale", .label = "Length", .group = Group::Leaves, .section = "Blade", .unit = Unit::Metre,
     .field = &G::leafScale, .range = {0.001, 50}, .useful = {0.02, 1}, .step = 0.01, .decimals = 3, .defaults = {0.2},
     .obsolete = kLeavesOnly, .help = "The length of a leaf."},
    {.key = "LeafScaleX", .label = "Width", .group = Group::Leaves, .section = "Blade", .field = &G::leafScaleX,
     .range = {0.001, 100}, .useful = {0.05, 2}, .step = 0.05, .decimals = 2, .defaults = {0.5}, .obsolete = kLeavesOnly,
     .help = "The width of a leaf as a part of its length."},
    {.key = "LeafStalk", .label = "Stalk", .group = Group::Leaves, .section = "Blade", .field = &G::leafStalk,
     .range = {0, 5}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .obsolete = kLeafMesh,
     .help = "The length of the stalk between stem and blade, as a part of the leaf's length."},
    {.key = "LeafFold", .label = "Fold", .group = Group::Leaves, .section = "Blade", .unit = Unit::Degree,
     .field = &G::leafFold, .range = {-80, 80}, .useful = {0, 45}, .step = 1, .decimals = 1, .defaults = {0},
     .obsolete = kLeafMesh, .help = "How far each half of a leaf is folded up along its midrib."},
    {.key = "LeafRounding", .label = "Rounding", .group = Group::Leaves, .section = "Shading", .field = &G::leafRounding,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .obsolete = kLeafMesh,
     .help = "Shades the leaves as if they were the surface of one round crown: softer light on dense crowns."},

    // Pruning
    {.key = "PruneRatio", .label = "Strength", .group = Group::Pruning, .section = "Envelope", .field = &G::pruneRatio,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .obsolete = kFromBranches,
     .help = "0 leaves the branches alone, 1 shortens them until they stay inside the envelope."},
    {.key = "PruneWidth", .label = "Width", .group = Group::Pruning, .section = "Envelope", .field = &G::pruneWidth,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaults = {0.5}, .obsolete = kFromBranches,
     .help = "The radius of the envelope at its widest place, as a part of the tree's height."},
    {.key = "PruneWidthPeak", .label = "Widest place", .group = Group::Pruning, .section = "Envelope",
     .field = &G::pruneWidthPeak, .range = {0, 1}, .useful = {0, 1}, .step = 0.01, .decimals = 3, .defaults = {0.5},
     .obsolete = kFromBranches,
     .help = "Where the envelope is widest, from 0 at its bottom to 1 at its top."},
    {.key = "PrunePowerLow", .label = "Curve below", .group = Group::Pruning, .section = "Envelope",
     .field = &G::prunePowerLow, .range = {0.0001, 100}, .useful = {0.001, 3}, .step = 0.05, .decimals = 3,
     .defaults = {0.5}, .obsolete = kFromBranches,
     .help = "The envelope below its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow."},
    {.key = "PrunePowerHigh", .label = "Curve above", .group = Group::Pruning, .section = "Envelope",
     .field = &G::prunePowerHigh, .range = {0.0001, 100}, .useful = {0.001, 3}, .step = 0.05, .decimals = 3,
     .defaults = {0.5}, .obsolete = kFromBranches,
     .help = "The envelope above its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow."},

    // Textures
    {.key = "TextureWrapX", .label = "Bark repeats around", .group = Group::Textures, .section = "Bark",
     .field = &G::textureWrapX, .range = {0.001, 1000}, .useful = {0.5, 10}, .step = 0.5, .decimals = 2, .defaults = {1},
     .obsolete = kMeshOnly, .help = "How often the bark picture goes around the trunk; branches follow. Whole numbers leave no seam."},
    {.key = "TextureWrapY", .label = "Bark repeats along", .group = Group::Textures, .section = "Bark",
     .field = &G::textureWrapY, .range = {0.001, 1000}, .useful = {0.5, 20}, .step = 0.5, .decimals = 2, .defaults = {1},
     .obsolete = kMeshOnly, .help = "How often the bark picture repeats from the trunk's base to its tip. Branches show it at the same scale."},
};

constexpr TextInfo kTexts[] = {
    {"Species", "Species", &TextParams::species, Group::Tree, Stage::None, "The name of the kind of tree."},
    {"Author", "Author", &TextParams::author, Group::Tree, Stage::None, "Who made the file."},
    {"Description", "Description", &TextParams::description, Group::Tree, Stage::None, "What the tree is like."},
    {"Method", "Method", &TextParams::method, Group::Tree, Stage::Structure, "How the tree is grown: weber-penn."},
    {"BarkTexture", "Bark texture", &TextParams::barkTexture, Group::Textures, Stage::Material,
     "The picture on the stems; its path starts at the file's folder. Empty takes the built-in one.", true},
    {"LeafTexture", "Leaf texture", &TextParams::leafTexture, Group::Textures, Stage::Material,
     "The picture on the leaves, transparent outside the blade. Empty takes the built-in one.", true},
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
    addGlobals(Group::Tree);
    add(Group::Trunk, 0);
    for (int level = 1; level < kParamLevels; ++level) add(Group::Branches, level);
    for (const Group group : {Group::Leaves, Group::Pruning, Group::Textures}) addGlobals(group);
    return refs;
}

/// The first generation that a change of a level's value reaches, in a tree with so many levels.
Obsolete obsoleteByLevel(const ParamInfo& p, int level, int levels) {
    if (level < levels) return {p.obsolete.stage, level};
    if (level == levels && p.placesLeaves) return {p.obsolete.stage, Obsolete::kLeaves};
    return {};
}

Obsolete obsoleteBy(const ParamRef& ref, const CParams& before, const CParams& after) {
    const ParamInfo& p = *ref.info;
    const int levels = std::min(before.global.levels, after.global.levels);
    if (p.obsolete.generation == Obsolete::kOwnLevel)
        return obsoleteByLevel(p, ref.level, std::max(before.global.levels, after.global.levels));
    if (p.obsolete.generation == Obsolete::kLastLevel) return {p.obsolete.stage, levels};
    return p.obsolete;
}

Obsolete earlier(const Obsolete& a, const Obsolete& b) {
    if (a.stage == Stage::None || b.stage == Stage::None) return a.stage == Stage::None ? b : a;
    if (a.stage != b.stage) return {std::min(a.stage, b.stage), std::min(a.generation, b.generation)};
    return {a.stage, std::min(a.generation, b.generation)};
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

Obsolete firstObsolete(const CParams& before, const CParams& after) {
    Obsolete first;
    for (const ParamRef& ref : allParams())
        if (ref.get(before) != ref.get(after)) first = earlier(first, obsoleteBy(ref, before, after));
    for (const TextInfo& text : kTexts)
        if (before.text.*text.field != after.text.*text.field)
            first = earlier(first, {text.stage, text.stage == Stage::Structure ? 0 : Obsolete::kLeaves});
    return first;
}

std::string_view groupName(Group group) {
    constexpr string_view kNames[] = {"Tree", "Trunk", "Branches", "Leaves", "Pruning", "Textures"};
    return kNames[static_cast<std::size_t>(group)];
}

std::string_view unitName(Unit unit) {
    constexpr string_view kNames[] = {"", "m", "°"};
    return kNames[static_cast<std::size_t>(unit)];
}

} // namespace stromar
