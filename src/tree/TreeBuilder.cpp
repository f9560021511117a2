#include "stromar/tree/TreeBuilder.h"

namespace stromar {

std::shared_ptr<const CTree> growTree(const ITreeBuilder& builder, const CParams& params, const CProgress& progress, double age) {
    const auto stems = builder.atAge(params, builder.build(params, nullptr, 0, progress), age, progress);
    OrganArrays organs;
    for (const Organ organ : kOrgans)
        organs[static_cast<std::size_t>(organ)] = builder.growOrgans(params, *stems, organ, {}, progress);
    return std::make_shared<const CTree>(stems->withOrgans(std::move(organs)));
}

} // namespace stromar
