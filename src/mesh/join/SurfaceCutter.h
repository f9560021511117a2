#pragma once
#include "join/CrossingCurves.h"
#include <set>
#include <unordered_map>

namespace stromar {

/// Makes curves along which two surfaces cross edges of both.
class CSurfaceCutter {
public:
    using Index = CWoodPatch::Index;
    using Surface = CCrossingCurves::Surface;

    /// The patch must be marked.
    CSurfaceCutter(const CCrossingCurves& curves, CWoodPatch& patch);

    /// Undoes what was cut before. False where that cannot be. Time squared in the segments.
    bool cut(const std::set<Index>& curves);

    /// The patch's point at a node of a curve that is cut.
    Index pointOf(Index node) const { return m_pointOf.at(node); }
    /// Of a triangle there was before: itself, where it is whole.
    std::vector<Index> partsOf(Index whole);

private:
    using Edge = std::pair<Index, Index>; ///< points, the lower first
    void addPoints(const std::set<Index>& curves);
    bool cutSurface(Surface surface, const std::set<Index>& curves);
    bool splitEdge(std::vector<Index> nodes);
    bool splitFace(Index node);
    bool splitEdgeAt(Index part, const glm::dvec3& areas, Index node);
    bool connect(Index whole, Index from, Index to);
    bool fill(Index whole, const std::vector<Index>& edge, std::vector<std::array<Index, 3>>& filled) const;
    glm::dvec2 at(Index point, Index whole) const;
    template <typename Do>
    bool forEachNode(const std::set<Index>& curves, Do&& work) const;

    const CCrossingCurves& m_curves;
    CWoodPatch& m_patch;
    std::size_t m_firstNew, m_listed; ///< triangles
    std::unordered_map<Index, std::vector<Index>>
        m_parts; ///< by whole triangle, up to the last listed; some are removed
    std::unordered_map<Index, Index> m_pointOf, m_nodeOf; ///< by node, by point
    std::set<Edge> m_fixed;                               ///< of the surface that is being cut
};

} // namespace stromar
