#pragma once
#include "Arrangement.h"
#include "stromar/app/ExportOptions.h"
#include "stromar/app/Motion.h"
#include "stromar/model/ExportModel.h"
#include "stromar/model/ModelSway.h"
#include <span>

namespace stromar {

/// Adds what the options ask for, so that a model sways elsewhere. `sways` are of its levels of detail, the finest
/// first, whose meshes it has in the order of TreeModel::visitMeshes().
void addWind(ExportModel& model, std::span<const std::shared_ptr<const ModelSway>> sways, const ExportOptions& options,
             const Motion& motion, const Arrangement& arrangement);
/// The same in pictures beside it, for engines that read them; `beside` is the model's path without its ending, with
/// which their names begin. All levels of detail share them.
void addWindPictures(const ModelSway& sway, const ExportOptions& options, const Arrangement& arrangement,
                     const std::filesystem::path& beside, CFileSet& files);

} // namespace stromar
