#include "PointGenerator.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::size_t kTubeGrain = 128, kLeafGrain = 4096;

struct Counts {
    std::size_t vertices = 0, indices = 0;
};

std::size_t lidVertices(const Tube& tube) { return tube.points + (tube.lobed ? 1 : 0); }
std::size_t lidTriangles(const Tube& tube) { return tube.lobed ? tube.points : tube.points - 2; }

Counts countsOf(const Tube& tube) {
    const std::size_t full = tube.ringCount - (tube.pointed ? 1 : 0), lids = tube.pointed ? 1 : 2;
    return {full * (tube.points + 1) + (tube.pointed ? tube.points : 0) + lids * lidVertices(tube),
            3 * ((full - 1) * 2 * tube.points + (tube.pointed ? tube.points : 0) + lids * lidTriangles(tube))};
}

/// Writes the triangles of one tube; vertices lie ring by ring, then the tip or upper lid, then the lower lid.
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
    void addLid(bool base, bool lobed) {
        const std::uint32_t first = lobed ? 1 : 0, count = lobed ? m_points : m_points - 2;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t b = lobed ? i : i + 1, c = (b + 1) % m_points;
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

void writeTube(const Tube& tube, CPointGenerator& points, VertexSink sink, CTriangleWriter triangles) {
    points.startTube(tube);
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
        triangles.addLid(false, tube.lobed);
    }
    points.addLid(true, sink);
    triangles.addLid(true, tube.lobed);
}

std::shared_ptr<CMesh> makeMesh(std::string name, Surface surface, const Counts& size) {
    auto mesh = std::make_shared<CMesh>();
    mesh->name = std::move(name);
    mesh->surface = surface;
    mesh->positions.resize(size.vertices);
    mesh->normals.resize(size.vertices);
    mesh->texCoords.resize(size.vertices);
    mesh->indices.resize(size.indices);
    return mesh;
}

VertexSink sinkAt(CMesh& mesh, std::size_t vertex) {
    return {mesh.positions.data() + vertex, mesh.normals.data() + vertex, mesh.texCoords.data() + vertex};
}

/// Chooses `count` of `total` leaves, evenly: the index of the i-th.
std::size_t chosenLeaf(std::size_t i, std::size_t count, std::size_t total) {
    return (2 * i + 1) * total / (2 * count);
}

void writeLeaf(const CLeaf& leaf, double growth, VertexSink sink, std::uint32_t* index, std::uint32_t first) {
    const glm::dvec3 p = glm::abs(leaf.position);
    const double least = 1e-5 * std::max({p.x, p.y, p.z});
    const glm::dvec3 side = std::max(least, leaf.width * growth) / 2 * glm::cross(leaf.normal, leaf.axis);
    const glm::dvec3 up = std::max(least, leaf.length * growth) * leaf.axis;
    sink.add(leaf.position + side, leaf.normal, 0, 0);
    sink.add(leaf.position - side, leaf.normal, 1, 0);
    sink.add(leaf.position - side + up, leaf.normal, 1, 1);
    sink.add(leaf.position + side + up, leaf.normal, 0, 1);
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) *index++ = first + corner;
}
} // namespace

std::shared_ptr<const CMesh> meshOfStems(const CTree& tree, int generation, const MeshPlan& plan, const CParams& params,
                                         const CProgress& progress) {
    std::vector<Counts> first(plan.tubes.size() + 1);
    for (std::size_t t = 0; t < plan.tubes.size(); ++t) {
        const Counts own = countsOf(plan.tubes[t]);
        first[t + 1] = {first[t].vertices + own.vertices, first[t].indices + own.indices};
    }
    const auto mesh =
        makeMesh(generation == 0 ? "trunk" : "branches " + std::to_string(generation), Surface::Bark, first.back());
    const CStemSurface surface(params, generation, tree.scaleTree());
    const glm::dvec2 wrap(params.global.textureWrapX, params.global.textureWrapY);
    parallelFor(
        plan.tubes.size(), kTubeGrain,
        [&](std::size_t begin, std::size_t end) {
            CPointGenerator points(tree.generation(static_cast<std::size_t>(generation)), plan, surface, wrap);
            for (std::size_t t = begin; t < end; ++t)
                writeTube(plan.tubes[t], points, sinkAt(*mesh, first[t].vertices),
                          CTriangleWriter(mesh->indices.data() + first[t].indices,
                                          static_cast<std::uint32_t>(first[t].vertices), plan.tubes[t].points));
        },
        progress);
    return mesh;
}

std::shared_ptr<const CMesh> meshOfLeaves(const CTree& tree, const Detail& detail, const CProgress& progress) {
    const std::size_t total = tree.leaves().size();
    const std::size_t count =
        std::min(detail.leafBudget, static_cast<std::size_t>(std::ceil(double(total) * detail.leafShare)));
    const double growth = count == 0 ? 1 : std::min(kMostLeafGrowth, std::sqrt(double(total) / double(count)));
    const auto mesh = makeMesh("leaves", Surface::Leaf, {4 * count, 6 * count});
    parallelFor(
        count, kLeafGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                writeLeaf(tree.leaves()[chosenLeaf(i, count, total)], growth, sinkAt(*mesh, 4 * i),
                          mesh->indices.data() + 6 * i, static_cast<std::uint32_t>(4 * i));
        },
        progress);
    return mesh;
}

} // namespace stromar
