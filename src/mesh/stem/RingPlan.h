#pragma once
#include "stromar/mesh/MeshBuilder.h"

namespace stromar {

/// The rings of those stems of a generation that are to be drawn.
MeshPlan planStems(const CTree& tree, int generation, const MeshParams& params, const Detail& detail, const StemMesh* parents,
                   const std::vector<bool>& drawn, Thickening thickening, const CProgress& progress);

} // namespace stromar
