#pragma once
#include "mesh/MeshMeasures.h"
#include "stromar/app/TreeCreator.h"
#include <string>

namespace stromar::test {

/// What differs first between two models, or nothing.
inline std::string modelDifference(const TreeModel& a, const TreeModel& b) {
    if (a.tree->height() != b.tree->height()) return "the scale of the tree";
    if (a.stems.size() != b.stems.size()) return "the number of generations";
    for (std::size_t g = 0; g < a.stems.size(); ++g)
        if (!sameBytes(*a.stems[g], *b.stems[g])) return a.stems[g]->name;
    for (std::size_t i = 0; i < a.organs.size(); ++i)
        if (!sameBytes(*a.organs[i]->expanded(CProgress()), *b.organs[i]->expanded(CProgress()))) return a.organs[i]->name();
    if (!a.cards != !b.cards || (a.cards && !sameBytes(*a.cards, *b.cards))) return "the cards of twigs";
    return {};
}

/// What a creator that knows nothing makes.
inline std::shared_ptr<const TreeModel> createAnew(const CParams& params, const Detail& detail, int threads = 2) {
    return CTreeCreator().create(params, detail, CProgress(threads));
}

} // namespace stromar::test
