#include "stromar/mesh/Mesh.h"
#include <algorithm>
#include <cmath>
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

std::optional<double> meetTriangle(const glm::dvec3& from, const glm::dvec3& direction, const glm::dvec3& a,
                                   const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
    const double volume = glm::dot(ab, p);
    if (std::abs(volume) < 1e-300) return {};
    const glm::dvec3 toA = from - a, q = glm::cross(toA, ab);
    const double u = glm::dot(toA, p) / volume, v = glm::dot(direction, q) / volume;
    if (u < 0 || v < 0 || u + v > 1) return {};
    return glm::dot(ac, q) / volume;
}

std::optional<TriangleHit> meetMesh(const CMesh& mesh, const glm::dvec3& from, const glm::dvec3& direction) {
    std::optional<TriangleHit> nearest;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const auto corner = [&](std::size_t c) { return glm::dvec3(mesh.positions[mesh.indices[t + c]]); };
        const auto met = meetTriangle(from, direction, corner(0), corner(1), corner(2));
        if (met && *met > 0 && (!nearest || *met < nearest->distance)) nearest = TriangleHit{t, *met};
    }
    return nearest;
}

std::uint8_t thinnessOf(double radius, double trunk) {
    if (radius <= 0 || trunk <= 0) return 255;
    return static_cast<std::uint8_t>(std::clamp(VertexLook::kThinnessOfHalf * std::log2(trunk / radius) + 0.5, 0.0, 255.0));
}

std::shared_ptr<CMesh> allocateMesh(std::string name, Surface surface, std::size_t vertices, std::size_t indices) {
    auto mesh = std::make_shared<CMesh>();
    mesh->name = std::move(name);
    mesh->surface = surface;
    mesh->positions.resize(vertices);
    mesh->normals.resize(vertices);
    mesh->texCoords.resize(vertices);
    mesh->looks.resize(vertices);
    mesh->indices.resize(indices);
    return mesh;
}

} // namespace stromar
