#pragma once
#include "join/CrossingCurves.h"
#include <cstddef>
#include <optional>

namespace stromar {

/// Cuts both surfaces along the closed curves where they cross and leaves out what lies inside of the other, as far as
/// that hangs together with the base; a branch that lies in the wood as a whole is left out, which gives 0. Gives by how many degrees the
/// curves turn, each at least by 360: the more, the more ragged they are. None where that cannot be: the patch must be
/// undone then. The patch must be marked. Time n log n in the triangles, squared in those that cross; `work`: how many
/// crossing triangles may be cut, less those that were and a little for those that were looked at.
std::optional<double> uniteSurfaces(const CrossingSurfaces& surfaces, std::size_t& work, CWoodPatch& patch);

} // namespace stromar
