#pragma once
#include "stromar/app/Methods.h"

namespace stromar {

// What the window shows of Weber and Penn's values.

std::span<const Guide> weberPennGuides();
DemoPlant weberPennDemonstration();
int weberPennGenerationOf(const ParamRef& ref, const CParams& params);

} // namespace stromar
