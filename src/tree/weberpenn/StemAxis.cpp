#include "StemAxis.h"
#include "Draw.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace stromar {

namespace {

std::uint64_t place(std::uint64_t path, int k) { return hashCombine(path, static_cast<std::uint64_t>(k)); }
} // namespace

void CAxisGrower::grow(std::uint64_t id, double key, const Frame& frame, StemAxis& axis) {
    m_id = id;
    m_splitError = centred(key + m_random.phase(id, kDrawCountPhase));
    m_growing.clear();
    axis.paths.clear();
    axis.rotationPhase.clear();
    axis.segments.clear();
    axis.curveRes = m_params.level().curveRes;
    openPath({.id = 0, .firstSegment = 0, .segmentCount = 0, .firstPosition = 0, .source = -1}, 0,
             {frame, glm::dvec3(0), 0, 1, false}, axis);
    for (int k = 0; k < axis.curveRes; ++k) {
        const std::size_t live = axis.paths.size();
        for (std::size_t p = 0; p < live; ++p) addSegment(p, k, axis);
        if (k + 1 == axis.curveRes) break;
        for (std::size_t p = 0; p < live; ++p) split(p, k, axis);
    }
}

void CAxisGrower::openPath(const CPath& path, double rotationPhase, const Growing& growing, StemAxis& axis) {
    CPath opened = path;
    opened.firstSegment = static_cast<std::uint32_t>(axis.segments.size());
    opened.segmentCount = static_cast<std::uint32_t>(axis.curveRes) - path.firstPosition;
    axis.segments.resize(axis.segments.size() + opened.segmentCount);
    axis.paths.push_back(opened);
    axis.rotationPhase.push_back(rotationPhase);
    m_growing.push_back(growing);
}

void CAxisGrower::addSegment(std::size_t p, int k, StemAxis& axis) {
    if (k > 0) bend(p, k, axis);
    Growing& growing = m_growing[p];
    const CPath& path = axis.paths[p];
    StemAxis::Segment& segment = axis.segments[path.firstSegment + static_cast<std::uint32_t>(k) - path.firstPosition];
    segment = {growing.position, growing.frame, growing.density, false};
    growing.position = axis.end(segment);
}

void CAxisGrower::bend(std::size_t p, int k, const StemAxis& axis) {
    const LevelParams& level = m_params.level();
    Growing& growing = m_growing[p];
    const double n = axis.curveRes;
    const bool upperHalf = 2 * k >= axis.curveRes;
    const double curve = level.curveBack == 0 ? level.curve.radians() / n
                                              : (upperHalf ? level.curveBack : level.curve).radians() / (n / 2);
    growing.frame = rotatedX(growing.frame, curve + growing.correction);
    if (level.curveV.value > 0) {
        const std::uint64_t here = place(axis.paths[p].id, k);
        const double around = kTurn * m_random.uniform(m_id, kDrawCurveAxis, here);
        const glm::dvec3 bendAxis = std::cos(around) * growing.frame[0] + std::sin(around) * growing.frame[1];
        growing.frame =
            rotatedAbout(growing.frame, bendAxis, m_random.vary(level.curveV.radians(), m_id, kDrawCurveAngle, here) / n);
    }
    if (m_params.generation() >= 2) attractUp(growing.frame);
}

void CAxisGrower::attractUp(Frame& frame) const {
    const double attraction = m_params.tree().attractionUp;
    if (attraction == 0) return;
    const double dec = declination(frame);
    if (m_params.tree().attractionAxis == static_cast<int>(AttractionAxis::Stem)) {
        frame = rotatedX(frame, -attraction * dec * frame[1].z / m_params.level().curveRes);
        return;
    }
    const glm::dvec3 level = glm::cross(frame[2], glm::dvec3(0, 0, 1));
    const double sine = glm::length(level);
    if (sine < 1e-12) return;
    const double up = attraction * dec * sine / m_params.level().curveRes;
    frame = rotatedAbout(frame, level / sine, std::clamp(up, dec - std::numbers::pi, dec)); // not beyond the vertical
}

void CAxisGrower::split(std::size_t p, int k, StemAxis& axis) {
    const LevelParams& level = m_params.level();
    const bool atBase = m_params.generation() == 0 && k == 0 && m_params.tree().baseSplits > 0;
    const int clones = cloneCount(m_growing[p], atBase);
    if (clones == 0) return;
    const CPath source = axis.paths[p];
    const std::uint64_t here = place(source.id, k);
    const double lean = declination(m_growing[p].frame);
    const double angle =
        std::max(0.0, level.splitAngle.radians() + m_random.vary(level.splitAngleV.radians(), m_id, kDrawSplitAngle, here) - lean);
    Growing& growing = m_growing[p];
    growing.frame = rotatedX(growing.frame, angle);
    growing.correction -= angle / (axis.curveRes - 1 - k);
    growing.density /= clones + 1;
    growing.halved = growing.halved || (!atBase && m_params.tree().cloneHalving != 0);
    axis.segments[source.firstSegment + static_cast<std::uint32_t>(k) - source.firstPosition].forks = true;
    for (int j = 1; j <= clones; ++j) {
        Growing clone = m_growing[p];
        clone.frame = rotatedWorldZ(clone.frame, spreadAngle(atBase, clones, j, lean, source.id, k));
        openPath({.id = hashCombine(here, static_cast<std::uint64_t>(j)),
                  .firstSegment = 0,
                  .segmentCount = 0,
                  .firstPosition = static_cast<std::uint32_t>(k + 1),
                  .source = static_cast<std::int32_t>(p)},
                 kTurn * j / (clones + 1), clone, axis);
    }
}

int CAxisGrower::cloneCount(const Growing& growing, bool atBase) {
    if (atBase) return m_params.tree().baseSplits;
    const double wanted = m_params.level().segSplits * (growing.halved ? 0.5 : 1);
    const double count = std::floor(wanted + m_splitError + 0.5);
    m_splitError -= count - wanted;
    return static_cast<int>(count);
}

double CAxisGrower::spreadAngle(bool atBase, int clones, int j, double lean, std::uint64_t pathId, int k) const {
    const std::uint64_t here = hashCombine(place(pathId, k), static_cast<std::uint64_t>(j));
    if (atBase || clones >= 2) {
        const double evenly = kTurn * j / (clones + 1);
        return atBase ? evenly + m_random.vary(m_params.level().splitAngleV.radians(), m_id, kDrawBaseSpread, here) : evenly;
    }
    const double u = m_random.uniform(m_id, kDrawSpreadSize, here);
    const double degrees = 20 + 0.75 * (30 + std::abs(lean / kRadiansPerDegree - 90)) * u * u;
    const double sign = m_random.uniform(m_id, kDrawSpreadSign, here) < 0.5 ? -1 : 1;
    return sign * degrees * kRadiansPerDegree;
}

} // namespace stromar
