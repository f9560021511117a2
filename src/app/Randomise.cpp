#include "stromar/app/Randomise.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
bool mayMove(const ParamRef& ref, const CParams& params) {
    const ParamInfo& info = *ref.info;
    const auto is = [&](auto member) { return info.field == ParamInfo::Field(member); };
    return info.words.empty() && !info.unused() && !is(&GlobalParams::seed) && !is(&GlobalParams::season) &&
           whyIdle(ref, params).empty();
}

double moved(const ParamInfo& info, double value, double by) {
    const double half = (info.useful.max - info.useful.min) / 2;
    const double low = std::min(value, info.useful.min), high = std::max(value, info.useful.max);
    const double digits = std::pow(10, info.decimals);
    return std::clamp(std::round((value + by * half) * digits) / digits, low, high);
}
} // namespace

std::vector<std::pair<ParamRef, double>> randomised(const CParams& params, std::span<const ParamRef> refs,
                                                    double amount, std::uint64_t seed) {
    const CRandom random(seed, true);
    std::vector<std::pair<ParamRef, double>> values;
    for (std::size_t i = 0; i < allParams().size(); ++i) { // the place in the table, not in `refs`, draws the number
        const ParamRef& ref = allParams()[i];
        if (std::ranges::find(refs, ref) == refs.end() || !mayMove(ref, params)) continue;
        values.emplace_back(ref, moved(*ref.info, ref.get(params), random.vary(amount, i, 0)));
    }
    return values;
}

} // namespace stromar
