#pragma once
#include "stromar/params/Params.h"

namespace stromar {

/// What the month makes of a tree's organs. All 1 in high summer (leaves) or in their own month (blossoms, fruits).
struct Phenology {
    double leaves;    ///< part of the leaves that are there
    double leafSize;  ///< of a leaf's full length
    double blossoms;  ///< part of the blossoms that are there
    double fruits;    ///< part of the fruits that hang
    double fruitSize; ///< of a fruit's full length
};
Phenology phenologyOf(const CommonParams& global);

} // namespace stromar
