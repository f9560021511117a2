#pragma once
#include "TableProof.h"

namespace stromar {

/// The rows of what every tree has: texts, which stand in front of a method's own rows in their group, and numbers,
/// which stand behind them.
std::span<const ParamInfo> commonTexts();
std::span<const ParamInfo> commonNumbers();

} // namespace stromar
