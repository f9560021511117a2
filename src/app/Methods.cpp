#include "stromar/app/Methods.h"
#include "methods/WeberPenn.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include <algorithm>
#include <cassert>
#include <vector>

namespace stromar {

namespace {
const TreeMethod kMethods[] = {
    {.block = &weberPennBlock(),
     .makeBuilder = [](bool varied) -> std::unique_ptr<ITreeBuilder> { return std::make_unique<CWeberPennBuilder>(varied); },
     .bound = &weberPennBound,
     .guides = weberPennGuides(),
     .demonstration = weberPennDemonstration(),
     .generationOf = &weberPennGenerationOf},
};

std::vector<TreeMethod>& known() {
    static std::vector<TreeMethod> methods = [] {
        for (const TreeMethod& method : kMethods) registerBlock(*method.block);
        return std::vector<TreeMethod>(std::begin(kMethods), std::end(kMethods));
    }();
    return methods;
}

/// Files are read before any tree is grown: their methods are known from the start.
[[maybe_unused]] const bool kAreKnown = !known().empty();
} // namespace

std::span<const TreeMethod> treeMethods() { return known(); }

const TreeMethod& methodOf(const CParams& params) {
    const auto found = std::ranges::find(known(), &params.block(), &TreeMethod::block);
    assert(found != known().end());
    return *found;
}

void registerMethod(const TreeMethod& method) {
    registerBlock(*method.block);
    known().push_back(method);
}

} // namespace stromar
