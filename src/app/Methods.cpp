#include "stromar/app/Methods.h"
#include "methods/LSystem.h"
#include "methods/Strands.h"
#include "methods/WeberPenn.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/tree/lsystem/LSystemBuilder.h"
#include "stromar/tree/strands/StrandsBuilder.h"
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
    {.block = &lsystemBlock(),
     .makeBuilder = [](bool varied) -> std::unique_ptr<ITreeBuilder> { return std::make_unique<CLSystemBuilder>(varied); },
     .bound = &lsystemBound,
     .boundIsQuick = false,
     .demonstration = {.settings = "Derivations=4"},
     .language = &lsystemLanguage()},
    {.block = &strandsBlock(),
     .makeBuilder = [](bool varied) -> std::unique_ptr<ITreeBuilder> { return std::make_unique<CStrandsBuilder>(varied); },
     .bound = &strandsBound,
     .demonstration = {.settings = "Strands=60 TrunkHeight=1.5 InheritedLength=1.5"},
     .quantities = strandQuantities(),
     .curvePlaces = &strandPlaces,
     .curveAxis = &strandAxis},
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

CurveAxis axisOf(const ParamInfo& curve, const CParams& params) {
    const TreeMethod& method = methodOf(params);
    return method.curveAxis ? method.curveAxis(curve, params) : CurveAxis{curve.overLabel, curve.overStep};
}

const TextLanguage* languageOf(const ParamInfo& info) {
    for (const TreeMethod& method : known())
        if (method.language && method.language->key == info.key) return method.language;
    return nullptr;
}

std::size_t offsetOf(std::string_view text, int line, int column) {
    std::size_t at = 0;
    for (int i = 1; i < line && at < text.size(); ++i) at = std::min(text.find('\n', at), text.size() - 1) + 1;
    return std::min(text.size(), at + static_cast<std::size_t>(std::max(0, column - 1)));
}

void registerMethod(const TreeMethod& method) {
    registerBlock(*method.block);
    known().push_back(method);
}

} // namespace stromar
