#pragma once
#include "stromar/tree/Tree.h"
#include "stromar/tree/lsystem/Turtle.h"

namespace stromar {

/// What the turtle drew as stems: what it draws on and on outside brackets is one; where only brackets follow, the child
/// that turns least goes on, the first of those that turn alike. The others are stems of the next generation, at the end
/// of a segment. What follows an f stands by itself.
struct CTurtleGeneration : CGeneration {
    /// An organ that the word wrote.
    struct Written {
        glm::vec3 position, axis, normal;
        float size;  ///< metres; negative: the word says none
        float share; ///< of its size, that has grown
        std::uint32_t stem;
    };
    std::array<std::vector<Written>, kOrgans.size()> organs; ///< by Organ, in the order of their stems
    std::vector<float> shares;          ///< by stem: how much of its base's segment has grown
    std::vector<std::uint16_t> writers; ///< by segment: the production that wrote it; kNoProduction: the axiom
};

/// Segments without a length are left out; organs without wood below them sit on the first stem. Linear in the segments.
/// Throws CCancelled.
std::vector<std::shared_ptr<const CTurtleGeneration>> stemsOf(const CWord& word, const TurtlePath& path,
                                                              const CProgress& progress);
std::vector<std::shared_ptr<const CTurtleGeneration>> stemsOf(const GrowingWord& word, const TurtlePath& path,
                                                              const CProgress& progress);

} // namespace stromar
