#pragma once
#include "stromar/model/ExportModel.h"
#include "stromar/model/TreeModel.h"
#include <span>

namespace stromar {

/// Where a trunk parts into limbs of other levels, in trees of L-systems and strands, gives wood the bark of the level whose stems are as thick
/// as it is at its base (CBarkLevels): the viewport mixes barks along it, but a file can't. What shows another bark than the rest of its mesh
/// becomes one of its own, behind it, "branches_1_bark", with what its vertices carry. By level of detail of the model. Time n log n in the
/// vertices of the wood.
void partByBark(ExportModel& model, std::span<const std::shared_ptr<const TreeModel>> lods);

} // namespace stromar
