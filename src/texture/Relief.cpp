#include "Relief.h"
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace stromar {

TextureMaps squareMaps(int size) {
    TextureMaps maps;
    maps.width = maps.height = size;
    const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    maps.albedo.resize(pixels);
    maps.normal.resize(pixels);
    maps.roughness.resize(pixels);
    maps.height01.resize(pixels);
    return maps;
}

void addNormals(TextureMaps& maps, const std::vector<double>& heights, double relief, const CProgress& progress) {
    const int size = maps.width;
    const double slope = relief * size / 2;
    const auto height = [&](int x, int y) { return heights[maps.at((x + size) % size, (y + size) % size)]; };
    forEachPixel(size, progress, [&](int x, int y) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(slope * (height(x - 1, y) - height(x + 1, y)),
                                                       slope * (height(x, y + 1) - height(x, y - 1)), 1.0));
        maps.normal[maps.at(x, y)] = {toByte(127.5 + 127.5 * n.x), toByte(127.5 + 127.5 * n.y),
                                      toByte(127.5 + 127.5 * n.z)};
    });
}

} // namespace stromar
