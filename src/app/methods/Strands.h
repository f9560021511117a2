#pragma once
#include "stromar/app/Methods.h"

namespace stromar {

// What the window and the command line tell of the strand model.

std::span<const SegmentQuantity> strandQuantities();
CurvePlaces strandPlaces(const ParamInfo& curve, const CParams& params, const CTree& tree);
CurveAxis strandAxis(const ParamInfo& curve, const CParams& params);

} // namespace stromar
