#include "stromar/app/Randomise.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
bool mayMove(const ParamRef& ref, const CParams& params) {
    const ParamKind kind = ref.info->kind();
    return (kind == ParamKind::Number || kind == ParamKind::Curve) && ref.info->atRandom && !ref.info->unused() &&
           inactiveReason(ref, params).empty();
}

std::uint64_t hashOf(const std::string& key) {
    std::uint64_t hash = 0;
    for (const char c : key) hash = hashCombine(hash, static_cast<unsigned char>(c));
    return hash;
}

double moved(const ParamInfo& info, double value, double by) {
    const double half = (info.useful.max - info.useful.min) / 2;
    const double low = std::min(value, info.useful.min), high = std::max(value, info.useful.max);
    const double digits = std::pow(10, info.decimals);
    return std::clamp(std::round((value + by * half) * digits) / digits, low, high);
}

ParamValue moved(const ParamRef& ref, const CParams& params, double amount, const CRandom& random) {
    const std::uint64_t key = hashOf(ref.key());
    if (ref.info->numeric()) return moved(*ref.info, ref.get(params), random.vary(amount, key, 0));
    std::vector<CCurve::Point> points = ref.curve(params).points();
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].y = moved(*ref.info, points[i].y, random.vary(amount, key, 0, i));
    return CCurve(std::move(points));
}
} // namespace

ParamValues randomised(const CParams& params, std::span<const ParamRef> refs, double amount, std::uint64_t seed) {
    const CRandom random(seed, true);
    ParamValues values;
    for (const ParamRef& ref : allParams(params.block()))
        if (std::ranges::find(refs, ref) != refs.end() && mayMove(ref, params))
            values.emplace_back(ref, moved(ref, params, amount, random));
    return values;
}

} // namespace stromar
