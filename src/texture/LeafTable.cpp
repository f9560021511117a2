#include "RecipeBook.h"
#include "stromar/texture/Leaf.h"
#include "stromar/util/Translatable.h"

namespace stromar {

namespace {
using std::string_view;
using L = LeafParams;
using Plan = LeafPlan;

constexpr string_view kLeafKinds[] = {
    N_("oval"),   N_("beech"),  N_("oak"),   N_("birch"), N_("aspen"),  N_("willow"),         N_("lime"),
    N_("cherry"), N_("apple"),  N_("olive"), N_("bamboo"), N_("maple"), N_("japanese-maple"), N_("ash"),
    N_("acacia"), N_("frond"),  N_("chestnut"), N_("fan"), N_("pine"),  N_("spruce"),         N_("larch"),
    N_("cedar"),  N_("cypress"), N_("flower"), N_("blossom"), N_("candle")};

// clang-format off
/// Values that suit each kind.
constexpr L kLeaves[] = {
    {.kind = 0},
    {.kind = 1, .teeth = 9, .veins = 8, .width = 0.62, .stalk = 0.09, .peak = 0.45, .base = 0.7, .tip = 0.95, .tooth = 0.02,
     .gloss = 0.5, .green = {72, 112, 44}, .autumn = {190, 112, 40}},
    {.kind = 2, .veins = 5, .lobes = 5, .width = 0.6, .stalk = 0.05, .peak = 0.62, .base = 1.15, .tip = 0.5, .lobe = 0.42,
     .slant = 0.55, .gloss = 0.4, .green = {62, 92, 36}, .autumn = {156, 98, 42}},
    {.kind = 3, .teeth = 16, .veins = 7, .width = 0.72, .stalk = 0.22, .peak = 0.3, .base = 0.75, .tip = 1.35, .tooth = 0.1,
     .green = {84, 124, 46}, .autumn = {222, 182, 48}},
    {.kind = 4, .teeth = 12, .veins = 5, .width = 0.86, .stalk = 0.3, .peak = 0.42, .base = 0.5, .tip = 0.8, .heart = 0.1,
     .tooth = 0.04, .gloss = 0.5, .green = {92, 128, 56}, .autumn = {230, 186, 46}},
    {.kind = 5, .teeth = 26, .veins = 14, .width = 0.16, .stalk = 0.05, .peak = 0.36, .base = 0.7, .tip = 1.1, .tooth = 0.05,
     .gloss = 0.45, .green = {96, 126, 62}, .autumn = {214, 190, 70}},
    {.kind = 6, .teeth = 20, .veins = 7, .width = 0.84, .stalk = 0.26, .peak = 0.3, .base = 0.42, .tip = 1.1, .heart = 0.6,
     .tooth = 0.05, .green = {84, 124, 50}, .autumn = {220, 184, 58}},
    {.kind = 7, .teeth = 22, .veins = 8, .width = 0.52, .stalk = 0.16, .peak = 0.5, .base = 0.65, .tip = 1.05, .tooth = 0.05,
     .gloss = 0.5, .green = {72, 110, 42}, .autumn = {204, 88, 36}},
    {.kind = 8, .teeth = 18, .veins = 7, .width = 0.62, .stalk = 0.18, .peak = 0.48, .base = 0.55, .tip = 0.9, .tooth = 0.04,
     .gloss = 0.35, .green = {80, 114, 50}, .autumn = {196, 160, 60}},
    {.kind = 9, .veins = 6, .width = 0.22, .stalk = 0.05, .peak = 0.5, .base = 0.8, .tip = 0.8, .spots = 0.05, .gloss = 0.6,
     .green = {104, 120, 84}, .vein = {158, 166, 132}, .autumn = {104, 120, 84}},
    {.kind = 10, .veins = 24, .width = 0.14, .stalk = 0.03, .peak = 0.22, .base = 0.5, .tip = 1.2, .gloss = 0.5,
     .green = {98, 132, 50}, .autumn = {176, 168, 84}},
    {.kind = 11, .plan = Plan::Lobed, .teeth = 3, .veins = 5, .lobes = 5, .width = 1.1, .stalk = 0.2, .peak = 0.4, .base = 0.9,
     .tip = 1.15, .tooth = 0.3, .lobe = 0.5, .slant = 0.6, .spread = 104, .green = {78, 112, 42}, .autumn = {226, 160, 36}},
    {.kind = 12, .plan = Plan::Lobed, .teeth = 14, .veins = 8, .lobes = 7, .width = 1.05, .stalk = 0.2, .peak = 0.36, .base = 0.9,
     .tip = 1.25, .tooth = 0.08, .lobe = 0.78, .slant = 0.6, .spread = 118, .spots = 0.05, .green = {98, 120, 48},
     .autumn = {188, 34, 22}},
    {.kind = 13, .plan = Plan::Pinnate, .teeth = 12, .veins = 8, .leaflets = 5, .width = 0.72, .stalk = 0.14, .base = 0.75, .tip = 1.1,
     .tooth = 0.04, .lobe = 0.36, .spread = 62, .green = {80, 116, 46}, .autumn = {212, 186, 66}},
    {.kind = 14, .plan = Plan::Pinnate, .veins = 0, .leaflets = 16, .width = 0.4, .stalk = 0.04, .base = 0.4, .tip = 0.5, .lobe = 0.34,
     .spread = 74, .spots = 0, .green = {96, 118, 58}, .autumn = {150, 138, 66}},
    {.kind = 15, .plan = Plan::Pinnate, .veins = 0, .leaflets = 30, .width = 0.62, .stalk = 0.04, .peak = 0.3, .base = 0.5, .tip = 0.9,
     .lobe = 0.1, .spread = 52, .gloss = 0.6, .green = {84, 118, 46}, .autumn = {150, 140, 62}},
    {.kind = 16, .plan = Plan::Palmate, .teeth = 22, .veins = 12, .leaflets = 7, .width = 1.1, .stalk = 0.3, .peak = 0.68, .base = 1.1,
     .tip = 0.6, .tooth = 0.04, .lobe = 0.4, .spread = 112, .green = {70, 104, 40}, .autumn = {196, 132, 42}},
    {.kind = 17, .plan = Plan::Fan, .veins = 0, .leaflets = 34, .width = 1.4, .stalk = 0.3, .lobe = 1, .spread = 128, .gloss = 0.55,
     .green = {92, 118, 62}, .autumn = {158, 146, 84}},
    {.kind = 18, .plan = Plan::Needles, .veins = 0, .leaflets = 26, .width = 0.8, .stalk = 0, .lobe = 0.42, .spread = 44, .spots = 0,
     .gloss = 0.5, .green = {66, 96, 60}, .vein = {120, 96, 60}, .autumn = {66, 96, 60}},
    {.kind = 19, .plan = Plan::NeedleTwig, .veins = 0, .leaflets = 130, .width = 0.34, .stalk = 0, .lobe = 0.3, .spread = 52, .spots = 0,
     .green = {52, 82, 44}, .vein = {128, 96, 60}, .autumn = {52, 82, 44}},
    {.kind = 20, .plan = Plan::Needles, .veins = 0, .leaflets = 44, .width = 1.3, .stalk = 0, .lobe = 0.5, .spread = 88, .spots = 0,
     .green = {106, 144, 72}, .vein = {112, 90, 62}, .autumn = {222, 172, 60}},
    {.kind = 21, .plan = Plan::Needles, .veins = 0, .leaflets = 48, .width = 1.4, .stalk = 0, .lobe = 0.5, .spread = 92, .spots = 0,
     .green = {70, 96, 80}, .vein = {112, 90, 62}, .autumn = {70, 96, 80}},
    {.kind = 22, .plan = Plan::Scales, .veins = 0, .leaflets = 18, .width = 0.5, .stalk = 0, .spread = 40, .spots = 0, .gloss = 0.3,
     .green = {52, 78, 44}, .autumn = {52, 78, 44}},
    {.kind = 23, .plan = Plan::Flower, .leaflets = 5, .width = 1, .stalk = 0, .spots = 0, .gloss = 0.2, .green = {250, 240, 240},
     .vein = {236, 196, 202}, .autumn = {250, 240, 240}},
    {.kind = 24, .plan = Plan::Flowers, .lobes = 6, .leaflets = 5, .width = 1, .stalk = 0, .spots = 0, .gloss = 0.2,
     .green = {252, 244, 244}, .vein = {240, 204, 210}, .autumn = {252, 244, 244}},
    {.kind = 25, .plan = Plan::Candle, .lobes = 34, .leaflets = 4, .width = 0.5, .stalk = 0, .spots = 0, .gloss = 0.2,
     .green = {252, 246, 238}, .vein = {232, 168, 150}, .autumn = {252, 246, 238}},
};

constexpr RecipeParam<L> kLeafTable[] = {
    {"seed", N_("Seed"), N_("Another leaf of the same kind."), &L::seed, 0, 2147483647},
    {"width", N_("Width"), N_("The width of the picture as a part of its length. Give Width of the tree's leaves the same value."), &L::width, 0.02, 4},
    {"stalk", N_("Stalk"), N_("The part of the length that is stalk."), &L::stalk, 0, 0.6},
    {"peak", N_("Widest place"), N_("Where a blade is widest, from 0 at its foot to 1 at its tip."), &L::peak, 0.05, 0.95},
    {"base", N_("Base"), N_("Below 1 the blade begins round, above 1 like a wedge."), &L::base, 0.1, 4},
    {"tip", N_("Tip"), N_("Below 1 the blade ends round, above 1 in a drawn-out point."), &L::tip, 0.1, 4},
    {"heart", N_("Heart"), N_("How far the blade reaches back beside its stalk."), &L::heart, 0, 1},
    {"teeth", N_("Teeth"), N_("How many teeth each half of a blade has."), &L::teeth, 0, 80},
    {"tooth", N_("Depth of teeth"), N_("How deep they are cut, as a part of the half's width."), &L::tooth, 0, 0.6},
    {"lobes", N_("Lobes"), N_("How many lobes a half, or a hand-shaped leaf, has. Of blossoms: how many flowers. Of spruce twigs: how many pairs of side twigs."), &L::lobes, 0, 60},
    {"lobe", N_("Depth of lobes"), N_("How deep they are cut. Of leaflets and needles: how wide they are."), &L::lobe, 0, 1},
    {"slant", N_("Slant"), N_("How far teeth and lobes lean towards the tip."), &L::slant, 0, 1.5},
    {"leaflets", N_("Leaflets"), N_("Pairs of leaflets, leaflets of a hand, needles or petals."), &L::leaflets, 0, 300},
    {"spread", N_("Spread"), N_("How far lobes, leaflets or needles stand off, in degrees."), &L::spread, 0, 150},
    {"veins", N_("Veins"), N_("How many veins leave the midrib on each side."), &L::veins, 0, 40},
    {"spots", N_("Blemishes"), N_("How many spots and worn places there are."), &L::spots, 0, 1},
    {"gloss", N_("Gloss"), N_("How much the upper side shines."), &L::gloss, 0, 1},
    {"season", N_("Month"), N_("0.5 is the middle of January, 7 the height of summer, 10.5 late autumn."), &L::season, 0, 12},
    {"green", N_("Colour"), N_("The colour in summer."), &L::green, 0, 255},
    {"vein", N_("Veins' colour"), N_("The colour of veins and stalks."), &L::vein, 0, 255},
    {"autumn", N_("Autumn colour"), N_("The colour when the green has gone."), &L::autumn, 0, 255},
};
// clang-format on

constexpr RecipeBook<L> kLeafBook{"leaf", kLeafKinds, kLeaves, kLeafTable};
static_assert(std::size(kLeafKinds) == std::size(kLeaves));
} // namespace

const RecipeBook<LeafParams>& leafBook() { return kLeafBook; }

template struct RecipeBook<LeafParams>;

} // namespace stromar
