#pragma once
#include "RootFlare.h"
#include "stromar/params/TreeParams.h"
#include "stromar/tree/Tree.h"
#include <algorithm>
#include <cmath>

namespace stromar {

/// The form of the stems' wood in one generation: radius by taper, flare, lobes and the least radius. Metres, radians.
class CStemSurface {
public:
    CStemSurface(const CParams& params, int generation, const CTree& tree)
        : m_params(params, generation, tree.scaleTree()), m_trunk(generation == 0),
          m_trunkMeasures(tree.generation(0).stems.empty() ? StemMeasures{} : tree.generation(0).stems[0].measures) {}

    /// The root of the radius over the trunk's, at most 1: rings and bends err by equally many metres when their points
    /// and pieces are in this proportion.
    double thickness(double radius) const {
        return m_trunkMeasures.radius > 0 ? std::min(1.0, std::sqrt(radius / m_trunkMeasures.radius)) : 1;
    }

    /// Radius at a place of a segment, before lobes and the least radius.
    double woodRadius(const CStem& stem, const CSegment& segment, std::uint32_t position, double t) const {
        const double z = along(stem, position, t);
        const double tapered = stem.taper > 1 ? CCalculations::taperedRadius(stem.taper, stem.measures, z)
                                              : segment.radiusBase + t * (segment.radiusEnd - segment.radiusBase);
        return tapered * m_params.calc().flareAt(z);
    }
    /// Position / length.
    static double along(const CStem& stem, std::uint32_t position, double t) { return (position + t) / stem.curveRes; }

    /// Likewise, to the end of the farthest root.
    double outerRadius(const CStem& stem, const CSegment& segment, std::uint32_t position, double t) const {
        const double wood = woodRadius(stem, segment, position, t);
        if (roots() == 0) return wood;
        return wood + stem.measures.radius * CRootFlare::most(m_params.global(), along(stem, position, t));
    }

    /// Whether the radius changes other than evenly along a segment.
    bool uneven(const CStem& stem) const {
        return stem.taper > 1 || (m_trunk && (m_params.global().flare != 0 || roots() > 0));
    }

    int lobes() const { return m_trunk && m_params.global().lobeDepth > 0 ? m_params.global().lobes : 0; }
    int roots() const { return m_trunk && m_params.global().rootReach > 0 ? m_params.global().roots : 0; }
    CRootFlare rootsOf(const CStem& stem) const {
        return roots() > 0 ? CRootFlare(m_params.global(), stem.id) : CRootFlare();
    }
    /// What a ring around the trunk has to show.
    int ridges() const { return std::max(lobes(), roots()); }
    /// How far lobes stand out at z = position / length (Weber & Penn §4.4; LobeFade ends them as the thesis draws).
    double lobeDepth(double z) const {
        const GlobalParams& g = m_params.global();
        return g.lobeDepth * (1 + g.lobeFade * ((baseFalloff(z) - 1) / 99 - 1));
    }
    double minRadius() const { return m_params.global().minRadius; }

    /// Lengths below this vanish in the rounding of single-precision coordinates near the stem.
    static double leastDrawn(const CStem& stem, const CSegment& first) {
        const glm::dvec3 p = glm::abs(first.position);
        return 1e-5 * (std::max({p.x, p.y, p.z}) + stem.measures.length);
    }
    /// The radius below which a ring is drawn with this radius.
    double drawnFloor(const CStem& stem, const CSegment& first) const {
        return std::max(minRadius(), leastDrawn(stem, first));
    }

    /// How often the bark's picture is repeated.
    struct Bark {
        double around;   ///< times
        double perMetre; ///< along
    };
    /// Each trunk by TextureWrapX/Y (thesis §4.7). Other stems in the first trunk's metres per repeat, but whole times
    /// around, at least once; along so that the picture keeps its shape.
    Bark barkOf(const CStem& stem) const {
        const double x = m_params.global().textureWrapX, y = m_params.global().textureWrapY;
        if (m_trunk) return {x, y / std::max(1e-9, stem.measures.length)};
        const double perMetre = y / std::max(1e-9, m_trunkMeasures.length);
        const double exact = x * std::max(minRadius(), stem.measures.radius) / std::max(1e-9, m_trunkMeasures.radius);
        if (!(exact > 1e-6)) return {1, perMetre};
        const double around = std::max(1.0, std::round(exact));
        return {around, perMetre * around / exact};
    }

private:
    CTreeParams m_params;
    bool m_trunk;
    StemMeasures m_trunkMeasures;
};

} // namespace stromar
