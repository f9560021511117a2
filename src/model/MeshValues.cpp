#include "stromar/model/MeshValues.h"
#include "stromar/params/Season.h"

namespace stromar {

MeshParams meshParamsOf(const CParams& params) {
    const CommonParams& g = params.common;
    const Phenology now = phenologyOf(g);
    MeshParams mesh;
    mesh.minRadius = g.minRadius;
    mesh.barkAround = g.textureWrapX;
    mesh.barkAlong = g.textureWrapY;
    mesh.leaf = {g.leafShape,  g.leafForm != 0, g.leafPlanes,  g.leafFold.radians(),
                 g.leafStalk, g.leafScaleX,    g.leafRounding};
    for (std::size_t other = 0; other < mesh.otherLeaves.size(); ++other) mesh.otherLeaves[other].share = g.*kLeafShares[other];
    mesh.blossomPlanes = g.blossomPlanes;
    mesh.blossomDome = g.blossomDome;
    mesh.sunAndShade = g.leafSunShade;
    mesh.fruitStalk = g.fruitStalk;
    mesh.season = {{{now.leaves, now.leafSize}, {now.blossoms, 1}, {now.fruits, now.fruitSize}}};
    return mesh;
}

} // namespace stromar
