#include "stromar/mesh/Mesh.h"
#include <glm/common.hpp>

namespace stromar {

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
    mesh->openness.resize(vertices);
    mesh->indices.resize(indices);
    return mesh;
}

} // namespace stromar
