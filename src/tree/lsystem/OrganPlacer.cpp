#include "lsystem/OrganPlacer.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
constexpr std::uint64_t kOrganId = 0x6f7267, kStartTurn = 0x7475726e;
} // namespace

COrganPlacer::COrganPlacer(const CParams& params, const CTree& tree, Organ organ)
    : m_params(params), m_tree(tree), m_organ(organ), m_pose(poseOf(params.common, organ)),
      m_perBearer(perBearer(params, organ)), m_whorl(organ == Organ::Leaf ? params.common.leafWhorl : 1) {}

int COrganPlacer::perBearer(const CParams& params, Organ organ) {
    switch (organ) {
    case Organ::Blossom: return params.common.blossoms;
    case Organ::Fruit: return params.common.fruits;
    default: return static_cast<int>(std::lround(lsystem(params).stemLeaves * params.common.leafQuality));
    }
}

std::shared_ptr<const COrgans> COrganPlacer::grow(const OrganDemand& demand, const CProgress& progress) const {
    std::vector<std::vector<std::uint32_t>> counts(m_tree.generationCount());
    for (std::size_t g = 0; g < counts.size(); ++g) countOn(g, counts[g]);
    return placeOrgans(
        std::move(counts), demand, [this](const OrganSite& site) { return idOf(site); },
        [this](const OrganSite& site) { return place(site); }, progress);
}

/// Empty where none bears any.
void COrganPlacer::countOn(std::size_t g, std::vector<std::uint32_t>& counts) const {
    const CTurtleGeneration& own = generation(g);
    const auto& written = own.organs[static_cast<std::size_t>(m_organ)];
    if (written.empty() && m_perBearer <= 0) return;
    counts.assign(own.stems.size(), static_cast<std::uint32_t>(std::max(0, m_perBearer)));
    if (g + 1 < m_tree.generationCount())
        for (const CStem& child : m_tree.generation(g + 1).stems)
            if (child.parent >= 0) counts[static_cast<std::size_t>(child.parent)] = 0;
    for (const CTurtleGeneration::Written& organ : written) ++counts[organ.stem];
}

std::span<const CTurtleGeneration::Written> COrganPlacer::writtenOn(std::size_t g, std::size_t stem) const {
    const auto& written = generation(g).organs[static_cast<std::size_t>(m_organ)];
    const auto wanted = static_cast<std::uint32_t>(stem);
    const auto first = std::ranges::lower_bound(written, wanted, {}, &CTurtleGeneration::Written::stem);
    const auto end = std::ranges::upper_bound(written, wanted, {}, &CTurtleGeneration::Written::stem);
    return {first, end};
}

std::uint64_t COrganPlacer::idOf(const OrganSite& site) const {
    const CStem& stem = m_tree.generation(site.generation).stems[site.stem];
    return hashCombine(hashCombine(stem.id, kOrganId + static_cast<std::uint64_t>(m_organ)), site.number);
}

CLeaf COrganPlacer::place(const OrganSite& site) const {
    const auto written = writtenOn(site.generation, site.stem);
    if (site.number < written.size()) return placeWritten(written[site.number], site);
    return placeOnBearer(site.number - static_cast<std::uint32_t>(written.size()), site);
}

/// As the turtle stood: its heading is the axis, its upper side the normal.
CLeaf COrganPlacer::placeWritten(const CTurtleGeneration::Written& written, const OrganSite& site) const {
    CLeaf organ{written.position, written.axis, written.normal, static_cast<float>(m_pose.length),
                static_cast<float>(m_pose.width), site.stem, site.generation, site.number};
    if (written.size >= 0) {
        organ.width *= written.size / organ.length;
        organ.length = written.size;
    }
    organ.length *= written.share;
    organ.width *= written.share;
    if (m_organ == Organ::Leaf && m_pose.bend != 0) {
        const glm::dvec3 axis = written.axis, normal = written.normal;
        const Frame bent = m_pose.applied({glm::cross(normal, axis), normal, axis}, written.position);
        organ.axis = bent[2];
        organ.normal = bent[1];
    }
    return organ;
}

/// The i-th of those along a stem; the last stands at its tip.
CLeaf COrganPlacer::placeOnBearer(std::uint32_t i, const OrganSite& site) const {
    const CGeneration& all = m_tree.generation(site.generation);
    const CStem& stem = all.stems[site.stem];
    const auto whorl = static_cast<std::uint32_t>(m_whorl);
    const std::uint32_t node = i / whorl, nodes = (static_cast<std::uint32_t>(m_perBearer) + whorl - 1) / whorl;
    const double along = stem.length * (node + 1) / nodes;
    const std::span<const CSegment> segments = std::span(all.segments).subspan(stem.firstSegment, stem.segmentCount);
    const auto above = std::ranges::lower_bound(segments, along, {}, [](const CSegment& s) { return s.end(); });
    const CSegment& segment = above == segments.end() ? segments.back() : *above;
    const glm::dvec3 position = segment.axisPoint(std::min(1.0, (along - segment.start) / segment.length));
    const double start = unitOf(hashCombine(stem.id, kStartTurn)), inWhorl = double(i % whorl) / whorl;
    const double turn = lsystem(m_params).leafRotate.radians() * node + 2 * std::numbers::pi * (start + inWhorl);
    const Frame off = rotatedX(rotatedZ(segment.frame, turn), lsystem(m_params).leafDownAngle.radians());
    const Frame frame = m_pose.applied(off, position);
    const double share = generation(site.generation).shares[site.stem];
    return {glm::vec3(position), glm::vec3(frame[2]), glm::vec3(frame[1]), static_cast<float>(share * m_pose.length),
            static_cast<float>(share * m_pose.width), site.stem, site.generation, site.number};
}

} // namespace stromar
