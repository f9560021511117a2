#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/Twig.h"
#include "stromar/params/ParamTable.h"

namespace stromar {

/// How large a tree can become; whole numbers, but possibly beyond any integer.
struct Prediction {
    double stems, leaves, vertices;
};

/// Upper bounds of what a tree of these parameters may have, over all seeds. Takes microseconds: nothing is grown.
Prediction predictSize(const CParams& params, const Detail& detail);

BearerBound bearerBound(const CParams& params);
/// Whether cards may stand for the last stems: the level of detail has some, they gain something, and their picture can
/// be made.
bool mayShowCards(const CParams& params, const Detail& detail);

/// The value of `ref` nearest to its own at which the tree is predicted to have at most so many vertices, found between
/// `fits` and its own. Whole for integers. `fits` itself when not even that is small enough.
double nearestThatFits(const CParams& params, const ParamRef& ref, double fits, const Detail& detail,
                       double mostVertices);

} // namespace stromar
