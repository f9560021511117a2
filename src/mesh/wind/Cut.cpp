#include "stromar/mesh/Cut.h"
#include <algorithm>
#include <glm/common.hpp>
#include <map>
#include <tuple>
#include <utility>

namespace stromar {

namespace {
/// Whether a place is above the cut; between a node that stands and one that falls the point decides.
bool isAbove(const SwayPlace& place, double z, const CFall& fall) {
    const std::size_t node = place.index();
    return fall.falls(node) == fall.falls(node + 1) ? fall.falls(node) : z >= fall.felling().height;
}

bool before(const glm::vec3& a, const glm::vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// Cuts one mesh.
class CCutter {
public:
    CCutter(const CMesh& mesh, const SwayPlaces& places, const CWindTable& table, const CFall& fall)
        : m_fall(fall), m_mesh(std::make_shared<CMesh>(mesh)), m_source(mesh), m_places(places),
          m_above(places.size()) {
        m_mesh->indices.clear();
        for (const CPath& path : table.tree().generation(0).paths)
            m_pathStarts.push_back(table.nodeOf(0, path.firstSegment));
        std::ranges::sort(m_pathStarts);
        for (std::size_t v = 0; v < places.size(); ++v) {
            m_above[v] = isAbove(places[v], mesh.positions[v].z, fall);
            m_places[v] = fall.onOneSide(places[v], m_above[v]);
        }
    }

    CutMesh cut() {
        for (std::size_t t = 0; t < m_source.indices.size(); t += 3) cutTriangle(&m_source.indices[t]);
        for (auto& [node, edges] : m_edges) close(edges);
        return {m_mesh, std::move(m_places)};
    }

private:
    /// Of one side's cap, as it runs around it.
    struct Edge {
        std::uint32_t from, to;
        bool above;
    };

    std::ptrdiff_t pathAt(const SwayPlace& place) const {
        return std::ranges::upper_bound(m_pathStarts, static_cast<std::uint32_t>(place.index())) - m_pathStarts.begin();
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const std::uint32_t v : {a, b, c}) m_mesh->indices.push_back(v);
    }

    void cutTriangle(const std::uint32_t* corner) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = corner[i], b = corner[(i + 1) % 3], c = corner[(i + 2) % 3];
            if (m_above[b] != m_above[c] || m_above[a] == m_above[b]) continue;
            const std::uint32_t p = between(a, b, a), q = between(a, c, a), p2 = between(a, b, b),
                                q2 = between(a, c, b);
            add(a, p, q);
            add(p2, b, c);
            add(p2, c, q2);
            auto& edges = m_edges[pathAt(m_places[a])];
            edges.push_back({q, p, m_above[a]});
            edges.push_back({p2, q2, m_above[b]});
            return;
        }
        add(corner[0], corner[1], corner[2]);
    }

    /// A new vertex on the edge from a to b, at the cut, that belongs to the side of `side`.
    std::uint32_t between(std::uint32_t a, std::uint32_t b, std::uint32_t side) {
        if (before(m_mesh->positions[b], m_mesh->positions[a]))
            std::swap(a, b); // the same point from both sides of the edge
        const float height = static_cast<float>(m_fall.felling().height), da = m_mesh->positions[a].z - height,
                    db = m_mesh->positions[b].z - height;
        const float t = da * db < 0 ? da / (da - db) : 0.5f;
        return append(glm::mix(m_mesh->positions[a], m_mesh->positions[b], t),
                      glm::normalize(glm::mix(m_mesh->normals[a], m_mesh->normals[b], t)),
                      glm::mix(m_mesh->texCoords[a], m_mesh->texCoords[b], t), m_mesh->looks[a], m_places[side],
                      m_above[side]);
    }

    std::uint32_t append(const glm::vec3& place, const glm::vec3& normal, const glm::vec2& texCoord, VertexLook look,
                         const SwayPlace& hang, bool above) {
        m_mesh->positions.push_back(place);
        m_mesh->normals.push_back(normal);
        m_mesh->texCoords.push_back(texCoord);
        m_mesh->looks.push_back(look);
        m_places.push_back(hang);
        m_above.push_back(above);
        return static_cast<std::uint32_t>(m_places.size()) - 1;
    }

    /// A fan for each side, about the middle of the cut.
    void close(const std::vector<Edge>& edges) {
        glm::vec3 middle(0);
        for (const Edge& edge : edges) middle += m_mesh->positions[edge.from] / float(edges.size());
        for (const Edge& edge : edges) {
            const glm::vec3 normal(0, 0, edge.above ? -1 : 1);
            const auto copied = [&](const glm::vec3& place, std::uint32_t like) {
                return append(place, normal, glm::vec2(place.x, place.y), {}, m_places[like], edge.above);
            };
            const glm::vec3 from = m_mesh->positions[edge.from], to = m_mesh->positions[edge.to];
            const std::uint32_t a = copied(from, edge.from), b = copied(to, edge.to), c = copied(middle, edge.from);
            add(a, b, c);
        }
    }

    const CFall& m_fall;
    std::shared_ptr<CMesh> m_mesh;
    const CMesh& m_source;
    SwayPlaces m_places;
    std::vector<bool> m_above;
    std::vector<std::uint32_t> m_pathStarts;             ///< nodes
    std::map<std::ptrdiff_t, std::vector<Edge>> m_edges; ///< by path that is cut
};
} // namespace

CutMesh cutTrunks(const CMesh& mesh, const SwayPlaces& places, const CWindTable& table, const CFall& fall) {
    return CCutter(mesh, places, table, fall).cut();
}

SwayPlaces onOneSide(const SwayPlaces& places, const CWindTable& table, const CFall& fall) {
    SwayPlaces sided = places;
    for (SwayPlace& place : sided) {
        const std::size_t node = place.index();
        const float z = glm::mix(table.still()[node].z, table.still()[node + 1].z, place.part);
        place = fall.onOneSide(place, isAbove(place, z, fall));
    }
    return sided;
}

} // namespace stromar
