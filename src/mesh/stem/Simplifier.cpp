#include "stem/CentreLine.h"
#include "stem/Collar.h"
#include "stem/Smoother.h"
#include "stem/TubeWriter.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/util/Parallel.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <span>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 64;
constexpr int kFewestPointsPerLobe = 4;
constexpr double kFreeOfDisc = 1.05; // radii that a tilted ring stays off the plane of the next
constexpr double kTight = 0.985;     // cosine between rings that are close
constexpr double kAside = 0.85;      // cosine between a ring and the way to the next
constexpr double kTipReach = 4;      // radii of rings that a tip pushes out
constexpr double kApart = 0.2;       // radii between the first own ring above a collar and the next

/// Whether a stem is among the share of its generation that is drawn. A smaller share chooses of what a larger one
/// does.
bool isChosen(const CStem& stem, std::uint32_t s, double share) {
    return share >= 1 || s == 0 || unitOf(hashCombine(0, stem.id)) < share;
}

/// Chooses the parts of one generation for a level of detail: which rings are drawn and how many points each has.
class CSimplifier {
public:
    CSimplifier(const CTree& tree, int generation, const MeshParams& params, const Detail& detail, const StemMesh* parents)
        : m_detail(detail), m_generation(tree.generation(static_cast<std::size_t>(generation))),
          m_surface(tree, generation, params), m_smoother(m_surface), m_line(m_generation, m_surface),
          m_smooth(generation < detail.smoothGenerations) {
        if (parents && detail.collarRings > 0)
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
                  .points = path.source < 0 ? ringPoints(stem) : pointsOfFork(stem, path, plan),
                  .firstCollarPoint = static_cast<std::uint32_t>(plan.collarPoints.size())};
        tube.maxTurn = tube.points > 3 ? turnOf(stem, m_detail.maxTurn) : 0;
        m_line.start(stem, path, tube.maxTurn);
        tube.lobed = m_surface.ridges() > 0 &&
                     tube.points >= static_cast<std::uint32_t>(kFewestPointsPerLobe * m_surface.ridges());
        tube.pointed = endsInPoint(stem, path);
        const double start = withCollar ? addCollar(stem, tube, plan) : 0;
        if ((start > 0 || !withCollar) && addRings(stem, path, start, tube, plan) && !collarFolds(tube, plan) &&
            unfold(stem, tube, plan)) {
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
        const double radius = std::max(m_surface.woodRadius(stem, first, 0), m_surface.drawnFloor(stem, first));
        const Collar* collar = m_collars->make(
            stem,
            std::span(m_generation.segments).subspan(stem.firstSegment, m_generation.paths[tube.path].segmentCount),
            radius, tube.points);
        if (!collar || collar->minGap() < CStemSurface::minDrawn(stem, first)) return 0;
        tube.collarRings = static_cast<std::uint32_t>(tube.points > 3 ? m_detail.collarRings : 1);
        plan.collarPoints.insert(plan.collarPoints.end(), collar->points.begin(), collar->points.end());
        return collar->clear;
    }

    /// False when the tube is too short to be drawn.
    bool addRings(const CStem& stem, const CPath& path, double start, Tube& tube, MeshPlan& plan) {
        const std::span<const CSegment> segments = m_generation.segmentsOf(path);
        const double clear = start > 0 ? start + kApart * stem.radius : segments.front().start;
        std::uint32_t first = 0;
        while (first + 1 < path.segmentCount && segments[first].end() <= start) ++first;
        const double t = start > 0 ? (start - segments[first].start) / segments[first].length : 0;
        m_spacing = CStemSurface::minDrawn(stem, m_generation.segments[stem.firstSegment]);
        m_last = discAt(stem, {path.firstSegment + first, tube.points, t});
        plan.rings.push_back(m_last.ring);
        const auto add = [&](std::uint32_t segment, double place, bool needed) {
            const CSegment& own = m_generation.segments[segment];
            if (own.start + place * own.length > clear)
                addRing(stem, tube, discAt(stem, {segment, tube.points, place}), needed, plan);
        };
        double left = 0;
        for (std::uint32_t i = first; i < path.segmentCount; ++i) {
            const std::uint32_t segment = path.firstSegment + i;
            if (i > 0 && !isLeftOut(stem, segment, left)) add(segment, 0, m_line.forksBelow(segment));
            if (m_smooth) addBetween(stem, segment, add);
            if (i + 1 == path.segmentCount) add(segment, 1, true);
        }
        tube.ringCount = static_cast<std::uint32_t>(plan.rings.size()) - tube.firstRing;
        halvePoints(stem, tube, plan);
        return glm::distance(ringCentre(plan.rings[tube.firstRing]), ringCentre(plan.rings.back())) >= m_spacing;
    }

    /// Gives rings half as many points as soon as that is enough for their radius. Lobes and spheres keep theirs.
    void halvePoints(const CStem& stem, const Tube& tube, MeshPlan& plan) const {
        if (tube.lobed || !stem.profile.isEven()) return;
        std::uint32_t points = tube.points;
        for (std::uint32_t r = 0; r < tube.ringCount; ++r) {
            Ring& ring = plan.rings[tube.firstRing + r];
            const bool tip = tube.pointed && r + 1 == tube.ringCount;
            if (r > 0 && !tip && points >= 6 && points % 2 == 0 &&
                roundPoints(discAt(stem, ring).radius) <= static_cast<int>(points / 2))
                points /= 2;
            ring.points = points;
        }
    }

    /// As many as the ring has that a clone leaves.
    std::uint32_t pointsOfFork(const CStem& stem, const CPath& path, const MeshPlan& plan) const {
        const std::uint32_t sourcePath = stem.firstPath + static_cast<std::uint32_t>(path.source);
        const CPath& source = m_generation.paths[sourcePath];
        const std::uint32_t segment = source.firstSegment + path.firstPosition - source.firstPosition;
        for (auto tube = plan.tubes.rbegin(); tube != plan.tubes.rend(); ++tube) {
            if (tube->path != sourcePath) continue;
            std::uint32_t points = tube->points;
            for (std::uint32_t r = 0; r < tube->ringCount; ++r)
                if (const Ring& ring = plan.ringsOf(*tube)[r];
                    ring.segment < segment || (ring.segment == segment && ring.t == 0))
                    points = ring.points;
            return points;
        }
        return ringPoints(stem);
    }

    /// A ring as the flat round thing it covers.
    struct Disc {
        Ring ring;
        glm::dvec3 centre, axis, right;
        double radius;
    };

    Disc discAt(const CStem& stem, const Ring& ring) const {
        const CCentreLine::Place place = m_line.at(ring.segment, ring.t);
        const double radius = m_surface.outerRadius(stem, m_generation.segments[ring.segment], ring.t);
        const double floor = m_surface.drawnFloor(stem, m_generation.segments[stem.firstSegment]);
        return {ring, place.centre, place.frame[2], place.frame[0], place.stretch * std::max(radius, floor)};
    }

    /// Whether two rings would touch or one reach through the other, so that the wall between them folds.
    bool collide(const Disc& low, const Disc& high) const {
        const glm::dvec3 apart = high.centre - low.centre;
        const double distance = glm::length(apart);
        if (distance < m_spacing) return true;
        if (distance > low.radius + high.radius) return false;
        const double cosine = glm::dot(low.axis, high.axis);
        if (cosine > 1 - 1e-12) return false;
        const double sine = cosine > 0 ? std::sqrt(std::max(0.0, 1 - cosine * cosine)) : 1;
        return glm::dot(apart, low.axis) < kFreeOfDisc * high.radius * sine ||
               glm::dot(apart, high.axis) < kFreeOfDisc * low.radius * sine;
    }

    /// Appends a ring that keeps off the last one; a ring that is needed pushes others out, all but the first.
    void addRing(const CStem& stem, const Tube& tube, const Disc& disc, bool needed, MeshPlan& plan) {
        if (!needed && collide(m_last, disc)) return;
        while (collide(m_last, disc) && plan.rings.size() - tube.firstRing > 1 && alongBetween(m_last, disc) < kTipReach * (m_last.radius + disc.radius)) {
            plan.rings.pop_back();
            m_last = discAt(stem, plan.rings.back());
        }
        plan.rings.push_back(disc.ring);
        m_last = disc;
    }

    /// Metres along the path.
    double alongBetween(const Disc& low, const Disc& high) const {
        const auto along = [&](const Ring& ring) {
            const CSegment& segment = m_generation.segments[ring.segment];
            return segment.start + ring.t * segment.length;
        };
        return along(high.ring) - along(low.ring);
    }

    /// Whether a ring between segments changes too little to be drawn; `left` sums the turns since the last that is.
    bool isLeftOut(const CStem& stem, std::uint32_t segment, double& left) const {
        left += m_line.turnBelow(segment);
        const CSegment& above = m_generation.segments[segment];
        const bool needed = m_line.forksBelow(segment) || m_surface.uneven(stem) || above.helixRadius > 0 ||
                            left >= turnOf(stem, m_detail.minTurn) ||
                            left * above.length > 2 * above.radiusBase; // the chord would leave the wood
        if (needed) left = 0;
        return !needed;
    }

    double turnOf(const CStem& stem, double ofTrunk) const {
        return std::numbers::pi / 180 *
               std::min(kCoarsestTurn * ofTrunk, ofTrunk / std::max(1e-6, m_surface.thickness(stem.radius)));
    }

    /// Tries the tube's collar and what is next to it.
    bool collarFolds(const Tube& tube, const MeshPlan& plan) {
        if (tube.collarRings == 0) return false;
        Tube trial = tube;
        trial.pointed = tube.pointed && tube.ringCount == 2;
        trial.ringCount = 2;
        return !writeTrial(trial, plan);
    }

    /// Takes rings out where the walls of a stem that turns in less than its thickness would fold, and lets it end in a
    /// point if its end would; false when that does not help.
    bool unfold(const CStem& stem, Tube& tube, MeshPlan& plan) {
        if (tube.lobed || !isTight(stem, tube, plan)) return true;
        for (;;) {
            Tube trial = tube;
            const bool folds = !writeTrial(trial, plan);
            if (!folds && enclosesWood(trial)) return true;
            const std::uint32_t folded = folds ? foldedRing(trial, plan) : tube.ringCount - 1;
            if (!tube.pointed && folded + 1 >= tube.ringCount)
                tube.pointed = true;
            else if (tube.ringCount > 2) {
                const std::uint32_t out = std::clamp(folded, 1u, tube.ringCount - 2);
                plan.rings.erase(plan.rings.begin() + tube.firstRing + out);
                --tube.ringCount;
            } else if (!tube.pointed)
                tube.pointed = true;
            else
                return false;
            halvePoints(stem, tube, plan);
        }
    }

    /// Whether two rings that follow each other are turned against each other, so that the wall between them may fold.
    bool isTight(const CStem& stem, const Tube& tube, const MeshPlan& plan) const {
        Disc low = discAt(stem, *plan.ringsOf(tube));
        for (std::uint32_t r = 1; r < tube.ringCount; ++r) {
            const Disc high = discAt(stem, plan.ringsOf(tube)[r]);
            const glm::dvec3 apart = high.centre - low.centre;
            const double distance = glm::length(apart);
            const bool tilted = distance < low.radius + high.radius && glm::dot(low.axis, high.axis) < kTight;
            const bool aside = std::min(glm::dot(apart, low.axis), glm::dot(apart, high.axis)) < kAside * distance;
            const bool twisted = glm::dot(low.right, high.right) < kAside; // about the line, where rings were left out
            if (tilted || aside || twisted) return true;
            low = high;
        }
        return false;
    }

    /// The first ring of a tube of the trial that has a vertex whose normal looks into a triangle around it.
    std::uint32_t foldedRing(const Tube& trial, const MeshPlan& plan) const {
        const auto& indices = m_trial.indices;
        for (std::size_t t = 0; t < trial.indexCount(); t += 3) {
            const auto at = [&](std::size_t c) { return m_trial.positions[indices[t + c]]; };
            const glm::vec3 face = glm::cross(at(1) - at(0), at(2) - at(0));
            for (std::size_t c = 0; c < 3; ++c)
                if (glm::dot(face, m_trial.normals[indices[t + c]]) <= 0) return ringOf(trial, plan, indices[t + c]);
        }
        return 1;
    }

    /// Whether a tube of the trial is not inside out.
    bool enclosesWood(const Tube& trial) const {
        double volume = 0;
        const glm::dvec3 origin(m_trial.positions[0]);
        for (std::size_t t = 0; t < trial.indexCount(); t += 3) {
            const auto at = [&](std::size_t c) { return glm::dvec3(m_trial.positions[m_trial.indices[t + c]]) - origin; };
            volume += glm::dot(at(0), glm::cross(at(1), at(2)));
        }
        return volume > 0;
    }

    /// The lids' vertices belong to the last ring and to the first.
    static std::uint32_t ringOf(const Tube& tube, const MeshPlan& plan, std::uint32_t vertex) {
        std::uint32_t end = tube.collarRings * (tube.points + 1);
        for (std::uint32_t r = 0; r < tube.ringCount; ++r) {
            end += plan.ringsOf(tube)[r].points + 1;
            if (vertex < end) return r;
        }
        return tube.ringCount - 1;
    }

    /// False when it folds.
    bool writeTrial(Tube& trial, const MeshPlan& plan) {
        trial.firstVertex = 0;
        trial.firstIndex = 0;
        measure(plan, trial);
        m_trial.positions.resize(trial.vertexCount());
        m_trial.normals.resize(trial.vertexCount());
        m_trial.texCoords.resize(trial.vertexCount());
        m_trial.skyVisibility.resize(trial.vertexCount());
        m_trial.indices.resize(trial.indexCount());
        CPointGenerator points(m_generation, plan, m_surface);
        return writeTube(plan, trial, points, m_trial);
    }

    template <typename Add>
    void addBetween(const CStem& stem, std::uint32_t segment, Add&& add) {
        m_places.clear();
        m_smoother.subdivide(stem, m_generation.segments[segment], m_detail.helixRings, m_places);
        m_line.addBendRings(segment, m_places);
        std::ranges::sort(m_places);
        for (const double t : m_places) add(segment, t, false);
    }

    std::uint32_t ringPoints(const CStem& stem) const {
        const int forLobes = m_detail.lobePoints * m_surface.ridges();
        return static_cast<std::uint32_t>(std::max(roundPoints(stem.radius), forLobes));
    }

    int roundPoints(double radius) const { return roundRingPoints(m_detail, m_surface.thickness(radius)); }

    bool endsInPoint(const CStem& stem, const CPath& path) const {
        const std::uint32_t last = path.firstSegment + path.segmentCount - 1;
        const double radius = m_surface.woodRadius(stem, m_generation.segments[last], 1);
        return radius < m_surface.drawnFloor(stem, m_generation.segments[stem.firstSegment]);
    }

    glm::dvec3 ringCentre(const Ring& ring) const { return m_line.at(ring.segment, ring.t).centre; }

    const Detail& m_detail;
    const CGeneration& m_generation;
    CStemSurface m_surface;
    CSmoother m_smoother;
    CCentreLine m_line;
    bool m_smooth;
    std::optional<CCollarMaker> m_collars;
    Disc m_last{};        ///< of the tube that is being planned
    double m_spacing = 0; ///< metres below which rings coincide
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
        measure(plan, tube);
        tube.firstVertex = static_cast<std::uint32_t>(plan.vertexCount);
        tube.firstIndex = plan.indexCount;
        plan.vertexCount += tube.vertexCount();
        plan.indexCount += tube.indexCount();
    }
}

MeshPlan planAll(const CTree& tree, int generation, const MeshParams& params, const Detail& detail,
                 const StemMesh* parents, const std::vector<bool>& drawn, const CProgress& progress) {
    const CGeneration& own = tree.generation(static_cast<std::size_t>(generation));
    std::vector<MeshPlan> parts((own.stems.size() + kGrain - 1) / kGrain);
    parallelFor(
        own.stems.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
            CSimplifier simplifier(tree, generation, params, detail, parents);
            for (std::size_t s = begin; s < end; ++s)
                if (drawn[s]) simplifier.planStem(static_cast<std::uint32_t>(s), parts[begin / kGrain]);
        },
        progress);
    MeshPlan plan;
    for (const MeshPlan& part : parts) append(plan, part);
    layOut(plan, own.paths.size());
    return plan;
}

/// The part of the last generation's stems that fills what the others leave of the detail's share of triangles.
double shareOfTwigs(const CTree& tree, const MeshParams& params, const Detail& detail, const CProgress& progress) {
    const int last = static_cast<int>(tree.generationCount()) - 1;
    const auto size = [&](int generation, const Detail& at) {
        const std::vector<bool> all(tree.generation(static_cast<std::size_t>(generation)).stems.size(), true);
        return double(planAll(tree, generation, params, at, nullptr, all, progress).indexCount);
    };
    double left = 0;
    for (int g = 0; g <= last; ++g) left += detail.share * size(g, detailOf(detail.model, 0));
    for (int g = 0; g < last; ++g) left -= size(g, detail);
    return std::clamp(left / std::max(1.0, size(last, detail)), detail.share, 1.0);
}
} // namespace

bool isSparse(const CTree& tree, int generation, const Detail& detail, const StemSet& asCards) {
    return asCards.empty() && detail.share < 1 && generation >= 2 && generation + 1 == static_cast<int>(tree.generationCount());
}

MeshPlan planRings(const CTree& tree, int generation, const MeshParams& params, const Detail& detail,
                   const StemMesh* parents, const CProgress& progress, const StemSet& asCards) {
    const auto g = static_cast<std::size_t>(generation);
    const double share = isSparse(tree, generation, detail, asCards) ? shareOfTwigs(tree, params, detail, progress) : 1;
    std::vector<bool> chosen, drawn;
    for (std::uint32_t s = 0; s < tree.generation(g).stems.size(); ++s) {
        chosen.push_back(isChosen(tree.generation(g).stems[s], s, share));
        drawn.push_back(chosen.back() && !asCards.has(g, s));
    }
    MeshPlan plan = planAll(tree, generation, params, detail, parents, drawn, progress);
    plan.stemIsChosen = std::move(chosen);
    return plan;
}

} // namespace stromar
