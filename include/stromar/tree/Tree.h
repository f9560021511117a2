#pragma once
#include "stromar/params/Calculations.h"
#include "stromar/tree/Frame.h"
#include "stromar/util/RawVector.h"
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace stromar {

/// A straight piece of a stem, or one turn of a helix about a straight axis.
struct CSegment {
    glm::dvec3 position; ///< of its base, metres
    Frame frame;
    double length;
    double radiusBase, radiusEnd; ///< by taper; without flare, lobes and the least radius
    double density;     ///< share of the stem's children and leaves that this path's part gets, 1 before any split
    double helixRadius; ///< of the drawn centre line about the axis; 0 = straight
    bool forks;         ///< clones start at its end

    /// A point of the axis, t in 0..1 from base to end.
    glm::dvec3 axisPoint(double t) const { return position + t * length * frame[2]; }
    /// A point of the drawn centre line: the axis, or the helix about it.
    glm::dvec3 centre(double t) const;
    /// The unit tangent of the drawn centre line.
    glm::dvec3 tangent(double t) const;
};

/// A way through a stem from its base (path 0) or from a fork (a clone) to a tip: consecutive segments.
struct CPath {
    std::uint64_t id;
    std::uint32_t firstSegment; ///< in the generation
    std::uint32_t segmentCount;
    std::uint32_t firstPosition; ///< how many segments of the stem lie below the first
    std::int32_t source;         ///< the path in the same stem it split from, −1 for path 0
    double phase;                ///< start of its children's rotation, radians
};

/// A trunk, branch or twig with its clones. It owns paths, and through them segments, of its generation's arrays.
struct CStem {
    std::uint64_t id; ///< the same in every tree in which the stem sits in the same place
    double key;       ///< start of its counts' error diffusion, 0..1
    StemMeasures measures;
    double woodAtBase;      ///< radius of the parent's wood where it sits; 0 for the trunk
    double taper;           ///< up to 1: radii are linear along segments; above: CCalculations::taperedRadius
    double birth;           ///< when it starts to grow, 0..1 of the tree's age
    std::int32_t parent;    ///< stem of the generation before, −1 for the trunk
    std::uint32_t path;     ///< of the parent
    std::uint32_t position; ///< which segment along that path's stem it sits on, counted from the stem's base
    std::uint32_t firstPath, pathCount;
    std::uint32_t firstSegment, segmentCount; ///< all it owns, the clones' included
    std::uint32_t curveRes;                   ///< segments from base to tip
};

/// All stems of one level. Immutable once built; links are indices.
struct CGeneration {
    std::vector<CStem> stems;
    std::vector<CPath> paths;
    std::vector<CSegment> segments;

    std::size_t cloneCount() const { return paths.size() - stems.size(); }
};

struct CLeaf {
    glm::dvec3 position; ///< where the blade starts
    glm::dvec3 axis;     ///< unit vector along the blade
    glm::dvec3 normal;   ///< unit vector out of its upper side
    double length, width;
    std::uint32_t stem; ///< that bears it, in the last generation
};
using LeafArray = RawVector<CLeaf>;

/// What grows on the stems of the last generation. Blossoms and fruits are placed like leaves.
enum class Organ { Leaf, Blossom, Fruit };
inline constexpr std::array kOrgans{Organ::Leaf, Organ::Blossom, Organ::Fruit};
using OrganArrays = std::array<std::shared_ptr<const LeafArray>, kOrgans.size()>; ///< by Organ, none is null

/// The structure of one tree. A value that shares what it did not change with the tree it was made from; safe to read
/// from any thread.
class CTree {
public:
    CTree(double scaleTree, std::vector<std::shared_ptr<const CGeneration>> generations, OrganArrays organs)
        : m_scaleTree(scaleTree), m_generations(std::move(generations)), m_organs(std::move(organs)) {}

    /// Height by which all lengths are scaled, metres.
    double scaleTree() const { return m_scaleTree; }
    std::size_t generationCount() const { return m_generations.size(); }
    const CGeneration& generation(std::size_t g) const { return *m_generations[g]; }
    const std::vector<std::shared_ptr<const CGeneration>>& generations() const { return m_generations; }
    const LeafArray& leaves() const { return *shared(Organ::Leaf); }
    const std::shared_ptr<const LeafArray>& shared(Organ organ) const {
        return m_organs[static_cast<std::size_t>(organ)];
    }
    std::size_t stemCount() const;

private:
    double m_scaleTree;
    std::vector<std::shared_ptr<const CGeneration>> m_generations;
    OrganArrays m_organs;
};

} // namespace stromar
