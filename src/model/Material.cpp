#include "stromar/model/Material.h"
#include "stromar/params/ParamTable.h"
#include <algorithm>
#include <iterator>

namespace stromar {

namespace {
using T = TextParams;
template <auto Texture>
bool isChosen(const CParams& params) {
    return !(params.text.*Texture).empty();
}
constexpr glm::vec3 kBarkColour{0.42f, 0.34f, 0.26f};
template <auto Texture>
constexpr SurfaceInfo barkOfLevel(const char* name) {
    return {name, kBarkColour, false, Texture, "", &isChosen<Texture>};
}
constexpr glm::vec3 kLeafColour{0.30f, 0.45f, 0.18f};
template <auto Texture, std::size_t Other>
constexpr SurfaceInfo leafOfKind(const char* name) {
    return {name, kLeafColour, true, Texture, "",
            [](const CParams& params) { return isChosen<Texture>(params) && params.common.*kLeafShares[Other] > 0; }};
}

constexpr SurfaceInfo kSurfaceTable[] = {
    {"bark", kBarkColour, false, &T::barkTexture, "bark.png", nullptr},
    {"leaf", kLeafColour, true, &T::leafTexture, "leaf.png", nullptr},
    {"blossom", {0.95f, 0.88f, 0.90f}, true, &T::blossomTexture, "leaf:blossom", &hasBlossoms},
    {"fruit",
     {0.65f, 0.16f, 0.10f},
     false,
     &T::fruitTexture,
     "bark:smooth spots=0 light=#c8402c dark=#7c1c18",
     &hasFruits},
    {"twig", kLeafColour, true, nullptr, "", nullptr},
    barkOfLevel<&T::bark1Texture>("bark_1"),
    barkOfLevel<&T::bark2Texture>("bark_2"),
    barkOfLevel<&T::bark3Texture>("bark_3"),
    leafOfKind<&T::leaf2Texture, 0>("leaf_2"),
    leafOfKind<&T::leaf3Texture, 1>("leaf_3"),
    leafOfKind<&T::leaf4Texture, 2>("leaf_4"),
    {"impostor", kLeafColour, true, nullptr, "", nullptr},
};
static_assert(std::size(kSurfaceTable) == kSurfaces.size());
} // namespace

const SurfaceInfo& surfaceOf(Surface surface) { return kSurfaceTable[static_cast<std::size_t>(surface)]; }

bool hasSurface(const CParams& params, Surface surface) {
    const SurfaceInfo& info = surfaceOf(surface);
    return info.texture && (!info.borne || info.borne(params));
}

Surface shownSurface(const CParams& params, Surface surface) {
    while (standIn(surface) != surface && !hasSurface(params, surface)) surface = standIn(surface);
    return surface;
}

} // namespace stromar
