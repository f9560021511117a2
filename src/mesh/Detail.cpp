#include "stromar/mesh/Detail.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace stromar {

namespace {
constexpr int kAll = 1000;
constexpr std::size_t kNoBudget = std::numeric_limits<std::size_t>::max();

// clang-format off
constexpr Detail kDetails[] = {
    //                                    points lobe turn least sag  taper helix smooth collar fork wood share leaves growth planes cards sky
    {"Simple model",      Model::Simple, 0,  6,   0,   0,    0, 0,     0,    10,   1,    0,  0,  1.0,  1.0,  24000,     3.5, 0,  0,     1},
    {"Full model",        Model::Full,   0, 24,  12,   8,    0, 0,     0,    10, kAll,   3,  3,  1.0,  1.0,  kNoBudget, 2,   0,  0,     1},
    {"Full model, LOD 1", Model::Full,   1, 16,   8,  16,    4, 0,     0.06,  6, kAll,   2,  5,  0.5,  0.5,  kNoBudget, 2,   0,  0,     1},
    {"Full model, LOD 2", Model::Full,   2, 10,   0,   0,   10, 0,     0.1,   4, kAll,   1,  9,  0.25, 0.25, kNoBudget, 2,   2,  0.25,  1},
    {"Full model, LOD 3", Model::Full,   3,  6,   0,   0,   20, 0.004, 0.13,  3,   1,    0,  0,  0.04, 0.1,  kNoBudget, 3.2, 1,  0.075, 0.95},
};
// clang-format on
static_assert(std::ranges::max(kDetails, {}, &Detail::lod).lod == kMaxLod);
} // namespace

std::span<const Detail> detailTable() { return kDetails; }

const Detail& detailOf(Model model, int lod) {
    for (const Detail& detail : kDetails)
        if (detail.model == model && detail.lod == lod) return detail;
    assert(false && "no such level of detail");
    return kDetails[0];
}

Detail withLeaves(const Detail& detail, const LeafShare& share) {
    Detail own = detail;
    own.share *= share.leaves;
    own.cardShare *= share.cards;
    own.maxLeafGrowth /= std::sqrt(share.leaves);
    return own;
}

int roundRingPoints(const Detail& detail, double thickness) {
    const int points = static_cast<int>(std::ceil(detail.ringPoints * thickness - 1e-9));
    return std::max(3, points > 5 ? (points + 1) / 2 * 2 : points);
}

double outlineShare(int sides) { return sides * std::sin(std::numbers::pi / sides) / std::numbers::pi; }

} // namespace stromar
