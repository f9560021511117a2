#pragma once
#include "stromar/mesh/MeshParams.h"
#include "stromar/params/Params.h"

namespace stromar {

/// What the values of a tree mean to the mesher.
MeshParams meshParamsOf(const CParams& params);

} // namespace stromar
