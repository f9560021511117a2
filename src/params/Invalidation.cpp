#include "stromar/params/ParamTable.h"
#include <algorithm>

namespace stromar {

namespace {
/// The first generation that a change of a level's value reaches, in a tree with so many levels.
Invalidation invalidatedByLevel(const ParamInfo& p, int level, int levels) {
    if (level < levels) return {p.invalidates.stage, level};
    if (level == levels && p.placesLeaves) return {p.invalidates.stage, Invalidation::kLeaves};
    return {};
}

Invalidation invalidatedBy(const ParamRef& ref, const CParams& before, const CParams& after) {
    const ParamInfo& p = *ref.info;
    const int levels = std::min(before.global.levels, after.global.levels);
    if (p.invalidates.generation == Invalidation::kOwnLevel)
        return invalidatedByLevel(p, ref.level, std::max(before.global.levels, after.global.levels));
    if (p.invalidates.generation == Invalidation::kLastLevel) return {p.invalidates.stage, levels};
    return p.invalidates;
}

Invalidation earlier(const Invalidation& a, const Invalidation& b) {
    if (a.stage == Stage::None || b.stage == Stage::None) return a.stage == Stage::None ? b : a;
    if (a.stage != b.stage) return {std::min(a.stage, b.stage), std::min(a.generation, b.generation)};
    return {a.stage, std::min(a.generation, b.generation)};
}
} // namespace

Invalidation invalidationOf(const CParams& before, const CParams& after) {
    Invalidation first;
    for (const ParamRef& ref : allParams())
        if (ref.get(before) != ref.get(after)) first = earlier(first, invalidatedBy(ref, before, after));
    for (const TextInfo& text : textTable())
        if (before.text.*text.field != after.text.*text.field)
            first = earlier(first, {text.stage, text.stage == Stage::Structure ? 0 : Invalidation::kLeaves});
    return first;
}

} // namespace stromar
