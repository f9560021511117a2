#pragma once
#include "stem/StemSurface.h"
#include "stromar/mesh/MeshBuilder.h"

namespace stromar {

/// Writes tubes by themselves, to see how they turn out. Made once for many.
class CTubeTrial {
public:
    CTubeTrial(const CGeneration& generation, const CStemSurface& surface) : m_generation(generation), m_surface(surface) {}

    /// False when it folds.
    bool write(const MeshPlan& plan, const Tube& tube);
    /// Rings that have a vertex whose normal looks into a triangle around it, the lowest first; never two that follow
    /// each other, since without one of them the other may be in order.
    std::vector<std::uint32_t> foldedRings(const MeshPlan& plan) const;
    /// Whether the tube is not inside out.
    bool enclosesWood() const;

private:
    const CGeneration& m_generation;
    const CStemSurface& m_surface;
    Tube m_tube{};
    CMesh m_mesh;
};

} // namespace stromar
