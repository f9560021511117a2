#include "stromar/tree/Tree.h"
#include "stromar/util/Turn.h"
#include <glm/geometric.hpp>
#include <numbers>

namespace stromar {

namespace {
}

glm::dvec3 CSegment::centre(double t) const {
    if (helixRadius == 0) return axisPoint(t);
    const double angle = kTurn * turns * t;
    return axisPoint(t) + helixRadius * (std::cos(angle) - 1) * frame[0] + helixRadius * std::sin(angle) * frame[1];
}

glm::dvec3 CSegment::tangent(double t) const {
    if (helixRadius == 0) return frame[2];
    const double angle = kTurn * turns * t, around = kTurn * turns * helixRadius;
    return glm::normalize(length * frame[2] - around * std::sin(angle) * frame[0] + around * std::cos(angle) * frame[1]);
}

const CSegment* CGeneration::segmentBelow(const CStem& stem, const CPath& path) const {
    if (path.source < 0) return nullptr;
    return &segmentAt(stem, static_cast<std::uint32_t>(path.source), path.firstPosition - 1);
}

const CSegment& CGeneration::segmentAt(const CStem& stem, std::uint32_t path, std::uint32_t position) const {
    const CPath& own = paths[stem.firstPath + path];
    return segments[own.firstSegment + position - own.firstPosition];
}

CTree::CTree(double height, std::vector<std::shared_ptr<const CGeneration>> generations, const BaseForm& base)
    : m_height(height), m_base(base), m_generations(std::move(generations)) {
    m_organs.fill(std::make_shared<const COrgans>());
}

CTree CTree::withOrgans(OrganArrays organs) const {
    CTree tree = *this;
    tree.m_organs = std::move(organs);
    return tree;
}

const CStem& CTree::ancestor(std::size_t g, const CStem& stem, std::size_t generations) const {
    return generations == 0 ? stem : ancestor(g - 1, generation(g - 1).stems[static_cast<std::size_t>(stem.parent)], generations - 1);
}

bool CTree::branchesAtNodes(std::size_t g) const {
    return g + 1 < generationCount() && !generation(g + 1).stems.empty() && generation(g + 1).stems.front().atNode;
}

std::size_t CTree::stemCount() const {
    std::size_t count = 0;
    for (const auto& generation : m_generations) count += generation->stems.size();
    return count;
}

} // namespace stromar
