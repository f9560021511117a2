#include "stromar/mesh/MeshBound.h"
#include "stem/CentreLine.h"
#include "stem/Smoother.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/mesh/twig/Twig.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr double kUnevenRings = 60;   // that a flare or roots ask for along a path, at most
constexpr double kRoundEndRings = 40; // likewise a round end
constexpr double kBytesPerVertex = 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + 1;
constexpr double kCornersPerVertex = 6; // of the triangles, per vertex
constexpr double kCopies = 2;           // the mesh, and what the graphics card or a writer gets

class CGenerationMeshBound {
public:
    CGenerationMeshBound(const SizeBound& tree, std::size_t generation, const Detail& detail)
        : m_base(tree.base), m_bound(tree.generations[generation]), m_trunk(generation == 0),
          m_smooth(static_cast<int>(generation) < detail.smoothGenerations), m_detail(detail) {}

    double points() const {
        const int round = roundRingPoints(m_detail, std::sqrt(m_bound.thickness));
        const int ridges = m_trunk ? std::max(m_base.lobeCount(), m_base.rootCount()) : 0;
        return std::max(round, m_detail.lobePoints * ridges);
    }
    double rings() const {
        const double collars = m_trunk ? 0 : points() > 3 ? m_detail.collarRings : std::min(1, m_detail.collarRings);
        return m_bound.segments + 2 * m_bound.paths + collars + addedRings();
    }
    double vertices() const { return m_bound.stems * (rings() + 2 * m_bound.paths) * (points() + 1); }
    double planBytes() const {
        return m_bound.stems * (rings() * sizeof(Ring) + m_bound.paths * (sizeof(Tube) + sizeof(std::int32_t)) +
                                points() * sizeof(SurfacePoint) + 1);
    }

private:
    /// Rings that CSmoother and CCentreLine may add between the ends of a stem's segments.
    double addedRings() const {
        if (!m_smooth) return 0;
        const double bends = ringsPerBend() * (m_bound.segments - 1);
        const double helix = m_bound.helix ? (m_detail.helixRings - 1) * m_bound.segments : 0;
        const double max = double(CSmoother::ringLimit(1 / m_bound.along)) * m_bound.segments;
        if (m_bound.spheres) return bends + std::max(helix, max);
        const double uneven = (m_bound.roundEnds ? kRoundEndRings : 0) +
                              (m_trunk && m_base.flare != 0 ? kUnevenRings : 0) +
                              (m_trunk && m_base.rootCount() > 0 ? kUnevenRings : 0);
        return bends + std::max(helix, std::min(max, uneven * m_bound.paths));
    }

    double ringsPerBend() const {
        constexpr double kMax = CCentreLine::kMaxBendRings;
        if (m_detail.maxTurn <= 0 || points() <= 3) return 0;
        if (m_bound.forks) return kMax;
        const double between = m_detail.maxTurn / std::sqrt(m_bound.thickness);
        const double pieces = std::ceil(m_bound.turn / std::min(between, kCoarsestTurn * m_detail.maxTurn));
        return pieces <= 1 ? 0 : std::min(kMax, 2 * std::floor((pieces + 1) / 2));
    }

    const BaseForm& m_base;
    const GenerationBound& m_bound;
    bool m_trunk, m_smooth;
    const Detail& m_detail;
};

/// Organs that are grown for a detail, and what is drawn of them.
struct OrganBound {
    double grown = 0, vertices = 0;
};

OrganBound organBound(const SizeBound& tree, Organ organ, const MeshParams& params, const Detail& detail, bool onCards) {
    const double count = tree.organs[static_cast<std::size_t>(organ)];
    // Which of them have fallen is chance: of none or all of them it is known.
    const bool all = params.seasonOf(organ).share > 0;
    if (organ == Organ::Leaf && onCards)
        return {std::min(count, 2 * tree.bearers.leaves),
                !all ? 0 : std::min(4 * std::ceil(count * detail.share), tree.generations.back().stems * double(maxVerticesOfCard(detail)))};
    const double grown = demandOf(detail, {}).bound(count);
    return {grown, all ? grown * double(verticesPerOrgan(params, organ, detail)) : 0};
}
} // namespace

MeshBound meshBound(const SizeBound& tree, const MeshParams& params, const Detail& detail, bool onCards) {
    MeshBound bound;
    for (std::size_t g = 0; g < tree.generations.size(); ++g) {
        if (onCards && g + 1 == tree.generations.size()) continue;
        const CGenerationMeshBound own(tree, g, detail);
        bound.vertices += own.vertices();
        bound.bytes += 2 * own.planBytes(); // its parts and the whole
    }
    for (const Organ organ : kOrgans) {
        const OrganBound own = organBound(tree, organ, params, detail, onCards);
        bound.vertices += own.vertices;
        bound.bytes += own.grown * (sizeof(CLeaf) + sizeof(std::uint32_t) + kCopies * sizeof(InstancePlace));
        if (tree.organs[static_cast<std::size_t>(organ)] > 0) bound.bytes += tree.stems() * sizeof(std::uint32_t); // counts
    }
    bound.bytes += kCopies * bound.vertices * (kBytesPerVertex + kCornersPerVertex * sizeof(std::uint32_t));
    return bound;
}

} // namespace stromar
