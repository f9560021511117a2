#pragma once
#include "stem/Nodes.h"
#include "stromar/mesh/MeshBuilder.h"

namespace stromar {

/// The rings of those stems of a generation that are to be drawn. Branches part from them at forks where those above are given.
MeshPlan planStems(const CTree& tree, int generation, const MeshParams& params, const Detail& detail, StemsBelow below,
                   const std::vector<bool>& drawn, Thickening thickening, const BranchesAbove* above, const CProgress& progress);

} // namespace stromar
