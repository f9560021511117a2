#include "stromar/params/ParamTable.h"
#include <algorithm>

namespace stromar {

namespace {
Invalidation invalidatedBy(const ParamRef& ref, const CParams& before, const CParams& after) {
    const ParamBlock& block = after.block();
    return block.invalidation ? block.invalidation(ref, before, after) : ref.info->invalidates;
}

Invalidation earlier(const Invalidation& a, const Invalidation& b) {
    if (a.stage == Stage::None || b.stage == Stage::None) return a.stage == Stage::None ? b : a;
    return {std::min(a.stage, b.stage), std::min(a.generation, b.generation)};
}
} // namespace

Invalidation invalidationOf(const CParams& before, const CParams& after) {
    if (&before.block() != &after.block()) return {Stage::Structure, 0};
    Invalidation first;
    for (const ParamRef& ref : allParams(after.block()))
        if (ref.differs(before, after)) first = earlier(first, invalidatedBy(ref, before, after));
    return first;
}

} // namespace stromar
