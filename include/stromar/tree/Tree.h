#pragma once
#include "stromar/tree/Frame.h"
#include "stromar/tree/Organs.h"
#include "stromar/tree/StemForm.h"
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace stromar {

/// A straight piece of a stem, or one turn of a helix about a straight axis. Pieces of one stem may differ in length.
struct CSegment {
    glm::dvec3 position; ///< of its base, metres
    Frame frame;
    double start;                 ///< of its base, metres along the stem from the stem's base
    double length;                ///< metres
    double radiusBase, radiusEnd; ///< without base form and the least radius
    double helixRadius;           ///< of the drawn centre line about the axis; 0 = straight
    bool forks;                   ///< clones start at its end
    float turns = 1;              ///< of a helix: less where its tip has only come so far

    double end() const { return start + length; }
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
};

/// A trunk, branch or twig with its clones. It owns paths, and through them segments, of its generation's arrays.
struct CStem {
    std::uint64_t id; ///< the same in every tree in which the stem sits in the same place
    double length;    ///< from its base to the tip of path 0, metres
    double radius;    ///< at its base; without base form and the least radius
    double offset;    ///< of its base along the parent, from the parent's base, metres
    double parentRadius; ///< of the parent's wood where it sits; 0 without a parent
    double birth;        ///< when it starts to grow, 0..1 of the tree's age
    RadiusProfile profile;
    std::int32_t parent;    ///< stem of the generation before, −1 for a trunk
    std::uint32_t path;     ///< of the parent
    std::uint32_t position; ///< which segment of that path it sits on, counted from the parent's base
    std::uint32_t firstPath, pathCount;
    std::uint32_t firstSegment, segmentCount; ///< all it owns, the clones' included
    bool atNode = false; ///< its base lies on the parent's axis, where a segment ends: so of all of a generation, which are in the order of their places

    /// So thick a branch may part from its parent at a node like another of its limbs.
    static constexpr double kPartingRadius = 0.6; ///< over the parent's
    bool mayPart() const { return atNode && radius >= kPartingRadius * parentRadius; }
};

/// All stems that are equally many turns away from the root. Immutable once built; links are indices.
struct CGeneration {
    virtual ~CGeneration() = default;

    std::vector<CStem> stems;
    std::vector<CPath> paths;
    std::vector<CSegment> segments;

    std::size_t cloneCount() const { return paths.size() - stems.size(); }
    /// The segments of a path, from its base.
    std::span<const CSegment> segmentsOf(const CPath& path) const {
        return std::span(segments).subspan(path.firstSegment, path.segmentCount);
    }
    /// The segment at whose end a clone's path starts; null for path 0 of a stem.
    const CSegment* segmentBelow(const CStem& stem, const CPath& path) const;
    /// The segment of a path of a stem at a place counted from the stem's base.
    const CSegment& segmentAt(const CStem& stem, std::uint32_t path, std::uint32_t position) const;
    /// From the stem's base to the path's tip, metres.
    double lengthOf(const CPath& path) const { return segmentsOf(path).back().end(); }
};

/// The structure of one tree. A value that shares what it did not change with the tree it was made from; safe to read
/// from any thread.
class CTree {
public:
    /// A tree that bears nothing. `height` is what the builder aims at. `base` is the form of all trunks where they
    /// enter the ground.
    CTree(double height, std::vector<std::shared_ptr<const CGeneration>> generations, const BaseForm& base = {});
    CTree withOrgans(OrganArrays organs) const;

    /// What the builder aims at, metres: by it guides are scaled.
    double height() const { return m_height; }
    /// Of the stems of generation 0.
    const BaseForm& base() const { return m_base; }
    std::size_t generationCount() const { return m_generations.size(); }
    const CGeneration& generation(std::size_t g) const { return *m_generations[g]; }
    const std::vector<std::shared_ptr<const CGeneration>>& generations() const { return m_generations; }
    const std::shared_ptr<const COrgans>& organs(Organ organ) const { return m_organs[static_cast<std::size_t>(organ)]; }
    /// Those that are grown.
    const LeafArray& grown(Organ organ) const { return organs(organ)->grown; }
    const LeafArray& leaves() const { return grown(Organ::Leaf); }
    std::size_t stemCount() const;
    /// The stem so many generations below one of generation `g` that this grows on; 0: itself.
    const CStem& ancestor(std::size_t g, const CStem& stem, std::size_t generations) const;
    /// Whether the branches of a generation's stems, the next generation, start at nodes.
    bool branchesAtNodes(std::size_t g) const;

private:
    double m_height;
    BaseForm m_base;
    std::vector<std::shared_ptr<const CGeneration>> m_generations;
    OrganArrays m_organs;
};

} // namespace stromar
