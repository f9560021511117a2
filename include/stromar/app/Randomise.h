#pragma once
#include "stromar/app/Prediction.h"
#include "stromar/params/ParamTable.h"
#include "stromar/util/Progress.h"
#include <cstdint>
#include <span>

namespace stromar {

/// Moves each number, and each point of a curve up or down, by chance, at most by `amount` (0..1) of half its useful
/// range, and never out of that range unless it lies outside already. Leaves alone what does nothing in this tree,
/// choices, texts, and what its row keeps from chance. The same `seed` moves the same key the same way, whatever else
/// moves and whatever other rows there are.
ParamValues randomised(const CParams& params, std::span<const ParamRef> refs, double amount, std::uint64_t seed);

/// The same, and still a tree: with a fifth of its stems and leaves at least, five times as many at most, a third to three
/// times as high. What is none is thrown again, somewhat less far, a few times; where none is a tree, nothing moves. Cost: the
/// simple model of every throw. Throws CTooLarge where the tree itself is too large, CCancelled.
ParamValues randomisedTree(const CParams& params, std::span<const ParamRef> refs, double amount, std::uint64_t seed,
                           const SizeLimits& limits, const CProgress& progress = CProgress(2));

} // namespace stromar
