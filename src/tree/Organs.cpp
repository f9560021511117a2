#include "stromar/tree/Organs.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace stromar {

namespace {
constexpr std::uint64_t kThinning = 0x7468696e;
}

std::size_t COrgans::totalOn(std::size_t generation) const {
    if (generation >= counts.size()) return 0;
    return std::accumulate(counts[generation].begin(), counts[generation].end(), std::size_t{0});
}

std::shared_ptr<const COrgans> allOrgans(LeafArray grown,
                                         const std::vector<std::shared_ptr<const CGeneration>>& generations) {
    auto organs = std::make_shared<COrgans>();
    organs->counts.resize(generations.size());
    for (CLeaf& leaf : grown) {
        std::vector<std::uint32_t>& counts = organs->counts[leaf.generation];
        counts.resize(generations[leaf.generation]->stems.size(), 0);
        leaf.number = counts[leaf.stem]++;
    }
    organs->total = grown.size();
    organs->grown = std::move(grown);
    return organs;
}

double OrganDemand::partOf(double total, double offered) const {
    const double wanted = std::max(std::min(few, max), std::min(max, std::ceil(share * total)));
    return wanted >= offered ? 1 : wanted / offered;
}

double OrganDemand::bound(double total) const {
    const double wanted = std::max(std::min(few, max), std::min(max, std::ceil(share * total)));
    constexpr double kDeviations = 8; // of a sum of independent choices
    return wanted >= total ? total : std::min(total, wanted + kDeviations * std::sqrt(wanted) + kDeviations);
}

bool OrganDemand::keeps(double part, std::uint64_t id) {
    return part >= 1 || unitOf(hashCombine(kThinning, id)) < part;
}

} // namespace stromar
