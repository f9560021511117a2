#pragma once
#include "stromar/mesh/Sway.h"
#include "stromar/tree/Fall.h"

namespace stromar {

/// The wood of trunks as a felling leaves it: two closed parts, each vertex on its side of the cut.
struct CutMesh {
    std::shared_ptr<const CMesh> mesh;
    SwayPlaces places;
};

/// Cuts the mesh of generation 0 level at the height of a felling, and closes both sides. `places` are of its vertices.
CutMesh cutTrunks(const CMesh& mesh, const SwayPlaces& places, const CWindTable& table, const CFall& fall);

/// Places of what hangs on trunks, each on its side of the cut: by height where it hangs between.
SwayPlaces onOneSide(const SwayPlaces& places, const CWindTable& table, const CFall& fall);

} // namespace stromar
