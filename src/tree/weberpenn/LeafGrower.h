#pragma once
#include "CommonValues.h"
#include "Placement.h"
#include "stromar/params/methods/weberpenn/TreeParams.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include "stromar/util/Random.h"

namespace stromar {

/// How many organs of one kind there are and how large they are.
struct OrganRule {
    int number;           ///< on one stem at most; negative: in a fan at its tip
    double density;       ///< times the number; areas stay
    int whorl;            ///< at one place
    OrganPose pose;
    std::uint32_t purpose;
};
OrganRule organRule(const CParams& params, Organ organ);

/// Grows the leaves, or what is placed like them, of the last generation (Weber & Penn §4.5, thesis §4.9). `bearing` is
/// what that generation sees, `leafLevel` what the next one would: it places the leaves.
class CLeafGrower {
public:
    CLeafGrower(const CTreeParams& bearing, const CTreeParams& leafLevel, const CRandom& random, const OrganRule& rule)
        : m_bearing(bearing), m_leafLevel(leafLevel), m_random(random), m_rule(rule) {}

    /// Counts all; grows those that are asked for.
    std::shared_ptr<const COrgans> grow(const CGrownGeneration& generation, const OrganDemand& demand,
                                        const CProgress& progress) const;

private:
    /// The organs of one stem, one after the other.
    struct Bearer {
        std::uint32_t stem;
        double part; ///< that is kept
        CLeaf* next; ///< where the next kept one goes
        std::uint32_t number = 0;
    };

    std::uint32_t countOn(const CGrownGeneration& generation, std::size_t stem) const;
    std::size_t keptOn(const CGrownGeneration& generation, std::size_t stem, double part) const;
    void growOn(const CGrownGeneration& generation, Bearer& bearer) const;
    void growAlong(const CGrownGeneration& generation, Bearer& bearer) const;
    void growNode(const CGrownGeneration& generation, const SegmentShare& share, int node, CRotation& rotation,
                  Bearer& bearer) const;
    void growFans(const CGrownGeneration& generation, Bearer& bearer) const;
    template <typename Visit>
    void visitNames(const CGrownGeneration& generation, std::size_t stem, Visit&& visit) const;
    template <typename Visit>
    void shareOut(const CGrownGeneration& generation, std::size_t stem, Visit&& visit) const;
    double numberOn(const CGrownGeneration& generation, std::size_t stem) const;
    double nodesOn(const CGrownGeneration& generation, std::size_t stem) const {
        return numberOn(generation, stem) / m_rule.whorl;
    }
    double startError(const CGrownGeneration& generation, std::size_t stem) const;
    int fanSize(const CGrownGeneration& generation, std::size_t stem, const CPath& path) const;
    std::uint64_t leafId(const CStem& stem, const CPath& path, std::uint32_t position, int i) const;
    CLeaf makeLeaf(const glm::dvec3& position, const Frame& frame, const Bearer& bearer) const;

    const CTreeParams& m_bearing;
    const CTreeParams& m_leafLevel;
    const CRandom& m_random;
    OrganRule m_rule;
};

} // namespace stromar
