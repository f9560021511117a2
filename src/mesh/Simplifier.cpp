#include "Smoother.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 256;
constexpr int kPointsPerLobe = 8, kFewestPointsPerLobe = 4;

/// Chooses the parts of one generation for a level of detail: which rings are drawn and how many points each has.
class CSimplifier {
public:
    CSimplifier(const CTree& tree, int generation, const CParams& params, const Detail& detail)
        : m_generation(tree.generation(static_cast<std::size_t>(generation))),
          m_surface(params, generation, tree.scaleTree()), m_smoother(m_surface),
          m_smooth(generation < detail.smoothGenerations),
          m_points(detail.ringPoints[static_cast<std::size_t>(std::min(generation, 3))]),
          m_full(detail.model == Model::Full && detail.lod == 0) {}

    void planStem(std::uint32_t s, MeshPlan& plan) {
        const CStem& stem = m_generation.stems[s];
        for (std::uint32_t p = 0; p < stem.pathCount; ++p) planPath(s, stem.firstPath + p, plan);
    }

private:
    void planPath(std::uint32_t s, std::uint32_t p, MeshPlan& plan) {
        const CStem& stem = m_generation.stems[s];
        const CPath& path = m_generation.paths[p];
        const CSegment& first = m_generation.segments[path.firstSegment];
        const double spacing = CStemSurface::leastDrawn(stem, m_generation.segments[stem.firstSegment]);
        Tube tube{s, p, static_cast<std::uint32_t>(plan.rings.size()), 0, ringPoints(), false, false};
        tube.lobed = m_surface.lobes() > 0 &&
                     tube.points >= static_cast<std::uint32_t>(kFewestPointsPerLobe * m_surface.lobes());
        plan.rings.push_back({path.firstSegment, 0});
        glm::dvec3 last = first.centre(0);
        const auto add = [&](std::uint32_t segment, double t, bool tip) {
            const glm::dvec3 here = m_generation.segments[segment].centre(t);
            const bool near = glm::distance(here, last) < spacing;
            if (near && !tip) return;
            if (near && plan.rings.size() - tube.firstRing > 1) plan.rings.pop_back();
            plan.rings.push_back({segment, t});
            last = here;
        };
        for (std::uint32_t i = 0; i < path.segmentCount; ++i) {
            const std::uint32_t segment = path.firstSegment + i;
            if (i > 0) add(segment, 0, false);
            if (m_smooth) addBetween(stem, segment, path.firstPosition + i, add);
            if (i + 1 == path.segmentCount) add(segment, 1, true);
        }
        tube.ringCount = static_cast<std::uint32_t>(plan.rings.size()) - tube.firstRing;
        tube.pointed = endsInPoint(stem, path);
        if (glm::distance(ringCentre(plan.rings[tube.firstRing]), ringCentre(plan.rings.back())) < spacing) {
            plan.rings.resize(tube.firstRing); // too short to be drawn
            return;
        }
        plan.tubes.push_back(tube);
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
    std::vector<double> m_places;
};

void append(MeshPlan& whole, const MeshPlan& part) {
    const auto rings = static_cast<std::uint32_t>(whole.rings.size());
    whole.rings.insert(whole.rings.end(), part.rings.begin(), part.rings.end());
    for (Tube tube : part.tubes) {
        tube.firstRing += rings;
        whole.tubes.push_back(tube);
    }
}
} // namespace

MeshPlan planRings(const CTree& tree, int generation, const CParams& params, const Detail& detail,
                   const CProgress& progress) {
    const std::size_t stems = tree.generation(static_cast<std::size_t>(generation)).stems.size();
    std::vector<MeshPlan> parts((stems + kGrain - 1) / kGrain);
    parallelFor(
        stems, kGrain,
        [&](std::size_t begin, std::size_t end) {
            CSimplifier simplifier(tree, generation, params, detail);
            for (std::size_t s = begin; s < end; ++s)
                simplifier.planStem(static_cast<std::uint32_t>(s), parts[begin / kGrain]);
        },
        progress);
    if (parts.size() == 1) return std::move(parts.front());
    MeshPlan plan;
    for (const MeshPlan& part : parts) append(plan, part);
    return plan;
}

} // namespace stromar
