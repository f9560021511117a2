#include "Collar.h"
#include "Smoother.h"
#include "TubeWriter.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 64;
constexpr int kPointsPerLobe = 8, kFewestPointsPerLobe = 4;
constexpr double kApart = 0.2; // radii between the first own ring above a collar and the next

/// Chooses the parts of one generation for a level of detail: which rings are drawn and how many points each has.
class CSimplifier {
public:
    CSimplifier(const CTree& tree, int generation, const CParams& params, const Detail& detail, const StemMesh* parents)
        : m_generation(tree.generation(static_cast<std::size_t>(generation))),
          m_surface(params, generation, tree.scaleTree()), m_smoother(m_surface),
          m_smooth(generation < detail.smoothGenerations),
          m_points(detail.ringPoints[static_cast<std::size_t>(std::min(generation, 3))]),
          m_full(detail.model == Model::Full && detail.lod == 0),
          m_collarRings(
              static_cast<std::uint32_t>(m_points > 3 ? detail.collarRings : std::min(detail.collarRings, 1))) {
        if (parents && m_collarRings > 0)
            m_collars.emplace(tree.generation(static_cast<std::size_t>(generation - 1)), *parents);
    }

    void planStem(std::uint32_t s, MeshPlan& plan) {
        const CStem& stem = m_generation.stems[s];
        for (std::uint32_t p = 0; p < stem.pathCount; ++p) planPath(s, stem.firstPath + p, plan);
    }

private:
    void planPath(std::uint32_t s, std::uint32_t p, MeshPlan& plan) {
        const bool mayHaveCollar = m_collars && m_generation.paths[p].source < 0;
        if (!mayHaveCollar || !planTube(s, p, true, plan)) planTube(s, p, false, plan);
    }

    /// False, and the plan as it was, when the tube cannot be drawn so.
    bool planTube(std::uint32_t s, std::uint32_t p, bool withCollar, MeshPlan& plan) {
        const CStem& stem = m_generation.stems[s];
        const CPath& path = m_generation.paths[p];
        Tube tube{.stem = s,
                  .path = p,
                  .firstRing = static_cast<std::uint32_t>(plan.rings.size()),
                  .points = ringPoints(),
                  .firstCollarPoint = static_cast<std::uint32_t>(plan.collarPoints.size())};
        tube.lobed = m_surface.lobes() > 0 &&
                     tube.points >= static_cast<std::uint32_t>(kFewestPointsPerLobe * m_surface.lobes());
        tube.pointed = endsInPoint(stem, path);
        const double start = withCollar ? addCollar(stem, tube, plan) : 0;
        if ((start > 0 || !withCollar) && addRings(stem, path, start, tube, plan) && !collarFolds(tube, plan)) {
            plan.tubes.push_back(tube);
            return true;
        }
        plan.rings.resize(tube.firstRing);
        plan.collarPoints.resize(tube.firstCollarPoint);
        return false;
    }

    /// How far from the stem's base its own rings start, metres; 0 without a collar.
    double addCollar(const CStem& stem, Tube& tube, MeshPlan& plan) {
        const CSegment& first = m_generation.segments[stem.firstSegment];
        const double radius = std::max(m_surface.woodRadius(stem, first, 0, 0), m_surface.drawnFloor(stem, first));
        const Collar* collar = m_collars->make(
            stem,
            std::span(m_generation.segments).subspan(stem.firstSegment, m_generation.paths[tube.path].segmentCount),
            radius, tube.points);
        if (!collar) return 0;
        tube.collarRings = m_collarRings;
        plan.collarPoints.insert(plan.collarPoints.end(), collar->points.begin(), collar->points.end());
        return collar->clear;
    }

    /// False when the tube is too short to be drawn.
    bool addRings(const CStem& stem, const CPath& path, double start, Tube& tube, MeshPlan& plan) {
        const double segmentLength = stem.measures.length / stem.curveRes;
        const double spacing = CStemSurface::leastDrawn(stem, m_generation.segments[stem.firstSegment]);
        const auto segmentAt = static_cast<std::uint32_t>(start / segmentLength);
        plan.rings.push_back({path.firstSegment + segmentAt, start / segmentLength - segmentAt});
        glm::dvec3 last = ringCentre(plan.rings.back());
        const auto add = [&](std::uint32_t segment, double t, bool tip) {
            if (start > 0 && (segment - path.firstSegment + t) * segmentLength <= start + kApart * stem.measures.radius)
                return;
            const glm::dvec3 here = ringCentre({segment, t});
            const bool near = glm::distance(here, last) < spacing;
            if (near && !tip) return;
            if (near && plan.rings.size() - tube.firstRing > 1) plan.rings.pop_back();
            plan.rings.push_back({segment, t});
            last = here;
        };
        for (std::uint32_t i = segmentAt; i < path.segmentCount; ++i) {
            const std::uint32_t segment = path.firstSegment + i;
            if (i > 0) add(segment, 0, false);
            if (m_smooth) addBetween(stem, segment, path.firstPosition + i, add);
            if (i + 1 == path.segmentCount) add(segment, 1, true);
        }
        tube.ringCount = static_cast<std::uint32_t>(plan.rings.size()) - tube.firstRing;
        return glm::distance(ringCentre(plan.rings[tube.firstRing]), ringCentre(plan.rings.back())) >= spacing;
    }

    /// Tries the tube's collar and what is next to it.
    bool collarFolds(const Tube& tube, const MeshPlan& plan) {
        if (tube.collarRings == 0) return false;
        Tube trial = tube;
        trial.firstVertex = 0;
        trial.firstIndex = 0;
        trial.pointed = tube.pointed && tube.ringCount == 2;
        trial.ringCount = 2;
        m_trial.positions.resize(trial.vertexCount());
        m_trial.normals.resize(trial.vertexCount());
        m_trial.texCoords.resize(trial.vertexCount());
        m_trial.indices.resize(trial.indexCount());
        CPointGenerator points(m_generation, plan, m_surface, {1, 1});
        return !writeTube(trial, points, m_trial);
    }

    template <typename Add>
    void addBetween(const CStem& stem, std::uint32_t segment, std::uint32_t position, Add&& add) {
        m_places.clear();
        m_smoother.subdivide(stem, m_generation.segments[segment], position, m_places);
        for (const double t : m_places) add(segment, t, false);
    }

    std::uint32_t ringPoints() const {
        const int forLobes = m_full ? kPointsPerLobe * m_surface.lobes() : 0;
        return static_cast<std::uint32_t>(std::max(m_points, forLobes));
    }

    bool endsInPoint(const CStem& stem, const CPath& path) const {
        const std::uint32_t last = path.firstSegment + path.segmentCount - 1;
        const double radius =
            m_surface.woodRadius(stem, m_generation.segments[last], path.firstPosition + path.segmentCount - 1, 1);
        return radius < m_surface.drawnFloor(stem, m_generation.segments[stem.firstSegment]);
    }

    glm::dvec3 ringCentre(const Ring& ring) const { return m_generation.segments[ring.segment].centre(ring.t); }

    const CGeneration& m_generation;
    CStemSurface m_surface;
    CSmoother m_smoother;
    bool m_smooth;
    int m_points;
    bool m_full;
    std::uint32_t m_collarRings; ///< twigs get by with one
    std::optional<CCollarMaker> m_collars;
    std::vector<double> m_places;
    CMesh m_trial;
};

void append(MeshPlan& whole, const MeshPlan& part) {
    const auto rings = static_cast<std::uint32_t>(whole.rings.size());
    const auto collarPoints = static_cast<std::uint32_t>(whole.collarPoints.size());
    whole.rings.insert(whole.rings.end(), part.rings.begin(), part.rings.end());
    whole.collarPoints.insert(whole.collarPoints.end(), part.collarPoints.begin(), part.collarPoints.end());
    for (Tube tube : part.tubes) {
        tube.firstRing += rings;
        tube.firstCollarPoint += collarPoints;
        whole.tubes.push_back(tube);
    }
}

/// Gives every tube its place in the mesh.
void layOut(MeshPlan& plan, std::size_t paths) {
    plan.tubeOfPath.assign(paths, -1);
    for (std::size_t t = 0; t < plan.tubes.size(); ++t) {
        Tube& tube = plan.tubes[t];
        plan.tubeOfPath[tube.path] = static_cast<std::int32_t>(t);
        tube.firstVertex = static_cast<std::uint32_t>(plan.vertexCount);
        tube.firstIndex = plan.indexCount;
        plan.vertexCount += tube.vertexCount();
        plan.indexCount += tube.indexCount();
    }
}
} // namespace

MeshPlan planRings(const CTree& tree, int generation, const CParams& params, const Detail& detail,
                   const StemMesh* parents, const CProgress& progress) {
    const CGeneration& own = tree.generation(static_cast<std::size_t>(generation));
    std::vector<MeshPlan> parts((own.stems.size() + kGrain - 1) / kGrain);
    parallelFor(
        own.stems.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            CSimplifier simplifier(tree, generation, params, detail, parents);
            for (std::size_t s = begin; s < end; ++s)
                simplifier.planStem(static_cast<std::uint32_t>(s), parts[begin / kGrain]);
        },
        progress);
    MeshPlan plan;
    for (const MeshPlan& part : parts) append(plan, part);
    layOut(plan, own.paths.size());
    return plan;
}

} // namespace stromar
