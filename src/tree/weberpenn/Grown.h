#pragma once
#include "stromar/params/methods/weberpenn/Calculations.h"
#include "stromar/tree/Tree.h"

namespace stromar {

/// The law of thickness of a taper 0..3 (Weber & Penn §4.4).
inline RadiusProfile taperProfile(double taper) {
    if (taper < 1) return {taper, 1, RadiusProfile::Form::Segments};
    if (taper < 2) return {2 - taper, 1, RadiusProfile::Form::RoundEnd};
    return {0, taper - 2, RadiusProfile::Form::Spheres};
}

/// What the builder knows of a stem beside what the tree says.
struct StemScratch {
    double countPhase; ///< start of its counts' error diffusion, 0..1
    double lengthMax;  ///< nLength + var(nLengthV) it was made with
    double parentLength;
};

/// A generation as the builder keeps it, to grow the next one on it.
struct CGrownGeneration : CGeneration {
    std::vector<StemScratch> scratch;    ///< by stem
    std::vector<double> rotationPhase;   ///< by path: start of its children's rotation, radians
    std::vector<double> density;         ///< by segment: share of the stem's children and leaves, 1 before any split
    std::uint32_t curveRes = 1;          ///< segments from base to tip, of equal length

    StemMeasures measuresOf(std::size_t stem) const {
        const CStem& own = stems[stem];
        return {own.length, scratch[stem].lengthMax, own.radius, own.offset, scratch[stem].parentLength};
    }
};

/// Of a tree that this builder made.
inline const CGrownGeneration& grownOf(const CTree& tree, std::size_t generation) {
    return static_cast<const CGrownGeneration&>(tree.generation(generation));
}

} // namespace stromar
