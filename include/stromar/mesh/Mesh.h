#pragma once
#include "stromar/util/RawVector.h"
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stromar {

enum class Surface { Bark, Leaf, Blossom, Fruit, Twig, Bark1, Bark2, Bark3, Leaf2, Leaf3, Leaf4, Impostor };
inline constexpr std::array kSurfaces{Surface::Bark, Surface::Leaf,  Surface::Blossom, Surface::Fruit,
                                      Surface::Twig, Surface::Bark1, Surface::Bark2,   Surface::Bark3,
                                      Surface::Leaf2, Surface::Leaf3, Surface::Leaf4,  Surface::Impostor};
/// Of stems, by generation; deeper ones have the last.
inline constexpr std::array kBarks{Surface::Bark, Surface::Bark1, Surface::Bark2, Surface::Bark3};
constexpr Surface barkOf(std::size_t generation) { return kBarks[generation < kBarks.size() ? generation : kBarks.size() - 1]; }
constexpr bool isBark(Surface surface) { return std::ranges::find(kBarks, surface) != kBarks.end(); }

/// Of leaves, by kind.
inline constexpr std::array kLeafSurfaces{Surface::Leaf, Surface::Leaf2, Surface::Leaf3, Surface::Leaf4};
inline constexpr std::size_t kLeafKinds = kLeafSurfaces.size();
constexpr bool isLeaf(Surface surface) { return std::ranges::find(kLeafSurfaces, surface) != kLeafSurfaces.end(); }

/// What a surface shows that has no picture of its own: that of the level before, or of the first kind; of the others
/// itself.
constexpr Surface standIn(Surface surface) {
    if (isLeaf(surface)) return Surface::Leaf;
    const auto bark = std::ranges::find(kBarks, surface);
    return bark == kBarks.begin() || bark == kBarks.end() ? surface : *(bark - 1);
}

struct Bounds {
    glm::vec3 min, max;
};

/// What only a picture shows of a vertex.
struct VertexLook {
    std::uint8_t skyVisibility = 255; ///< 255: sees the whole sky as far as its own stem is concerned; 0: none
    std::uint8_t thinness = 0;        ///< of the wood: kThinnessOfHalf for each time that it is half as thick as the trunk

    static constexpr int kThinnessOfHalf = 24;
    bool operator==(const VertexLook&) const = default;
};
/// VertexLook::thinness. Radii in metres.
std::uint8_t thinnessOf(double radius, double trunk);

/// Triangles of one generation of stems, or of all leaves. Metres, z up; counter-clockwise seen from outside.
/// Vertices at the seam of the bark are doubled; leaves are flat and meant to be seen from both sides.
class CMesh {
public:
    std::string name; ///< "trunk", "branches_1", …, "leaves" or "twigs"
    Surface surface = Surface::Bark;
    RawVector<glm::vec3> positions;
    RawVector<glm::vec3> normals; ///< unit
    RawVector<glm::vec2> texCoords;
    RawVector<VertexLook> looks;
    RawVector<std::uint32_t> indices; ///< three per triangle

    std::size_t vertexCount() const { return positions.size(); }
    std::size_t triangleCount() const { return indices.size() / 3; }
    std::size_t bytes() const { return bytesOf(vertexCount(), indices.size()); }
    static constexpr std::size_t bytesOf(std::size_t vertices, std::size_t indices) {
        return vertices * (2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(VertexLook)) + indices * sizeof(std::uint32_t);
    }
    double area() const; ///< of its triangles, m²
    /// Of a mesh with vertices.
    Bounds bounds() const;
};

using Meshes = std::vector<std::shared_ptr<const CMesh>>;

/// How far along a ray it meets a triangle, in lengths of `direction` (Möller & Trumbore 1997), else nothing. May be behind.
std::optional<double> meetTriangle(const glm::dvec3& from, const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b,
                                   const glm::dvec3& c);
/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
glm::dvec3 nearestOnTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
/// Barycentric coordinates of a point in a triangle, none below 0; of one outside those of a point of its edge.
glm::dvec3 barycentricOf(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
/// A triangle on a ray.
struct TriangleHit {
    std::size_t first; ///< of its three indices
    double distance;   ///< in lengths of the ray's direction
};
/// The nearest triangle of a mesh in front. Linear in the triangles.
std::optional<TriangleHit> meetMesh(const CMesh& mesh, const glm::dvec3& from, const glm::dvec3& direction);

/// A mesh with so many vertices and indices, their values not yet set.
std::shared_ptr<CMesh> allocateMesh(std::string name, Surface surface, std::size_t vertices, std::size_t indices);

} // namespace stromar
