#pragma once
#include "stromar/app/Methods.h"
#include "stromar/mesh/twig/Twig.h"
#include "stromar/model/MeshValues.h"

namespace stromar::test {

/// What cards show of a tree; null where they gain nothing.
inline std::shared_ptr<const Twig> twigOf(const CTree& tree, const CParams& params) {
    const MeshParams mesh = meshParamsOf(params);
    if (!suitsCards(methodOf(params).bound(params, CProgress()).twigs, mesh.seasonOf(Organ::Leaf))) return nullptr;
    return typicalTwig(tree, mesh, CProgress(2));
}

} // namespace stromar::test
