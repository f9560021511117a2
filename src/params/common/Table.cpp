#include "CommonTable.h"
#include "stromar/params/BuiltInMesh.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <array>

namespace stromar {

namespace {
using std::string_view;

constexpr string_view kLeafShapes[] = {
    N_("oval"), N_("triangle"), N_("three-lobe-oak"), N_("three-lobe-maple"), N_("five-lobe-maple"), N_("three-leaflets"), N_("square"), N_("needles"),
    N_("lance"), N_("heart"), N_("pinnate"), N_("palmate"), N_("fan")};
constexpr string_view kLeafForms[] = {N_("card"), N_("outline")};
constexpr string_view kSwitch[] = {N_("off"), N_("on")};

constexpr string_view kLobeDepthAliases[] = {"LobesDepth"};
constexpr string_view kLeafBendAliases[] = {"Bend"};

constexpr Invalidation kFromTrunk{Stage::Structure, 0};
constexpr Invalidation kLeavesOnly{Stage::Structure, Invalidation::kLeaves};
constexpr Invalidation kMeshOnly{Stage::Mesh, 0};
constexpr Invalidation kLeafMesh{Stage::Mesh, Invalidation::kLeaves};
constexpr Invalidation kPictures{Stage::Material, Invalidation::kLeaves};
constexpr Invalidation kNothing{Stage::None, Invalidation::kLeaves};

// When a value does nothing. What the method knows of it is asked for all rows alike.
using Inactive = string_view (*)(const CParams&, int);
constexpr Inactive kNeedsLobes = [](const CParams& p, int) -> string_view {
    return p.common.lobes > 0 ? "" : N_("The trunk has no lobes.");
};
constexpr Inactive kNeedsLobeDepth = [](const CParams& p, int) -> string_view {
    return p.common.lobes > 0 && p.common.lobeDepth > 0 ? "" : N_("The trunk has no lobes, or they have no depth.");
};
constexpr Inactive kNeedsRoots = [](const CParams& p, int) -> string_view {
    return p.common.roots > 0 ? "" : N_("The trunk has no roots.");
};
constexpr string_view kHasMesh = N_("The leaf has a mesh of its own.");
constexpr Inactive kNeedsNoMesh = [](const CParams& p, int) { return p.text.leafMesh.empty() ? string_view() : kHasMesh; };
constexpr Inactive kNeedsNoFile = [](const CParams& p, int) {
    return hasLeavesOfAnyWidth(p) ? string_view() : N_("The mesh keeps its proportions.");
};
constexpr Inactive kNeedsOutline = [](const CParams& p, int) -> string_view {
    if (!p.text.leafMesh.empty()) return kHasMesh;
    return p.common.leafForm != 0 ? "" : N_("A card shows what its texture shows: set Form to outline.");
};
constexpr Inactive kNeedsCards = [](const CParams& p, int) -> string_view {
    if (!p.text.leafMesh.empty()) return kHasMesh;
    return p.common.leafForm == 0 ? "" : N_("Only cards have several planes: set Form to card.");
};
constexpr Inactive kNeedsSeasons = [](const CParams& p, int) -> string_view {
    const bool leaves = !p.block().hasLeaves || p.block().hasLeaves(p);
    return leaves || hasBlossoms(p) || hasFruits(p) ? "" : N_("The tree has no leaves, blossoms or fruits.");
};
constexpr Inactive kNeedsBlossoms = [](const CParams& p, int) -> string_view {
    return hasBlossoms(p) ? "" : N_("The tree has no blossoms: their Number is 0.");
};
constexpr Inactive kNeedsFruits = [](const CParams& p, int) -> string_view {
    return hasFruits(p) ? "" : N_("The tree has no fruits: their Number is 0.");
};

// clang-format off
// N_() of the groups, which all methods share
[[maybe_unused]] constexpr string_view kGroupNames[] = {N_("Tree"), N_("Trunk"), N_("Branches"), N_("Leaves"), N_("Blossom"), N_("Pruning"), N_("Textures")};

constexpr ParamInfo kTexts[] = {
    {.key = "Species", .label = N_("Species"), .group = Group::Tree, .section = N_("About"), .field = field<&TextParams::species>,
     .invalidates = kNothing, .help = N_("The name of the kind of tree.")},
    {.key = "Author", .label = N_("Author"), .group = Group::Tree, .section = N_("About"), .field = field<&TextParams::author>,
     .invalidates = kNothing, .help = N_("Who made the file.")},
    {.key = "Description", .label = N_("Description"), .group = Group::Tree, .section = N_("About"), .field = field<&TextParams::description>,
     .invalidates = kNothing, .help = N_("What the tree is like.")},
    {.key = "LikedSeeds", .label = N_("Liked seeds"), .group = Group::Tree, .section = N_("Growth"), .field = field<&TextParams::likedSeeds>,
     .invalidates = kNothing, .help = N_("Seeds worth finding again, separated by blanks."), .shown = false},
    {.key = "BarkTexture", .label = N_("Bark texture"), .group = Group::Textures, .section = N_("Bark"), .field = field<&TextParams::barkTexture>,
     .invalidates = kPictures, .help = N_("The picture on the stems; its path starts at the file's folder. A recipe as bark:furrowed seed=3 is drawn. Empty takes the built-in one."), .recipes = "bark", .whenEmpty = N_("built in")},
    {.key = "1BarkTexture", .label = N_("Bark of branches 1"), .group = Group::Textures, .section = N_("Bark"), .field = field<&TextParams::bark1Texture>,
     .invalidates = kPictures, .help = N_("The picture on branches, which have a material of their own then. The trunk shows it where it is as thin as they are. Empty: as the trunk."), .recipes = "bark", .whenEmpty = N_("as the trunk")},
    {.key = "2BarkTexture", .label = N_("Bark of branches 2"), .group = Group::Textures, .section = N_("Bark"), .field = field<&TextParams::bark2Texture>,
     .invalidates = kPictures, .help = N_("The picture on branches of branches, which have a material of their own then. Thin branches show it too. Empty: as branches 1."), .recipes = "bark", .whenEmpty = N_("as branches 1")},
    {.key = "3BarkTexture", .label = N_("Bark of branches 3"), .group = Group::Textures, .section = N_("Bark"), .field = field<&TextParams::bark3Texture>,
     .invalidates = kPictures, .help = N_("The picture on branches 3 and deeper ones, which have a material of their own then. Thin branches 2 show it too. Empty: as branches 2."), .recipes = "bark", .whenEmpty = N_("as branches 2")},
    {.key = "LeafTexture", .label = N_("Leaf texture"), .group = Group::Textures, .section = N_("Leaves"), .field = field<&TextParams::leafTexture>,
     .invalidates = kPictures, .help = N_("The picture on the leaves, transparent outside the blade. A recipe as leaf:oak seed=3 is drawn. Empty takes the built-in one."), .recipes = "leaf", .whenEmpty = N_("built in")},
    {.key = "Leaf2Texture", .label = N_("Leaf texture 2"), .group = Group::Textures, .section = N_("Leaves"), .field = field<&TextParams::leaf2Texture>,
     .invalidates = kPictures, .help = N_("The picture on leaves of this kind, which have a material of their own then. Empty: as the first kind."), .recipes = "leaf", .whenEmpty = N_("as the first kind")},
    {.key = "Leaf3Texture", .label = N_("Leaf texture 3"), .group = Group::Textures, .section = N_("Leaves"), .field = field<&TextParams::leaf3Texture>,
     .invalidates = kPictures, .help = N_("The picture on leaves of this kind, which have a material of their own then. Empty: as the first kind."), .recipes = "leaf", .whenEmpty = N_("as the first kind")},
    {.key = "Leaf4Texture", .label = N_("Leaf texture 4"), .group = Group::Textures, .section = N_("Leaves"), .field = field<&TextParams::leaf4Texture>,
     .invalidates = kPictures, .help = N_("The picture on leaves of this kind, which have a material of their own then. Empty: as the first kind."), .recipes = "leaf", .whenEmpty = N_("as the first kind")},
    {.key = "LeafMesh", .label = N_("Mesh"), .group = Group::Leaves, .section = N_("Blade"), .field = field<&TextParams::leafMesh>,
     .invalidates = kLeafMesh, .help = N_("A mesh in place of a card: mesh:curved and the like, or a file (.obj, .glb) whose foot is the origin; its path starts at the file's folder. The leaf texture lies on it by its texture coordinates."), .recipes = "mesh", .whenEmpty = N_("none")},
    {.key = "Leaf2Mesh", .label = N_("Mesh 2"), .group = Group::Leaves, .section = N_("Kinds"), .field = field<&TextParams::leaf2Mesh>,
     .invalidates = kLeafMesh, .help = N_("The mesh of leaves of this kind. Empty: as the first kind."), .recipes = "mesh", .whenEmpty = N_("as the first kind")},
    {.key = "Leaf3Mesh", .label = N_("Mesh 3"), .group = Group::Leaves, .section = N_("Kinds"), .field = field<&TextParams::leaf3Mesh>,
     .invalidates = kLeafMesh, .help = N_("The mesh of leaves of this kind. Empty: as the first kind."), .recipes = "mesh", .whenEmpty = N_("as the first kind")},
    {.key = "Leaf4Mesh", .label = N_("Mesh 4"), .group = Group::Leaves, .section = N_("Kinds"), .field = field<&TextParams::leaf4Mesh>,
     .invalidates = kLeafMesh, .help = N_("The mesh of leaves of this kind. Empty: as the first kind."), .recipes = "mesh", .whenEmpty = N_("as the first kind")},
    {.key = "BlossomTexture", .label = N_("Blossom texture"), .group = Group::Textures, .section = N_("Blossoms and fruits"), .field = field<&TextParams::blossomTexture>,
     .invalidates = kPictures, .help = N_("The picture on the blossoms. Empty draws leaf:blossom."), .recipes = "leaf", .whenEmpty = N_("built in")},
    {.key = "FruitTexture", .label = N_("Fruit texture"), .group = Group::Textures, .section = N_("Blossoms and fruits"), .field = field<&TextParams::fruitTexture>,
     .invalidates = kPictures, .help = N_("The skin of the fruits. Empty draws a red one."), .recipes = "bark", .whenEmpty = N_("built in")},
};

constexpr ParamInfo kNumbers[] = {
    {.key = "MinRadius", .label = N_("Min radius"), .group = Group::Tree, .section = N_("Thickness"), .unit = Unit::Metre,
     .field = field<&CommonParams::minRadius>, .range = {0, 1}, .useful = {0, 0.01}, .step = 0.0005, .decimals = 4, .defaults = {0.0005},
     .invalidates = kMeshOnly, .help = N_("No stem is drawn thinner than this, so that fine twigs stay visible."),
     .demo = {"Levels=2 Ratio=0.01 Scale=4", {0.0005, 0.01, 0.04}}},
    {.key = "Seed", .label = N_("Seed"), .synonyms = N_("random"), .group = Group::Tree, .section = N_("Growth"), .field = field<&CommonParams::seed>,
     .range = {-2147483647, 2147483647}, .useful = {0, 999}, .step = 1, .defaults = {13}, .invalidates = kFromTrunk,
     .help = N_("Every seed gives another tree of the same kind. The same seed always grows the same tree."), .atRandom = false},
    {.key = "Season", .label = N_("Month"), .synonyms = N_("autumn winter spring date"), .group = Group::Tree, .section = N_("Season"), .field = field<&CommonParams::season>,
     .range = {0, 12}, .useful = {0, 12}, .step = 0.1, .decimals = 2, .defaults = {7}, .invalidates = kLeafMesh,
     .help = N_("The time of the year: 0 is New Year, 4.5 spring, 7 summer, 10 autumn. Leaves, their colour, blossoms and fruits follow."),
     .atRandom = false, .inactive = kNeedsSeasons, .demo = {"Leaves=12 LeafScale=0.5 Levels=2", {4, 7, 10.3}}},
    {.key = "Evergreen", .label = N_("Evergreen"), .group = Group::Tree, .section = N_("Season"), .field = field<&CommonParams::evergreen>,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("On: the leaves stay, and stay green, through the winter."), .words = kSwitch,
     .inactive = kNeedsSeasons, .demo = {"Leaves=12 LeafScale=0.5 Levels=2 Season=1"}},
    {.key = "Flexibility", .label = N_("Flexibility"), .synonyms = N_("stiff sway"), .group = Group::Tree, .section = N_("Wind"), .field = field<&CommonParams::flexibility>,
     .range = {0, 2}, .useful = {0, 2}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kPictures,
     .help = N_("How far the wood bends in the wind: 0 is stiff, 2 bends twice as far. The tree in still air stays as it is."), .atRandom = false,
     .demo = {.settings = "Leaves=12 LeafScale=0.4 Levels=2 Ratio=0.012 Flare=0", .values = {0, 1, 2}, .inWind = true}},
    {.key = "Flare", .label = N_("Flare"), .synonyms = N_("root collar buttress base"), .group = Group::Trunk, .section = N_("Thickness"), .field = field<&CommonParams::flare>,
     .range = {-1, 20}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {0.5}, .invalidates = kFromTrunk,
     .help = N_("How much the trunk widens at the ground. 1 makes it twice as thick there."),
     .demo = {"Levels=1 Scale=3 Ratio=0.06 0Taper=0.5", {0, 0.8, 2.5}}},
    {.key = "Lobes", .label = N_("Lobes"), .group = Group::Trunk, .section = N_("Lobes"), .field = field<&CommonParams::lobes>,
     .range = {0, 60}, .useful = {0, 12}, .step = 1, .defaults = {0}, .invalidates = kMeshOnly,
     .help = N_("The number of bulges around the trunk. Odd numbers look natural, even ones symmetric."),
     .demo = {"Levels=1 Scale=2 Ratio=0.15 LobeDepth=0.2 LobeFade=0", {0, 5, 9}, true}},
    {.key = "LobeDepth", .label = N_("Lobe depth"), .group = Group::Trunk, .section = N_("Lobes"), .field = field<&CommonParams::lobeDepth>,
     .range = {0, 1}, .useful = {0, 0.4}, .step = 0.01, .decimals = 3, .defaults = {0}, .invalidates = kMeshOnly,
     .help = N_("How far the bulges stand out, as a part of the radius."), .aliases = kLobeDepthAliases,
     .inactive = kNeedsLobes, .demo = {"Levels=1 Scale=2 Ratio=0.15 Lobes=5 LobeFade=0", {0, 0.1, 0.3}, true}},
    {.key = "LobeFade", .label = N_("Lobes fade"), .group = Group::Trunk, .section = N_("Lobes"), .field = field<&CommonParams::lobeFade>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kMeshOnly,
     .help = N_("1 lets the lobes end a little above the ground, 0 lets them run up the whole trunk."),
     .inactive = kNeedsLobeDepth, .demo = {"Levels=1 Scale=2 Ratio=0.15 Lobes=5 LobeDepth=0.3 0Taper=0.5", {0, 0.5, 1}}},
    {.key = "Roots", .label = N_("Roots"), .group = Group::Trunk, .section = N_("Roots"), .field = field<&CommonParams::roots>,
     .range = {0, 30}, .useful = {0, 9}, .step = 1, .defaults = {0}, .invalidates = kMeshOnly,
     .help = N_("The number of ridges that run from the trunk into the ground. High ones are buttresses."),
     .demo = {"Levels=1 Scale=4 Ratio=0.06", {0, 4, 8}, true}},
    {.key = "RootReach", .label = N_("Reach of roots"), .group = Group::Trunk, .section = N_("Roots"), .field = field<&CommonParams::rootReach>,
     .range = {0, 20}, .useful = {0, 4}, .step = 0.1, .decimals = 2, .defaults = {1.2}, .invalidates = kMeshOnly,
     .help = N_("How far the roots reach out of the trunk on the ground, in radii of the trunk."),
     .inactive = kNeedsRoots, .demo = {"Levels=1 Scale=4 Ratio=0.06 Roots=5", {0.5, 1.5, 3}, true}},
    {.key = "RootHeight", .label = N_("Height of roots"), .group = Group::Trunk, .section = N_("Roots"), .field = field<&CommonParams::rootHeight>,
     .range = {0.001, 1}, .useful = {0.02, 0.4}, .step = 0.01, .decimals = 3, .defaults = {0.12}, .invalidates = kMeshOnly,
     .help = N_("Where the roots leave the trunk, as a part of its length."),
     .inactive = kNeedsRoots, .demo = {"Levels=1 Scale=4 Ratio=0.06 Roots=5 RootReach=2", {0.05, 0.15, 0.4}}},
    {.key = "LeafWhorl", .label = N_("At one place"), .group = Group::Leaves, .section = N_("Placement"), .field = field<&CommonParams::leafWhorl>,
     .range = {1, 50}, .useful = {1, 8}, .step = 1, .defaults = {1}, .invalidates = kLeavesOnly,
     .help = N_("How many leaves leave a stem at the same place: 1 are alternate, 2 opposite, more a whorl."),
     .demo = {"2Rotate=90 2DownAngle=60 2BranchDistV=0", {1, 2, 4}}},
    {.key = "LeafQuality", .label = N_("Density"), .group = Group::Leaves, .section = N_("Placement"), .field = field<&CommonParams::leafQuality>,
     .range = {0.001, 100}, .useful = {0.05, 2}, .step = 0.05, .decimals = 3, .defaults = {1}, .invalidates = kLeavesOnly,
     .help = N_("Fewer but larger leaves below 1, more and smaller ones above: the leaf area stays."),
     .demo = {.values = {0.4, 1, 2}}},
    {.key = "LeafBend", .label = N_("Turn to the light"), .group = Group::Leaves, .section = N_("Placement"), .field = field<&CommonParams::leafBend>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0.3}, .invalidates = kLeavesOnly,
     .help = N_("How far the leaves turn outwards and up to the light."), .aliases = kLeafBendAliases,
     .demo = {.values = {0, 0.5, 1}}},
    {.key = "LeafShape", .label = N_("Shape"), .group = Group::Leaves, .section = N_("Blade"), .field = field<&CommonParams::leafShape>,
     .range = {0, 12}, .useful = {0, 12}, .step = 1, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("The kind of leaf: its outline where the form is 'outline'. A card shows what its texture shows."),
     .words = kLeafShapes,
     .inactive = kNeedsOutline, .demo = {"1Branches=1 1DownAngle=90 1Length=0.05 1Curve=0 2DownAngle=0 Leaves=-1 LeafScale=0.8 LeafScaleX=0.9 LeafBend=0", {}, true}},
    {.key = "LeafForm", .label = N_("Form"), .group = Group::Leaves, .section = N_("Blade"), .field = field<&CommonParams::leafForm>,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("A card is a rectangle with the leaf texture. An outline is cut to the shape and needs no transparency."),
     .words = kLeafForms,
     .inactive = kNeedsNoMesh, .demo = {"LeafShape=4 1Branches=1 1DownAngle=90 1Length=0.05 2DownAngle=0 Leaves=-1 LeafScale=0.8 LeafScaleX=0.9 LeafBend=0", {}, true}},
    {.key = "LeafPlanes", .label = N_("Planes"), .group = Group::Leaves, .section = N_("Blade"), .field = field<&CommonParams::leafPlanes>,
     .range = {1, 6}, .useful = {1, 3}, .step = 1, .defaults = {1}, .invalidates = kLeafMesh,
     .help = N_("How many cards, turned about their length, make one leaf: 2 or 3 for tufts and twigs of needles."),
     .inactive = kNeedsCards, .demo = {"LeafForm=0 LeafScaleX=0.3", {1, 2, 3}}},
    {.key = "LeafScale", .label = N_("Length"), .synonyms = N_("size"), .group = Group::Leaves, .section = N_("Blade"), .unit = Unit::Metre,
     .field = field<&CommonParams::leafScale>, .range = {0.001, 50}, .useful = {0.02, 1}, .step = 0.01, .decimals = 3, .defaults = {0.2},
     .invalidates = kLeavesOnly, .help = N_("The length of a leaf."),
     .demo = {.values = {0.1, 0.2, 0.35}}},
    {.key = "LeafScaleX", .label = N_("Width"), .group = Group::Leaves, .section = N_("Blade"), .field = field<&CommonParams::leafScaleX>,
     .range = {0.001, 100}, .useful = {0.05, 2}, .step = 0.05, .decimals = 2, .defaults = {0.5}, .invalidates = kLeavesOnly,
     .help = N_("The width of a leaf as a part of its length."),
     .inactive = kNeedsNoFile, .demo = {.values = {0.2, 0.6, 1.2}}},
    {.key = "LeafStalk", .label = N_("Stalk"), .group = Group::Leaves, .section = N_("Blade"), .field = field<&CommonParams::leafStalk>,
     .range = {0, 5}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("The length of the stalk between stem and blade, as a part of the leaf's length."),
     .demo = {.values = {0, 0.4, 1}}},
    {.key = "LeafFold", .label = N_("Fold"), .group = Group::Leaves, .section = N_("Blade"), .unit = Unit::Degree,
     .field = field<&CommonParams::leafFold>, .range = {-80, 80}, .useful = {0, 45}, .step = 1, .decimals = 1, .defaults = {0},
     .invalidates = kLeafMesh, .help = N_("How far each half of a leaf is folded up along its midrib."),
     .inactive = kNeedsNoMesh, .demo = {"Leaves=-1 LeafScale=0.8 LeafForm=1 1Length=0.05 LeafScaleX=0.8 LeafBend=0", {0, 25, 60}}},
    {.key = "LeafRounding", .label = N_("Rounding"), .group = Group::Leaves, .section = N_("Shading"), .field = field<&CommonParams::leafRounding>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("Shades the leaves as if they were the surface of one round crown: softer light on dense crowns.")},
    {.key = "LeafSunShade", .label = N_("Sun and shade"), .group = Group::Leaves, .section = N_("Blade"), .field = field<&CommonParams::leafSunShade>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("How much leaves that grow in the shade of the crown differ from those in the sun: at 1 they are 1.6 times as long and wide, and darker in the window and its pictures."),
     .demo = {"Levels=3 1Branches=14 2Branches=5 Leaves=7 LeafScale=0.24 LeafScaleX=0.8", {0, 0.5, 1}}},
    {.key = "Leaf2Share", .label = N_("Share 2"), .group = Group::Leaves, .section = N_("Kinds"), .field = field<&CommonParams::leafShare2>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("The part of the leaves that is of this kind, with a texture or a mesh of its own."), .atRandom = false,
     .demo = {"Leaf2Mesh=mesh:rolled Levels=2 Leaves=12 LeafScale=0.4 LeafScaleX=0.8", {0, 0.5, 1}}},
    {.key = "Leaf3Share", .label = N_("Share 3"), .group = Group::Leaves, .section = N_("Kinds"), .field = field<&CommonParams::leafShare3>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("The part of the leaves that is of this kind, with a texture or a mesh of its own."), .atRandom = false,
     .demo = {"Leaf3Mesh=mesh:rolled Levels=2 Leaves=12 LeafScale=0.4 LeafScaleX=0.8", {0, 0.5, 1}}},
    {.key = "Leaf4Share", .label = N_("Share 4"), .group = Group::Leaves, .section = N_("Kinds"), .field = field<&CommonParams::leafShare4>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("The part of the leaves that is of this kind, with a texture or a mesh of its own."), .atRandom = false,
     .demo = {"Leaf4Mesh=mesh:rolled Levels=2 Leaves=12 LeafScale=0.4 LeafScaleX=0.8", {0, 0.5, 1}}},
    {.key = "Blossoms", .label = N_("Number"), .group = Group::Blossom, .section = N_("Blossoms"), .field = field<&CommonParams::blossoms>,
     .range = {0, 5000}, .useful = {0, 60}, .step = 1, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("The most blossoms that a stem of the last level bears. They stand where leaves could."),
     .demo = {"Leaves=0 BlossomScale=0.15 Season=4.5", {2, 8, 20}}},
    {.key = "BlossomScale", .label = N_("Size"), .group = Group::Blossom, .section = N_("Blossoms"), .unit = Unit::Metre,
     .field = field<&CommonParams::blossomScale>, .range = {0.001, 50}, .useful = {0.01, 0.5}, .step = 0.01, .decimals = 3, .defaults = {0.05},
     .invalidates = kLeavesOnly, .help = N_("The length and width of a blossom, or of the cluster that its picture shows."),
     .inactive = kNeedsBlossoms, .demo = {"Leaves=0 Blossoms=8 Season=4.5", {0.08, 0.15, 0.3}}},
    {.key = "BlossomUp", .label = N_("Upright"), .group = Group::Blossom, .section = N_("Blossoms"), .field = field<&CommonParams::blossomUp>,
     .range = {-1, 1}, .useful = {-1, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("1 sets blossoms upright like candles, -1 lets them hang like catkins, 0 lets them stand like leaves."),
     .inactive = kNeedsBlossoms, .demo = {"Leaves=0 Blossoms=6 Season=4.5 BlossomScale=0.3 BlossomTexture=\"leaf:candle\"", {-1, 0, 1}}},
    {.key = "BlossomPlanes", .label = N_("Planes"), .group = Group::Blossom, .section = N_("Blossoms"), .field = field<&CommonParams::blossomPlanes>,
     .range = {1, 6}, .useful = {1, 3}, .step = 1, .defaults = {1}, .invalidates = kLeafMesh,
     .help = N_("How many cards, turned about their length, make one blossom: 2 or 3 for candles and catkins."),
     .inactive = kNeedsBlossoms, .demo = {"Leaves=0 Blossoms=6 Season=4.5 BlossomScale=0.3", {1, 2, 3}}},
    {.key = "BlossomDome", .label = N_("Dome"), .group = Group::Blossom, .section = N_("Blossoms"), .field = field<&CommonParams::blossomDome>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0}, .invalidates = kLeafMesh,
     .help = N_("How far the middle of a cluster of blossoms stands out: 0 is a flat card, at 1 its edge lies half its width lower."),
     .inactive = kNeedsBlossoms, .demo = {"Leaves=0 Blossoms=6 Season=4.5 BlossomScale=0.3", {0, 0.5, 1}}},
    {.key = "BlossomMonth", .label = N_("Month"), .group = Group::Blossom, .section = N_("Blossoms"), .field = field<&CommonParams::blossomMonth>,
     .range = {0, 12}, .useful = {0, 12}, .step = 0.1, .decimals = 2, .defaults = {4.5}, .invalidates = kLeafMesh,
     .help = N_("When the tree is in full blossom; it begins and ends most of a month before and after."),
     .inactive = kNeedsBlossoms, .demo = {"Leaves=0 Blossoms=8 Season=4.5 BlossomScale=0.15", {4, 4.5, 6}}},
    {.key = "Fruits", .label = N_("Number"), .group = Group::Blossom, .section = N_("Fruits"), .field = field<&CommonParams::fruits>,
     .range = {0, 5000}, .useful = {0, 30}, .step = 1, .defaults = {0}, .invalidates = kLeavesOnly,
     .help = N_("The most fruits that a stem of the last level bears."),
     .demo = {"Leaves=0 FruitScale=0.1 Season=9", {1, 4, 12}}},
    {.key = "FruitScale", .label = N_("Length"), .group = Group::Blossom, .section = N_("Fruits"), .unit = Unit::Metre,
     .field = field<&CommonParams::fruitScale>, .range = {0.001, 50}, .useful = {0.01, 0.3}, .step = 0.01, .decimals = 3, .defaults = {0.07},
     .invalidates = kLeavesOnly, .help = N_("The length of a ripe fruit."),
     .inactive = kNeedsFruits, .demo = {"Leaves=0 Fruits=4 Season=9", {0.05, 0.1, 0.2}}},
    {.key = "FruitScaleX", .label = N_("Width"), .group = Group::Blossom, .section = N_("Fruits"), .field = field<&CommonParams::fruitScaleX>,
     .range = {0.01, 100}, .useful = {0.2, 2}, .step = 0.05, .decimals = 2, .defaults = {1}, .invalidates = kLeavesOnly,
     .help = N_("The width of a fruit as a part of its length: small for cones and pods."),
     .inactive = kNeedsFruits, .demo = {"Leaves=0 Fruits=4 Season=9 FruitScale=0.2", {0.3, 0.7, 1.2}}},
    {.key = "FruitStalk", .label = N_("Stalk"), .group = Group::Blossom, .section = N_("Fruits"), .field = field<&CommonParams::fruitStalk>,
     .range = {0, 20}, .useful = {0, 3}, .step = 0.05, .decimals = 2, .defaults = {0.3}, .invalidates = kLeafMesh,
     .help = N_("The length of the stalk that a fruit hangs on, as a part of its own length."),
     .inactive = kNeedsFruits, .demo = {"Leaves=0 Fruits=4 Season=9 FruitScale=0.12", {0, 0.6, 1.5}}},
    {.key = "FruitMonth", .label = N_("Month"), .group = Group::Blossom, .section = N_("Fruits"), .field = field<&CommonParams::fruitMonth>,
     .range = {0, 12}, .useful = {0, 12}, .step = 0.1, .decimals = 2, .defaults = {9}, .invalidates = kLeafMesh,
     .help = N_("When the fruits are ripe. They grow in the two months before and fall in the month after."),
     .inactive = kNeedsFruits, .demo = {"Leaves=0 Fruits=4 Season=9 FruitScale=0.12", {9, 10, 10.8}}},
    {.key = "TextureWrapX", .label = N_("Bark repeats around"), .group = Group::Textures, .section = N_("Bark"),
     .field = field<&CommonParams::textureWrapX>, .range = {0.001, 1000}, .useful = {0.5, 10}, .step = 0.5, .decimals = 2, .defaults = {1},
     .invalidates = kMeshOnly, .help = N_("How often the bark picture goes around the trunk; branches follow. Whole numbers leave no seam.")},
    {.key = "TextureWrapY", .label = N_("Bark repeats along"), .group = Group::Textures, .section = N_("Bark"),
     .field = field<&CommonParams::textureWrapY>, .range = {0.001, 1000}, .useful = {0.5, 20}, .step = 0.5, .decimals = 2, .defaults = {1},
     .invalidates = kMeshOnly, .help = N_("How often the bark picture would repeat from the trunk's base to its tip if it stayed as thick. Thinner wood shows it smaller, undistorted.")},
    {.key = "LeafColourV", .label = N_("Colour variation"), .synonyms = N_("hue tint random"), .group = Group::Textures, .section = N_("Leaves"), .field = field<&CommonParams::leafColourV>,
     .range = {0, 1}, .useful = {0, 1}, .step = 0.05, .decimals = 2, .defaults = {0.5}, .invalidates = kPictures,
     .help = N_("How much leaves differ in hue and lightness, in the window and in its pictures. 0: all are alike.")},
};
// clang-format on

static_assert(rowsAreSane(kNumbers) && rowsAreSane(kTexts), "a row has no text, a bad range, a default out of range, or a twin");
static_assert(bytesDescribed(kNumbers, false) == sizeof(CommonParams), "a field of CommonParams has no row");
static_assert(bytesDescribed(kTexts, false) == sizeof(TextParams), "a field of TextParams has no row");
} // namespace

std::span<const ParamInfo> commonTexts() { return kTexts; }
std::span<const ParamInfo> commonNumbers() { return kNumbers; }

} // namespace stromar
