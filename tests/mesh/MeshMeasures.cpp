#include "mesh/MeshMeasures.h"
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <map>

namespace stromar::test {

namespace {
glm::dvec3 corner(const CMesh& mesh, std::size_t index) { return glm::dvec3(mesh.positions[mesh.indices[index]]); }

template <typename Array>
bool sameArray(const Array& a, const Array& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}
} // namespace

std::string inWords(const MeshFaults& faults) {
    std::string words;
    for (const MeshCheck& check : meshChecks())
        if (faults.*check.count > 0)
            words += std::to_string(faults.*check.count) + " " + std::string(check.name) + "; ";
    return words;
}

double signedVolume(const CMesh& mesh, std::size_t firstIndex, std::size_t indexCount) {
    if (indexCount == 0) return 0;
    const glm::dvec3 origin = corner(mesh, firstIndex); // near, so that little is lost to cancellation
    double volume = 0;
    for (std::size_t t = firstIndex; t < firstIndex + indexCount; t += 3)
        volume +=
            glm::dot(corner(mesh, t) - origin, glm::cross(corner(mesh, t + 1) - origin, corner(mesh, t + 2) - origin)) /
            6;
    return volume;
}

double signedVolume(const std::vector<std::shared_ptr<const CMesh>>& meshes) {
    double sixfold = 0;
    for (const auto& mesh : meshes)
        for (std::size_t t = 0; t < mesh->indices.size(); t += 3)
            sixfold += glm::dot(corner(*mesh, t), glm::cross(corner(*mesh, t + 1), corner(*mesh, t + 2)));
    return sixfold / 6;
}

std::map<MeshEdge, std::size_t> trianglesByEdge(const CMesh& mesh) {
    std::map<MeshEdge, std::size_t> edges;
    const auto placeOf = [&](std::size_t i) {
        const glm::vec3& place = mesh.positions[mesh.indices[i]];
        return std::array{place.x, place.y, place.z};
    };
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) edges[{placeOf(i), placeOf(i % 3 == 2 ? i - 2 : i + 1)}] = i - i % 3;
    return edges;
}

bool sameBytes(const CMesh& a, const CMesh& b) {
    return a.name == b.name && a.surface == b.surface && sameArray(a.positions, b.positions) &&
           sameArray(a.normals, b.normals) && sameArray(a.texCoords, b.texCoords) &&
           sameArray(a.looks, b.looks) && sameArray(a.indices, b.indices);
}

std::size_t invertedSurfaces(const MeshPlan& plan, const CMesh& mesh) {
    std::size_t inverted = 0;
    for (const std::span<const Tube> tubes : surfacesOf(plan)) {
        const std::size_t first = tubes.front().firstIndex, end = tubes.back().firstIndex + tubes.back().indexCount();
        if (!(signedVolume(mesh, first, end - first) > 0)) ++inverted;
    }
    return inverted;
}

namespace {
using Point = std::array<long, 3>;
Point rounded(const glm::vec3& p) { return {std::lround(p.x * 1e5), std::lround(p.y * 1e5), std::lround(p.z * 1e5)}; }
} // namespace

std::size_t openEdges(const std::vector<const CMesh*>& meshes) {
    std::map<std::pair<Point, Point>, int> balance;
    for (const CMesh* mesh : meshes)
        for (std::size_t t = 0; t < mesh->indices.size(); t += 3)
            for (std::size_t c = 0; c < 3; ++c) {
                const Point a = rounded(mesh->positions[mesh->indices[t + c]]),
                            b = rounded(mesh->positions[mesh->indices[t + (c + 1) % 3]]);
                if (a < b) ++balance[{a, b}];
                if (b < a) --balance[{b, a}];
            }
    std::size_t open = 0;
    for (const auto& [edge, sum] : balance) open += sum != 0;
    return open;
}

} // namespace stromar::test
