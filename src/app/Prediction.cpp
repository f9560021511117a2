#include "stromar/app/Prediction.h"
#include "stromar/app/LeafMesh.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Pictures.h"
#include "stromar/mesh/MeshBound.h"
#include "stromar/model/MeshValues.h"
#include "stromar/util/Text.h"
#include <cmath>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace stromar {

namespace {
constexpr double kManyLeaves = 1000;

bool showsCards(const CParams& params, const SizeBound& bound, const MeshParams& mesh, const Detail& detail) {
    return detail.twigPlanes > 0 && isBakeable(params) && suitsCards(bound.twigs, mesh.seasonOf(Organ::Leaf));
}

/// "950", "1.3 million": rounded up.
std::string countText(double count) {
    if (count < 1e6) return numberText(std::ceil(count));
    if (count < 1e12) return numberText(std::ceil(count / 1e5) / 10) + " million";
    return "more than a million million";
}

/// "0.3 GB": rounded up.
std::string memoryText(double bytes) {
    if (bytes < 1e8) return numberText(std::ceil(bytes / 1e6)) + " MB";
    if (bytes < 1e15) return numberText(std::ceil(bytes / 1e8) / 10) + " GB";
    return "more than a million GB";
}
} // namespace

Prediction predictSize(const CParams& params, const Detail& detail, const CProgress& progress) {
    const SizeBound bound = methodOf(params).bound(params, progress);
    const MeshParams mesh = meshParamsWithLeaf(params);
    // Where few leaves are left, there may be none by chance.
    const double left = mesh.seasonOf(Organ::Leaf).share, leaves = bound.organs[static_cast<std::size_t>(Organ::Leaf)];
    const bool onCards = (left == 1 || left * leaves > kManyLeaves) && showsCards(params, bound, mesh, detail);
    const MeshBound drawn = meshBound(bound, mesh, detail, onCards);
    return {bound.stems(),  bound.segments(), bound.organCount(), bound.organs[static_cast<std::size_t>(Organ::Leaf)],
            drawn.vertices, bound.bytes() + drawn.bytes};
}

double SizeLimits::defaultMemory() {
    std::ifstream info("/proc/meminfo");
    for (std::string word; info >> word;)
        if (double kilobytes = 0; word == "MemAvailable:" && info >> kilobytes) return 1024 * kilobytes / 2;
    return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)) / 2;
}

SizeLimits SizeLimits::none() {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    return {kAny, kAny};
}

std::string refusalText(const Prediction& size, const SizeLimits& limits) {
    std::string text = "this tree would have up to " + countText(size.stems) + " stems, " + countText(size.leaves) +
                       " leaves and " + countText(size.vertices) + " vertices and take up to " + memoryText(size.bytes) +
                       " of memory; the limit is ";
    if (size.vertices > limits.vertices) text += countText(limits.vertices) + " vertices";
    if (size.vertices > limits.vertices && size.bytes > limits.bytes) text += " and ";
    if (size.bytes > limits.bytes) text += memoryText(limits.bytes);
    return text;
}

void refuseTooLarge(const CParams& params, const Detail& detail, const SizeLimits& limits, const CProgress& progress) {
    const Prediction size = predictSize(params, detail, progress);
    if (!limits.allow(size)) throw CTooLarge(size, limits);
}

bool mayShowCards(const CParams& params, const Detail& detail, const CProgress& progress) {
    return showsCards(params, methodOf(params).bound(params, progress), meshParamsOf(params), detail);
}

std::optional<std::pair<ParamRef, double>> leastChangeThatFits(const CParams& params, const Detail& detail, const SizeLimits& limits,
                                                               const CProgress& progress) {
    std::optional<std::pair<ParamRef, double>> best;
    double most = 0; // share of its value that is left
    for (const ParamRef& ref : allParams(params.block())) {
        progress.poll();
        if (!ref.info->integer() || ref.get(params) <= 1) continue;
        CParams least = params;
        ref.set(least, std::max(ref.info->range.min, 1.0));
        if (!limits.allow(predictSize(least, detail, progress))) continue;
        const double fits = nearestThatFits(params, ref, ref.get(least), detail, limits), left = fits / ref.get(params);
        if (left <= most) continue;
        most = left;
        best = {ref, fits};
    }
    return best;
}

double nearestThatFits(const CParams& params, const ParamRef& ref, double fits, const Detail& detail,
                       const SizeLimits& limits) {
    const double step = ref.info->integer() ? 1 : std::pow(10, -ref.info->decimals);
    double small = fits / step, large = ref.get(params) / step;
    CParams tried = params;
    const auto isAllowed = [&] {
        try {
            return limits.allow(predictSize(tried, detail));
        } catch (const CError&) {
            return false;
        }
    };
    while (std::abs(large - small) > 1) {
        const double middle = std::round((small + large) / 2);
        ref.set(tried, middle * step);
        (isAllowed() ? small : large) = middle;
    }
    return small * step;
}

} // namespace stromar
