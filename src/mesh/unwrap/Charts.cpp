#include "unwrap/Charts.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <unordered_map>

namespace stromar {

namespace {
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Triangle2 {
    std::array<glm::dvec2, 3> p;

    double area() const { return ((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y)) / 2; }
    glm::dvec2 low() const { return glm::min(p[0], glm::min(p[1], p[2])); }
    glm::dvec2 high() const { return glm::max(p[0], glm::max(p[1], p[2])); }
};

/// Whether one of the sides of `a` parts them, but for rounding.
bool parts(const Triangle2& a, const Triangle2& b) {
    constexpr double kTouch = 1e-4; // of their extent
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 side = a.p[(i + 1) % 3] - a.p[i], across(-side.y, side.x);
        const auto range = [&](const Triangle2& t) {
            const double x = glm::dot(across, t.p[0]), y = glm::dot(across, t.p[1]), z = glm::dot(across, t.p[2]);
            return std::pair(std::min({x, y, z}), std::max({x, y, z}));
        };
        const auto [lowA, highA] = range(a);
        const auto [lowB, highB] = range(b);
        const double touch = kTouch * std::min(highA - lowA, highB - lowB);
        if (highA - lowB <= touch || highB - lowA <= touch) return true;
    }
    return false;
}

bool overlap(const Triangle2& a, const Triangle2& b) { return !parts(a, b) && !parts(b, a); }

/// Triangles by where they lie.
class CPlane {
public:
    explicit CPlane(double cell) : m_cell(cell) {}

    bool isFree(const Triangle2& triangle) const {
        bool free = true;
        visitCells(triangle, [&](std::uint64_t cell) {
            const auto found = m_cells.find(cell);
            free = free && (found == m_cells.end() || std::ranges::none_of(found->second, [&](std::uint32_t other) { return overlap(triangle, m_triangles[other]); }));
        });
        return free;
    }
    void add(const Triangle2& triangle) {
        const auto own = static_cast<std::uint32_t>(m_triangles.size());
        m_triangles.push_back(triangle);
        visitCells(triangle, [&](std::uint64_t cell) { m_cells[cell].push_back(own); });
    }
    /// Whether it takes so few cells that it may be looked at.
    bool holds(const Triangle2& triangle) const {
        constexpr double kMostCells = 64;
        const glm::dvec2 cells = (triangle.high() - triangle.low()) / m_cell;
        return std::max(cells.x, cells.y) < kMostCells;
    }

private:
    template <typename Visit> void visitCells(const Triangle2& triangle, Visit&& visit) const {
        const glm::dvec2 low = glm::floor(triangle.low() / m_cell), high = glm::floor(triangle.high() / m_cell);
        for (double y = low.y; y <= high.y; ++y)
            for (double x = low.x; x <= high.x; ++x)
                visit(std::uint64_t(std::uint32_t(std::int64_t(x))) << 32 | std::uint32_t(std::int64_t(y)));
    }

    double m_cell;
    std::vector<Triangle2> m_triangles;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells;
};

class CChartMaker {
public:
    CChartMaker(const CMesh& mesh, const CProgress& progress) : m_mesh(mesh), m_progress(progress), m_done(mesh.triangleCount(), false) { findNeighbours(); }

    std::vector<Chart> make() {
        std::vector<Chart> all;
        for (std::uint32_t t = 0; t < m_done.size(); ++t)
            if (!m_done[t]) all.push_back(isFlat(inPicture(t)) ? ownChart(t) : grow(t));
        return all;
    }

private:
    const std::uint32_t* cornersOf(std::uint32_t t) const { return &m_mesh.indices[3 * std::size_t{t}]; }
    Triangle2 inPicture(std::uint32_t t) const {
        const std::uint32_t* c = cornersOf(t);
        return {{glm::dvec2(m_mesh.texCoords[c[0]]), glm::dvec2(m_mesh.texCoords[c[1]]), glm::dvec2(m_mesh.texCoords[c[2]])}};
    }
    static bool isFlat(const Triangle2& t) {
        constexpr double kFlat = 1e-5; // of the square of its extent
        const glm::dvec2 extent = t.high() - t.low();
        const double longer = std::max(extent.x, extent.y);
        return !(std::abs(t.area()) > kFlat * longer * longer);
    }

    /// By edge of a triangle: the one on its other side.
    void findNeighbours() {
        struct Edge {
            std::uint64_t ends;
            std::uint32_t place;
        };
        std::vector<Edge> edges(m_mesh.indices.size());
        for (std::uint32_t place = 0; place < edges.size(); ++place) {
            const std::uint32_t t = place / 3, a = cornersOf(t)[place % 3], b = cornersOf(t)[(place + 1) % 3];
            edges[place] = {std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), place};
        }
        std::ranges::sort(edges, [](const Edge& a, const Edge& b) { return a.ends != b.ends ? a.ends < b.ends : a.place < b.place; });
        m_progress.poll();
        m_neighbours.assign(edges.size(), kNone);
        for (std::size_t i = 1; i < edges.size(); ++i)
            if (edges[i].ends == edges[i - 1].ends) {
                m_neighbours[edges[i].place] = edges[i - 1].place / 3;
                m_neighbours[edges[i - 1].place] = edges[i].place / 3;
            }
    }

    Chart grow(std::uint32_t seed) {
        const Triangle2 first = inPicture(seed);
        const glm::dvec2 extent = first.high() - first.low();
        CPlane plane(std::max(extent.x, extent.y));
        const bool turned = first.area() < 0; // a picture seen from behind is one piece with others seen from behind
        Chart chart;
        const auto take = [&](std::uint32_t t) {
            if (t == kNone || m_done[t]) return;
            const Triangle2 own = inPicture(t);
            if (isFlat(own) || (own.area() < 0) != turned || !plane.holds(own) || !plane.isFree(own)) return;
            plane.add(own);
            chart.triangles.push_back(t);
            m_done[t] = true;
        };
        take(seed);
        for (std::size_t next = 0; next < chart.triangles.size(); ++next) {
            if (next % 1024 == 0) m_progress.poll();
            for (std::size_t edge = 0; edge < 3; ++edge) take(m_neighbours[3 * std::size_t{chart.triangles[next]} + edge]);
        }
        measure(chart);
        return chart;
    }

    /// From places in a picture to metres: as long, in the mean, along each of its sides as the surface is.
    void measure(Chart& chart) const {
        glm::dvec2 metres(0);
        double weight = 0;
        for (const std::uint32_t t : chart.triangles) {
            const std::uint32_t* c = cornersOf(t);
            const Triangle2 in = inPicture(t);
            const glm::dvec3 e1 = glm::dvec3(m_mesh.positions[c[1]]) - glm::dvec3(m_mesh.positions[c[0]]),
                             e2 = glm::dvec3(m_mesh.positions[c[2]]) - glm::dvec3(m_mesh.positions[c[0]]);
            const glm::dvec2 d1 = in.p[1] - in.p[0], d2 = in.p[2] - in.p[0];
            const double twice = 2 * in.area(), own = glm::length(glm::cross(e1, e2));
            metres += own * glm::dvec2(glm::length((d2.y * e1 - d1.y * e2) / twice), glm::length((d1.x * e2 - d2.x * e1) / twice));
            weight += own;
        }
        metres = weight > 0 ? metres / weight : glm::dvec2(0);
        for (const std::uint32_t t : chart.triangles)
            for (const glm::dvec2& p : inPicture(t).p) chart.corners.push_back(metres * p);
        moveToOrigin(chart);
    }

    static void moveToOrigin(Chart& chart) {
        glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
        for (const glm::dvec2& p : chart.corners) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        for (glm::dvec2& p : chart.corners) p -= low;
        chart.size = high - low;
    }

    /// Of a triangle that has no place in the picture.
    Chart ownChart(std::uint32_t t) {
        m_done[t] = true;
        const std::uint32_t* c = cornersOf(t);
        const glm::dvec3 e1 = glm::dvec3(m_mesh.positions[c[1]]) - glm::dvec3(m_mesh.positions[c[0]]),
                         e2 = glm::dvec3(m_mesh.positions[c[2]]) - glm::dvec3(m_mesh.positions[c[0]]);
        const double base = glm::length(e1), along = base > 0 ? glm::dot(e1, e2) / base : 0;
        const double height = std::sqrt(std::max(0.0, glm::dot(e2, e2) - along * along));
        Chart chart{{t}, {{0, 0}, {base, 0}, {along, height}}, {}};
        moveToOrigin(chart);
        return chart;
    }

    const CMesh& m_mesh;
    const CProgress& m_progress;
    std::vector<bool> m_done;
    std::vector<std::uint32_t> m_neighbours;
};
} // namespace

std::vector<Chart> chartsOf(const CMesh& mesh, const CProgress& progress) { return CChartMaker(mesh, progress).make(); }

} // namespace stromar
