#pragma once
#include "stromar/model/ExportModel.h"
#include "stromar/util/Progress.h"

namespace stromar {

/// Texture coordinates without overlap, over all meshes of a level of detail, as the channel TEXCOORD_1. Throws CCancelled.
void addSecondUvs(ExportModel& model, const CProgress& progress);

} // namespace stromar
