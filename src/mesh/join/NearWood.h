#pragma once
#include "join/TubeLines.h"

namespace stromar {

/// Tubes that are near each other and the triangles around them, of all generations.
struct WoodPlace {
    std::vector<std::uint32_t> tubes; ///< which of those that were asked for
    std::vector<std::vector<std::uint32_t>> near; ///< of each: the triangles around it
    struct Source {
        std::uint32_t generation;
        std::size_t first; ///< of its indices
    };
    std::vector<Source> triangles;
};

/// The wood of all generations while it is joined.
struct Wood {
    std::vector<std::shared_ptr<CMesh>> meshes;
    std::vector<std::vector<VertexSource>> sources; ///< of their vertices
};

/// Parts tubes so that no triangle is near those of two places. Those with the fewest triangles around them are chosen, as long as these are no
/// more than `most` together. Time n log m in all triangles and the tubes, and `most` for each tube.
std::vector<WoodPlace> placesOf(const std::vector<CTubeLines>& lines, const Wood& wood, std::size_t most, const CProgress& progress);

CWoodPatch patchOf(const WoodPlace& place, std::span<const StemMesh> stems, const Wood& wood);

/// Which closed surface a vertex was part of: by its first tube, of its generation.
std::uint32_t surfaceOf(std::span<const StemMesh> stems, const VertexSource& source);

} // namespace stromar
