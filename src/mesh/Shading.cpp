#include "stromar/mesh/Shading.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
/// Any unit vector at a right angle to a unit vector.
glm::vec3 squareTo(const glm::vec3& n) {
    const glm::vec3 other = std::abs(n.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(glm::cross(n, other));
}
} // namespace

Crown crownOf(const Meshes& meshes) {
    Bounds all{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
    const auto isLeafy = [](const auto& mesh) {
        return isLeaf(mesh->surface) || mesh->surface == Surface::Twig;
    };
    const bool leaves = std::ranges::any_of(meshes, isLeafy);
    for (const auto& mesh : meshes) {
        if (leaves && !isLeafy(mesh)) continue;
        const Bounds own = mesh->bounds();
        all = {glm::min(all.min, own.min), glm::max(all.max, own.max)};
    }
    return {(all.min + all.max) / 2.0f, glm::max((all.max - all.min) / 2.0f, 1e-6f)};
}

std::uint8_t ambientAt(const Crown& crown, const CMesh& mesh, std::size_t vertex) {
    const float outside = std::min(1.0f, glm::length((mesh.positions[vertex] - crown.centre) / crown.radii));
    const float light = kInTheMiddle + (1 - kInTheMiddle) * outside * outside;
    return static_cast<std::uint8_t>(light * static_cast<float>(mesh.looks[vertex].skyVisibility) + 0.5f);
}

glm::dvec3 sunAndShadeAt(double lit, double sunAndShade) {
    return glm::mix(glm::dvec3(1), glm::mix(glm::dvec3(0.68, 0.8, 0.76), glm::dvec3(1.06, 1.03, 0.96), lit), sunAndShade);
}

std::vector<glm::vec4> tangentsOf(const CMesh& mesh) {
    std::vector<glm::vec3> alongU(mesh.vertexCount(), glm::vec3(0)), alongV(mesh.vertexCount(), glm::vec3(0));
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const std::uint32_t* corners = &mesh.indices[t];
        const glm::vec3 e1 = mesh.positions[corners[1]] - mesh.positions[corners[0]],
                        e2 = mesh.positions[corners[2]] - mesh.positions[corners[0]];
        const glm::vec2 d1 = mesh.texCoords[corners[1]] - mesh.texCoords[corners[0]],
                        d2 = mesh.texCoords[corners[2]] - mesh.texCoords[corners[0]];
        const float turn = d1.x * d2.y - d1.y * d2.x < 0 ? -1.0f : 1.0f; // only directions matter
        for (int c = 0; c < 3; ++c) {
            alongU[corners[c]] += turn * (d2.y * e1 - d1.y * e2);
            alongV[corners[c]] += turn * (d1.x * e2 - d2.x * e1);
        }
    }
    std::vector<glm::vec4> tangents(mesh.vertexCount());
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        const glm::vec3& n = mesh.normals[v];
        glm::vec3 tangent = alongU[v] - glm::dot(n, alongU[v]) * n;
        const float length = glm::length(tangent);
        tangent = length > 1e-20f ? tangent / length : squareTo(n);
        tangents[v] = {tangent, glm::dot(glm::cross(n, tangent), alongV[v]) < 0 ? -1.0f : 1.0f};
    }
    return tangents;
}

} // namespace stromar
