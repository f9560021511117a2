#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/params/Params.h"

namespace stromar {

/// How large a tree can become; whole numbers, but possibly beyond any integer.
struct Prediction {
    double stems, leaves, vertices;
};

/// Upper bounds of what a tree of these parameters may have, over all seeds. Takes microseconds: nothing is grown.
Prediction predictSize(const CParams& params, const Detail& detail);

} // namespace stromar
