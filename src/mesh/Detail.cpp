#include "stromar/mesh/Detail.h"
#include <cassert>
#include <limits>

namespace stromar {

namespace {
constexpr int kAll = 1000;
constexpr std::size_t kNoBudget = std::numeric_limits<std::size_t>::max();

constexpr Detail kDetails[] = {
    {"Simple model", Model::Simple, 0, {6, 4, 3, 3}, 1, 0, 1.0, 12000},
    {"Full model", Model::Full, 0, {16, 8, 5, 3}, kAll, 3, 1.0, kNoBudget},
    {"Full model, LOD 1", Model::Full, 1, {10, 6, 4, 3}, kAll, 2, 0.5, kNoBudget},
    {"Full model, LOD 2", Model::Full, 2, {8, 4, 3, 3}, 2, 1, 0.25, kNoBudget},
    {"Full model, LOD 3", Model::Full, 3, {5, 3, 3, 3}, 1, 0, 0.1, kNoBudget},
};
} // namespace

std::span<const Detail> detailTable() { return kDetails; }

const Detail& detailOf(Model model, int lod) {
    for (const Detail& detail : kDetails)
        if (detail.model == model && detail.lod == lod) return detail;
    assert(false && "no such level of detail");
    return kDetails[0];
}

} // namespace stromar
