#pragma once
#include <array>
#include <string>

namespace stromar {

constexpr int kParamLevels = 4; ///< sets of level values; generation 4 and deeper use the last

/// Values of the whole tree. Lengths in metres, angles in degrees. What each means stands in the parameter table.
struct GlobalParams {
    double scale, scaleV, zScale, zScaleV, baseSize, ratio, ratioPower, lobeDepth, lobeFade, rootReach, rootHeight,
        flare, attractionUp;
    double trunkScale, trunkScaleV;
    double trunksSpread, trunksLean;
    double leafScale, leafScaleX, leafBend, leafQuality, leafFold, leafStalk, leafRounding;
    double season, blossomScale, blossomUp, blossomMonth, fruitScale, fruitScaleX, fruitStalk, fruitMonth;
    double pruneRatio, pruneWidth, pruneWidthPeak, prunePowerLow, prunePowerHigh;
    double textureWrapX, textureWrapY, minRadius;
    int shape, levels, lobes, roots, baseSplits, leaves, leafShape, leafForm, cloneHalving, seed;
    int trunks, evergreen, leafWhorl, leafPlanes, blossoms, blossomPlanes, fruits;

    bool operator==(const GlobalParams&) const = default;
};

/// Values of one level: 0 the trunk, 1 the branches on it, …
struct LevelParams {
    double length, lengthV, taper;
    double curve, curveBack, curveV;
    double segSplits, splitAngle, splitAngleV;
    double branchDist, branchDistV, downAngle, downAngleV, rotate, rotateV;
    int curveRes, branches, whorl;

    bool operator==(const LevelParams&) const = default;
};

/// What a file says in words. Texture paths are relative to the file; empty = the built-in picture.
struct TextParams {
    std::string species, author, description, method, likedSeeds, barkTexture, leafTexture, blossomTexture,
        fruitTexture;

    bool operator==(const TextParams&) const = default;
};

/// Everything a user can set for one tree: a plain value, to be copied, compared and handed to other threads.
struct CParams {
    GlobalParams global;
    std::array<LevelParams, kParamLevels> level;
    TextParams text;

    CParams(); ///< the table's defaults
    bool operator==(const CParams&) const = default;
};

} // namespace stromar
