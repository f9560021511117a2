#pragma once
#include "TableProof.h"

namespace stromar {

/// The rows of what every tree has. In a group, pictures stand in front of a method's own rows, numbers and other texts
/// behind them.
std::span<const ParamInfo> commonTexts();
std::span<const ParamInfo> commonNumbers();

} // namespace stromar
