#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/tree/Tree.h"
#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace stromar {

/// The form of all leaves of a tree: points of a blade of length and width 1, its foot at the origin, its axis along y.
/// Made once, written for every leaf.
struct LeafBlade {
    struct Point {
        glm::dvec3 place;  ///< x across (times the width), y along (times the length), z up (times the width)
        glm::dvec3 normal; ///< unit, in the same axes
        glm::vec2 texCoord;
    };
    std::vector<Point> points;
    std::vector<std::uint32_t> indices; ///< three per triangle, counter-clockwise seen from above
};

/// Puts a blade's points where one leaf has them, in the size of the season.
class CBladePlacer {
public:
    CBladePlacer(const CLeaf& leaf, double growth) : m_leaf(leaf), m_right(glm::cross(leaf.axis, leaf.normal)) {
        const glm::dvec3 p = glm::abs(leaf.position);
        const double least = 1e-5 * std::max({p.x, p.y, p.z}); // seen in single precision
        m_width = std::max(least, leaf.width * growth);
        m_length = std::max(least, leaf.length * growth);
    }

    /// From the leaf's position.
    glm::dvec3 offset(const LeafBlade::Point& point) const {
        return m_width * point.place.x * m_right + m_length * point.place.y * m_leaf.axis +
               m_width * point.place.z * m_leaf.normal;
    }
    glm::dvec3 normal(const LeafBlade::Point& point) const {
        return glm::normalize(point.normal.x / m_width * m_right + point.normal.y / m_length * m_leaf.axis +
                              point.normal.z / m_width * m_leaf.normal);
    }

private:
    const CLeaf& m_leaf;
    glm::dvec3 m_right;
    double m_width, m_length;
};

/// A leaf as a card for a picture or as its outline. Coarse models get plain cards.
LeafBlade makeBlade(const LeafForm& form, const Detail& detail);
/// What an organ is drawn as.
LeafBlade bladeOf(const MeshParams& params, Organ organ, const Detail& detail);
/// A square for a picture, in so many planes.
LeafBlade makeCard(int planes);
/// An ellipsoid on a stalk of so many of its lengths.
LeafBlade makeFruit(double stalk, const Detail& detail);

} // namespace stromar
