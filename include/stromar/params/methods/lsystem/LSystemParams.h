#pragma once
#include "stromar/params/ParamTable.h"

namespace stromar {

/// The block of L-systems (Prusinkiewicz & Lindenmayer, "The Algorithmic Beauty of Plants", chapters 1 and 2). The
/// grammar's letters are read by parseGrammar().
struct LSystemParams {
    std::string grammar;
    double lengthUnit, widthUnit; ///< metres
    double tropismX, tropismY, tropismZ, tropismBend;
    Degrees turnAngle, leafDownAngle, leafRotate;
    int derivations, stemLeaves;

    bool operator==(const LSystemParams&) const = default;
};

const ParamBlock& lsystemBlock();
inline const LSystemParams& lsystem(const CParams& params) { return params.as<LSystemParams>(); }
inline LSystemParams& lsystem(CParams& params) { return params.as<LSystemParams>(); }

} // namespace stromar
