#pragma once
#include "stromar/mesh/JoinedStems.h"

namespace stromar {

/// How high a bark stands out, as its picture tells. Immutable.
class CBarkRelief {
public:
    /// `heights`: 255 the highest, rows from the top. `depth`: from 0 to 255, in widths of the picture on the stem.
    CBarkRelief(std::vector<std::uint8_t> heights, int width, int height, double depth);

    /// About its mean, in widths of the picture; between pixels bilinear, and repeated.
    double at(const glm::vec2& texCoord) const;

private:
    double height(std::int64_t x, std::int64_t y) const;

    std::vector<std::uint8_t> m_heights;
    int m_width, m_height;
    double m_depth, m_mean = 0;
};

/// By generation; null: its bark is flat.
using BarkReliefs = std::vector<std::shared_ptr<const CBarkRelief>>;

/// What displacement may make.
struct DisplacementLimit {
    std::size_t triangles;
};

struct DisplacedStems {
    Meshes meshes;                                  ///< by generation
    std::vector<std::vector<VertexSource>> sources; ///< of their vertices; new ones move like an end of the edge they divide
};

/// Wood whose bark stands out of its walls. Edges are halved until none is longer than `cell`, metres, and every vertex is moved along
/// its normal by its bark's relief: all of it on wood 0.7 times as thick as the trunk, nothing below 0.35, or where a picture of the
/// bark is less than four cells wide. Equal positions stay equal: what was closed is closed afterwards. Normals stay those of the
/// smooth wood, because the pictures of normals show the same relief. Cost: about a second for a million triangles. Same result for
/// any number of threads. Throws CError beyond the limit, and CCancelled.
DisplacedStems displaceStems(const Meshes& stems, const std::vector<std::vector<VertexSource>>& sources, const BarkReliefs& reliefs,
                             double cell, const DisplacementLimit& limit, const CProgress& progress);

} // namespace stromar
