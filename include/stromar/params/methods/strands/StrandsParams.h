#pragma once
#include "stromar/params/ParamTable.h"
#include <optional>

namespace stromar {

/// What a curve of the strand model runs over: the number of turns aside (Gravelius order), or a quantity of the branch
/// that splits, at its base.
enum class CurveOver { Order, Height, RootLength, Thickness };

/// The block of the strand model (Holton 1994, as Zamuda & Strnad used it). A value of a branch is the curve …G times the
/// curve …W over the number of splits below it (Weibull order).
struct StrandsParams {
    CCurve strandShareG, strandShareW;
    CCurve splitAngleG, splitAngleW, planeTurnG, planeTurnW, gravimorphismG, gravimorphismW; ///< degrees
    CCurve lengthLeastG, lengthLeastW, lengthMostG, lengthMostW, lengthFactorG, lengthFactorW, gravicentralismG;
    double trunkHeight, inheritedLength; ///< metres
    double strandThickness;              ///< of a branch of one strand, metres: a diameter
    double strandVariation;
    Degrees leafDownAngle, leafRotate;
    int strands, stemLeaves;
    int splitAngleOver, planeTurnOver, gravimorphismOver, lengthLeastOver, lengthMostOver, lengthFactorOver,
        gravicentralismOver; ///< CurveOver

    bool operator==(const StrandsParams&) const = default;
};

const ParamBlock& strandsBlock();
inline const StrandsParams& strands(const CParams& params) { return params.as<StrandsParams>(); }
inline StrandsParams& strands(CParams& params) { return params.as<StrandsParams>(); }

/// The values of a split, in the order of strandValues().
enum class StrandValueId { Share, SplitAngle, PlaneTurn, Hanging, LengthLeast, LengthMost, LengthFactor, LeaderTurn };

/// A value of the model: its rows.
struct StrandValue {
    const ParamInfo *byOrder, *byDepth; ///< …G and …W; the latter null where there is none
    const ParamInfo* over;              ///< what …G runs over; null: the order
};
std::span<const StrandValue> strandValues();
/// What a curve of a tree runs over; nothing for …W, which run over the depth.
std::optional<CurveOver> overOf(const ParamInfo& curve, const CParams& params);

} // namespace stromar
