#pragma once
#include "stromar/model/ExportModel.h"

namespace stromar {

/// One mesh for each material, of every level of detail, named after it, with what the vertices carry: a program draws each at once.
/// Instances stay as they are.
void mergeByMaterial(ExportModel& model);

} // namespace stromar
