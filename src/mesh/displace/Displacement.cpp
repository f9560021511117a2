#include "stromar/mesh/Displacement.h"
#include "stromar/util/Error.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace stromar {

namespace {
using std::uint32_t;
constexpr double kAllRelief = 0.5 * VertexLook::kThinnessOfHalf; // thinness: of wood 0.7 times as thick as the trunk
constexpr double kNoRelief = 1.5 * VertexLook::kThinnessOfHalf;  // 0.35 times
constexpr double kFirstCells = 4, kAllCells = 8;                 // that a picture of the bark is wide
constexpr double kWidest = 1.5;                                  // of the mean: pictures are stretched where a trunk flares
constexpr float kLooksDown = -0.7f;                              // z of a normal
constexpr double kStep = 1.3;                                    // from the longest edge to a cell

auto ordered(const glm::vec3& p) { return std::tie(p.x, p.y, p.z); }

struct Vertex {
    glm::vec3 position, normal;
    glm::vec2 texCoord;
    VertexLook look;
    VertexSource source;
    float tile;  ///< metres that the picture of the bark is wide there
    float share; ///< of its relief that is shown
    bool divided = false; ///< whether edges to others like it are halved
    glm::vec3 way{0};
};

/// 0 at one end, 1 at the other, level at both.
double ramp(double value, double none, double all) {
    const double part = std::clamp((value - none) / (all - none), 0.0, 1.0);
    return part * part * (3 - 2 * part);
}

/// The same for both directions of an edge and for all of its copies.
Vertex middle(const Vertex& a, const Vertex& b) {
    const auto mean = [](std::uint8_t x, std::uint8_t y) { return static_cast<std::uint8_t>((x + y) / 2); };
    const glm::vec3 normal = a.normal + b.normal;
    const float length = glm::length(normal);
    return {(a.position + b.position) / 2.f,
            length > 1e-3f ? normal / length : a.normal,
            (a.texCoord + b.texCoord) / 2.f,
            {mean(a.look.skyVisibility, b.look.skyVisibility), mean(a.look.thinness, b.look.thinness)},
            ordered(a.position) < ordered(b.position) ? a.source : b.source,
            (a.tile + b.tile) / 2,
            (a.share + b.share) / 2,
            true};
}

/// The triangles of a generation while they are divided.
class CDividedMesh {
public:
    CDividedMesh(const CMesh& mesh, const std::vector<VertexSource>& sources) : m_triangles(mesh.indices.begin(), mesh.indices.end()) {
        for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
            m_vertices.push_back({mesh.positions[v], mesh.normals[v], mesh.texCoords[v], mesh.looks[v], sources[v], 0, 0});
    }

    std::vector<Vertex>& vertices() { return m_vertices; }
    const std::vector<Vertex>& vertices() const { return m_vertices; }
    const std::vector<uint32_t>& triangles() const { return m_triangles; }

    /// All sides of triangles that show some relief are halved: of some of them alone the others would never end.
    void markDivided() {
        for (std::size_t t = 0; t < m_triangles.size(); t += 3) {
            const std::span<const uint32_t> corners(&m_triangles[t], 3);
            if (std::ranges::none_of(corners, [&](uint32_t corner) { return m_vertices[corner].share > 0; })) continue;
            for (const uint32_t corner : corners) m_vertices[corner].divided = true;
        }
    }
    void start() { m_open = std::exchange(m_triangles, {}); }
    std::size_t triangleCount() const { return (m_triangles.size() + m_open.size()) / 3; }
    double longest() const {
        double longest = 0;
        for (std::size_t t = 0; t < m_open.size(); t += 3)
            for (std::size_t side = 0; side < 3; ++side) longest = std::max(longest, length(m_open[t + side], m_open[t + (side + 1) % 3]));
        return longest;
    }
    /// Square metres of the triangles all of whose sides are halved.
    double dividedArea() const {
        double area = 0;
        for (std::size_t t = 0; t < m_open.size(); t += 3) {
            const Vertex &a = m_vertices[m_open[t]], &b = m_vertices[m_open[t + 1]], &c = m_vertices[m_open[t + 2]];
            if (a.divided && b.divided && c.divided) area += 0.5 * double(glm::length(glm::cross(b.position - a.position, c.position - a.position)));
        }
        return area;
    }
    /// Halves every edge longer than `longest` once; triangles without one longer than `cell` are done. False: there was none.
    /// Stops beyond the limit.
    bool halve(double longest, double cell, const DisplacementLimit& limit) {
        const std::size_t before = triangleCount();
        const std::vector<uint32_t> open = std::exchange(m_open, {});
        m_middles = {};
        for (std::size_t t = 0; t < open.size() && triangleCount() <= limit.triangles; t += 3)
            divide({open[t], open[t + 1], open[t + 2]}, longest, cell);
        return triangleCount() > before;
    }

    void finish() { m_triangles.insert(m_triangles.end(), m_open.begin(), m_open.end()); }

private:
    using Corners = std::array<uint32_t, 3>;

    /// 0 for an edge that stays.
    double length(uint32_t a, uint32_t b) const {
        const Vertex &one = m_vertices[a], &other = m_vertices[b];
        return one.divided && other.divided ? glm::distance(one.position, other.position) : 0;
    }

    uint32_t middleOf(uint32_t a, uint32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [found, isNew] = m_middles.try_emplace(std::uint64_t(low) << 32 | high, static_cast<uint32_t>(m_vertices.size()));
        if (isNew) m_vertices.push_back(middle(m_vertices[low], m_vertices[high]));
        return found->second;
    }

    static void add(std::vector<uint32_t>& to, uint32_t a, uint32_t b, uint32_t c) { to.insert(to.end(), {a, b, c}); }
    void add(uint32_t a, uint32_t b, uint32_t c) { add(m_open, a, b, c); }

    float distance(uint32_t a, uint32_t b) const { return glm::distance(m_vertices[a].position, m_vertices[b].position); }

    void divide(const Corners& corners, double longest, double cell) {
        std::array<double, 3> lengths; // of the side after each corner
        for (std::size_t i = 0; i < 3; ++i) lengths[i] = length(corners[i], corners[(i + 1) % 3]);
        if (*std::ranges::max_element(lengths) <= cell) return add(m_triangles, corners[0], corners[1], corners[2]);
        const auto halved = [&](std::size_t side) { return lengths[side % 3] > longest; };
        const int count = halved(0) + halved(1) + halved(2);
        std::size_t first = 0; // so that a lone halved side comes first, and a lone whole one last
        while (count == 1 ? !halved(first) : count == 2 && halved(first + 2)) ++first;
        const uint32_t a = corners[first], b = corners[(first + 1) % 3], c = corners[(first + 2) % 3];
        if (count == 0) return add(a, b, c);
        const uint32_t ab = middleOf(a, b);
        if (count == 1) {
            add(a, ab, c);
            return add(ab, b, c);
        }
        const uint32_t bc = middleOf(b, c);
        if (count == 2) {
            add(ab, b, bc);
            const bool shorter = distance(a, bc) < distance(ab, c);
            add(a, ab, shorter ? bc : c);
            return shorter ? add(a, bc, c) : add(ab, bc, c);
        }
        const uint32_t ca = middleOf(c, a);
        add(a, ab, ca);
        add(ab, b, bc);
        add(ca, bc, c);
        add(ab, bc, ca);
    }

    std::vector<Vertex> m_vertices;
    std::vector<uint32_t> m_triangles, m_open; ///< that are done, that are to be divided
    std::unordered_map<std::uint64_t, uint32_t> m_middles;
};

/// Vertices of all generations that are at the same place.
class CPlaces {
public:
    explicit CPlaces(std::vector<CDividedMesh>& wood) {
        for (CDividedMesh& mesh : wood)
            for (Vertex& vertex : mesh.vertices()) m_sorted.push_back(&vertex);
        std::stable_sort(m_sorted.begin(), m_sorted.end(),
                         [](const Vertex* a, const Vertex* b) { return ordered(a->position) < ordered(b->position); });
    }

    template <typename Visit>
    void visit(Visit&& visit) const {
        for (auto first = m_sorted.begin(); first != m_sorted.end();) {
            auto last = first;
            while (last != m_sorted.end() && (*last)->position == (*first)->position) ++last;
            visit(std::span<Vertex* const>(first, last));
            first = last;
        }
    }

private:
    std::vector<Vertex*> m_sorted;
};

/// Of a triangle or more: in square metres, and in pictures of bark.
struct Areas {
    double metres = 0, pictures = 0;
    double tile() const { return pictures > 0 ? std::sqrt(metres / pictures) : 0; }
};

/// The sums of all triangles around a vertex are left in `tile` and `share`.
Areas addAreas(CDividedMesh& mesh) {
    Areas all;
    std::vector<Vertex>& vertices = mesh.vertices();
    const std::vector<uint32_t>& corners = mesh.triangles();
    for (std::size_t t = 0; t < corners.size(); t += 3) {
        const Vertex &a = vertices[corners[t]], &b = vertices[corners[t + 1]], &c = vertices[corners[t + 2]];
        const float metres = glm::length(glm::cross(b.position - a.position, c.position - a.position));
        const glm::vec2 u = b.texCoord - a.texCoord, v = c.texCoord - a.texCoord;
        const float pictures = std::abs(u.x * v.y - u.y * v.x);
        all.metres += metres;
        all.pictures += pictures;
        for (std::size_t i = 0; i < 3; ++i) {
            vertices[corners[t + i]].tile += metres;
            vertices[corners[t + i]].share += pictures;
        }
    }
    return all;
}

/// How wide the pictures of barks are at every place, how much of their relief is shown there, and what is divided for it.
void measure(std::vector<CDividedMesh>& wood, const BarkReliefs& reliefs, double cell) {
    double widest = 0;
    for (std::size_t g = 0; g < wood.size(); ++g)
        if (reliefs[g]) widest = std::max(widest, kWidest * addAreas(wood[g]).tile());
    const CPlaces places(wood);
    places.visit([&](std::span<Vertex* const> copies) {
        Areas around;
        int thinness = copies.front()->look.thinness; // of the thickest: where a branch stands, the wall decides
        for (const Vertex* copy : copies) {
            around.metres += copy->tile;
            around.pictures += copy->share;
            thinness = std::min<int>(thinness, copy->look.thinness);
        }
        const double tile = std::min(widest, around.tile());
        for (Vertex* copy : copies) {
            copy->tile = static_cast<float>(tile);
            copy->share = static_cast<float>(ramp(thinness, kNoRelief, kAllRelief) * ramp(tile / cell, kFirstCells, kAllCells));
        }
    });
    for (CDividedMesh& mesh : wood) mesh.markDivided();
    places.visit([](std::span<Vertex* const> copies) {
        const bool any = std::ranges::any_of(copies, &Vertex::divided);
        for (Vertex* copy : copies) copy->divided = any;
    });
}

/// More triangles than the limit, or a surface that cells cannot cover with fewer.
void refuseMore(const std::vector<CDividedMesh>& wood, double cell, const DisplacementLimit& limit) {
    const double largest = std::sqrt(3.0) / 4 * cell * cell; // of the triangles whose sides are no longer than a cell
    double count = 0, least = 0;
    for (const CDividedMesh& mesh : wood) {
        count += double(mesh.triangleCount());
        least += mesh.dividedArea() / largest;
    }
    if (std::max(count, least) > double(limit.triangles))
        throw CError(translated(
            NC_("stromar",
                "displacement in cells of %1 m would make more than %2 million triangles; choose larger cells"),
            cell, std::floor(double(limit.triangles) / 1e5) / 10));
}

/// The longest edges first, which keeps thin triangles from being cut into thinner ones.
void divide(std::vector<CDividedMesh>& wood, double cell, const DisplacementLimit& limit, const CProgress& progress) {
    double longest = cell;
    for (CDividedMesh& mesh : wood) {
        mesh.start();
        longest = std::max(longest, mesh.longest());
    }
    refuseMore(wood, cell, limit);
    while (longest > cell) {
        longest = std::max(cell, longest / kStep);
        for (CDividedMesh& mesh : wood)
            while (mesh.halve(longest, cell, limit)) {
                refuseMore(wood, cell, limit);
                progress.poll();
            }
    }
    for (CDividedMesh& mesh : wood) mesh.finish();
}

/// Copies move as their mean does. What stands on the ground stays there.
void moveOut(std::vector<CDividedMesh>& wood, const BarkReliefs& reliefs) {
    for (std::size_t g = 0; g < wood.size(); ++g)
        for (Vertex& vertex : wood[g].vertices())
            if (reliefs[g] && vertex.share > 0)
                vertex.way = static_cast<float>(reliefs[g]->at(vertex.texCoord)) * vertex.tile * vertex.share * vertex.normal;
    CPlaces(wood).visit([](std::span<Vertex* const> copies) {
        const bool onGround = copies.front()->position.z <= 0;
        glm::vec3 sum(0);
        float count = 0;
        for (const Vertex* copy : copies) {
            if (onGround && copy->normal.z < kLooksDown) continue; // of the lid that closes the trunk
            sum += copy->way;
            ++count;
        }
        if (count == 0) return;
        if (onGround) sum.z = 0;
        for (Vertex* copy : copies) copy->position += sum / count;
    });
}

std::shared_ptr<const CMesh> asMesh(const CMesh& before, const CDividedMesh& divided) {
    const std::vector<Vertex>& vertices = divided.vertices();
    auto mesh = allocateMesh(before.name, before.surface, vertices.size(), divided.triangles().size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        mesh->positions[v] = vertices[v].position;
        mesh->normals[v] = vertices[v].normal;
        mesh->texCoords[v] = vertices[v].texCoord;
        mesh->looks[v] = vertices[v].look;
    }
    std::ranges::copy(divided.triangles(), mesh->indices.begin());
    return mesh;
}
} // namespace

CBarkRelief::CBarkRelief(std::vector<std::uint8_t> heights, int width, int height, double depth)
    : m_heights(std::move(heights)), m_width(width), m_height(height), m_depth(depth) {
    m_mean = std::accumulate(m_heights.begin(), m_heights.end(), 0.0) / double(m_heights.size());
}

double CBarkRelief::height(std::int64_t x, std::int64_t y) const {
    const auto wrapped = [](std::int64_t at, int size) { return static_cast<std::size_t>((at % size + size) % size); };
    return m_heights[wrapped(y, m_height) * static_cast<std::size_t>(m_width) + wrapped(x, m_width)];
}

double CBarkRelief::at(const glm::vec2& texCoord) const {
    const double x = double(texCoord.x) * m_width - 0.5, y = (1 - double(texCoord.y)) * m_height - 0.5;
    const auto left = static_cast<std::int64_t>(std::floor(x)), top = static_cast<std::int64_t>(std::floor(y));
    const double right = x - double(left), low = y - double(top);
    const double upper = glm::mix(height(left, top), height(left + 1, top), right);
    const double lower = glm::mix(height(left, top + 1), height(left + 1, top + 1), right);
    return m_depth * (glm::mix(upper, lower, low) - m_mean) / 255;
}

DisplacedStems displaceStems(const Meshes& stems, const std::vector<std::vector<VertexSource>>& sources, const BarkReliefs& reliefs,
                             double cell, const DisplacementLimit& limit, const CProgress& progress) {
    std::vector<CDividedMesh> wood;
    for (std::size_t g = 0; g < stems.size(); ++g) wood.emplace_back(*stems[g], sources[g]);
    measure(wood, reliefs, cell);
    divide(wood, cell, limit, progress);
    moveOut(wood, reliefs);
    DisplacedStems displaced;
    for (std::size_t g = 0; g < stems.size(); ++g) {
        progress.poll();
        displaced.meshes.push_back(asMesh(*stems[g], wood[g]));
        std::vector<VertexSource>& own = displaced.sources.emplace_back();
        for (const Vertex& vertex : wood[g].vertices()) own.push_back(vertex.source);
    }
    return displaced;
}

} // namespace stromar
