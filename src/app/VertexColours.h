#pragma once
#include "stromar/app/ExportOptions.h"
#include "stromar/model/ExportModel.h"
#include "stromar/model/TreeModel.h"
#include <span>

namespace stromar {

/// Adds the light that vertices get from the sky as the options want it, and how leaves differ in colour (LeafColourV,
/// LeafSunShade). `lods` are its levels of detail, the finest first, whose meshes it has in the order of TreeModel::visitMeshes();
/// none of a solid. Channels of the wind go before.
void addColours(ExportModel& model, std::span<const std::shared_ptr<const TreeModel>> lods, const ExportOptions& options);

} // namespace stromar
