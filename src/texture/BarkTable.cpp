#include "RecipeBook.h"
#include "stromar/texture/Bark.h"
#include "stromar/util/Translatable.h"

namespace stromar {

namespace {
using std::string_view;
using B = BarkParams;
constexpr string_view kBarkKinds[] = {N_("furrowed"), N_("plated"), N_("smooth"), N_("birch"),
                                  N_("willow"),   N_("cherry"), N_("palm")};

/// Values that suit each kind.
constexpr BarkParams kBarks[] = {
    {.kind = 0,
     .ridges = 11,
     .stretch = 3.2,
     .crack = 0.45,
     .depth = 1,
     .grain = 0.6,
     .warp = 0.7,
     .light = {154, 140, 122},
     .dark = {50, 42, 36}},
    {.kind = 1,
     .ridges = 6,
     .stretch = 2.2,
     .crack = 0.28,
     .depth = 0.9,
     .grain = 0.7,
     .warp = 0.5,
     .light = {176, 118, 80},
     .dark = {66, 44, 34}},
    {.kind = 2,
     .ridges = 6,
     .spots = 60,
     .stretch = 0.4,
     .crack = 0.1,
     .depth = 0.3,
     .grain = 0.35,
     .warp = 0.5,
     .light = {172, 174, 158},
     .dark = {84, 86, 76}},
    {.kind = 3,
     .ridges = 5,
     .rings = 14,
     .spots = 90,
     .stretch = 0.3,
     .crack = 0.3,
     .depth = 0.4,
     .grain = 0.3,
     .warp = 0.4,
     .light = {232, 228, 218},
     .dark = {58, 48, 42}},
    {.kind = 4,
     .ridges = 8,
     .stretch = 4,
     .crack = 0.42,
     .depth = 0.9,
     .grain = 0.6,
     .warp = 1,
     .light = {142, 132, 112},
     .dark = {58, 50, 40}},
    {.kind = 5,
     .ridges = 4,
     .rings = 12,
     .spots = 70,
     .stretch = 0.3,
     .crack = 0.25,
     .depth = 0.45,
     .grain = 0.3,
     .warp = 0.3,
     .light = {138, 84, 66},
     .dark = {62, 36, 32}},
    {.kind = 6,
     .ridges = 20,
     .rings = 8,
     .stretch = 3,
     .crack = 0.4,
     .depth = 0.8,
     .grain = 0.8,
     .warp = 0.4,
     .light = {158, 142, 118},
     .dark = {76, 64, 50}},
};

constexpr RecipeParam<B> kBarkTable[] = {
    {"seed", N_("Seed"), N_("Another bark of the same kind."), &B::seed, 0, 2147483647},
    {"ridges", N_("Ridges"), N_("How many ridges or plates stand side by side in the picture."), &B::ridges, 1, 64},
    {"stretch", N_("Length of ridges"), N_("How many times longer than wide they are."), &B::stretch, 0.1, 20},
    {"crack", N_("Cracks"), N_("How wide the furrows between them are, as a part of a ridge."), &B::crack, 0, 1},
    {"depth", N_("Depth"), N_("How deep the relief is."), &B::depth, 0, 3},
    {"grain", N_("Grain"), N_("How rough the surface is in detail."), &B::grain, 0, 1},
    {"warp", N_("Wandering"), N_("How crooked ridges and rings run."), &B::warp, 0, 3},
    {"rings", N_("Rings"), N_("How many bands run around the stem in the picture."), &B::rings, 0, 64},
    {"spots", N_("Spots"), N_("How many pores or eyes there are."), &B::spots, 0, 400},
    {"light", N_("Light colour"), N_("The colour of what stands out."), &B::light, 0, 255},
    {"dark", N_("Dark colour"), N_("The colour of what lies deep."), &B::dark, 0, 255},
};
constexpr RecipeBook<B> kBarkBook{"bark", kBarkKinds, kBarks, kBarkTable};
static_assert(std::size(kBarkKinds) == std::size(kBarks));
} // namespace

const RecipeBook<BarkParams>& barkBook() { return kBarkBook; }

template struct RecipeBook<BarkParams>;

} // namespace stromar
