#include "mesh/MeshCheck.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <tuple>

namespace stromar::test {

namespace {
bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string vertexFault(const CMesh& mesh, std::size_t v) {
    if (!finite(mesh.positions[v])) return "position is no number";
    if (!finite(mesh.normals[v])) return "normal is no number";
    if (std::abs(glm::length(glm::dvec3(mesh.normals[v])) - 1) > 1e-3) return "normal is not unit";
    if (!std::isfinite(mesh.texCoords[v].x) || !std::isfinite(mesh.texCoords[v].y))
        return "texture coordinate is no number";
    return {};
}

glm::dvec3 corner(const CMesh& mesh, std::size_t index) { return glm::dvec3(mesh.positions[mesh.indices[index]]); }

glm::dvec3 faceNormal(const CMesh& mesh, std::size_t t) {
    const glm::dvec3 a = corner(mesh, t);
    return glm::cross(corner(mesh, t + 1) - a, corner(mesh, t + 2) - a);
}

using Place = std::array<float, 3>;
Place placeOf(const glm::vec3& p) { return {p.x, p.y, p.z}; }

/// For each vertex of the tube the number of its position.
std::vector<std::uint32_t> weld(const CMesh& mesh, const TubeRange& tube) {
    std::vector<std::uint32_t> order(tube.vertexCount), number(tube.vertexCount);
    std::iota(order.begin(), order.end(), 0u);
    const auto place = [&](std::uint32_t v) { return placeOf(mesh.positions[tube.firstVertex + v]); };
    std::ranges::sort(order, {}, place);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && place(order[i]) != place(order[i - 1])) ++count;
        number[order[i]] = count;
    }
    return number;
}

std::string at(const std::string& what, std::size_t where) { return what + " " + std::to_string(where); }

template <typename Array>
bool sameArray(const Array& a, const Array& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

} // namespace

std::string arrayFault(const CMesh& mesh) {
    if (mesh.normals.size() != mesh.vertexCount() || mesh.texCoords.size() != mesh.vertexCount())
        return "arrays of different length";
    if (mesh.indices.size() % 3 != 0) return "a triangle is incomplete";
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
        if (const std::string fault = vertexFault(mesh, v); !fault.empty()) return at(fault + ": vertex", v);
    std::vector<bool> used(mesh.vertexCount(), false);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (mesh.indices[i] >= mesh.vertexCount()) return at("index beyond the end:", i);
        used[mesh.indices[i]] = true;
    }
    const auto idle = std::ranges::find(used, false);
    return idle == used.end() ? std::string()
                              : at("no triangle uses vertex", static_cast<std::size_t>(idle - used.begin()));
}

std::string triangleFault(const CMesh& mesh) {
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const std::uint32_t a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
        if (a == b || b == c || c == a) return at("the same corner twice: triangle", t / 3);
        if (!(glm::length(faceNormal(mesh, t)) > 0)) return at("no area: triangle", t / 3);
    }
    return {};
}

std::vector<TubeRange> tubeRanges(const MeshPlan& plan) {
    std::vector<TubeRange> ranges;
    for (const Tube& tube : plan.tubes)
        ranges.push_back({tube.firstVertex, tube.vertexCount(), tube.firstIndex, tube.indexCount()});
    return ranges;
}

std::string closednessFault(const CMesh& mesh, const TubeRange& tube) {
    const std::vector<std::uint32_t> number = weld(mesh, tube);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t i = 0; i < tube.indexCount; ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const std::size_t a = mesh.indices[tube.firstIndex + i] - tube.firstVertex;
        const std::size_t b = mesh.indices[tube.firstIndex + next] - tube.firstVertex;
        if (a >= tube.vertexCount || b >= tube.vertexCount) return "a triangle reaches into another tube";
        edges.emplace_back(number[a], number[b]);
    }
    std::ranges::sort(edges);
    if (std::ranges::adjacent_find(edges) != edges.end()) return "an edge is used twice in one direction";
    const auto hasTwin = [&](const auto& edge) {
        return std::ranges::binary_search(edges, std::pair(edge.second, edge.first));
    };
    return std::ranges::all_of(edges, hasTwin) ? std::string() : "an edge is used in one direction only";
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

std::size_t countTiltedNormals(const CMesh& mesh) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::dvec3 face = faceNormal(mesh, t);
        const auto tilted = [&](std::size_t i) {
            return glm::dot(face, glm::dvec3(mesh.normals[mesh.indices[i]])) <= 0;
        };
        if (tilted(t) || tilted(t + 1) || tilted(t + 2)) ++count;
    }
    return count;
}

bool sameBytes(const CMesh& a, const CMesh& b) {
    return a.name == b.name && a.surface == b.surface && sameArray(a.positions, b.positions) &&
           sameArray(a.normals, b.normals) && sameArray(a.texCoords, b.texCoords) && sameArray(a.indices, b.indices);
}

} // namespace stromar::test
