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

/// The frame carried towards the plumb line: down for −1, up for 1.
Frame raised(const Frame& frame, double rise) {
    const glm::dvec3 axis = (1 - std::abs(rise)) * frame[2] + glm::dvec3(0, 0, rise);
    const double length = glm::length(axis);
    return length > 1e-9 ? transported(frame, axis / length) : frame;
}

/// Its direction on the ground; that of x where it has none.
glm::dvec2 horizontal(const glm::dvec3& v) { return v.x == 0 && v.y == 0 ? glm::dvec2(1, 0) : glm::dvec2(v); }
} // namespace

OrganRule organRule(const CParams& params, Organ organ) {
    const CommonParams& g = params.common;
    switch (organ) {
    case Organ::Blossom:
        return {
            g.blossoms,    1, 1, g.blossomScale, g.blossomScale, g.leafBend * (1 - std::abs(g.blossomUp)), g.blossomUp,
            kDrawBlossomId};
    case Organ::Fruit: return {g.fruits, 1, 1, g.fruitScale, g.fruitScale * g.fruitScaleX, 0, -0.85, kDrawFruitId};
    default: break;
    }
    const double length = g.leafScale / std::sqrt(g.leafQuality);
    return {weberPenn(params).leaves, g.leafQuality, g.leafWhorl, length, length * g.leafScaleX, g.leafBend, 0, kDrawLeafId};
}

std::uint64_t CLeafGrower::leafId(const CStem& stem, const CPath& path, std::uint32_t position, int i) const {
    const std::uint64_t site =
        hashCombine(hashCombine(stem.id, path.id), (std::uint64_t{position} << 32) | static_cast<std::uint32_t>(i));
    return hashCombine(site, m_rule.purpose);
}

Frame bentToLight(const Frame& frame, const glm::dvec3& position, double bend) {
    if (bend == 0) return frame;
    const glm::dvec3 n = frame[1];
    const glm::dvec2 from = horizontal(n), to = horizontal(position);
    const double outwards = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    const Frame turned = rotatedWorldZ(frame, bend * outwards);
    const glm::dvec3 m = turned[1];
    const double level = std::hypot(m.x, m.y);
    const glm::dvec3 axis = level > 1e-12 ? glm::dvec3(m.y, -m.x, 0) / level : turned[0];
    return rotatedAbout(turned, axis, bend * std::atan2(level, m.z));
}

std::shared_ptr<const LeafArray> CLeafGrower::grow(const CGrownGeneration& generation, const CProgress& progress) const {
    const std::size_t stems = generation.stems.size();
    std::vector<std::size_t> first(stems + 1, 0);
    parallelFor(
        stems, kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t s = begin; s < end; ++s) first[s + 1] = countOn(generation, s);
        },
        progress);
    for (std::size_t s = 0; s < stems; ++s) first[s + 1] += first[s];
    auto leaves = std::make_shared<LeafArray>();
    leaves->resize(first[stems]);
    parallelFor(
        stems, kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t s = begin; s < end; ++s)
                growOn(generation, static_cast<std::uint32_t>(s), leaves->data() + first[s]);
        },
        progress);
    return leaves;
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

std::size_t CLeafGrower::countOn(const CGrownGeneration& generation, std::size_t s) const {
    const CStem& stem = generation.stems[s];
    std::size_t count = 0;
    if (m_rule.number < 0) {
        for (std::uint32_t p = 0; p < stem.pathCount; ++p)
            count += static_cast<std::size_t>(fanSize(generation, s, generation.paths[stem.firstPath + p]));
        return count;
    }
    distribute(generation, stem, m_bearing.calc().bareLength(), nodesOn(generation, s), startError(generation, s),
               [&](const SegmentShare& share) { count += static_cast<std::size_t>(share.count * m_rule.whorl); });
    return count;
}

void CLeafGrower::growOn(const CGrownGeneration& generation, std::uint32_t stem, CLeaf* leaf) const {
    if (m_rule.number < 0)
        growFans(generation, stem, leaf);
    else
        growAlong(generation, stem, leaf);
}

void CLeafGrower::growAlong(const CGrownGeneration& generation, std::uint32_t s, CLeaf* leaf) const {
    const CStem& stem = generation.stems[s];
    CRotation rotation(m_leafLevel.level().rotate.radians());
    std::uint32_t path = stem.pathCount;
    distribute(generation, stem, m_bearing.calc().bareLength(), nodesOn(generation, s), startError(generation, s),
               [&](const SegmentShare& share) {
                   if (share.path != path) rotation.startPath(generation.rotationPhase[stem.firstPath + share.path]);
                   path = share.path;
                   for (int i = 0; i < share.count; ++i) growNode(generation, s, share, i, rotation, leaf);
               });
}

void CLeafGrower::growNode(const CGrownGeneration& generation, std::uint32_t s, const SegmentShare& share, int node,
                           CRotation& rotation, CLeaf*& leaf) const {
    const CStem& stem = generation.stems[s];
    const CSegment& segment = generation.segments[share.segment];
    const CPath& own = generation.paths[stem.firstPath + share.path];
    const LevelParams& level = m_leafLevel.level();
    double w = 0, turn = 0;
    for (int j = 0; j < m_rule.whorl; ++j) {
        const std::uint64_t id = leafId(stem, own, share.position, node * m_rule.whorl + j);
        const double variation = m_random.vary(level.rotateV.radians(), id, kDrawRotation);
        if (j == 0) {
            w = placeInSegment(share, node, 1, m_random.vary(level.branchDistV, id, kDrawPlace));
            turn = rotation.next(variation);
        } else
            turn += 2 * std::numbers::pi / m_rule.whorl;
        const double offset = (share.position + w) * segment.length;
        const double down =
            downAngle(level, m_bearing.calc(), generation.measuresOf(s), offset, m_random.uniform(id, kDrawDownAngle));
        *leaf++ = makeLeaf(segment.centre(w), rotatedX(rotatedZ(segment.frame, turn), down), s);
    }
}

void CLeafGrower::growFans(const CGrownGeneration& generation, std::uint32_t s, CLeaf* leaf) const {
    const CStem& stem = generation.stems[s];
    const LevelParams& level = m_leafLevel.level();
    for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
        const CPath& path = generation.paths[stem.firstPath + p];
        const CSegment& last = generation.segments[path.firstSegment + path.segmentCount - 1];
        const int count = fanSize(generation, s, path);
        for (int i = 0; i < count; ++i) {
            const std::uint64_t id = leafId(stem, path, generation.curveRes, i);
            const double inFan = count > 1 ? level.rotate.radians() * (double(i) / (count - 1) - 0.5) : 0;
            const double turn = inFan + m_random.vary(level.rotateV.radians(), id, kDrawRotation);
            const double down = downAngle(level, m_bearing.calc(), generation.measuresOf(s), stem.length,
                                          m_random.uniform(id, kDrawDownAngle));
            *leaf++ = makeLeaf(last.centre(1), rotatedX(rotatedY(last.frame, turn), down), s);
        }
    }
}

CLeaf CLeafGrower::makeLeaf(const glm::dvec3& position, const Frame& frame, std::uint32_t stem) const {
    const Frame bent = bentToLight(m_rule.rise != 0 ? raised(frame, m_rule.rise) : frame, position, m_rule.bend);
    return {position, bent[2], bent[1], m_rule.length, m_rule.width, stem,
            static_cast<std::uint32_t>(m_bearing.generation())};
}

} // namespace stromar
