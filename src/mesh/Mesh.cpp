#include "stromar/mesh/Mesh.h"
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stromar {

double CMesh::area() const {
    double area = 0;
    for (std::size_t t = 0; t < indices.size(); t += 3) {
        const glm::dvec3 a = positions[indices[t]], b = positions[indices[t + 1]], c = positions[indices[t + 2]];
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

Bounds CMesh::bounds() const {
    Bounds box{positions.front(), positions.front()};
    for (const glm::vec3& p : positions) box = {glm::min(box.min, p), glm::max(box.max, p)};
    return box;
}

std::shared_ptr<CMesh> allocateMesh(std::string name, Surface surface, std::size_t vertices, std::size_t indices) {
    auto mesh = std::make_shared<CMesh>();
    mesh->name = std::move(name);
    mesh->surface = surface;
    mesh->positions.resize(vertices);
    mesh->normals.resize(vertices);
    mesh->texCoords.resize(vertices);
    mesh->skyVisibility.resize(vertices);
    mesh->indices.resize(indices);
    return mesh;
}

} // namespace stromar
