#pragma once
#include "stromar/tree/Tree.h"
#include <array>
#include <vector>

namespace stromar {

/// A part of a generation's stems, and how thick they are at most: the radius over the first trunk's.
struct ThicknessShare {
    double share, thickness;
};

/// At most so much in one generation of stems. Whole numbers, but possibly beyond any integer.
struct GenerationBound {
    double stems = 0;               ///< of the whole tree
    double paths = 1, segments = 1; ///< of one stem
    double along = 1;               ///< segments from a stem's base to a tip, at least
    std::vector<ThicknessShare> thickness{{1, 1}}; ///< the shares are 1 together
    double turn = 0;                ///< degrees between two segments that follow each other
    double forkTurn = 0;            ///< degrees that a fork turns its paths, and that they turn back later
    bool forks = false, helix = false, roundEnds = false, spheres = false;
};

/// What is known of the stems that bear leaves before a tree is grown.
struct BearerBound {
    double leaves = 0;     ///< on one of them, at most
    double length = 0;     ///< of one of them, metres, at most
    double leafLength = 0; ///< metres
};

/// How large a tree can become, over all seeds; told by the values alone, in microseconds.
struct SizeBound {
    std::vector<GenerationBound> generations;
    std::array<double, kOrgans.size()> organs{}; ///< by Organ
    BaseForm base;
    BearerBound bearers;
    double scratchPerStem = 0, scratchPerSegment = 0; ///< bytes that the builder keeps besides

    double stems() const;
    double segments() const;
    double organCount() const;
    /// Of the stems and what the builder keeps, while they are built: the largest part is held twice. Organs are grown
    /// as a model asks for them.
    double bytes() const;
};

} // namespace stromar
