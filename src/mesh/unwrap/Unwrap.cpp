#include "stromar/mesh/Unwrap.h"
#include "unwrap/Charts.h"
#include "unwrap/Packing.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr double kGap = 1.0 / 512, kGaps = 0.25; // of the square; of its side, all gaps side by side

glm::vec2 placeOf(glm::dvec2 p, const Packing& packing) {
    p *= packing.scale;
    return glm::vec2(packing.corner + (packing.turned ? glm::dvec2(p.y, p.x) : p));
}

/// A mesh with the places of its charts.
Unwrapped unwrapped(const CMesh& mesh, const std::vector<Chart>& charts, const Packing* packings) {
    constexpr std::uint32_t kUncut = UINT32_MAX;
    Unwrapped all;
    all.indices.resize(mesh.indices.size());
    struct Copy {
        std::uint32_t chart = kUncut, vertex = 0;
    };
    std::vector<Copy> last(mesh.vertexCount()); // of each vertex
    for (std::uint32_t c = 0; c < charts.size(); ++c)
        for (std::size_t i = 0; i < charts[c].corners.size(); ++i) {
            const std::size_t place = 3 * std::size_t{charts[c].triangles[i / 3]} + i % 3;
            Copy& copy = last[mesh.indices[place]];
            if (copy.chart != c) {
                copy = {c, static_cast<std::uint32_t>(all.sources.size())};
                all.sources.push_back(mesh.indices[place]);
                all.texCoords.push_back(placeOf(charts[c].corners[i], packings[c]));
            }
            all.indices[place] = copy.vertex;
        }
    return all;
}
} // namespace

std::vector<Unwrapped> unwrap(std::span<const std::shared_ptr<const CMesh>> meshes, const CProgress& progress) {
    std::vector<std::vector<Chart>> charts;
    std::vector<glm::dvec2> sizes;
    for (const auto& mesh : meshes) {
        charts.push_back(chartsOf(*mesh, progress));
        for (const Chart& chart : charts.back()) sizes.push_back(chart.size);
    }
    progress.poll();
    const std::vector<Packing> packings = packed(sizes, std::min(kGap, kGaps / std::sqrt(double(std::max<std::size_t>(1, sizes.size())))));
    std::vector<Unwrapped> all;
    const Packing* next = packings.data();
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        all.push_back(unwrapped(*meshes[i], charts[i], next));
        next += charts[i].size();
    }
    return all;
}

} // namespace stromar
