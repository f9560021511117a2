#include "stem/TubeWriter.h"
#include "stem/FrontNormals.h"
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
/// Writes the triangles of one tube; vertices lie ring by ring, the collar's first, then the tip or upper lid, then the
/// lower lid.
class CTriangleWriter {
public:
    CTriangleWriter(std::uint32_t* out, std::uint32_t first, std::uint32_t points)
        : m_out(out), m_next(first), m_points(points) {}

    /// Up to a ring of as many points, or of half as many; at a fork of any other number.
    void addWall(std::uint32_t above) {
        const std::uint32_t low = m_next, high = m_next + m_points + 1;
        const bool even = above == m_points || 2 * above == m_points;
        if (!even) addFan(low, high, above);
        for (std::uint32_t i = 0; i < above && even; ++i) {
            const std::uint32_t b = high + i;
            if (above == m_points) {
                const std::uint32_t a = low + i;
                add(a, a + 1, b + 1);
                add(a, b + 1, b);
            } else {
                const std::uint32_t a = low + 2 * i;
                add(a, a + 1, b);
                add(a + 1, b + 1, b);
                add(a + 1, a + 2, b + 1);
            }
        }
        m_next = high;
        m_points = above;
    }
    void addCone() {
        for (std::uint32_t i = 0; i < m_points; ++i) add(m_next + i, m_next + i + 1, m_next + m_points + 1 + i);
        m_next += 2 * m_points + 1;
    }
    void skipRing() { m_next += m_points + 1; }
    /// To a ring that no wall leads to.
    void part(std::uint32_t above) {
        skipRing();
        m_points = above;
    }
    void addLid(bool base, std::uint32_t points, bool middle) {
        m_points = points;
        const std::uint32_t first = middle ? 1 : 0, count = middle ? m_points : m_points - 2;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t b = middle ? i : i + 1, c = (b + 1) % m_points;
            if (base)
                add(m_next, m_next + first + c, m_next + first + b);
            else
                add(m_next, m_next + first + b, m_next + first + c);
        }
        m_next += m_points + first;
    }

private:
    /// Evenly to a ring of another number of points.
    void addFan(std::uint32_t low, std::uint32_t high, std::uint32_t above) {
        std::uint32_t a = 0;
        for (std::uint32_t b = 0; b < above; ++b) {
            for (; (2 * a + 1) * above < (2 * b + 1) * m_points; ++a) add(low + a, low + a + 1, high + b);
            add(low + a, high + b + 1, high + b);
        }
        for (; a < m_points; ++a) add(low + a, low + a + 1, high + above);
    }
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        *m_out++ = a;
        *m_out++ = b;
        *m_out++ = c;
    }
    std::uint32_t* m_out;
    std::uint32_t m_next, m_points;
};

/// The quads of a collar are split along their shorter diagonals: a branch at an acute angle leaves the wood on one side long before
/// the other, and along the longer one its walls would fold.
void splitCollarQuads(const Tube& tube, CMesh& mesh) {
    std::uint32_t* out = mesh.indices.data() + tube.firstIndex;
    const auto length = [&](std::uint32_t a, std::uint32_t b) { return glm::distance(mesh.positions[a], mesh.positions[b]); };
    for (std::uint32_t r = 0; r < tube.collarRings; ++r)
        for (std::uint32_t i = 0; i < tube.points; ++i, out += 6) {
            const std::uint32_t a = tube.firstVertex + r * (tube.points + 1) + i, b = a + tube.points + 1;
            if (length(a + 1, b) < length(a, b + 1)) std::ranges::copy(std::array{a, a + 1, b, a + 1, b + 1, b}, out);
        }
}
} // namespace

bool writeTube(const MeshPlan& plan, const Tube& tube, CPointGenerator& points, CMesh& mesh) {
    VertexSink sink = sinkAt(mesh, tube.firstVertex);
    const Ring* rings = plan.ringsOf(tube);
    CTriangleWriter triangles(mesh.indices.data() + tube.firstIndex, tube.firstVertex,
                              tube.startsAtFork() ? rings[0].points : tube.points);
    points.startTube(tube);
    for (std::uint32_t r = 0; r < tube.collarRings; ++r) {
        points.addCollarRing(r, sink);
        triangles.addWall(tube.points);
    }
    const std::uint32_t full = tube.ringCount - (tube.pointed ? 1 : 0);
    for (std::uint32_t r = 0; r < full; ++r) {
        points.addRing(r, sink);
        if (r + 1 == full) continue;
        if (rings[r + 1].parted)
            triangles.part(rings[r + 1].points);
        else
            triangles.addWall(rings[r + 1].points);
    }
    if (tube.pointed) {
        points.addTip(sink);
        triangles.addCone();
    } else {
        triangles.skipRing();
        points.addLid(false, sink);
        triangles.addLid(false, rings[full - 1].points, tube.middleOfLid(false));
    }
    for (const ForkedBranch& branch : plan.branchesOf(tube)) {
        points.addBranchLid(branch, sink);
        triangles.addLid(false, branch.limb.lidPoints(), true);
    }
    if (!tube.joined) {
        points.addLid(true, sink);
        triangles.addLid(true, plan.baseLidPoints(tube), tube.middleOfLid(true));
    }
    splitCollarQuads(tube, mesh);
    return turnNormalsToFront(mesh, plan, tube);
}

void measure(const MeshPlan& plan, Tube& tube) {
    const Ring* rings = plan.ringsOf(tube);
    const std::uint32_t full = tube.ringCount - (tube.pointed ? 1 : 0), last = rings[full - 1].points;
    tube.vertices = tube.collarRings * (tube.points + 1);
    tube.indices = tube.collarRings * wallIndices(tube.points, tube.points);
    for (std::uint32_t r = 0; r < full; ++r) {
        tube.vertices += rings[r].points + 1;
        if (r + 1 < full) tube.indices += wallIndices(rings[r], rings[r + 1]);
    }
    const auto addLid = [&](std::uint32_t points, bool middle) {
        tube.vertices += points + (middle ? 1 : 0);
        tube.indices += 3 * std::size_t{middle ? points : points - 2};
    };
    for (const ForkedBranch& branch : plan.branchesOf(tube)) addLid(branch.limb.lidPoints(), true);
    if (!tube.joined) addLid(plan.baseLidPoints(tube), tube.middleOfLid(true));
    if (!tube.pointed) return addLid(last, tube.middleOfLid(false));
    tube.vertices += last; // one tip for each side of the cone
    tube.indices += 3 * std::size_t{last};
}

} // namespace stromar
