#pragma once
#include "stromar/mesh/MeshParams.h"
#include "stromar/tree/Tree.h"

namespace stromar {

/// Whether a stem's n-th organ is among those that are gone where a share is left. One that has fallen stays on the
/// ground when others fall.
bool hasFallen(const CStem& stem, std::uint32_t n, double share);

/// Calls visit(index, organ) for the organs that are there.
template <typename Visit>
void forEachPresent(const CTree& tree, Organ organ, double share, Visit&& visit) {
    const LeafArray& all = *tree.shared(organ);
    std::uint32_t onStem = 0; // organs lie in the order of their stems
    for (std::size_t i = 0; i < all.size(); ++i) {
        const CLeaf& own = all[i];
        onStem = i > 0 && own.stem == all[i - 1].stem && own.generation == all[i - 1].generation ? onStem + 1 : 0;
        if (!hasFallen(tree.generation(own.generation).stems[own.stem], onStem, share)) visit(i, own);
    }
}

/// Chooses `count` of `total`, evenly: the index of the i-th.
inline std::size_t evenly(std::size_t i, std::size_t count, std::size_t total) {
    return (2 * i + 1) * total / (2 * count);
}

/// Where leaves look when they are shaded as a round crown, and by how much.
struct Rounding {
    glm::dvec3 centre{0};
    double share = 0;
    double least = 0; ///< cosine to a leaf's own normal, so that its folded halves are not seen from behind

    /// A normal turned outwards, but never to the back of its leaf.
    glm::dvec3 turned(const glm::dvec3& normal, const glm::dvec3& place) const;
};
Rounding roundingOf(const LeafArray& leaves, const LeafForm& form);

} // namespace stromar
