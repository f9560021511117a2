#include "stromar/mesh/Sway.h"
#include "stem/PathSurface.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::size_t kTubeGrain = 256, kLeafGrain = 4096, kVertexGrain = 16384;

/// Writes where the vertices of one tube hang, in the order of TubeWriter.
class CTubePlaces {
public:
    CTubePlaces(const CWindTable& table, std::size_t generation, const MeshPlan& plan, const CMesh& mesh,
                SwayPlaces& places)
        : m_table(table), m_tree(table.tree()), m_all(m_tree.generation(generation)), m_generation(generation),
          m_plan(plan), m_mesh(mesh), m_places(places) {}

    void write(const Tube& tube) {
        const Ring* rings = m_plan.ringsOf(tube);
        const SwayPlace base{static_cast<float>(m_table.nodeOf(m_generation, m_all.paths[tube.path].firstSegment)), 0};
        m_next = tube.firstVertex;
        if (tube.collarRings > 0) {
            for (std::uint32_t i = 0; i <= tube.points; ++i) add(onWood(tube, m_mesh.positions[m_next]));
            add(base, std::size_t{tube.collarRings - 1} * (tube.points + 1));
        }
        const std::uint32_t full = tube.ringCount - (tube.pointed ? 1 : 0);
        for (std::uint32_t r = 0; r < full; ++r) add(placeOf(tube, r), rings[r].points + 1);
        const Ring& last = rings[tube.ringCount - 1];
        add(placeOf(last), rings[full - 1].points + (!tube.pointed && tube.middleOfLid(false) ? 1 : 0));
        for (const ForkedBranch& branch : m_plan.branchesOf(tube)) addForkLid(tube, branch);
        if (tube.joined) return;
        if (tube.forked) {
            add(m_places[tube.firstVertex]);
            for (const std::uint32_t v : m_plan.limbOf(tube).boundary()) add(m_places[tube.firstVertex + v]);
            return;
        }
        if (tube.middleOfLid(true)) add(base);
        for (std::uint32_t i = 0; i < tube.points; ++i) add(m_places[tube.firstVertex + i]);
    }

private:
    void add(const SwayPlace& place, std::size_t count = 1) {
        std::fill_n(m_places.data() + m_next, count, place);
        m_next += count;
    }

    /// Over the hole of a branch.
    void addForkLid(const Tube& tube, const ForkedBranch& branch) {
        const CStem& stem = m_all.stems[tube.stem];
        const auto placeOfPoint = [&](std::uint32_t i) {
            const auto [segment, t] = placeAlong(m_all, stem, m_all.paths[tube.path], double(m_plan.branchPoints[branch.firstPoint + i].along));
            return placeOf({segment, 0, t});
        };
        add(placeOfPoint(0));
        for (const std::uint32_t i : branch.limb.boundary()) add(placeOfPoint(i));
    }

    /// The rings of a fork move with the path that runs on, so that all that part there stay together.
    SwayPlace placeOf(const Tube& tube, std::uint32_t ring) const {
        const Ring* rings = m_plan.ringsOf(tube);
        const Fork* fork = m_plan.forkAt(tube, ring);
        if (!fork) return placeOf(rings[ring]);
        std::uint32_t point = fork->firstPoint;
        for (std::uint32_t r = fork->ring; r < ring; ++r) point += rings[r].points + 1;
        const CStem& stem = m_all.stems[tube.stem];
        const CPath& own = m_all.paths[tube.path];
        const double along = double(m_plan.forkPoints[point].along);
        if (tube.forked && fork->ring == 0) return onParentAt(stem, along);
        const bool starts = tube.joined && fork->ring == 0;
        const CPath& path = starts ? m_all.paths[stem.firstPath + static_cast<std::uint32_t>(own.source)] : own;
        const auto [segment, t] = placeAlong(m_all, stem, path, along);
        return placeOf({segment, 0, t});
    }

    SwayPlace placeOf(const Ring& ring) const {
        return {static_cast<float>(m_table.nodeOf(m_generation, ring.segment)), static_cast<float>(ring.t)};
    }

    /// At a fork of the parent's.
    SwayPlace onParentAt(const CStem& stem, double along) const {
        const CGeneration& before = m_tree.generation(m_generation - 1);
        const CStem& parent = before.stems[static_cast<std::size_t>(stem.parent)];
        const auto [segment, t] = placeAlong(before, parent, before.paths[parent.firstPath + stem.path], along);
        return {static_cast<float>(m_table.nodeOf(m_generation - 1, segment)), static_cast<float>(t)};
    }

    /// On the wood of the collar, beside the branch's base, up or down the path there.
    SwayPlace onWood(const Tube& tube, const glm::vec3& point) const {
        const std::size_t below = m_generation - tube.standsOn;
        const CStem& stem = m_tree.ancestor(m_generation, m_all.stems[tube.stem], tube.standsOn - 1);
        const CGeneration& before = m_tree.generation(below);
        const CStem& parent = before.stems[static_cast<std::size_t>(stem.parent)];
        const CPath& path = before.paths[parent.firstPath + stem.path];
        std::uint32_t at = stem.position - path.firstPosition;
        const auto along = [&] {
            const CSegment& segment = before.segments[path.firstSegment + at];
            return segment.length > 0
                       ? glm::dot(glm::dvec3(point) - segment.position, segment.frame[2]) / segment.length
                       : 0;
        };
        double t = along();
        for (; t > 1 && at + 1 < path.segmentCount; t = along()) ++at;
        for (; t < 0 && at > 0; t = along()) --at;
        return {static_cast<float>(m_table.nodeOf(below, path.firstSegment + at)),
                static_cast<float>(glm::clamp(t, 0.0, 1.0))};
    }

    const CWindTable& m_table;
    const CTree& m_tree;
    const CGeneration& m_all;
    std::size_t m_generation;
    const MeshPlan& m_plan;
    const CMesh& m_mesh;
    SwayPlaces& m_places;
    std::size_t m_next = 0;
};

std::shared_ptr<CMesh> copyOf(const CMesh& mesh) { return std::make_shared<CMesh>(mesh); }
} // namespace

SwayPlaces swayOfStems(const CWindTable& table, std::size_t generation, const MeshPlan& plan, const CMesh& mesh,
                       const CProgress& progress) {
    SwayPlaces places(mesh.vertexCount());
    parallelFor(
        plan.tubes.size(), kTubeGrain,
        [&](std::size_t begin, std::size_t end) {
            CTubePlaces writer(table, generation, plan, mesh, places);
            for (std::size_t t = begin; t < end; ++t) writer.write(plan.tubes[t]);
        },
        progress);
    return places;
}

SwayPlaces swayOfOrgans(const CWindTable& table, const COrganMesh& organs, const CProgress& progress) {
    SwayPlaces places(organs.count());
    parallelFor(
        organs.count(), kLeafGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const CLeaf& leaf = organs.leaf(i);
                places[i] = table.nearestOn(leaf.generation, leaf.stem, glm::dvec3(leaf.position));
            }
        },
        progress);
    return places;
}

SwayPlaces swayOfCards(const CWindTable& table, const std::vector<TwigPlace>& twigs, const CMesh& cards,
                       const CProgress& progress) {
    SwayPlaces places(cards.vertexCount());
    if (twigs.empty()) return places;
    const std::size_t each = cards.vertexCount() / twigs.size();
    parallelFor(
        twigs.size(), kTubeGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin * each; v < end * each; ++v)
                places[v] =
                    table.nearestOn(twigs[v / each].generation, twigs[v / each].stem, glm::dvec3(cards.positions[v]));
        },
        progress);
    return places;
}

Flutter flutterOf(const CTree& tree, const CLeaf& leaf) {
    const std::uint64_t stem = tree.generation(leaf.generation).stems[leaf.stem].id;
    return {hashCombine(stem, leaf.number), leaf.width / std::max(1e-9f, leaf.length)};
}

std::shared_ptr<const CMesh> swayed(const CMesh& mesh, const SwayPlaces& places, const CWindTable& table,
                                    const WindPose& pose, const CProgress& progress) {
    const auto moved = copyOf(mesh);
    parallelFor(
        mesh.vertexCount(), kVertexGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                const Swayed here(table.still(), pose, places[v]);
                moved->positions[v] = here.point(mesh.positions[v]);
                moved->normals[v] = here.direction(mesh.normals[v]);
            }
        },
        progress);
    return moved;
}

std::shared_ptr<const CMesh> swayed(const COrganMesh& organs, const SwayPlaces& places, const CWindTable& table,
                                    const WindPose& pose, double seconds, double loop, const CProgress& progress) {
    const auto moved = copyOf(*organs.expanded(progress));
    const std::size_t each = organs.blade().points.size();
    parallelFor(
        organs.count(), kLeafGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const CLeaf& leaf = organs.leaf(i);
                const Swayed here(table.still(), pose, places[i]);
                const glm::quat flutter =
                    glm::angleAxis(flutterOf(table.tree(), leaf).angle(here.strength, seconds, loop), leaf.axis);
                for (std::size_t v = i * each; v < (i + 1) * each; ++v) {
                    moved->positions[v] = here.point(leaf.position + flutter * (moved->positions[v] - leaf.position));
                    moved->normals[v] = here.direction(flutter * moved->normals[v]);
                }
            }
        },
        progress);
    return moved;
}

} // namespace stromar
