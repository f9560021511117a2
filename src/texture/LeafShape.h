#pragma once
#include "stromar/texture/Leaf.h"
#include <glm/vec2.hpp>
#include <vector>

namespace stromar {

/// A piece of a leaf's picture: a blade, a lobe, a leaflet, a needle, a petal or a stalk. In lengths of the card, the
/// origin in the middle of its lower edge, y up.
struct Blade {
    enum class Tissue { Lamina, Stalk, Petal, Anther };

    glm::dvec2 foot{0};
    double turn = 0; ///< of its axis from straight up, radians, clockwise
    double length = 1, half = 0.3;
    double peak = 0.45, base = 0.6, tip = 0.9; ///< where it is widest; how blunt it is: below 1 round, above 1 hollow
    double bend = 0;                           ///< to the right, at its tip, in parts of its length
    int teeth = 0, veins = 0, lobes = 0;
    double tooth = 0, lobe = 0, slant = 0.35;
    int layer = 0;   ///< higher ones cover lower ones; those of the same layer grow together
    double tone = 0; ///< lighter or darker than the others, −1..1
    Tissue tissue = Tissue::Lamina;
};

/// All pieces of a leaf, the lowest first.
std::vector<Blade> bladesOf(const LeafParams& leaf);

} // namespace stromar
