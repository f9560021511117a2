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
    const glm::dvec3 toA = from - a;
    const double u = glm::dot(toA, p) / volume;
    if (u < 0 || u > 1) return {};
    const glm::dvec3 q = glm::cross(toA, ab);
    const double v = glm::dot(direction, q) / volume;
    if (v < 0 || u + v > 1) return {};
    return glm::dot(ac, q) / volume;
}

glm::dvec3 nearestOnTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return a;
    const glm::dvec3 bp = p - b;
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
    const glm::dvec3 cp = p - c;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
    return a + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc));
}

glm::dvec3 barycentricOf(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 u = b - a, v = c - a, w = p - a;
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), wu = glm::dot(w, u), wv = glm::dot(w, v);
    const double whole = uu * vv - uv * uv;
    if (!(whole > 0)) return glm::dvec3(1.0 / 3);
    const glm::dvec3 shares(0, std::clamp((vv * wu - uv * wv) / whole, 0.0, 1.0), std::clamp((uu * wv - uv * wu) / whole, 0.0, 1.0));
    const double others = shares.y + shares.z;
    return others > 1 ? glm::dvec3(0, shares.y / others, shares.z / others) : glm::dvec3(1 - others, shares.y, shares.z);
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
