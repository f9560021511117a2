#pragma once
#include "stromar/params/ParamTable.h"

namespace stromar {

// The compiler proves a table before any test runs.

constexpr bool rowIsSane(const ParamInfo& p) {
    if (p.key.empty() || p.label.empty() || p.section.empty() || p.help.empty()) return false;
    if (p.kind() == ParamKind::Text) return true;
    if (p.step <= 0 || p.range.min >= p.range.max) return false;
    if (!p.range.contains(p.useful.min) || !p.range.contains(p.useful.max) || p.useful.min >= p.useful.max) return false;
    if (p.kind() == ParamKind::Curve)
        return !p.defaultText.empty() && !p.overLabel.empty() && p.over.min < p.over.max && p.overStep > 0 &&
               p.over.contains(p.shownOver.min) && p.over.contains(p.shownOver.max);
    if (p.integer() != (p.decimals == 0)) return false;
    if ((p.field.type == ParamField::Type::Angle) != (p.unit == Unit::Degree)) return false;
    if (!p.words.empty() && p.range.max + 1 != static_cast<double>(p.words.size())) return false;
    for (int level = p.firstLevel; level <= p.lastLevel(); ++level)
        if (!p.range.contains(p.defaults[static_cast<std::size_t>(level)])) return false;
    return true;
}

constexpr bool rowsAreSane(std::span<const ParamInfo> rows) {
    for (const ParamInfo& p : rows) {
        if (!rowIsSane(p)) return false;
        for (const ParamInfo& q : rows)
            if (&p != &q && (p.key == q.key || p.field == q.field)) return false;
    }
    return true;
}

/// Of the members that rows describe, with the padding behind them.
constexpr std::size_t bytesDescribed(std::span<const ParamInfo> rows, bool perLevel) {
    std::size_t bytes = 0;
    for (const ParamInfo& p : rows)
        if (p.perLevel() == perLevel) bytes += p.field.bytes;
    return (bytes + sizeof(double) - 1) / sizeof(double) * sizeof(double);
}

} // namespace stromar
