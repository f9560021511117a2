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

/// An index of a triangle that was taken out.
inline constexpr std::uint32_t kGone = ~std::uint32_t{0};

/// Arrays of wood have room for one part in so many more, which uniting may fill.
inline constexpr std::size_t kWoodSlack = 50;

/// The wood of all generations while it is joined. Triangles that are taken out keep their room.
struct Wood {
    std::vector<std::shared_ptr<CMesh>> meshes;
    std::vector<std::vector<VertexSource>> sources; ///< of their vertices
};

/// Triangles that follow one another in a mesh, most of them of one stem.
struct WoodBlock {
    std::uint32_t generation;
    std::size_t first, end; ///< indices
    Bounds around;
};

/// All triangles of wood that grows, by generation and place.
class CWoodBlocks {
public:
    /// Adds those that are new since. Linear in these.
    void update(const Wood& wood, const CProgress& progress);
    std::span<const WoodBlock> all() const { return m_all; }

private:
    std::vector<WoodBlock> m_all;
    std::vector<std::size_t> m_ends; ///< by generation: of its indices
};

/// Parts tubes so that no triangle is near those of two places. Those with the fewest triangles around them are chosen, as long as these are no
/// more than `most` together. Time n log m in all triangles and the tubes, and `most` for each tube.
std::vector<WoodPlace> placesOf(const std::vector<CTubeLines>& lines, std::span<const WoodBlock> blocks, const Wood& wood, std::size_t most,
                                const CProgress& progress);

CWoodPatch patchOf(const WoodPlace& place, std::span<const StemMesh> stems, const Wood& wood);

/// Which closed surface a vertex was part of: by its first tube, of its generation.
std::uint32_t surfaceOf(std::span<const StemMesh> stems, const VertexSource& source);

} // namespace stromar
