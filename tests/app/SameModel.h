#pragma once
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
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

/// Of any size.
inline std::shared_ptr<const TreeModel> created(const CParams& params, const Detail& detail = detailOf(Model::Full), int threads = 2) {
    return CTreeCreator(true, SizeLimits::none()).create(params, detail, CProgress(threads));
}

/// A tree of few branches.
inline std::shared_ptr<const TreeModel> smallModel() {
    static const auto model = [] {
        CParams params = preset("quaking_aspen");
        weberPenn(params).level[1].branches = 6;
        weberPenn(params).level[2].branches = 4;
        params.text.bark1Texture = params.text.bark2Texture = "";
        return createAnew(params, detailOf(Model::Simple));
    }();
    return model;
}

} // namespace stromar::test
