#pragma once
#include "stromar/tree/Organs.h"
#include "stromar/util/Progress.h"
#include "stromar/util/Random.h"

namespace stromar {

class CParams;
class CTree;

/// The organs of a kind on a tree at an age: those of its last generation whose places the wood has passed, growing up;
/// leaves on the young wood of the others until the last is there, so that a seedling is green. `tree` has CYoungGenerations.
std::shared_ptr<const COrgans> growYoungOrgans(const CParams& params, const CTree& tree, Organ organ, const CRandom& random,
                                               const OrganDemand& demand, const CProgress& progress);

} // namespace stromar
