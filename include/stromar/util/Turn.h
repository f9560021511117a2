#pragma once
#include <numbers>

namespace stromar {

constexpr double kTurn = 2 * std::numbers::pi; ///< a whole one, in radians

} // namespace stromar
