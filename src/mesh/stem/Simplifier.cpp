#include "stem/Simplifier.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace stromar {

namespace {
constexpr int kFewestPointsPerLobe = 4;
constexpr double kFreeOfDisc = 1.05; // radii that a tilted ring stays off the plane of the next
constexpr double kTight = 0.985;     // cosine between rings that are close
constexpr double kAside = 0.85;      // cosine between a ring and the way to the next
constexpr double kTipReach = 4;      // radii of rings that a tip pushes out
constexpr double kApart = 0.2;       // radii between the first own ring above a collar and the next
constexpr double kApartOfFork = 0.05; // likewise above a fork
constexpr CollarShape kCollarShapes[]{{1, 0.3}, {1, 0.1}, {0.6, 0.3}, {0.6, 0.1}, {0.6, 0.02}, {0.4, 0.1}}; // first the usual one
constexpr ExitSearch kExitSearches[]{{}, {.ahead = 3}, {.ahead = 3, .aside = true}, {.ahead = 6}};
constexpr double kCoinciding = 0.5; // radii that the lines of two paths may lie apart for one of them to be drawn for both
constexpr double kLeastGap = 0.4; // between neighbours on a collar, of what can be drawn well
constexpr std::uint32_t kOneByOne = 16; // folded rings that are taken out before many are at a time; likewise tries with the forks that do not fold

/// Whether branches may part at forks of a generation's stems.
bool branchesPart(const CTree& tree, int generation, const Detail& detail, const BranchesAbove* above) {
    return above && detail.collarRings > 0 && tree.branchesAtNodes(static_cast<std::size_t>(generation));
}
} // namespace

void CSimplifier::Mark::restore(MeshPlan& plan) const {
    plan.rings.resize(rings);
    plan.tubes.resize(tubes);
    plan.collarPoints.resize(collarPoints);
    plan.forks.resize(forks);
    plan.forkPoints.resize(forkPoints);
    plan.branches.resize(branches);
    plan.branchPoints.resize(branchPoints);
    plan.barkJoints.resize(barkJoints);
}

CSimplifier::CSimplifier(const CTree& tree, int generation, const MeshParams& params, const Detail& detail,
                         StemsBelow below, std::span<const float> room, const Thickening& thickening, const BranchesAbove* above)
    : m_detail(detail), m_generation(tree.generation(static_cast<std::size_t>(generation))),
      m_surface(tree, generation, params, detail, thickening), m_smoother(m_surface), m_line(m_generation, m_surface),
      m_forkMaker(tree, static_cast<std::size_t>(generation), m_surface, detail), m_trial(m_generation, m_surface),
      m_smooth(generation < detail.smoothGenerations), m_maxSag(detail.maxSag * tree.height()), m_room(room) {
    if (!below.empty() && detail.collarRings > 0) {
        m_collars.emplace(tree, below);
        m_parents = &below.back()->plan;
    }
    if (!branchesPart(tree, generation, detail, above)) return;
    m_branches.emplace(tree, static_cast<std::size_t>(generation), params, detail, *above, m_surface);
    m_forkMaker.letBranchesPart(m_branches->nodes(), m_branches->branchSurface());
}

void CSimplifier::planStem(std::uint32_t s, MeshPlan& plan) {
    const Mark before(plan);
    planPaths(s, plan);
    const auto own = std::span(plan.tubes).subspan(before.tubes);
    if (own.size() < 3) return;
    const std::vector<Tube> all(own.begin(), own.end());
    std::ranges::stable_sort(own, {}, [&](const Tube& tube) { return surfaceOf(tube, all); });
}

/// Forks that turn out to fold are left out: the path they part from is planned again, and all after it.
void CSimplifier::planPaths(std::uint32_t s, MeshPlan& plan) {
    const CStem& stem = m_generation.stems[s];
    m_refused.clear();
    m_tries = 0;
    m_starts.assign(stem.pathCount, {});
    findCoinciding(stem);
    if (m_parents) m_starts[0] = startOnParent(*m_parents, stem, s);
    std::vector<Mark> before;
    for (std::uint32_t p = 0; p < stem.pathCount;) {
        before.erase(before.begin() + p, before.end());
        before.emplace_back(plan);
        const std::uint32_t again = planPath(s, p, plan);
        if (again <= p) before[again].restore(plan);
        p = again;
    }
}

/// Which path of the stem is to be planned next.
std::uint32_t CSimplifier::planPath(std::uint32_t s, std::uint32_t p, MeshPlan& plan) {
    const std::uint32_t index = m_generation.stems[s].firstPath + p;
    const CPath& path = m_generation.paths[index];
    const bool mayHaveCollar = m_collars && path.source < 0 && m_starts[p].common.points == 0;
    if (mayHaveCollar && (planWithCollar(s, index, plan) || isHidden(m_generation.stems[s], path))) return p + 1;
    ForkStart& start = m_starts[p];
    const bool starts = start.common.points > 0;
    if (!starts && m_drawnAs[p] != p) return p + 1;
    if (planTube(s, index, {}, plan)) return p + 1;
    if (!starts || !m_startFolds) {
        const bool one = !m_folded.empty() && ++m_tries < kOneByOne;
        const std::vector<std::uint32_t>& folded = one ? m_folded : m_planned;
        m_refused.insert(folded.begin(), folded.end());
        if (!folded.empty()) return p;
    }
    if (!starts) return p + 1;
    if (path.source < 0) {
        start = {}; // the parent keeps its lid
        return p;
    }
    m_refused.insert(start.common.segment);
    return static_cast<std::uint32_t>(path.source);
}

/// Whether the wood of its parent hides a stem: then it is not drawn.
bool CSimplifier::isHidden(const CStem& stem, const CPath& path) {
    return stem.pathCount == 1 && m_collars->hides(stem, m_generation.segmentsOf(path));
}

/// Finds the clones that run along in the wood of those they split from: they are not drawn, and theirs lie in the same wood or come out of it.
void CSimplifier::findCoinciding(const CStem& stem) {
    const auto paths = std::span(m_generation.paths).subspan(stem.firstPath, stem.pathCount);
    m_drawnAs.assign(stem.pathCount, 0);
    for (std::uint32_t p = 1; p < stem.pathCount; ++p) {
        const std::uint32_t wood = m_drawnAs[static_cast<std::size_t>(paths[p].source)];
        m_drawnAs[p] = coincides(stem, paths[p], paths[wood]) ? wood : p;
    }
}

bool CSimplifier::coincides(const CStem& stem, const CPath& clone, const CPath& wood) const {
    const auto own = m_generation.segmentsOf(clone), beside = m_generation.segmentsOf(wood).subspan(clone.firstPosition - wood.firstPosition);
    if (own.size() > beside.size()) return false;
    return std::ranges::equal(own, beside.first(own.size()), [&](const CSegment& one, const CSegment& other) {
        const double near = kCoinciding * m_surface.drawnAtBase(stem, other);
        return glm::distance(one.centre(0.5), other.centre(0.5)) <= near && glm::distance(one.centre(1), other.centre(1)) <= near;
    });
}

/// With the usual collar, or in turn with what may fit where that folds or the branch does not seem to leave the wood; one that has too
/// little room crosses others.
bool CSimplifier::planWithCollar(std::uint32_t s, std::uint32_t p, MeshPlan& plan) {
    const double room = double(m_room[s]);
    return planWithCollar(s, p, room, plan) || (room < 1 && planWithCollar(s, p, 1, plan));
}

bool CSimplifier::planWithCollar(std::uint32_t s, std::uint32_t p, double room, MeshPlan& plan) {
    for (const ExitSearch& search : kExitSearches)
        for (CollarShape shape : kCollarShapes) {
            shape.width *= room;
            if (planTube(s, p, CollarTry{shape, search}, plan)) return true;
            if (!m_folded.empty()) return false; // it is a fork that folds
            if (!m_collars->leavesWood()) break;
        }
    return false;
}

/// False, and the plan as it was, when the tube cannot be drawn so.
bool CSimplifier::planTube(std::uint32_t s, std::uint32_t p, const std::optional<CollarTry>& collar, MeshPlan& plan) {
    const CStem& stem = m_generation.stems[s];
    const CPath& path = m_generation.paths[p];
    const Mark before(plan);
    ForkStart& fork = startOf(stem, p);
    const bool forked = fork.limb.isBranch;
    const double radius = path.source < 0 ? stem.radius : m_generation.segments[path.firstSegment].radiusBase;
    Tube tube{.stem = s,
              .path = p,
              .firstRing = static_cast<std::uint32_t>(before.rings),
              .points = fork.common.points > 0 ? fork.common.points : static_cast<std::uint32_t>(m_surface.ringPoints(radius)),
              .firstCollarPoint = static_cast<std::uint32_t>(before.collarPoints),
              .firstFork = static_cast<std::uint32_t>(before.forks),
              .joined = fork.common.points > 0 && !forked,
              .forked = forked,
              .firstBranch = static_cast<std::uint32_t>(before.branches)};
    if (forked) fork.firstPoint = addForkPoints(fork.limb.points, plan);
    startBark(stem, tube, plan);
    tube.maxTurn = tube.points > 3 ? m_surface.turnOf(stem, m_detail.maxTurn) : 0;
    m_line.start(stem, path, tube.maxTurn);
    tube.lobed = m_surface.ridges() > 0 &&
                 tube.points >= static_cast<std::uint32_t>(kFewestPointsPerLobe * m_surface.ridges());
    tube.pointed = endsInPoint(stem, path);
    m_forkMaker.start(stem, p - stem.firstPath, tube.maxTurn, tube.lobed);
    m_planned.clear();
    m_folded.clear();
    m_startFolds = false;
    for (std::uint32_t q = 1; q < stem.pathCount; ++q)
        if (m_generation.paths[stem.firstPath + q].source == static_cast<std::int32_t>(p - stem.firstPath)) m_starts[q] = {};
    const double start = collar ? addCollar(stem, *collar, tube, plan) : 0;
    if ((start > 0 || !collar) && addRings(stem, path, start, tube, plan) && !collarFolds(tube, plan) &&
        !forksFold(tube, plan) && unfold(stem, tube, plan)) {
        plan.tubes.push_back(tube);
        return true;
    }
    before.restore(plan);
    return false;
}

/// The first path of the closed surface that a tube is a part of.
std::uint32_t CSimplifier::surfaceOf(const Tube& tube, std::span<const Tube> own) const {
    if (!tube.joined) return tube.path;
    const CPath& path = m_generation.paths[tube.path];
    const std::uint32_t source = m_generation.stems[tube.stem].firstPath + static_cast<std::uint32_t>(path.source);
    return surfaceOf(*std::ranges::find(own, source, &Tube::path), own);
}

/// How far from the stem's base its own rings start, metres; 0 without a collar.
double CSimplifier::addCollar(const CStem& stem, const CollarTry& own, Tube& tube, MeshPlan& plan) {
    const CSegment& first = m_generation.segments[stem.firstSegment];
    const double radius = m_surface.drawnAtBase(stem, first);
    const auto segments = std::span(m_generation.segments).subspan(stem.firstSegment, m_generation.paths[tube.path].segmentCount);
    const Collar* collar = m_collars->make(stem, {segments, radius, tube.points}, own.shape, own.search);
    if (!collar || collar->minGap() < kLeastGap * CStemSurface::minDrawn(stem, first)) return 0;
    tube.standsOn = collar->standsOn;
    tube.collarRings = static_cast<std::uint32_t>(tube.points > 3 ? m_detail.collarRings : 1);
    plan.collarPoints.insert(plan.collarPoints.end(), collar->points.begin(), collar->points.end());
    return collar->clear;
}

/// False when the tube is too short to be drawn.
bool CSimplifier::addRings(const CStem& stem, const CPath& path, double start, Tube& tube, MeshPlan& plan) {
    m_spacing = CStemSurface::minDrawn(stem, m_generation.segments[stem.firstSegment]);
    m_clear = start > 0 ? start + kApart * stem.radius : m_generation.segments[path.firstSegment].start;
    m_fixed = 1;
    m_halved = 0;
    const auto add = [&](std::uint32_t segment, double place, bool needed) {
        const Ring ring{segment, tube.points, place};
        if (alongOf(ring) > m_clear) addRing(stem, tube, discAt(stem, ring), needed, plan);
    };
    const auto radiusAbove = [&, own = m_generation.segmentsOf(path)](std::uint32_t i) { // that is drawn: the width of an L-system's stem jumps at nodes
        return i + 1 < path.segmentCount ? own[i + 1].radiusBase : own[i].radiusEnd;
    };
    Bend left;
    for (std::uint32_t i = addFirstRings(stem, path, start, tube, plan); i < path.segmentCount; ++i) {
        const std::uint32_t segment = path.firstSegment + i;
        const bool forks = i > 0 && m_line.forksBelow(segment);
        if (i > 0 && !((forks || m_branches) && addFork(stem, tube, segment, plan)) && !isLeftOut(stem, segment, radiusAbove(i), left))
            add(segment, 0, forks);
        if (m_smooth) addBetween(stem, segment, add);
        if (i + 1 == path.segmentCount) add(segment, 1, true);
    }
    tube.ringCount = ringCountOf(tube, plan);
    halvePoints(stem, tube, plan);
    const auto centre = [&](const Ring& ring) { return m_line.at(ring.segment, ring.t).centre; };
    return glm::distance(centre(plan.rings[tube.firstRing]), centre(plan.rings.back())) >= m_spacing;
}

/// The path's lowest ring, or all those of the fork it starts at; which of its segments the next stands on.
std::uint32_t CSimplifier::addFirstRings(const CStem& stem, const CPath& path, double start, Tube& tube, MeshPlan& plan) {
    if (const ForkStart& fork = startOf(stem, tube.path); fork.common.points > 0)
        return addLimb(stem, fork, tube, plan);
    const std::span<const CSegment> segments = m_generation.segmentsOf(path);
    std::uint32_t first = 0;
    while (first + 1 < path.segmentCount && segments[first].end() <= start) ++first;
    Ring ring{path.firstSegment + first, tube.points, start > 0 ? (start - segments[first].start) / segments[first].length : 0};
    const CSegment* below = m_generation.segmentBelow(stem, path);
    if (const double reach = m_line.forkReach(path.firstSegment); below && reach > 0)
        ring = {indexOf(*below), tube.points, 1 - reach / below->length};
    m_last = discAt(stem, ring);
    plan.rings.push_back(ring);
    return first;
}

/// The common ring of a fork and those with which the tube's path goes on; false where its clones start inside the wood.
bool CSimplifier::addFork(const CStem& stem, Tube& tube, std::uint32_t segment, MeshPlan& plan) {
    const auto node = m_forkMaker.nodeAt(segment, m_line.forkReach(segment));
    if (!node || m_refused.contains(node->segmentBelow)) return false;
    const CSegment& below = m_generation.segments[node->segmentBelow];
    Ring common{node->segmentBelow, tube.points, 1 - node->reach / below.length};
    const Disc disc = discAt(stem, common);
    if (alongOf(common) <= m_clear || collide(discAt(stem, plan.rings[tube.firstRing + m_fixed - 1]), disc)) return false;
    if (!node->branches.empty() && (isRidged(stem, tube, common) || !m_branches->mayPart(*node, ownRadius(stem, common)))) return false;
    std::vector<Ring> pushedOut;
    while (plan.rings.size() - tube.firstRing > m_fixed &&
           (alongOf(plan.rings.back()) >= alongOf(common) || collide(discAt(stem, plan.rings.back()), disc))) {
        pushedOut.push_back(plan.rings.back());
        popRing(tube, plan);
    }
    plan.rings.push_back(common);
    tube.ringCount = ringCountOf(tube, plan);
    halvePoints(stem, tube, plan);
    if (std::uint32_t& points = plan.rings.back().points; !node->branches.empty()) points = m_branches->pointsAt(*node, ownRadius(stem, common), points);
    common = plan.rings.back();
    auto rings = m_forkMaker.make(*node, common.points);
    if (!rings || (m_branches && m_branches->fold(*rings, common.points))) {
        popRing(tube, plan);
        plan.rings.insert(plan.rings.end(), pushedOut.rbegin(), pushedOut.rend());
        m_last = discAt(stem, plan.rings.back());
        return false;
    }
    plan.forks.push_back({tube.ringCount - 1, 1, addForkPoints(rings->common, plan)});
    ForkStart runsOn;
    std::ranges::sort(rings->limbs, {}, &ForkLimb::number);
    for (ForkLimb& limb : rings->limbs) {
        if (limb.isBranch) {
            m_branches->add(limb, common.points, tube, plan);
            continue;
        }
        ForkStart& start = limb.number == node->paths.front() ? runsOn : m_starts[limb.number];
        start.firstPoint = addForkPoints(limb.points, plan);
        start.common = common;
        start.limb = std::move(limb);
    }
    m_planned.push_back(node->segmentBelow);
    addLimb(stem, runsOn, tube, plan);
    return true;
}

/// That of a branch runs on from its parent's.
void CSimplifier::startBark(const CStem& stem, Tube& tube, MeshPlan& plan) {
    if (tube.forked) {
        tube.barkJoint = static_cast<std::uint32_t>(plan.barkJoints.size());
        plan.barkJoints.push_back(m_parents->branch(tube.stem)->bark);
    }
    if (m_branches) m_branches->startPath(m_generation, stem, m_generation.paths[tube.path], tube.forked ? &plan.barkJoints.back() : nullptr);
}

/// Whether roots or lobes stand out of a ring.
bool CSimplifier::isRidged(const CStem& stem, const Tube& tube, const Ring& ring) const {
    return tube.lobed && (m_surface.lobes() > 0 || alongOf(ring) < m_surface.rootsOf(stem).height() * stem.length);
}

/// With a path's rings above a fork; which of its segments the first of its own stands on.
std::uint32_t CSimplifier::addLimb(const CStem& stem, const ForkStart& start, Tube& tube, MeshPlan& plan) {
    const CPath& path = m_generation.paths[tube.path];
    addLimbRings(m_generation, start, tube, plan);
    m_last = discAt(stem, plan.rings.back());
    m_fixed = ringCountOf(tube, plan);
    m_clear = start.limb.along.back() + kApartOfFork * m_last.radius;
    return std::max(m_last.ring.segment, path.firstSegment) - path.firstSegment;
}

/// Gives rings half as many points as soon as that is enough for their radius, but for those about forks; above these as many as there.
void CSimplifier::halvePoints(const CStem& stem, const Tube& tube, MeshPlan& plan) {
    const auto isGiven = [&, forks = std::span(plan.forks).subspan(tube.firstFork)](std::uint32_t r) {
        const auto above = std::ranges::upper_bound(forks, r, {}, &Fork::ring);
        return above != forks.begin() && r <= (above - 1)->ring + (above - 1)->rings + 1;
    };
    const bool mayHalve = !tube.lobed && stem.profile.isEven();
    Ring* rings = &plan.rings[tube.firstRing];
    std::uint32_t points = m_halved > 0 ? rings[m_halved - 1].points : tube.points;
    for (std::uint32_t r = std::exchange(m_halved, tube.ringCount); r < tube.ringCount; ++r) {
        Ring& ring = rings[r];
        const bool tip = tube.pointed && r + 1 == tube.ringCount;
        if (isGiven(r))
            points = ring.points;
        else if (mayHalve && r > 0 && !tip && canHalve(stem, points, ring))
            points /= 2;
        ring.points = points;
    }
}

bool CSimplifier::canHalve(const CStem& stem, std::uint32_t points, const Ring& ring) const {
    return points >= 6 && points % 2 == 0 &&
           m_surface.roundPoints(ownRadius(stem, ring)) <= static_cast<int>(points / 2);
}

CSimplifier::Disc CSimplifier::discAt(const CStem& stem, const Ring& ring) const {
    const CCentreLine::Place place = m_line.at(ring.segment, ring.t);
    const double radius = m_surface.outerRadius(stem, m_generation.segments[ring.segment], ring.t);
    const double floor = m_surface.drawnFloor(stem, m_generation.segments[stem.firstSegment]);
    return {ring, place.centre, place.frame[2], place.frame[0], place.stretch * std::max(radius, floor)};
}

/// Whether two rings would touch or one reach through the other, so that the wall between them folds.
bool CSimplifier::collide(const Disc& low, const Disc& high) const {
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

/// Appends a ring that keeps off the last one; a ring that is needed pushes others out, all but those that are fixed.
void CSimplifier::addRing(const CStem& stem, const Tube& tube, const Disc& disc, bool needed, MeshPlan& plan) {
    if (!needed && collide(m_last, disc)) return;
    while (collide(m_last, disc) && plan.rings.size() - tube.firstRing > m_fixed &&
           alongOf(disc.ring) - alongOf(m_last.ring) < kTipReach * (m_last.radius + disc.radius)) {
        popRing(tube, plan);
        m_last = discAt(stem, plan.rings.back());
    }
    plan.rings.push_back(disc.ring);
    m_last = disc;
}

/// Metres from the stem's base.
double CSimplifier::alongOf(const Ring& ring) const {
    const CSegment& segment = m_generation.segments[ring.segment];
    return segment.start + ring.t * segment.length;
}

/// Whether a ring between segments changes too little to be drawn; `radiusAbove`: of the next one.
bool CSimplifier::isLeftOut(const CStem& stem, std::uint32_t segment, double radiusAbove, Bend& left) const {
    const CSegment &below = m_generation.segments[segment - 1], &above = m_generation.segments[segment];
    if (left.length == 0) left.radius = below.radiusBase;
    left.turn += m_line.turnBelow(segment);
    left.length += below.length;
    const bool bends = left.turn >= m_surface.turnOf(stem, m_detail.minTurn) ||
                       left.turn * above.length > 2 * above.radiusBase; // the chord would leave the wood
    const double sag = left.turn * (left.length + above.length) / 8; // of an arc
    const double ofCone = glm::mix(left.radius, radiusAbove, left.length / (left.length + above.length));
    const double maxTaperError = m_detail.maxTaperError * above.radiusBase / std::max(1e-6, m_surface.thickness(stem.radius));
    const bool offCone = std::abs(above.radiusBase - ofCone) > maxTaperError;
    const bool needed = m_line.forksBelow(segment) || m_surface.uneven(stem) || above.helixRadius > m_maxSag || (bends && sag >= m_maxSag) || offCone;
    if (needed) left = {};
    return !needed;
}

/// Tries the tube's collar and what is next to it.
bool CSimplifier::collarFolds(const Tube& tube, const MeshPlan& plan) {
    if (tube.collarRings == 0) return false;
    Tube trial = tube;
    trial.pointed = tube.pointed && tube.ringCount == 2;
    trial.ringCount = 2;
    trial.branchCount = 0; // their forks are further up
    return !m_trial.write(plan, trial) || !m_trial.enclosesWood();
}

/// Whether a tube with forks folds: it is to be planned without those where it does.
bool CSimplifier::forksFold(const Tube& tube, const MeshPlan& plan) {
    if (tube.forkCount == 0 || m_trial.write(plan, tube)) return false;
    const std::span<const Fork> forks = plan.forksOf(tube);
    const std::vector<std::uint32_t> rings = m_trial.foldedRings(plan);
    const auto foldsBetween = [&](const Fork& low, const Fork& high) {
        return std::ranges::any_of(rings, [&](std::uint32_t ring) { return ring + 1 >= low.ring && ring <= high.ring + high.rings + 1; });
    };
    const std::size_t first = tube.startsAtFork() ? 1 : 0; // then two for each: its common ring, and the limb
    m_startFolds = first > 0 && foldsBetween(forks[0], forks[0]);
    for (std::size_t f = 0; f < m_planned.size(); ++f)
        if (foldsBetween(forks[first + 2 * f], forks[first + 2 * f + 1])) m_folded.push_back(m_planned[f]);
    return true;
}

/// Takes rings out where the walls of a stem that turns in less than its thickness would fold, and lets it end in a
/// point if its end would; false when that does not help.
bool CSimplifier::unfold(const CStem& stem, Tube& tube, MeshPlan& plan) {
    if (tube.lobed || tube.forkCount > 0 || !isTight(stem, tube, plan)) return true;
    for (std::uint32_t tries = 0;; ++tries) {
        const bool folds = !m_trial.write(plan, tube);
        if (!folds && m_trial.enclosesWood()) return true;
        const std::vector<std::uint32_t> folded = folds ? m_trial.foldedRings(plan) : std::vector{tube.ringCount - 1};
        if (!tube.pointed && folded.front() + 1 >= tube.ringCount)
            tube.pointed = true;
        else if (tube.ringCount > 2)
            takeOut(folded, tries, tube, plan);
        else if (!tube.pointed)
            tube.pointed = true;
        else
            return false;
        m_halved = 0;
        halvePoints(stem, tube, plan);
    }
}

/// The lowest of the folded rings, but never a tube's first or last; after some tries all, and more and more above each, so
/// that the tries stay few.
void CSimplifier::takeOut(std::span<const std::uint32_t> folded, std::uint32_t tries, Tube& tube, MeshPlan& plan) {
    const std::uint32_t run = tries < kOneByOne ? 1 : 1 + (tries - kOneByOne) / 4;
    if (tries < kOneByOne) folded = folded.first(1);
    std::uint32_t end = tube.ringCount - 1;
    for (std::size_t i = folded.size(); i-- > 0 && tube.ringCount > 2;) {
        const std::uint32_t out = std::clamp(folded[i], 1u, tube.ringCount - 2), count = std::min(run, std::max(end, out + 1) - out);
        const auto first = plan.rings.begin() + tube.firstRing + out;
        plan.rings.erase(first, first + count);
        tube.ringCount -= count;
        end = out;
    }
}

/// Whether two rings that follow each other are turned against each other, so that the wall between them may fold.
bool CSimplifier::isTight(const CStem& stem, const Tube& tube, const MeshPlan& plan) const {
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

template <typename Add>
void CSimplifier::addBetween(const CStem& stem, std::uint32_t segment, Add&& add) {
    m_places.clear();
    m_smoother.subdivide(stem, m_generation.segments[segment], m_detail.helixRings, m_places);
    m_line.addBendRings(segment, m_places);
    std::ranges::sort(m_places);
    for (const double t : m_places) add(segment, t, false);
}

bool CSimplifier::endsInPoint(const CStem& stem, const CPath& path) const {
    const std::uint32_t last = path.firstSegment + path.segmentCount - 1;
    const double radius = m_surface.woodRadius(stem, m_generation.segments[last], 1);
    return radius < m_surface.drawnFloor(stem, m_generation.segments[stem.firstSegment]);
}

} // namespace stromar
