#pragma once
#include "stromar/params/ParamTable.h"
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace stromar {

/// Moves each number by chance, at most by `amount` (0..1) of half its useful range, and never out of that range unless
/// it lies outside already. Leaves alone what does nothing in this tree, choices, and the seed. The same `seed` moves
/// the same way.
std::vector<std::pair<ParamRef, double>> randomised(const CParams& params, std::span<const ParamRef> refs,
                                                    double amount, std::uint64_t seed);

} // namespace stromar
