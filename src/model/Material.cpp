#include "stromar/model/Material.h"
#include "stromar/params/ParamTable.h"
#include <iterator>

namespace stromar {

namespace {
using T = TextParams;
constexpr SurfaceInfo kSurfaceTable[] = {
    {"bark", {0.42f, 0.34f, 0.26f}, false, &T::barkTexture, "bark.png", nullptr},
    {"leaf", {0.30f, 0.45f, 0.18f}, true, &T::leafTexture, "leaf.png", nullptr},
    {"blossom", {0.95f, 0.88f, 0.90f}, true, &T::blossomTexture, "leaf:blossom", &hasBlossoms},
    {"fruit",
     {0.65f, 0.16f, 0.10f},
     false,
     &T::fruitTexture,
     "bark:smooth spots=0 light=#c8402c dark=#7c1c18",
     &hasFruits},
    {"twig", {0.30f, 0.45f, 0.18f}, true, nullptr, "", nullptr},
};
static_assert(std::size(kSurfaceTable) == kSurfaces.size());
} // namespace

const SurfaceInfo& surfaceOf(Surface surface) { return kSurfaceTable[static_cast<std::size_t>(surface)]; }

bool hasSurface(const CParams& params, Surface surface) {
    const SurfaceInfo& info = surfaceOf(surface);
    return info.texture && (!info.borne || info.borne(params));
}

} // namespace stromar
