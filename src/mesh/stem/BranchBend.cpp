#include "stem/BranchBend.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stromar {

CBranchBend::CBranchBend(const CStem& branch, const CSegment& first, const RingShape& common, double reach, double above)
    : m_node(branch.offset), m_below(reach), m_above(above), m_corner(first.position), m_low(reach * common.frame[2]),
      m_high(above * first.frame[2]), m_common(common) {}

RingShape CBranchBend::shapeAt(const CPathSurface& branch, double along) const {
    const double own = along - m_node;
    RingShape shape = branch.shapeAt(std::max(own, m_above));
    if (own < m_above) {
        const double u = std::max(0.0, (own + m_below) / (m_below + m_above)), v = 1 - u;
        shape.slope = (shape.radius - m_common.radius) / (m_below + m_above);
        shape.radius = glm::mix(m_common.radius, shape.radius, u);
        shape.centre = m_corner + u * u * m_high - v * v * m_low;
        shape.frame = transported(m_common.frame, glm::normalize(v * m_low + u * m_high));
        shape.stretch = 1;
    } else
        shape.frame = transported(m_common.frame, shape.frame[2]);
    if (m_twist != 0) shape.frame = rotatedZ(shape.frame, m_twist * std::min(1.0, (along - m_common.along) / (m_twisted - m_common.along)));
    shape.along = along;
    return shape;
}

std::int32_t CBranchBend::turnTo(const CPathSurface& branch, double along, std::uint32_t points) {
    m_twist = 0;
    const Frame fork = shapeAt(branch, along).frame, own = branch.shapeAt(along - m_node).frame;
    const double turn = std::atan2(glm::dot(own[0], fork[1]), glm::dot(own[0], fork[0])), step = kTurn / points;
    const auto whole = static_cast<std::int32_t>(std::lround(turn / step));
    m_twist = turn - whole * step;
    m_twisted = along;
    return whole;
}

} // namespace stromar
