#include "stromar/params/ParamTable.h"
#include <algorithm>

namespace stromar {

namespace {
/// The first generation that a change of a level's value reaches, in a tree with so many levels.
Obsolete obsoleteByLevel(const ParamInfo& p, int level, int levels) {
    if (level < levels) return {p.obsolete.stage, level};
    if (level == levels && p.placesLeaves) return {p.obsolete.stage, Obsolete::kLeaves};
    return {};
}

Obsolete obsoleteBy(const ParamRef& ref, const CParams& before, const CParams& after) {
    const ParamInfo& p = *ref.info;
    const int levels = std::min(before.global.levels, after.global.levels);
    if (p.obsolete.generation == Obsolete::kOwnLevel)
        return obsoleteByLevel(p, ref.level, std::max(before.global.levels, after.global.levels));
    if (p.obsolete.generation == Obsolete::kLastLevel) return {p.obsolete.stage, levels};
    return p.obsolete;
}

Obsolete earlier(const Obsolete& a, const Obsolete& b) {
    if (a.stage == Stage::None || b.stage == Stage::None) return a.stage == Stage::None ? b : a;
    if (a.stage != b.stage) return {std::min(a.stage, b.stage), std::min(a.generation, b.generation)};
    return {a.stage, std::min(a.generation, b.generation)};
}
} // namespace

Obsolete firstObsolete(const CParams& before, const CParams& after) {
    Obsolete first;
    for (const ParamRef& ref : allParams())
        if (ref.get(before) != ref.get(after)) first = earlier(first, obsoleteBy(ref, before, after));
    for (const TextInfo& text : textTable())
        if (before.text.*text.field != after.text.*text.field)
            first = earlier(first, {text.stage, text.stage == Stage::Structure ? 0 : Obsolete::kLeaves});
    return first;
}

} // namespace stromar
