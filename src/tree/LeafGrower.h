#pragma once
#include "stromar/params/TreeParams.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Progress.h"
#include "stromar/util/Random.h"

namespace stromar {

/// Grows the leaves of the last generation (Weber & Penn §4.5, thesis §4.9). `bearing` is what that generation sees,
/// `leafLevel` what the next one would: it places the leaves.
class CLeafGrower {
public:
    CLeafGrower(const CTreeParams& bearing, const CTreeParams& leafLevel, const CRandom& random)
        : m_bearing(bearing), m_leafLevel(leafLevel), m_random(random) {}

    std::shared_ptr<const LeafArray> grow(const CGeneration& generation, const CProgress& progress) const;

private:
    std::size_t countOn(const CGeneration& generation, const CStem& stem) const;
    void growOn(const CGeneration& generation, std::uint32_t stem, CLeaf* leaf) const;
    void growAlong(const CGeneration& generation, std::uint32_t stem, CLeaf* leaf) const;
    void growFans(const CGeneration& generation, std::uint32_t stem, CLeaf* leaf) const;
    double numberOn(const CStem& stem) const;
    double startError(const CStem& stem) const;
    int fanSize(const CGeneration& generation, const CStem& stem, const CPath& path) const;
    CLeaf makeLeaf(const glm::dvec3& position, const Frame& frame, std::uint32_t stem) const;

    const CTreeParams& m_bearing;
    const CTreeParams& m_leafLevel;
    const CRandom& m_random;
};

/// The frame turned outwards and up to the light by `bend` 0..1 (Weber & Penn §4.9).
Frame bentToLight(const Frame& frame, const glm::dvec3& position, double bend);

} // namespace stromar
