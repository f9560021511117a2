#pragma once
#include "stromar/tree/Frame.h"
#include "stromar/tree/Organs.h"
#include "stromar/tree/lsystem/Word.h"
#include <numbers>

namespace stromar {

/// How a word is drawn. Z is up.
struct TurtleParams {
    double lengthUnit = 1, widthUnit = 1; ///< metres
    double turn = std::numbers::pi / 8;   ///< radians of + − & ^ \ / without a number
    glm::dvec3 tropism{0};                ///< where segments bend to
    double tropismBend = 0;               ///< radians, of a segment square to it of length 1
};

/// An F of the word. Columns of the frame: U, −L, H; Z is the heading.
struct TurtleSegment {
    glm::dvec3 position; ///< of its base, metres
    Frame frame;
    double length, width; ///< metres; the width is a diameter
    std::int32_t below;   ///< the segment at whose end it starts; −1: at the root, or after an f
    std::uint32_t module; ///< of the word
    std::uint32_t depth;  ///< of brackets
};

/// A leaf, blossom or fruit of the word.
struct TurtleOrgan {
    Organ organ;
    glm::dvec3 position;
    Frame frame;
    double size;        ///< metres; negative: the word says none
    double share;       ///< of its size, that has grown
    std::int32_t below; ///< the segment at whose end it sits; −1: none
};

struct TurtlePath {
    std::vector<TurtleSegment> segments; ///< in the order of the word
    std::vector<TurtleOrgan> organs;
};

/// What the turtle draws of a word that grows: lengths, widths, sizes and the tropism of an F are there by its share.
TurtlePath interpret(const GrowingWord& word, const TurtleParams& params, const CProgress& progress);
/// What the turtle draws (The Algorithmic Beauty of Plants §1.5, §2.2). One thread; linear in the modules.
TurtlePath interpret(const CWord& word, const TurtleParams& params, const CProgress& progress);

} // namespace stromar
