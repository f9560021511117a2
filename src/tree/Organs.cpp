#include "stromar/tree/Organs.h"
#include "stromar/tree/Tree.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr std::uint64_t kThinning = 0x7468696e;
}

std::size_t COrgans::countOn(const StemSet& stems) const {
    std::size_t count = 0;
    for (std::size_t g = 0; g < stems.stems.size(); ++g)
        for (std::size_t s = 0; s < stems.stems[g].size(); ++s)
            if (stems.stems[g][s]) count += countOn(g, s);
    return count;
}

StemSet twigsOf(const CTree& tree, const COrgans& leaves) {
    StemSet twigs;
    twigs.stems.resize(leaves.counts.size());
    for (std::size_t g = 0; g < leaves.counts.size(); ++g) {
        std::vector<bool>& own = twigs.stems[g];
        for (const std::uint32_t count : leaves.counts[g]) own.push_back(count > 0);
        if (own.empty() || g + 1 == tree.generationCount()) continue;
        for (const CStem& branch : tree.generation(g + 1).stems)
            if (branch.parent >= 0) own[static_cast<std::size_t>(branch.parent)] = false;
    }
    return twigs;
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
