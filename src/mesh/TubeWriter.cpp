#include "TubeWriter.h"
#include "FrontNormals.h"

namespace stromar {

namespace {
/// Writes the triangles of one tube; vertices lie ring by ring, the collar's first, then the tip or upper lid, then the
/// lower lid.
class CTriangleWriter {
public:
    CTriangleWriter(std::uint32_t* out, std::uint32_t first, std::uint32_t points)
        : m_out(out), m_next(first), m_points(points) {}

    void addWall() {
        for (std::uint32_t i = 0; i < m_points; ++i) {
            const std::uint32_t a = m_next + i, b = a + m_points + 1;
            add(a, a + 1, b + 1);
            add(a, b + 1, b);
        }
        m_next += m_points + 1;
    }
    void addCone() {
        for (std::uint32_t i = 0; i < m_points; ++i) add(m_next + i, m_next + i + 1, m_next + m_points + 1 + i);
        m_next += 2 * m_points + 1;
    }
    void skipRing() { m_next += m_points + 1; }
    void addLid(bool base, bool middle) {
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
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        *m_out++ = a;
        *m_out++ = b;
        *m_out++ = c;
    }
    std::uint32_t* m_out;
    std::uint32_t m_next, m_points;
};

} // namespace

bool writeTube(const Tube& tube, CPointGenerator& points, CMesh& mesh) {
    VertexSink sink = sinkAt(mesh, tube.firstVertex);
    CTriangleWriter triangles(mesh.indices.data() + tube.firstIndex, tube.firstVertex, tube.points);
    points.startTube(tube);
    for (std::uint32_t r = 0; r < tube.collarRings; ++r) {
        points.addCollarRing(r, sink);
        triangles.addWall();
    }
    const std::uint32_t full = tube.ringCount - (tube.pointed ? 1 : 0);
    for (std::uint32_t r = 0; r < full; ++r) {
        points.addRing(r, sink);
        if (r + 1 < full) triangles.addWall();
    }
    if (tube.pointed) {
        points.addTip(sink);
        triangles.addCone();
    } else {
        triangles.skipRing();
        points.addLid(false, sink);
        triangles.addLid(false, tube.middleOfLid(false));
    }
    points.addLid(true, sink);
    triangles.addLid(true, tube.middleOfLid(true));
    return turnNormalsToFront(mesh, tube);
}

std::size_t Tube::vertexCount() const {
    const std::size_t rings = collarRings + ringCount - (pointed ? 1 : 0);
    const std::size_t end = points + (pointed ? 0 : middleOfLid(false)); // tip or lid
    return rings * (points + 1) + end + points + middleOfLid(true);
}

std::size_t Tube::indexCount() const {
    const std::size_t walls = collarRings + ringCount - (pointed ? 2 : 1);
    const auto lid = [&](bool base) { return middleOfLid(base) ? points : points - 2; };
    return 3 * (walls * 2 * points + (pointed ? points : lid(false)) + lid(true));
}

} // namespace stromar
