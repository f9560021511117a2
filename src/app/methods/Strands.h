#pragma once
#include "stromar/app/Methods.h"

namespace stromar {

// What the window and the command line tell of the strand model.

std::span<const SegmentQuantity> strandQuantities();
double strandCurveAt(const ParamInfo& curve, const CParams& params, const CTree& tree, const SegmentPlace& place);

} // namespace stromar
