#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace stromar {

enum class Model { Simple, Full };

/// How finely a model is drawn: one row of the table of models and levels of detail.
struct Detail {
    std::string_view name; ///< for people
    Model model;
    int lod;               ///< 0..3, of the full model
    int ringPoints;        ///< of a ring as thick as the trunk; thinner stems have fewer by the root, 3 at least
    int lobePoints;        ///< for each lobe or root, at least; 0: they are drawn where the ring has four points for each
    double maxTurn;       ///< degrees between rings of a stem as thick as the trunk, thinner ones bend more; 0: mitres
    double minTurn;      ///< degrees, likewise: rings between smaller turns are left out; 0 draws all
    double maxSag;       ///< parts of the tree's height: bends that stand out less between two rings, or rows of a card, are left out
    double maxTaperError; ///< parts of its radius by which a trunk, thinner stems more, may differ from a cone between two rings: else none is left out
    int helixRings;        ///< per turn of a helix
    int smoothGenerations; ///< the first so many get rings between their segments' ends
    int collarRings;       ///< between a parent's surface and a branch's own rings; 0: branches start inside the wood
    int forkPoints;        ///< of a ring, from which it parts into a stem and one branch nearly as thick: thinner ones get a collar
    double woodShare;      ///< of the wood's triangles at LOD 0 that is aimed at: see chooseStems()
    double share;          ///< of the leaves, blossoms and fruits that are drawn, and of the twigs at least
    std::size_t leafBudget; ///< most leaves that are drawn; a few (kFewOrgans) always are
    double maxLeafGrowth;   ///< thinned leaves grow at most to this times their length, to cover what all would
    int twigPlanes;         ///< of a card that shows a whole twig; 0: every leaf is drawn by itself
    double cardShare;       ///< how many rectangles all cards have at most, for each leaf of the tree
    double cardSky;         ///< ambient light on cards: few large ones lie more in the sun than their picture, which is that of level 2, makes up for;
                            ///< no less, since in the shade they are right
};

/// Parts of what a detail draws.
struct LeafShare {
    double leaves = 1, cards = 1; ///< of twigs

    bool operator==(const LeafShare&) const = default;
};
/// The same with those, leaves as much larger as keeps their area.
Detail withLeaves(const Detail& detail, const LeafShare& share);

constexpr std::size_t kFewOrgans = 60; ///< so many leaves, blossoms or fruits are not thinned
constexpr std::size_t kFewWoodTriangles = 2500; ///< so many are not thinned at the last level of detail
constexpr double kCoarsestTurn = 2.5; ///< of thin stems, times what is allowed to a trunk

std::span<const Detail> detailTable();
constexpr int kMaxLod = 3; ///< of the full model
/// lod 0..3; the simple model has only 0.
const Detail& detailOf(Model model, int lod = 0);

/// The least part of a screen's height that the tree fills when a level of detail is shown, unless it is the last: that is shown down to
/// kLeastCoverage.
constexpr std::array<double, 4> kScreenCoverage{0.5, 0.25, 0.1, 0.03};
constexpr double kLeastCoverage = 0.01;
constexpr double screenCoverage(std::size_t lod, std::size_t levels) { return lod + 1 >= levels ? kLeastCoverage : kScreenCoverage[lod]; }

constexpr double kScreenHeight = 1080; ///< pixels, where what is seen is measured

/// Points of a round ring; `thickness` is the root of its radius over the trunk's. Even from 6 on: they can be halved.
int roundRingPoints(const Detail& detail, double thickness);
/// How wide a prism of so many sides is seen, on the average from all around, over the cylinder about it: its outline over the
/// circle's (Cauchy). 0.83 for 3 sides, 0.99 for 12.
double outlineShare(int sides);

} // namespace stromar
