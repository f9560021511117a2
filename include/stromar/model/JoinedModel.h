#pragma once
#include "stromar/model/TreeModel.h"

namespace stromar {

/// The model with its wood as one closed surface (see joinStems()): equal positions of its meshes of stems belong together. Plans
/// its rings once more where it has not kept them. The model itself where branches have no collars. Throws CCancelled.
std::shared_ptr<const TreeModel> joined(const std::shared_ptr<const TreeModel>& model, const CProgress& progress);

/// A generation of a model with the plan of its rings, which is made once more where it was not kept, `below` being all before it.
StemMesh planned(const TreeModel& model, std::size_t generation, std::span<const StemMesh> below, const CProgress& progress);

} // namespace stromar
