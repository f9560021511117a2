#include "join/TubeJoiner.h"
#include "join/Corners.h"
#include "join/Triangulation.h"
#include "stem/TubeWalls.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace stromar {

namespace {
constexpr int kMaxTries = 16;         // without branches that could not be cut out, each time fewer
constexpr int kSeparatePasses = 4;    // until no edge is doubled
constexpr double kNarrow = 0.49;      // turns: edges of the same vertices, on either side of a stem, are not both shorter
constexpr double kLeastAround = 1e-6; // repeats of the bark: to unroll it by
constexpr double kGood = 0.3;         // quality of a triangle: not flipped
constexpr double kFlat = 0.02;        // sine of a bend that is none
constexpr double kBetter = 1.05;      // times: quality after a flip

using Triangle = CTriangulation::Triangle;

/// Few values for each of many keys.
template <typename Value>
class CChains {
public:
    explicit CChains(std::size_t keys) : m_last(keys, kNone) {}

    void add(std::size_t key, const Value& value) {
        m_links.push_back({value, m_last[key]});
        m_last[key] = static_cast<std::uint32_t>(m_links.size() - 1);
    }
    /// The last one added that fits; null where none does.
    template <typename Fits>
    const Value* find(std::size_t key, Fits&& fits) const {
        for (std::uint32_t i = m_last[key]; i != kNone; i = m_links[i].before)
            if (fits(m_links[i].value)) return &m_links[i].value;
        return nullptr;
    }

private:
    struct Link {
        Value value;
        std::uint32_t before;
    };
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> m_last; ///< of each key's links
    std::vector<Link> m_links;
};

/// One tube's walls unrolled: turns about the stem by rings along it.
class CTubeJoiner {
public:
    CTubeJoiner(const CTree& tree, std::size_t generation, std::span<const StemMesh> stems, const Tube& tube)
        : m_generation(static_cast<std::uint32_t>(generation)), m_stems(stems), m_mesh(*stems[generation].mesh), m_plan(stems[generation].plan),
          m_tube(tube), m_wallsEnd(CTubeWalls(tree.generation(generation), m_plan, tube).end()) {}

    JoinedWalls join(const std::vector<BranchTube>& branches, const CProgress& progress) {
        unrollVertices();
        if (m_around < kLeastAround) return std::move(m_walls);
        std::vector<BranchTube> left = branches;
        bool all = false;
        for (int tries = 0; !all && !left.empty() && tries < kMaxTries; ++tries) { // what was added for one that failed must not stay
            progress.poll();
            CTriangulation surface(unrolledTriangles(left), m_tube.vertices);
            all = cutOut(left, surface);
            if (!all) continue;
            improve(surface);
            all = leaveTangled(separate(surface), left, tries < kMaxTries / 2);
            if (all) write(surface);
        }
        if (all) m_walls.joined = left;
        return std::move(m_walls);
    }

private:
    /// A point of a collar.
    struct Added {
        JoinedWalls::Vertex vertex;
        double turns; ///< where it lies in the plane of its triangle at the start
        BranchTube branch;
    };
    const Added& addedAt(CTriangulation::Index vertex) const { return m_added[vertex - m_tube.vertices]; }

    /// The points of the rings, from the lowest; a ring has one vertex more, at its seam.
    std::vector<std::uint32_t> ringPoints() const {
        std::vector<std::uint32_t> points(m_tube.collarRings, m_tube.points);
        const Ring* rings = m_plan.ringsOf(m_tube);
        for (std::uint32_t r = 0; r + (m_tube.pointed ? 1 : 0) < m_tube.ringCount; ++r) points.push_back(rings[r].points);
        return points;
    }

    /// At a fork rings run from valley to valley.
    bool isClosed(std::uint32_t first, std::uint32_t points) const { return position(first) == position(first + points); }

    /// The seam's vertices count as the ring's first, a turn further, and those of a limb's lowest ring as the common ring's, so that
    /// walls are one below and above a fork.
    void unrollVertices() {
        const std::vector<std::uint32_t> rings = ringPoints();
        m_around = turnOf(rings);
        if (m_around < kLeastAround) return;
        m_own.resize(m_tube.vertices);
        std::iota(m_own.begin(), m_own.end(), 0u);
        m_at.resize(m_tube.vertices);
        std::uint32_t first = 0, height = 0;
        for (std::size_t r = 0; r < rings.size(); ++r) {
            const bool parted = r > m_tube.collarRings && m_plan.ringsOf(m_tube)[r - m_tube.collarRings].parted;
            for (std::uint32_t v = first; v <= first + rings[r]; ++v) m_at[v] = {double(tex(v).x) / m_around, height - (parted ? 1 : 0)};
            if (parted)
                standOnCommonRing(first, rings[r], rings[r - 1]);
            else
                ++height;
            if (isClosed(first, rings[r])) stand(first + rings[r], m_own[first]);
            first += rings[r] + 1;
        }
        m_firstTip = first;
        for (std::uint32_t v = first; v < m_tube.vertices; ++v) m_at[v] = {double(tex(v).x) / m_around, height}; // a tip, and lids, which are not unrolled
    }

    /// How much of the bark goes around: as a closed ring says; 0 without one.
    double turnOf(const std::vector<std::uint32_t>& rings) const {
        std::uint32_t first = 0;
        for (const std::uint32_t points : rings) {
            if (isClosed(first, points)) return double(tex(first + points).x) - double(tex(first).x);
            first += points + 1;
        }
        return 0;
    }

    /// A vertex counts as another at the same place, whole turns from it.
    void stand(std::uint32_t v, std::uint32_t other) {
        m_own[v] = other;
        m_at[v] = {m_at[other].x + std::round(m_at[v].x - m_at[other].x), m_at[other].y};
    }

    void standOnCommonRing(std::uint32_t first, std::uint32_t points, std::uint32_t below) {
        for (std::uint32_t v = first; v <= first + points; ++v)
            for (std::uint32_t w = first - below - 1; w < first - 1; ++w)
                if (position(v) == position(w)) stand(v, m_own[w]);
    }

    /// With room for those that branches part.
    std::vector<Triangle> unrolledTriangles(const std::vector<BranchTube>& branches) const {
        std::size_t more = m_tube.pointed ? m_plan.ringsOf(m_tube)[m_tube.ringCount - 2].points : 0;
        for (const BranchTube& own : branches) more += 2 * std::size_t{m_stems[own.generation].plan.tubes[own.tube].points};
        std::vector<Triangle> triangles;
        triangles.reserve((m_wallsEnd - m_tube.firstIndex) / 3 + more);
        for (std::size_t i = m_tube.firstIndex; i < m_wallsEnd; i += 3) {
            Triangle& own = triangles.emplace_back();
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t v = m_mesh.indices[i + c] - m_tube.firstVertex;
                own.vertices[c] = m_own[v];
                own.at[c] = m_at[v];
            }
        }
        if (m_tube.pointed) closeCone(triangles);
        return triangles;
    }

    /// Between the walls of a cone, each of which has a tip of its own: triangles that are flat in space.
    void closeCone(std::vector<Triangle>& triangles) const {
        const std::size_t count = m_plan.ringsOf(m_tube)[m_tube.ringCount - 2].points, first = triangles.size() - count;
        for (std::size_t i = 0; i < count; ++i) {
            const Triangle own = triangles[first + i], &after = triangles[first + (i + 1) % count];
            const glm::dvec2 turn(i + 1 == count ? 1 : 0, 0);
            triangles.push_back({{own.vertices[1], after.vertices[2], own.vertices[2]}, {own.at[1], after.at[2] + turn, own.at[2]}});
        }
    }

    bool isTip(CTriangulation::Index vertex) const { return m_tube.pointed && vertex >= m_firstTip && vertex < m_tube.vertices; }
    std::ptrdiff_t tipsOf(const Triangle& triangle) const { return std::ranges::count_if(triangle.vertices, [&](auto v) { return isTip(v); }); }

    /// Leaves those that can be; false when others cannot.
    bool cutOut(std::vector<BranchTube>& branches, CTriangulation& surface) {
        m_added.clear();
        return std::erase_if(branches, [&](const BranchTube& branch) { return !cutOut(branch, surface); }) == 0;
    }

    bool cutOut(const BranchTube& branch, CTriangulation& surface) {
        const StemMesh& bearing = m_stems[branch.generation];
        const Tube& tube = bearing.plan.tubes[branch.tube];
        m_loop.clear();
        for (std::uint32_t i = 0; i < tube.points; ++i) {
            const SurfacePoint& point = bearing.plan.collarPoints[tube.firstCollarPoint + i];
            const auto triangle = static_cast<CTriangulation::Index>((point.triangle - m_tube.firstIndex) / 3);
            const glm::dvec3 shares = sharesAt(point);
            m_loop.push_back({triangle, placeOf(point, shares)});
            m_added.push_back({vertexAt(point, shares, {branch.generation, tube.firstVertex + i}), m_loop.back().at.x, branch});
        }
        const bool cut = surface.cutOut(m_loop);
        m_added.resize(surface.vertexCount() - m_tube.vertices); // fewer when one could not be added
        return cut;
    }

    /// Of a triangle.
    struct Side {
        CTriangulation::Index from, to, opposite;
        CTriangulation::Index triangle;
    };

    /// On a thin stem two edges may join the same vertices, one on either side: flips those that may be; what is left.
    std::vector<Side> separate(CTriangulation& surface) const {
        std::vector<Side> doubled = doubledSides(surface);
        for (int pass = 0; !doubled.empty() && pass < kSeparatePasses; ++pass) {
            bool turned = false;
            for (const Side& side : doubled) turned |= surface.turnAway(side.triangle, side.from, side.to);
            if (!turned) break;
            doubled = doubledSides(surface);
        }
        return doubled;
    }

    /// False when branches had to be left out for edges that join the same vertices: all that are at these, or only `one`.
    bool leaveTangled(const std::vector<Side>& doubled, std::vector<BranchTube>& branches, bool one) const {
        if (doubled.empty()) return true;
        std::vector<BranchTube> tangled; // first those at the ends of such edges
        const auto add = [&](CTriangulation::Index v) {
            if (v >= m_tube.vertices) tangled.push_back(addedAt(v).branch);
        };
        for (const Side& side : doubled) add(side.from), add(side.to);
        for (const Side& side : doubled) add(side.opposite);
        if (tangled.empty()) tangled = branches;
        if (one) tangled.erase(tangled.begin() + 1, tangled.end());
        std::erase_if(branches, [&](const BranchTube& branch) { return std::ranges::find(tangled, branch) != tangled.end(); });
        return false;
    }

    /// Those that another triangle has the same way round, where walls were changed: one of the two leads half around the stem or
    /// more, or to the tip.
    std::vector<Side> doubledSides(const CTriangulation& surface) const {
        constexpr std::uint8_t kChanged = 1, kWide = 2;
        const auto standIn = [&](std::uint32_t corner) { return isTip(corner) ? m_firstTip : corner; };
        std::vector<std::uint8_t> marks(surface.vertexCount());
        for (const Triangle& triangle : surface.triangles()) {
            if (!triangle.changed) continue;
            for (const std::uint32_t corner : triangle.vertices) marks[standIn(corner)] |= kChanged;
        }
        for (const Triangle& triangle : surface.triangles())
            for (std::uint32_t c = 0; c < 3; ++c) {
                const std::uint32_t from = triangle.vertices[c], to = triangle.vertices[after(c)];
                if (std::abs(triangle.at[c].x - triangle.at[after(c)].x) < kNarrow && !isTip(from) && !isTip(to)) continue;
                marks[standIn(from)] |= kWide;
                marks[standIn(to)] |= kWide;
            }
        std::vector<Side> doubled;
        CChains<Side> sides(surface.vertexCount());
        for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
            const Triangle& triangle = surface.triangles()[t];
            if (triangle.removed || tipsOf(triangle) > 1) continue;
            std::array<std::uint32_t, 3> v = triangle.vertices;
            for (std::uint32_t& corner : v) corner = standIn(corner);
            for (std::uint32_t c = 0; c < 3; ++c) {
                const Side side{v[c], v[after(c)], v[before(c)], static_cast<CTriangulation::Index>(t)};
                if ((marks[side.from] & marks[side.to]) != (kChanged | kWide)) continue;
                if (const Side* other = sides.find(side.from, [&](const Side& known) { return known.to == side.to; })) doubled.insert(doubled.end(), {*other, side});
                sides.add(side.from, side);
            }
        }
        return doubled;
    }

    glm::dvec3 sharesAt(const SurfacePoint& point) const {
        const std::uint32_t* v = &m_mesh.indices[point.triangle];
        return barycentricOf(point.position, glm::dvec3(m_mesh.positions[v[0]]), glm::dvec3(m_mesh.positions[v[1]]),
                        glm::dvec3(m_mesh.positions[v[2]]));
    }

    /// Of a point on a triangle, unrolled as that was at the start.
    glm::dvec2 placeOf(const SurfacePoint& point, const glm::dvec3& shares) const {
        const auto at = [&](std::size_t c) { return m_at[m_mesh.indices[point.triangle + c] - m_tube.firstVertex]; };
        return shares.x * at(0) + shares.y * at(1) + shares.z * at(2);
    }

    /// Where a collar stands the wall is as dark as that, else as the triangle.
    JoinedWalls::Vertex vertexAt(const SurfacePoint& point, const glm::vec3& shares, const VertexSource& source) const {
        const auto corner = [&](std::size_t c) { return m_mesh.indices[point.triangle + c]; };
        const glm::vec2 at = shares.x * m_mesh.texCoords[corner(0)] + shares.y * m_mesh.texCoords[corner(1)] +
                             shares.z * m_mesh.texCoords[corner(2)];
        const CMesh& branches = *m_stems[source.generation].mesh;
        const VertexLook look{branches.looks[source.vertex].skyVisibility, m_mesh.looks[corner(0)].thinness};
        return {source, branches.positions[source.vertex], glm::vec3(point.normal), at, look};
    }

    /// Of a vertex of the surface.
    struct Corner {
        glm::dvec3 place, normal;
    };
    /// Of a triangle with such vertices.
    struct Face {
        std::array<CTriangulation::Index, 3> vertices{CTriangulation::kNone, CTriangulation::kNone, CTriangulation::kNone};
        glm::dvec3 across; ///< twice its area long
        double twice;      ///< its area
        double quality;    ///< 1 when equilateral, towards 0 when thin, negative when it faces inwards
    };

    void improve(CTriangulation& surface) {
        m_corners.clear();
        m_corners.reserve(surface.vertexCount());
        for (std::uint32_t v = m_tube.firstVertex; v < m_tube.firstVertex + m_tube.vertices; ++v) m_corners.push_back({m_mesh.positions[v], m_mesh.normals[v]});
        for (const Added& own : m_added) m_corners.push_back({own.vertex.position, own.vertex.normal});
        m_faces.assign(surface.triangles().size(), {});
        surface.improve([&](const auto& corners, const auto& triangles) {
            return isBetterFlipped(corners, knownFace(surface, triangles[0]), knownFace(surface, triangles[1]));
        });
    }

    const Face& knownFace(const CTriangulation& surface, CTriangulation::Index triangle) {
        Face& known = m_faces[triangle];
        const auto &now = surface.triangles()[triangle].vertices, &then = known.vertices;
        if (now[0] != then[0] || now[1] != then[1] || now[2] != then[2]) known = faceOf(now);
        return known;
    }

    Face faceOf(const std::array<CTriangulation::Index, 3>& vertices) const {
        const Corner &p = m_corners[vertices[0]], &q = m_corners[vertices[1]], &r = m_corners[vertices[2]];
        const auto squared = [](const glm::dvec3& way) { return glm::dot(way, way); };
        const glm::dvec3 across = glm::cross(q.place - p.place, r.place - p.place);
        const double sides = squared(q.place - p.place) + squared(r.place - q.place) + squared(p.place - r.place), twice = glm::length(across);
        if (!(twice > 0)) return {vertices, across, 0, 0};
        const double front = std::min({glm::dot(across, p.normal), glm::dot(across, q.normal), glm::dot(across, r.normal)});
        return {vertices, across, twice, front > 0 ? 2 * std::sqrt(3.0) * twice / sides : front / twice};
    }

    /// Wood is round: an edge in a valley is flipped, which brings back the ridges of the walls as they were; between triangles that
    /// lie flat one that makes them thin.
    bool isBetterFlipped(const std::array<CTriangulation::Index, 4>& corners, const Face& one, const Face& other) const {
        const auto [a, b, near, far] = corners;
        const double now = std::min(one.quality, other.quality);
        const glm::dvec3 way = m_corners[b].place - m_corners[a].place;
        const double valley = glm::dot(glm::cross(other.across, one.across), way);
        if (valley <= 0 && now > kGood) return false; // as nearly all are
        const double flat = kFlat * one.twice * other.twice * glm::length(way);
        const bool isRidge = valley < -flat, isValley = valley > flat;
        if (!isValley && now > (isRidge ? 0 : kGood)) return false;
        const double flipped = std::min(faceOf({a, far, near}).quality, faceOf({far, b, near}).quality);
        return flipped > (isValley ? std::min(now, 0.0) : isRidge ? 0.0 : kBetter * now);
    }

    void write(const CTriangulation& surface) {
        m_written = CChains<Written>(surface.vertexCount());
        const std::span<const Triangle> all = surface.triangles();
        const std::size_t before = (m_wallsEnd - m_tube.firstIndex) / 3;
        for (std::size_t t = 0; t < all.size(); ++t) {
            if (!all[t].changed && !all[t].removed) continue;
            if (t < before) m_walls.replaced.push_back(m_tube.firstIndex + 3 * t);
            if (all[t].removed || tipsOf(all[t]) > 1) continue;
            for (std::size_t c = 0; c < 3; ++c) m_walls.triangles.push_back(written(all[t].vertices[c], all[t].at[c].x));
        }
    }

    /// The index of a vertex that a triangle shows at so many turns: of the mesh where that has one there.
    std::uint32_t written(CTriangulation::Index vertex, double turns) {
        const bool added = vertex >= m_tube.vertices;
        const double own = added ? addedAt(vertex).turns : m_at[vertex].x;
        const int further = std::abs(turns - own) < 0.5 ? 0 : static_cast<int>(std::lround(turns - own));
        if (!added && further == 0) return m_tube.firstVertex + vertex;
        if (const Written* known = m_written.find(vertex, [&](const Written& one) { return one.turns == further; })) return known->index;
        const Written copied{further, static_cast<std::uint32_t>(m_mesh.vertexCount() + m_walls.vertices.size())};
        JoinedWalls::Vertex copy = added ? addedAt(vertex).vertex : ownVertex(vertex);
        copy.texCoord.x += static_cast<float>(m_around * further);
        m_walls.vertices.push_back(copy);
        m_written.add(vertex, copied);
        return copied.index;
    }

    JoinedWalls::Vertex ownVertex(CTriangulation::Index vertex) const {
        const std::uint32_t v = m_tube.firstVertex + vertex;
        return {{m_generation, v}, m_mesh.positions[v], m_mesh.normals[v], m_mesh.texCoords[v], m_mesh.looks[v]};
    }

    const glm::vec2& tex(std::uint32_t v) const { return m_mesh.texCoords[m_tube.firstVertex + v]; }
    const glm::vec3& position(std::uint32_t v) const { return m_mesh.positions[m_tube.firstVertex + v]; }

    std::uint32_t m_generation;
    std::span<const StemMesh> m_stems;
    const CMesh& m_mesh;
    const MeshPlan& m_plan;
    const Tube& m_tube;
    std::size_t m_wallsEnd;
    double m_around = 0;
    std::uint32_t m_firstTip = 0; ///< of the tube's vertices: the tips of a pointed one
    std::vector<std::uint32_t> m_own; ///< of the tube's vertices: the one that stands for it
    std::vector<glm::dvec2> m_at;     ///< likewise: unrolled
    std::vector<Added> m_added;
    std::vector<CTriangulation::LoopPoint> m_loop; ///< of one branch
    std::vector<Corner> m_corners; ///< by vertex of the surface
    std::vector<Face> m_faces;     ///< by triangle of the surface: as it was when it was looked at last
    /// A copy of a vertex that is shown so many turns from its place.
    struct Written {
        int turns;
        std::uint32_t index;
    };
    CChains<Written> m_written{0}; ///< by vertex
    JoinedWalls m_walls;
};
} // namespace

JoinedWalls joinWalls(const CTree& tree, std::size_t generation, std::span<const StemMesh> stems, const Tube& tube,
                      const std::vector<BranchTube>& branches, const CProgress& progress) {
    return CTubeJoiner(tree, generation, stems, tube).join(branches, progress);
}

} // namespace stromar
