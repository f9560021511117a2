#pragma once
#include "stromar/util/RawVector.h"
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace stromar {

struct CGeneration;
class CTree;

/// What grows on stems of any generation. Blossoms and fruits are placed like leaves.
enum class Organ { Leaf, Blossom, Fruit };
inline constexpr std::array kOrgans{Organ::Leaf, Organ::Blossom, Organ::Fruit};

/// In single precision: a crown has hundreds of thousands.
struct CLeaf {
    glm::vec3 position; ///< where the blade starts, metres
    glm::vec3 axis;     ///< unit vector along the blade
    glm::vec3 normal;   ///< unit vector out of its upper side
    float length, width; ///< metres
    std::uint32_t stem;       ///< that bears it
    std::uint32_t generation; ///< of that stem
    std::uint32_t number;     ///< on that stem, whether those before it are grown or not
};
using LeafArray = RawVector<CLeaf>;

/// Some of a tree's stems, by generation; of a generation that is missing or empty none.
struct StemSet {
    std::vector<std::vector<bool>> stems;

    bool has(std::size_t generation, std::size_t stem) const {
        return generation < stems.size() && stem < stems[generation].size() && stems[generation][stem];
    }
    bool empty() const { return stems.empty(); }
    bool operator==(const StemSet&) const = default;
};

/// The organs of one kind that a tree bears. Perhaps only some of them are grown: those that a model shows.
struct COrgans {
    LeafArray grown;                                ///< in the order of generations, stems and numbers
    std::vector<std::vector<std::uint32_t>> counts; ///< by generation and stem: how many it bears; empty: none does
    std::size_t total = 0;                          ///< sum of the counts

    std::uint32_t countOn(std::size_t generation, std::size_t stem) const {
        return generation < counts.size() && !counts[generation].empty() ? counts[generation][stem] : 0;
    }
    std::size_t countOn(const StemSet& stems) const;
};
using OrganArrays = std::array<std::shared_ptr<const COrgans>, kOrgans.size()>; ///< by Organ, none is null

/// Organs that are all grown, in order; sets their numbers.
std::shared_ptr<const COrgans> allOrgans(LeafArray grown,
                                         const std::vector<std::shared_ptr<const CGeneration>>& generations);

/// The tree's twigs: stems without branches that bear leaves. Linear in the stems.
StemSet twigsOf(const CTree& tree, const COrgans& leaves);

/// Which organs of a kind are grown. Those that are kept are chosen by a number of each one's own place, so that a
/// larger demand keeps what a smaller one has. How many are kept is left to chance, near to what is aimed at.
struct OrganDemand {
    double share = 1;                                      ///< of all the tree bears
    double max = std::numeric_limits<double>::infinity();
    double few = 0;                                        ///< so many are not thinned
    std::optional<StemSet> stems{};                        ///< only on these

    static OrganDemand none() { return {.share = 0, .max = 0}; }

    bool mayBear(std::size_t generation, std::size_t stem) const {
        return !stems || stems->has(generation, stem);
    }
    /// Of `offered`, which sit on stems that may bear, of `total` on all stems: the part that is kept, 0..1.
    double partOf(double total, double offered) const;
    /// More of at most `total` are not grown; the chance of it is below 1e-12.
    double bound(double total) const;
    /// Whether one with this name is kept.
    static bool keeps(double part, std::uint64_t id);
};

} // namespace stromar
