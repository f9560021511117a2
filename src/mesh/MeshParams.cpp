#include "stromar/mesh/MeshParams.h"
#include "stromar/util/Random.h"
#include <algorithm>

namespace stromar {

namespace {
constexpr std::uint64_t kKindOrder = 0x6b696e64;
} // namespace

double MeshParams::shareOf(std::size_t kind) const {
    double left = 1;
    for (std::size_t other = 0; other < otherLeaves.size(); ++other) {
        const double share = std::min(left, otherLeaves[other].share);
        if (other + 1 == kind) return share;
        left -= share;
    }
    return left;
}

std::size_t MeshParams::kindOf(const CStem& stem, std::uint32_t n) const {
    if (std::ranges::all_of(otherLeaves, [](const LeafKind& other) { return other.share <= 0; })) return 0;
    double place = unitOf(hashCombine(hashCombine(kKindOrder, stem.id), n));
    for (std::size_t other = 0; other < otherLeaves.size(); ++other) {
        if (place < otherLeaves[other].share) return other + 1;
        place -= otherLeaves[other].share;
    }
    return 0;
}

LeafForm MeshParams::formOf(std::size_t kind) const {
    LeafForm form = leaf;
    if (kind > 0 && otherLeaves[kind - 1].mesh) form.mesh = otherLeaves[kind - 1].mesh;
    return form;
}

} // namespace stromar
