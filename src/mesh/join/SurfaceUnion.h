#pragma once
#include "join/CrossingCurves.h"

namespace stromar {

/// Cuts both surfaces along the closed curves where they cross and leaves out what lies inside of the other, as far as
/// that hangs together with the base; a branch that lies in the wood as a whole is left out. False where that cannot
/// be: the patch must be undone then. The patch must be marked. Time n log n in the triangles, squared in those that
/// cross; `work`: how many crossing triangles may be cut, less those that were and a little for those that were looked
/// at.
bool uniteSurfaces(const CrossingSurfaces& surfaces, std::size_t& work, CWoodPatch& patch);

} // namespace stromar
