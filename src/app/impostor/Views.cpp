#include "stromar/app/Impostor.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace stromar {

ImpostorView ImpostorView::from(const glm::dvec3& towards) {
    const glm::dvec3 across(-towards.y, towards.x, 0); // z × towards
    const double length = glm::length(across);
    const glm::dvec3 right = length < 1e-9 ? glm::dvec3(1, 0, 0) : across / length;
    return {right, glm::cross(towards, right), towards};
}

namespace {
double signOf(double v) { return v < 0 ? -1 : 1; }
} // namespace

ImpostorView CImpostorGrid::view(int column, int row) const {
    const glm::dvec2 place = glm::dvec2(column, row) * (2.0 / (m_across - 1)) - 1.0;
    glm::dvec2 flat = m_whole ? place : glm::dvec2(place.x + place.y, place.x - place.y) / 2.0;
    const double z = 1 - std::abs(flat.x) - std::abs(flat.y);
    if (z < 0) flat = {(1 - std::abs(flat.y)) * signOf(flat.x), (1 - std::abs(flat.x)) * signOf(flat.y)};
    return ImpostorView::from(glm::normalize(glm::dvec3(flat, std::abs(z) < 1e-12 ? 0 : z)));
}

glm::dvec2 CImpostorGrid::placeOf(const glm::dvec3& towards) const {
    const glm::dvec3 seen = m_whole ? towards : glm::dvec3(glm::dvec2(towards), std::max(0.0, towards.z));
    glm::dvec2 flat = glm::dvec2(seen) / std::max(1e-12, std::abs(seen.x) + std::abs(seen.y) + std::abs(seen.z));
    if (!m_whole) return {flat.x + flat.y, flat.x - flat.y};
    if (seen.z < 0) flat = {(1 - std::abs(flat.y)) * signOf(flat.x), (1 - std::abs(flat.x)) * signOf(flat.y)};
    return flat;
}

std::array<CImpostorGrid::Share, 3> CImpostorGrid::around(const glm::dvec3& towards) const {
    const glm::dvec2 place = (placeOf(towards) + 1.0) * ((m_across - 1) / 2.0);
    const auto first = [&](double v) { return std::clamp(static_cast<int>(std::floor(v)), 0, m_across - 2); };
    int column = first(place.x), step = 1;
    const int row = first(place.y);
    double x = std::clamp(place.x - column, 0.0, 1.0);
    const double y = std::clamp(place.y - row, 0.0, 1.0), middle = (m_across - 2) / 2.0;
    if (m_whole && (column - middle) * (row - middle) > 0) { // the cell's diagonal along the octahedron's edge
        column += step;
        step = -1;
        x = 1 - x;
    }
    if (x > y) return {{{column, row, 1 - x}, {column + step, row, x - y}, {column + step, row + 1, y}}};
    return {{{column, row, 1 - y}, {column, row + 1, y - x}, {column + step, row + 1, x}}};
}

} // namespace stromar
