#pragma once
#include "stromar/params/ParamTable.h"
#include <cstdint>
#include <span>

namespace stromar {

/// Moves each number, and each point of a curve up or down, by chance, at most by `amount` (0..1) of half its useful
/// range, and never out of that range unless it lies outside already. Leaves alone what does nothing in this tree,
/// choices, texts, and what its row keeps from chance. The same `seed` moves the same key the same way, whatever else
/// moves and whatever other rows there are.
ParamValues randomised(const CParams& params, std::span<const ParamRef> refs, double amount, std::uint64_t seed);

} // namespace stromar
