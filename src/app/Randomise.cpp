#include "stromar/app/Randomise.h"
#include "stromar/app/TreeCreator.h"
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

/// What a tree is recognised by.
struct Extent {
    double stems = 0, leaves = 0, height = 0, width = 0, girth = 0;
};

Extent extentOf(const CParams& params, const SizeLimits& limits, const CProgress& progress) {
    const auto model = CTreeCreator(true, limits).create(params, detailOf(Model::Simple), progress);
    const auto bounds = model->bounds();
    const glm::vec3 size = bounds ? bounds->max - bounds->min : glm::vec3(0);
    const auto& trunks = model->tree->generationCount() > 0 ? model->tree->generation(0).stems : std::vector<CStem>();
    return {double(model->tree->stemCount()), double(model->tree->organs(Organ::Leaf)->total), size.z, std::max(size.x, size.y),
            trunks.empty() ? 0.0 : trunks[0].radius};
}

bool isLike(double value, double before, double times) { return value >= before / times && value <= before * times; }

bool isLike(const CParams& params, const Extent& before, const SizeLimits& limits, const CProgress& progress) {
    try {
        const Extent now = extentOf(params, limits, progress);
        return isLike(now.stems, before.stems, 3) && isLike(now.leaves, before.leaves, 3) && isLike(now.height, before.height, 2) &&
               isLike(now.width, before.width, 2) && isLike(now.girth, before.girth, 2.5);
    } catch (const CError&) {
        return false; // too large
    }
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

ParamValues randomisedTree(const CParams& params, std::span<const ParamRef> refs, double amount, std::uint64_t seed, const SizeLimits& limits, const CProgress& progress) {
    constexpr int kThrows = 8;
    constexpr double kLess = 0.85; // of the amount with every throw
    const Extent before = extentOf(params, limits, progress);
    ParamValues values;
    for (int i = 0; i < kThrows; ++i, amount *= kLess) {
        values = randomised(params, refs, amount, i == 0 ? seed : hashCombine(seed, static_cast<std::uint64_t>(i)));
        CParams moved = params;
        for (const auto& [ref, value] : values) ref.setValue(moved, value);
        if (isLike(moved, before, limits, progress)) return values;
    }
    return {};
}

} // namespace stromar
