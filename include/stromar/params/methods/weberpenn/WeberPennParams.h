#pragma once
#include "stromar/params/ParamTable.h"
#include <array>

namespace stromar {

/// What AttractionUp turns a stem about, by the words of its table row.
enum class AttractionAxis { Stem, Horizontal };

/// Values of one level: 0 the trunk, 1 the branches on it, …
struct LevelParams {
    double length, lengthV, taper, segSplits, branchDist, branchDistV;
    Degrees curve, curveBack, curveV, splitAngle, splitAngleV, downAngle, downAngleV, rotate, rotateV;
    int curveRes, branches, whorl;

    bool operator==(const LevelParams&) const = default;
};

/// The block of Weber & Penn, "Creation and Rendering of Realistic Trees", SIGGRAPH '95. Lengths in metres.
struct WeberPennParams {
    double scale, scaleV, zScale, zScaleV, baseSize, ratio, ratioPower, attractionUp;
    double trunkScale, trunkScaleV, trunksSpread;
    Degrees trunksLean;
    double pruneRatio, pruneWidth, pruneWidthPeak, prunePowerLow, prunePowerHigh;
    int shape, levels, baseSplits, leaves, cloneHalving, trunks, attractionAxis;
    std::array<LevelParams, kParamLevels> level;

    bool operator==(const WeberPennParams&) const = default;
};

inline const WeberPennParams& weberPenn(const CParams& params) { return params.as<WeberPennParams>(); }
inline WeberPennParams& weberPenn(CParams& params) { return params.as<WeberPennParams>(); }
/// The values that a generation sees: 4 and deeper those of level 3.
inline const LevelParams& levelOf(const CParams& params, int generation) {
    return weberPenn(params).level[static_cast<std::size_t>(generation < kParamLevels ? generation : kParamLevels - 1)];
}

template <>
struct BlockPlace<LevelParams> {
    static constexpr bool kPerLevel = true;
    static const LevelParams& in(const CParams& params, int level) {
        return weberPenn(params).level[static_cast<std::size_t>(level)];
    }
};

} // namespace stromar
