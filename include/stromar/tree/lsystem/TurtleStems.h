#pragma once
#include "stromar/tree/Tree.h"
#include "stromar/tree/lsystem/Turtle.h"

namespace stromar {

/// What the turtle drew as stems: what it draws on and on outside brackets is one; where only brackets follow, the child
/// that turns least goes on, the first of those that turn alike. The others are stems of the next generation, at the end
/// of a segment. What follows an f stands by itself.
struct TurtleStems {
    struct Bearer {
        std::uint32_t generation, stem;
    };
    std::vector<std::shared_ptr<const CGeneration>> generations;
    std::vector<Bearer> ofSegment; ///< by segment of the turtle's path
};

/// Segments without a length are left out. Linear in the segments. Throws CCancelled.
TurtleStems stemsOf(const CWord& word, const TurtlePath& path, const CProgress& progress);

} // namespace stromar
