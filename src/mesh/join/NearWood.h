#pragma once
#include "join/TubeLines.h"

namespace stromar {

/// Tubes that are near each other and the triangles around them, of all generations.
struct WoodPlace {
    std::vector<std::uint32_t> tubes; ///< of those that were asked for
    std::vector<std::vector<std::uint32_t>> near; ///< of each: the triangles around it
    struct Source {
        std::uint32_t generation;
        std::size_t first; ///< of its indices
    };
    std::vector<Source> triangles;
};

/// Parts tubes so that no triangle is near those of two places. Time n log m in all triangles and the tubes.
std::vector<WoodPlace> placesOf(const std::vector<CTubeLines>& lines, const JoinedStems& joined, const CProgress& progress);

CWoodPatch patchOf(const WoodPlace& place, std::span<const StemMesh> stems, const JoinedStems& joined);

/// Which closed surface a vertex was part of: by its first tube, of its generation.
std::uint32_t surfaceOf(std::span<const StemMesh> stems, const VertexSource& source);

} // namespace stromar
