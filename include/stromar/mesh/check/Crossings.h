#pragma once
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include <cstddef>

namespace stromar {

/// How many pairs of stems run through each other that are not parent and child, as trees do not: their wood meets outside
/// of that which they grow from. Round stems along straight pieces; without lobes, roots and MinRadius. Time: a sort of the
/// segments, and what is near each other. Throws CCancelled.
std::size_t countCrossings(const CTree& tree, const CProgress& progress);

} // namespace stromar
