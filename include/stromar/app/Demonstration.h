#pragma once
#include "stromar/params/ParamTable.h"
#include <vector>

namespace stromar {

/// A small tree that shows what one value of a parameter does.
struct Demonstration {
    CParams params;
    double value;
};

/// Trees that differ in this value alone: one for each word of a choice, else three. Level 2 and deeper are shown at
/// level 1. Empty for what
/// changes no shape.
std::vector<Demonstration> demonstrationsOf(const ParamRef& ref);

} // namespace stromar
