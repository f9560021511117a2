#pragma once
#include "stem/RootFlare.h"
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/MeshParams.h"
#include "stromar/mesh/StemChoice.h"
#include "stromar/tree/Tree.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

/// The form of the stems' wood in one generation, as it is drawn: radius profile, base form and the least radius. Metres, radians;
/// `along` is counted from a stem's base.
class CStemSurface {
public:
    /// At a level of detail. The thickening has to outlive it.
    CStemSurface(const CTree& tree, int generation, const MeshParams& params, const Detail& detail, const Thickening& thickening)
        : CStemSurface(tree, generation, params) {
        m_detail = &detail;
        if (!thickening.stems.empty()) m_thickening = &thickening;
    }
    CStemSurface(const CTree& tree, int generation, const MeshParams& params)
        : m_params(params), m_stems(tree.generation(static_cast<std::size_t>(generation)).stems.data()), m_base(generation == 0 ? tree.base() : BaseForm()), m_trunk(generation == 0) {
        if (tree.generation(0).stems.empty()) return;
        m_trunkLength = tree.generation(0).stems[0].length;
        m_trunkRadius = tree.generation(0).stems[0].radius;
    }

    /// The root of the radius over the trunk's, at most 1: rings and bends err by equally many metres when their points
    /// and pieces are in this proportion.
    double thickness(double radius) const {
        return m_trunkRadius > 0 ? std::min(1.0, std::sqrt(radius / m_trunkRadius)) : 1;
    }

    /// Of a ring, at a level of detail.
    int ringPoints(double radius) const { return ringPoints(*m_detail, radius); }
    /// Without room for lobes.
    int roundPoints(double radius) const { return roundRingPoints(*m_detail, thickness(radius)); }

    /// Radians: as much in proportion as so many degrees are of the trunk.
    double turnOf(const CStem& stem, double ofTrunk) const {
        return std::numbers::pi / 180 * std::min(kCoarsestTurn * ofTrunk, ofTrunk / std::max(1e-6, thickness(stem.radius)));
    }

    /// With which a stem is drawn at its base.
    double drawnAtBase(const CStem& stem, const CSegment& first) const { return std::max(woodRadius(stem, first, 0), drawnFloor(stem, first)); }

    /// As in VertexLook.
    std::uint8_t thinness(double radius) const { return thinnessOf(radius, m_trunkRadius); }

    /// Radius at a place of a segment, before lobes and the least radius.
    double woodRadius(const CStem& stem, const CSegment& segment, double t) const {
        const double along = segment.start + t * segment.length;
        const double wood = stem.profile.isEven() ? segment.radiusBase + t * (radiusAbove(stem, segment) - segment.radiusBase)
                                                  : stem.profile.radiusAt(along, stem.length, stem.radius);
        return growthOf(stem) * (m_base.flare == 0 ? wood : wood * m_base.flareAt(along / stem.length));
    }

    /// Likewise, to the end of the farthest root.
    double outerRadius(const CStem& stem, const CSegment& segment, double t) const {
        const double wood = woodRadius(stem, segment, t);
        if (roots() == 0) return wood;
        return wood + stem.radius * CRootFlare::maxOut(m_base, (segment.start + t * segment.length) / stem.length);
    }

    /// Whether the radius changes other than evenly along a segment.
    bool uneven(const CStem& stem) const {
        return !stem.profile.isEven() || m_base.flare != 0 || roots() > 0;
    }

    int lobes() const { return m_base.lobeCount(); }
    int roots() const { return m_base.rootCount(); }
    CRootFlare rootsOf(const CStem& stem) const { return roots() > 0 ? CRootFlare(m_base, stem.id) : CRootFlare(); }
    /// What a ring around the trunk has to show.
    int ridges() const { return std::max(lobes(), roots()); }
    /// How far lobes stand out, as a part of the radius.
    double lobeDepth(const CStem& stem, double along) const { return m_base.lobeDepthAt(along / stem.length); }
    double minRadius() const { return m_params.minRadius; }

    /// Lengths below this vanish in the rounding of single-precision coordinates near the stem.
    static double minDrawn(const CStem& stem, const CSegment& first) {
        const glm::dvec3 p = glm::abs(first.position);
        return 1e-5 * (std::max({p.x, p.y, p.z}) + stem.length);
    }
    /// The radius below which a ring is drawn with this radius.
    double drawnFloor(const CStem& stem, const CSegment& first) const {
        return std::max(minRadius(), minDrawn(stem, first));
    }

    /// How often the bark's picture is repeated.
    struct Bark {
        double around;   ///< times
        double perMetre; ///< along
    };
    /// Each trunk by TextureWrapX/Y (thesis §4.7). Other stems in the first trunk's metres per repeat, but whole times
    /// around, at least once; along so that the picture keeps its shape.
    Bark barkOf(const CStem& stem) const {
        const double x = m_params.barkAround, y = m_params.barkAlong;
        if (m_trunk) return {x, y / std::max(1e-9, stem.length)};
        const double perMetre = y / std::max(1e-9, m_trunkLength);
        const double exact = x * std::max(minRadius(), stem.radius) / std::max(1e-9, m_trunkRadius);
        if (!(exact > 1e-6)) return {1, perMetre};
        const double around = std::max(1.0, std::round(exact));
        return {around, perMetre * around / exact};
    }

    /// How much thicker a stem is drawn than it is: it covers as much as with all stems and with the points of its rings at LOD 0.
    double growthOf(const CStem& stem) const {
        if (!m_detail || m_detail->lod == 0) return 1;
        const double outline = outlineShare(ringPoints(detailOf(m_detail->model, 0), stem.radius)) / outlineShare(ringPoints(stem.radius));
        return m_thickening && m_thickening->stems[static_cast<std::size_t>(&stem - m_stems)] ? m_thickening->growth * outline : outline;
    }

private:
    int ringPoints(const Detail& detail, double radius) const {
        return std::max(roundRingPoints(detail, thickness(radius)), detail.lobePoints * ridges());
    }

    /// At the end of a segment.
    static double radiusAbove(const CStem& stem, const CSegment& segment) {
        const bool runsOn = stem.profile.form == RadiusProfile::Form::Steps && segment.end() < stem.length;
        return runsOn ? (&segment + 1)->radiusBase : segment.radiusEnd; // segments of a stem lie one after the other
    }

    MeshParams m_params;
    const CStem* m_stems;
    const Detail* m_detail = nullptr; ///< none: as it is
    const Thickening* m_thickening = nullptr;
    BaseForm m_base; ///< none above the trunks
    bool m_trunk;
    double m_trunkLength = 0, m_trunkRadius = 0; ///< of the first
};

} // namespace stromar
