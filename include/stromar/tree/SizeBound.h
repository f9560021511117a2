#pragma once
#include "stromar/tree/Tree.h"
#include <array>
#include <vector>

namespace stromar {

/// A part of a generation's stems, and how thick they, or the wood they part from, are at most: the radius over the first trunk's.
struct ThicknessShare {
    double share, thickness;
};

/// Stems that may part from their parents at nodes (CStem::mayPart()), counted for each stem of the generation.
struct Parting {
    double branches = 0; ///< of the next generation
    double branched = 0; ///< of its own, at most 1
};

/// At most so much in one generation of stems. Whole numbers, but possibly beyond any integer.
struct GenerationBound {
    double stems = 0;               ///< of the whole tree
    double paths = 1, segments = 1; ///< of one stem
    double along = 1;               ///< segments from a stem's base to a tip, at least
    std::vector<ThicknessShare> thickness{{1, 1}}; ///< the shares are 1 together
    double turn = 0;                ///< degrees between two segments that follow each other
    Parting single, several;        ///< stems that part from others at nodes: one by itself, and more at one place
    double forkTurn = 0;            ///< degrees that a fork turns its paths, and that they turn back later
    bool forks = false, helix = false, roundEnds = false, spheres = false;
};

/// What is known of a tree's twigs (see twigsOf) before it is grown, and of what is left when cards stand for them.
struct TwigBound {
    double stems = 0;                  ///< at most
    double leaves = 0;                 ///< on a large one: twice the mean
    double length = 0;                 ///< likewise, metres
    double leafLength = 0;             ///< metres
    std::vector<GenerationBound> wood; ///< the stems that are none, by generation
    double otherLeaves = 0;            ///< on those, at most
};

/// How large a tree can become, over all seeds; told by the values alone, in microseconds.
struct SizeBound {
    std::vector<GenerationBound> generations;
    std::array<double, kOrgans.size()> organs{}; ///< by Organ
    BaseForm base;
    TwigBound twigs;
    double scratchPerStem = 0, scratchPerSegment = 0; ///< bytes that the builder keeps besides

    double stems() const;
    double segments() const;
    double organCount() const;
    /// Of the stems and what the builder keeps, while they are built: the largest part is held twice. Organs are grown
    /// as a model asks for them.
    double bytes() const;
};

} // namespace stromar
