#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/params/TreeParams.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace stromar {

/// The form of all leaves of a tree: points of a blade of length and width 1, its foot at the origin, its axis along y.
/// Made once, written for every leaf.
struct LeafBlade {
    struct Point {
        glm::dvec3 place;  ///< x across (times the width), y along (times the length), z up (times the width)
        glm::dvec3 normal; ///< unit, in the same axes
        glm::vec2 texCoord;
    };
    std::vector<Point> points;
    std::vector<std::uint32_t> indices; ///< three per triangle, counter-clockwise seen from above
};

/// LeafShape as a card for a picture, or as its outline; with LeafFold, LeafPlanes and LeafStalk. Coarse models get
/// plain cards.
LeafBlade makeBlade(const GlobalParams& inRadians, const Detail& detail);
/// A square for a picture.
LeafBlade makeCard();
/// An ellipsoid on a stalk of so many of its lengths.
LeafBlade makeFruit(double stalk, const Detail& detail);

} // namespace stromar
