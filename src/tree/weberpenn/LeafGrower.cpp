#include "LeafGrower.h"
#include "Draw.h"
#include "stromar/util/Parallel.h"
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 256;
constexpr int kTaperedShape = 4; // ShapeRatio of the leaves along the parent
} // namespace

OrganRule organRule(const CParams& params, Organ organ) {
    const CommonParams& g = params.common;
    switch (organ) {
    case Organ::Blossom: return {g.blossoms, 1, 1, poseOf(g, organ), kDrawBlossomId};
    case Organ::Fruit: return {g.fruits, 1, 1, poseOf(g, organ), kDrawFruitId};
    default: return {weberPenn(params).leaves, g.leafQuality, g.leafWhorl, poseOf(g, organ), kDrawLeafId};
    }
}

std::uint64_t CLeafGrower::leafId(const CStem& stem, const CPath& path, std::uint32_t position, int i) const {
    const std::uint64_t site =
        hashCombine(hashCombine(stem.id, path.id), (std::uint64_t{position} << 32) | static_cast<std::uint32_t>(i));
    return hashCombine(site, m_rule.purpose);
}

std::shared_ptr<const COrgans> CLeafGrower::grow(const CGrownGeneration& generation, const OrganDemand& demand,
                                                 const CProgress& progress) const {
    const std::size_t stems = generation.stems.size(), own = static_cast<std::size_t>(m_bearing.generation());
    const auto forStems = [&](const auto& work) {
        const auto range = [&](std::size_t begin, std::size_t end) {
            for (std::size_t s = begin; s < end; ++s) work(s);
        };
        parallelFor(stems, kGrain, range, progress);
    };
    auto organs = std::make_shared<COrgans>();
    organs->counts.resize(own + 1);
    std::vector<std::uint32_t>& counts = organs->counts[own];
    counts.resize(stems);
    forStems([&](std::size_t s) { counts[s] = countOn(generation, s); });
    std::size_t offered = 0;
    for (std::size_t s = 0; s < stems; ++s) {
        organs->total += counts[s];
        if (demand.mayBear(own, s)) offered += counts[s];
    }
    const double part = demand.partOf(double(organs->total), double(offered));
    if (part <= 0) return organs;
    std::vector<std::size_t> first(stems + 1, 0);
    forStems([&](std::size_t s) {
        if (demand.mayBear(own, s)) first[s + 1] = part >= 1 ? counts[s] : keptOn(generation, s, part);
    });
    for (std::size_t s = 0; s < stems; ++s) first[s + 1] += first[s];
    organs->grown.resize(first[stems]);
    forStems([&](std::size_t s) {
        if (first[s + 1] == first[s]) return;
        Bearer bearer{static_cast<std::uint32_t>(s), part, organs->grown.data() + first[s]};
        growOn(generation, bearer);
    });
    return organs;
}

double CLeafGrower::numberOn(const CGrownGeneration& generation, std::size_t stem) const {
    const double along = generation.stems[stem].offset / generation.scratch[stem].parentLength;
    return std::abs(m_rule.number) * shapeRatio(kTaperedShape, along, m_bearing.tree()) * m_rule.density;
}

double CLeafGrower::startError(const CGrownGeneration& generation, std::size_t stem) const {
    const double phase = m_random.phase(generation.stems[stem].id, kDrawCountPhase);
    return centred(generation.scratch[stem].countPhase + 2.0 / 3 + phase);
}

int CLeafGrower::fanSize(const CGrownGeneration& generation, std::size_t stem, const CPath& path) const {
    const double density = generation.density[path.firstSegment + path.segmentCount - 1];
    return static_cast<int>(std::floor(numberOn(generation, stem) * density + 0.5));
}

/// Calls visit(SegmentShare) for the nodes along a stem.
template <typename Visit>
void CLeafGrower::shareOut(const CGrownGeneration& generation, std::size_t stem, Visit&& visit) const {
    distribute(generation, generation.stems[stem], m_bearing.calc().bareLength(), nodesOn(generation, stem),
               startError(generation, stem), visit);
}

std::uint32_t CLeafGrower::countOn(const CGrownGeneration& generation, std::size_t s) const {
    const CStem& stem = generation.stems[s];
    int count = 0;
    if (m_rule.number < 0)
        for (std::uint32_t p = 0; p < stem.pathCount; ++p)
            count += fanSize(generation, s, generation.paths[stem.firstPath + p]);
    else
        shareOut(generation, s, [&](const SegmentShare& share) { count += share.count * m_rule.whorl; });
    return static_cast<std::uint32_t>(count);
}

template <typename Visit>
void CLeafGrower::visitNames(const CGrownGeneration& generation, std::size_t s, Visit&& visit) const {
    const CStem& stem = generation.stems[s];
    const auto visitAt = [&](const CPath& path, std::uint32_t position, int count) {
        for (int i = 0; i < count; ++i) visit(leafId(stem, path, position, i));
    };
    if (m_rule.number < 0)
        for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
            const CPath& path = generation.paths[stem.firstPath + p];
            visitAt(path, generation.curveRes, fanSize(generation, s, path));
        }
    else
        shareOut(generation, s, [&](const SegmentShare& share) {
            visitAt(generation.paths[stem.firstPath + share.path], share.position, share.count * m_rule.whorl);
        });
}

std::size_t CLeafGrower::keptOn(const CGrownGeneration& generation, std::size_t stem, double part) const {
    std::size_t kept = 0;
    visitNames(generation, stem, [&](std::uint64_t id) { kept += OrganDemand::keeps(part, id); });
    return kept;
}

void CLeafGrower::growOn(const CGrownGeneration& generation, Bearer& bearer) const {
    if (m_rule.number < 0)
        growFans(generation, bearer);
    else
        growAlong(generation, bearer);
}

void CLeafGrower::growAlong(const CGrownGeneration& generation, Bearer& bearer) const {
    const CStem& stem = generation.stems[bearer.stem];
    CRotation rotation(m_leafLevel.level().rotate.radians());
    std::uint32_t path = stem.pathCount;
    shareOut(generation, bearer.stem, [&](const SegmentShare& share) {
        if (share.path != path) rotation.startPath(generation.rotationPhase[stem.firstPath + share.path]);
        path = share.path;
        for (int i = 0; i < share.count; ++i) growNode(generation, share, i, rotation, bearer);
    });
}

void CLeafGrower::growNode(const CGrownGeneration& generation, const SegmentShare& share, int node,
                           CRotation& rotation, Bearer& bearer) const {
    const CStem& stem = generation.stems[bearer.stem];
    const CSegment& segment = generation.segments[share.segment];
    const CPath& own = generation.paths[stem.firstPath + share.path];
    const LevelParams& level = m_leafLevel.level();
    std::uint64_t first = 0;
    double turn = 0;
    for (int j = 0; j < m_rule.whorl; ++j, ++bearer.number) {
        const std::uint64_t id = leafId(stem, own, share.position, node * m_rule.whorl + j);
        if (j == 0) {
            first = id;
            turn = rotation.next(m_random.vary(level.rotateV.radians(), id, kDrawRotation));
        } else
            turn += 2 * std::numbers::pi / m_rule.whorl;
        if (!OrganDemand::keeps(bearer.part, id)) continue;
        const double w = placeInSegment(share, node, 1, m_random.vary(level.branchDistV, first, kDrawPlace));
        const double offset = (share.position + w) * segment.length;
        const double down = downAngle(level, m_bearing.calc(), generation.measuresOf(bearer.stem), offset,
                                      m_random.uniform(id, kDrawDownAngle));
        *bearer.next++ = makeLeaf(segment.centre(w), rotatedX(rotatedZ(segment.frame, turn), down), bearer);
    }
}

void CLeafGrower::growFans(const CGrownGeneration& generation, Bearer& bearer) const {
    const CStem& stem = generation.stems[bearer.stem];
    const LevelParams& level = m_leafLevel.level();
    for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
        const CPath& path = generation.paths[stem.firstPath + p];
        const CSegment& last = generation.segments[path.firstSegment + path.segmentCount - 1];
        const int count = fanSize(generation, bearer.stem, path);
        for (int i = 0; i < count; ++i, ++bearer.number) {
            const std::uint64_t id = leafId(stem, path, generation.curveRes, i);
            if (!OrganDemand::keeps(bearer.part, id)) continue;
            const double inFan = count > 1 ? level.rotate.radians() * (double(i) / (count - 1) - 0.5) : 0;
            const double turn = inFan + m_random.vary(level.rotateV.radians(), id, kDrawRotation);
            const double down = downAngle(level, m_bearing.calc(), generation.measuresOf(bearer.stem), stem.length,
                                          m_random.uniform(id, kDrawDownAngle));
            *bearer.next++ = makeLeaf(last.centre(1), rotatedX(rotatedY(last.frame, turn), down), bearer);
        }
    }
}

CLeaf CLeafGrower::makeLeaf(const glm::dvec3& position, const Frame& frame, const Bearer& bearer) const {
    const Frame bent = m_rule.pose.applied(frame, position);
    return {glm::vec3(position), glm::vec3(bent[2]), glm::vec3(bent[1]), static_cast<float>(m_rule.pose.length),
            static_cast<float>(m_rule.pose.width), bearer.stem, static_cast<std::uint32_t>(m_bearing.generation()),
            bearer.number};
}

} // namespace stromar
