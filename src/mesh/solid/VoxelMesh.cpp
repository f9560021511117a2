#include "stromar/mesh/VoxelMesh.h"
#include "solid/WoodPieces.h"
#include "stem/FrontNormals.h"
#include "stromar/util/Error.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <sstream>
#include <unordered_map>

namespace stromar {

namespace {
constexpr double kThinnest = 0.9;   // cubes: the radius that keeps the thinnest wood whole
constexpr double kLongest = 4;      // cubes, of a piece of wood
constexpr float kOutside = 1e9f;
constexpr double kFromCorner = 0.05; // of an edge, that a vertex keeps off its ends

// The six tetrahedra about a cube's diagonal (Kuhn): corners by the bits x, y, z. Neighbouring cubes cut their common face alike.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

using GridPoint = glm::vec<3, std::int64_t>;

/// With three digits.
std::string rounded(double value) {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
}

/// The grid of a solid: points `size` apart.
struct Grid {
    glm::dvec3 origin;
    double size;
    GridPoint count; ///< of points

    glm::dvec3 pointAt(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return origin + size * glm::dvec3(double(x), double(y), double(z));
    }
};

Grid gridAround(const std::vector<WoodPiece>& pieces, double size) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const WoodPiece& piece : pieces) {
        low = glm::min(low, glm::min(piece.from, piece.to) - piece.maxRadius());
        high = glm::max(high, glm::max(piece.from, piece.to) + piece.maxRadius());
    }
    const glm::dvec3 count = glm::ceil((high - low) / size) + 3.0;
    if (const double voxels = count.x * count.y * count.z; !(voxels <= kMaxVoxels))
        throw CError(translated(NC_("stromar", "a solid of %1 million voxels is too large; voxels of %2 m would do"),
                                rounded(voxels / 1e6), rounded(size * std::cbrt(voxels / kMaxVoxels) * 1.05)));
    return {low - 1.5 * size, size, GridPoint(count)};
}

/// Marches through the layers of a grid.
class CSolidMaker {
public:
    CSolidMaker(std::vector<WoodPiece> pieces, const Grid& grid)
        : m_pieces(std::move(pieces)), m_grid(grid),
          m_low(static_cast<std::size_t>(grid.count.x * grid.count.y), kOutside), m_high(m_low) {
        std::ranges::sort(m_pieces, {}, [](const WoodPiece& piece) { return lowest(piece); });
    }

    std::shared_ptr<CMesh> make(const CProgress& progress) {
        fill(m_high, 0);
        for (std::int64_t z = 1; z < m_grid.count.z; ++z) {
            progress.poll();
            m_low.swap(m_high);
            fill(m_high, z);
            march(z - 1);
            std::erase_if(m_vertices, [&](const auto& vertex) { return vertex.first.layer < z; });
        }
        return mesh();
    }

private:
    /// An edge of a tetrahedron, by its lower grid point and which of the seven directions it has.
    struct EdgeKey {
        std::int64_t layer;
        std::uint64_t edge;
        bool operator==(const EdgeKey&) const = default;
    };
    struct EdgeHash {
        std::size_t operator()(const EdgeKey& key) const {
            return std::hash<std::uint64_t>()(key.edge ^ static_cast<std::uint64_t>(key.layer) << 61);
        }
    };
    struct Corner {
        GridPoint at;
        float value;
    };

    static double lowest(const WoodPiece& piece) { return std::min(piece.from.z, piece.to.z) - piece.maxRadius(); }
    static double highest(const WoodPiece& piece) { return std::max(piece.from.z, piece.to.z) + piece.maxRadius(); }

    std::size_t indexOf(std::int64_t x, std::int64_t y) const { return static_cast<std::size_t>(y * m_grid.count.x + x); }

    /// How far a layer's points are outside of the wood.
    void fill(std::vector<float>& layer, std::int64_t z) {
        std::ranges::fill(layer, kOutside);
        const double height = m_grid.pointAt(0, 0, z).z, reach = 2 * m_grid.size;
        for (; m_next < m_pieces.size() && lowest(m_pieces[m_next]) - reach <= height; ++m_next) m_active.push_back(m_next);
        std::erase_if(m_active, [&](std::size_t p) { return highest(m_pieces[p]) + reach < height; });
        for (const std::size_t p : m_active) draw(m_pieces[p], layer, z, reach);
    }

    void draw(const WoodPiece& piece, std::vector<float>& layer, std::int64_t z, double reach) const {
        const double around = piece.maxRadius() + reach;
        const glm::dvec3 low = (glm::min(piece.from, piece.to) - around - m_grid.origin) / m_grid.size;
        const glm::dvec3 high = (glm::max(piece.from, piece.to) + around - m_grid.origin) / m_grid.size;
        const auto first = [](double v) { return std::max<std::int64_t>(0, std::int64_t(std::ceil(v))); };
        for (std::int64_t y = first(low.y); y <= std::min(m_grid.count.y - 1, std::int64_t(high.y)); ++y)
            for (std::int64_t x = first(low.x); x <= std::min(m_grid.count.x - 1, std::int64_t(high.x)); ++x) {
                float& value = layer[indexOf(x, y)];
                value = std::min(value, static_cast<float>(piece.distanceTo(m_grid.pointAt(x, y, z))));
            }
    }

    void march(std::int64_t z) {
        for (std::int64_t y = 0; y + 1 < m_grid.count.y; ++y)
            for (std::int64_t x = 0; x + 1 < m_grid.count.x; ++x) {
                std::array<Corner, 8> corners;
                int inside = 0;
                for (int c = 0; c < 8; ++c) {
                    const GridPoint at(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2 & 1));
                    const float value = (c & 4 ? m_high : m_low)[indexOf(at.x, at.y)];
                    corners[static_cast<std::size_t>(c)] = {at, value};
                    inside += value < 0;
                }
                if (inside == 0 || inside == 8) continue;
                for (const auto& own : kTetrahedra)
                    cut({corners[std::size_t(own[0])], corners[std::size_t(own[1])], corners[std::size_t(own[2])],
                         corners[std::size_t(own[3])]});
            }
    }

    /// All tetrahedra of the table have the same hand: seen from their first corner the others run clockwise.
    void cut(const std::array<Corner, 4>& corners) {
        std::array<std::size_t, 4> order{0, 1, 2, 3}; // those inside first, by an even number of swaps
        const auto isInside = [&](std::size_t c) { return corners[order[c]].value < 0; };
        int inside = 0;
        for (std::size_t c = 0; c < 4; ++c) inside += isInside(c);
        if (inside == 0 || inside == 4) return;
        bool odd = false;
        for (std::size_t to = 0; to < static_cast<std::size_t>(inside); ++to)
            for (std::size_t from = to; from < 4; ++from)
                if (isInside(from)) {
                    if (from != to) odd = !odd, std::swap(order[from], order[to]);
                    break;
                }
        const auto on = [&](std::size_t a, std::size_t b) { return vertexOn(corners[order[a]], corners[order[b]]); };
        if (inside == 1) return add(on(0, 1), on(0, 2), on(0, 3), odd);
        if (inside == 3) return add(on(3, 0), on(3, 1), on(3, 2), odd);
        const std::uint32_t a = on(0, 2), b = on(0, 3), c = on(1, 3), d = on(1, 2);
        add(a, b, c, odd);
        add(a, c, d, odd);
    }

    std::uint32_t vertexOn(const Corner& one, const Corner& other) {
        const auto sum = [](const Corner& corner) { return corner.at.x + corner.at.y + corner.at.z; };
        const bool swap = sum(other) < sum(one); // along Kuhn's edges coordinates only rise
        const Corner &low = swap ? other : one, &high = swap ? one : other;
        const GridPoint way = high.at - low.at;
        const auto direction = static_cast<std::uint64_t>(way.x + 2 * way.y + 4 * way.z);
        const EdgeKey key{low.at.z, indexOf(low.at.x, low.at.y) * 8 + direction};
        const auto [found, isNew] = m_vertices.try_emplace(key, static_cast<std::uint32_t>(m_positions.size()));
        if (isNew) {
            const double exact = double(low.value) / (double(low.value) - double(high.value));
            const double share = std::clamp(exact, kFromCorner, 1 - kFromCorner);
            m_positions.push_back(glm::vec3(glm::mix(m_grid.pointAt(low.at.x, low.at.y, low.at.z),
                                                     m_grid.pointAt(high.at.x, high.at.y, high.at.z), share)));
        }
        return found->second;
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
        for (const std::uint32_t v : {a, turned ? c : b, turned ? b : c}) m_indices.push_back(v);
    }

    std::shared_ptr<CMesh> mesh() const {
        auto mesh = allocateMesh("solid", Surface::Bark, m_positions.size(), m_indices.size());
        std::ranges::copy(m_positions, mesh->positions.begin());
        std::ranges::copy(m_indices, mesh->indices.begin());
        std::ranges::fill(mesh->looks, VertexLook{});
        for (std::size_t v = 0; v < m_positions.size(); ++v)
            mesh->texCoords[v] = {m_positions[v].x + m_positions[v].y, m_positions[v].z};
        setNormals(*mesh);
        return mesh;
    }

    /// The mean of the triangles about a vertex by area, turned to the front of each.
    static void setNormals(CMesh& mesh) {
        std::ranges::fill(mesh.normals, glm::vec3(0));
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const std::uint32_t* v = &mesh.indices[i];
            const glm::vec3 a = mesh.positions[v[0]];
            const glm::vec3 face = glm::cross(mesh.positions[v[1]] - a, mesh.positions[v[2]] - a);
            for (int c = 0; c < 3; ++c) mesh.normals[v[c]] += face;
        }
        for (glm::vec3& normal : mesh.normals) normal = glm::length(normal) > 0 ? glm::normalize(normal) : glm::vec3(0, 0, 1);
        turnNormalsToFront(mesh);
    }

    std::vector<WoodPiece> m_pieces;
    Grid m_grid;
    std::vector<float> m_low, m_high; ///< two layers
    std::size_t m_next = 0;
    std::vector<std::size_t> m_active;
    std::unordered_map<EdgeKey, std::uint32_t, EdgeHash> m_vertices; ///< of the layers that may still be met
    std::vector<glm::vec3> m_positions;
    std::vector<std::uint32_t> m_indices;
};
} // namespace

std::shared_ptr<const CMesh> voxelMesh(const CTree& tree, const MeshParams& params, double size, const CProgress& progress) {
    if (tree.stemCount() > kMaxVoxelStems)
        throw CError(translated(
            NC_("stromar", "the tree has %1 stems; a solid is made of %2 at most (fewer Levels or Branches)"),
            tree.stemCount(), kMaxVoxelStems));
    std::vector<WoodPiece> pieces = woodPiecesOf(tree, params, kThinnest * size, kLongest * size);
    if (pieces.empty())
        throw CError(translated(NC_("stromar", "the tree is empty, there is nothing to make a solid of")));
    const Grid grid = gridAround(pieces, size);
    return CSolidMaker(std::move(pieces), grid).make(progress);
}

} // namespace stromar
