#pragma once
#include "stromar/tree/Organs.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Progress.h"

namespace stromar {

/// Where an organ grows: the n-th of a stem.
struct OrganSite {
    std::uint32_t generation, stem, number;
};

/// The organs of a kind, of which stems bear so many as `counts` says by generation and stem: all are counted, those that
/// are asked for placed. `idOf` names a site, the same in every tree that has it; `place` makes its CLeaf, on many threads.
template <typename IdOf, typename Place>
std::shared_ptr<const COrgans> placeOrgans(std::vector<std::vector<std::uint32_t>> counts, const OrganDemand& demand,
                                           IdOf&& idOf, Place&& place, const CProgress& progress) {
    constexpr std::size_t kGrain = 256;
    auto organs = std::make_shared<COrgans>();
    organs->counts = std::move(counts);
    double offered = 0;
    for (std::size_t g = 0; g < organs->counts.size(); ++g)
        for (std::size_t s = 0; s < organs->counts[g].size(); ++s) {
            organs->total += organs->counts[g][s];
            if (demand.mayBear(g, s)) offered += organs->counts[g][s];
        }
    const double part = demand.partOf(double(organs->total), offered);
    if (part <= 0) return organs;
    std::vector<OrganSite> sites;
    for (std::uint32_t g = 0; g < organs->counts.size(); ++g)
        for (std::uint32_t s = 0; s < organs->counts[g].size(); ++s) {
            if (!demand.mayBear(g, s)) continue;
            for (OrganSite site{g, s, 0}; site.number < organs->counts[g][s]; ++site.number)
                if (part >= 1 || OrganDemand::keeps(part, idOf(site))) sites.push_back(site);
        }
    organs->grown.resize(sites.size());
    parallelFor(
        sites.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) organs->grown[i] = place(sites[i]);
        },
        progress);
    return organs;
}

} // namespace stromar
