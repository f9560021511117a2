#pragma once
#include "stromar/mesh/OrganMesh.h"

namespace stromar {

/// Whether a stem's n-th organ is among those that are gone where a share is left. One that has fallen stays on the
/// ground when others fall.
bool hasFallen(const CStem& stem, std::uint32_t n, double share);

/// How many of a stem's organs are there.
std::uint32_t presentOn(const CStem& stem, std::uint32_t count, double share);

/// Chooses `count` of `total`, evenly: the index of the i-th.
inline std::size_t evenly(std::size_t i, std::size_t count, std::size_t total) {
    return (2 * i + 1) * total / (2 * count);
}

/// About the middle of the stems that bear some.
Rounding roundingOf(const CTree& tree, const COrgans& organs, const LeafForm& form);
/// Of the same stems, 0 to 1.
CrownShade shadeOf(const CTree& tree, const COrgans& organs, double sunAndShade);

} // namespace stromar
