#pragma once
#include "stromar/mesh/OrganMesh.h"
#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace stromar {

/// Puts a blade's points where one leaf has them, in the size of the season.
class CBladePlacer {
public:
    CBladePlacer(const CLeaf& leaf, double growth)
        : m_foot(leaf.position), m_axis(leaf.axis), m_normal(leaf.normal), m_right(glm::cross(m_axis, m_normal)) {
        const glm::dvec3 p = glm::abs(m_foot);
        const double min = 1e-5 * std::max({p.x, p.y, p.z}); // seen in single precision
        m_width = std::max(min, leaf.width * growth);
        m_length = std::max(min, leaf.length * growth);
    }

    double width() const { return m_width; }
    double length() const { return m_length; }
    const glm::dvec3& foot() const { return m_foot; }
    glm::dvec3 place(const LeafBlade::Point& point) const {
        return m_foot + m_width * point.place.x * m_right + m_length * point.place.y * m_axis +
               m_width * point.place.z * m_normal;
    }
    glm::dvec3 normal(const LeafBlade::Point& point) const {
        return glm::normalize(point.normal.x / m_width * m_right + point.normal.y / m_length * m_axis +
                              point.normal.z / m_width * m_normal);
    }

    /// Columns: across, along, up.
    glm::dmat3 axes() const { return {m_right, m_axis, m_normal}; }

private:
    glm::dvec3 m_foot, m_axis, m_normal, m_right;
    double m_width, m_length;
};

/// A leaf as a card for a picture or as its outline. Coarse models get plain cards.
LeafBlade makeBlade(const LeafForm& form, const Detail& detail);
/// Height over a place of a card: x −0.5 .. 0.5 and y 0 .. 1. In parts of the width.
using LeafRelief = std::function<double(double x, double y)>;
/// A card that is bent; its foot stays.
LeafBlade bentCard(const LeafRelief& relief, const glm::ivec2& cells = {4, 6});
/// A square for a picture, in so many planes; near ones as domes whose edges lie so many half widths lower.
LeafBlade makeBlossom(int planes, double dome, const Detail& detail);
/// An ellipsoid on a stalk of so many of its lengths.
LeafBlade makeFruit(double stalk, const Detail& detail);

} // namespace stromar
