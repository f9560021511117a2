#include "stromar/mesh/MeshBound.h"
#include "stem/CentreLine.h"
#include "stem/BranchForks.h"
#include "stem/Smoother.h"
#include "stromar/mesh/JoinedStems.h"
#include "stromar/mesh/twig/Twig.h"
#include <algorithm>
#include <cmath>
#include <thread>

namespace stromar {

namespace {
constexpr double kRingsPerReach = 14; // of a flare or roots
constexpr double kRoundEndRings = 40; // likewise a round end
constexpr double kBytesPerVertex = 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(VertexLook);
constexpr double kCopies = 2;           // the mesh, and what the graphics card or a writer gets
constexpr double kJoinedGrowth = 1.3;   // of wood that is joined for a file: points of collars, copies at seams and creases
constexpr double kAroundFork = 2.5;     // rings of a limb: half the common one, a share of it, and the ring that turns the seam back
constexpr double kBytesPerChosenStem = 64; // while chooseStems() counts triangles and stems, and of its sets
constexpr double kBytesPerWall = 100;   // of a triangle while its tube is joined: unrolled, and in the tries

/// Of stems of one thickness in a generation.
class CStemMeshBound {
public:
    CStemMeshBound(const BaseForm& base, std::span<const GenerationBound> generations, std::size_t generation,
                   double thickness, const Detail& detail)
        : m_base(base), m_bound(generations[generation]), m_thickness(thickness), m_trunk(generation == 0),
          m_smooth(static_cast<int>(generation) < detail.smoothGenerations), m_detail(detail) {}

    double points() const {
        const double round = roundRingPoints(m_detail, std::sqrt(m_thickness));
        const int ridges = m_trunk ? std::max(m_base.lobeCount(), m_base.rootCount()) : 0;
        return std::max(round * parentsPoints(), double(m_detail.lobePoints * ridges));
    }
    double rings() const {
        const double collars = m_trunk ? 0 : points() > 3 ? m_detail.collarRings : std::min(1, m_detail.collarRings);
        return m_bound.segments + 2 * m_bound.paths + byCollar() * collars + addedRings() + forkRings();
    }
    double vertices() const { return rings() * (points() + 1) + 2 * m_bound.paths * lidVertices() + (branches() + branched()) * (points() + 2 * forkLevels() + 2); }
    /// Of the triangles: walls have two for each point of a ring, whose seam is doubled; lids have fewer.
    double corners() const { return vertices() * 6 * points() / (points() + 1); }
    /// Of wood that is joined for a file: once more its mesh, with where its vertices come from, and the points of all collars. Its plan
    /// takes the place of the one it was meshed by.
    double joinedBytes() const {
        if (m_detail.collarRings == 0) return 0;
        const double each = kBytesPerVertex + sizeof(VertexSource);
        return kJoinedGrowth * (vertices() * each + corners() * sizeof(std::uint32_t)) + pointBytes();
    }
    /// While the walls of one stem are cut open.
    double wallBytes() const { return m_detail.collarRings == 0 ? 0 : kBytesPerWall * corners() / 3; }
    double planBytes() const {
        const double forked = branches() * (sizeof(ForkedBranch) + (forkLevels() + 1) * (points() + 1) * sizeof(ForkPoint));
        return rings() * sizeof(Ring) + m_bound.paths * (sizeof(Tube) + 2 * sizeof(Fork) + sizeof(std::int32_t)) + forked + branched() * sizeof(BarkJoint) + 1;
    }
    /// Of the points of its collar and its forks, until its generation has a mesh.
    double pointBytes() const {
        return byCollar() * points() * sizeof(SurfacePoint) + forkRings() * (points() + 1) * sizeof(ForkPoint);
    }

private:
    /// One in the middle where Tube::middleOfLid() may be.
    double lidVertices() const { return points() + (m_trunk || m_detail.collarRings > 0 ? 1 : 0); }
    /// Rings that CSmoother and CCentreLine may add between the ends of a stem's segments.
    double addedRings() const {
        if (!m_smooth) return 0;
        const double bends = bendRings();
        const double helix = m_bound.helix ? (m_detail.helixRings - 1) * m_bound.segments : 0;
        const double max = double(CSmoother::ringLimit(1 / m_bound.along)) * m_bound.segments;
        if (m_bound.spheres) return bends + std::max(helix, max);
        const double uneven = (m_bound.roundEnds ? kRoundEndRings * m_bound.paths : 0) + (m_trunk ? baseRings() : 0);
        return bends + std::max(helix, std::min(max, uneven));
    }

    /// Up to the saddles between a stem's limbs (CForkMaker), for each clone and for the path it parts from; likewise for each branch that
    /// parts, in its generation and in its parent's.
    double forkRings() const {
        const double limbs = (m_bound.forks ? 2 * (m_bound.paths - 1) : 0) + branches() + branched();
        return limbs * (forkLevels() + kAroundFork) - branched(); // whose first ring is counted already
    }
    double forkLevels() const { return std::min(CForkMaker::kMaxLevels, 1 + 0.4 * points()); }
    double branches() const { return parting(&Parting::branches); }
    double branched() const { return parting(&Parting::branched); }
    /// Of stems: others start at forks, with more rings than a collar has.
    double byCollar() const { return std::max(0.0, 1 - branched()); }
    double parting(double Parting::* count) const {
        if (m_detail.collarRings == 0) return 0;
        const bool single = roundRingPoints(m_detail, std::sqrt(m_thickness)) >= m_detail.forkPoints;
        return m_bound.several.*count + (single ? m_bound.single.*count : 0);
    }
    /// Over what its thickness needs: a branch that starts at a fork has the points that its parent needs there, or not many more.
    double parentsPoints() const {
        return 1 + (CBranchForks::kTooManyPoints - 1) * branched();
    }

    /// Where flare and roots bend the lowest paths. Halving until the radius is met takes rings by the root of how far
    /// they reach, at whatever height.
    double baseRings() const {
        const auto rings = [](double reach) { return reach == 0 ? 0 : 8 + kRingsPerReach * std::sqrt(std::abs(reach)); };
        const double height = m_base.rootCount() > 0 ? std::max(0.125, m_base.rootHeight) : 0.125;
        const double paths = m_bound.along * height > 1 ? m_bound.paths : 1;
        return paths * (rings(m_base.flare) + (m_base.rootCount() > 0 ? rings(m_base.rootReach) : 0));
    }

    /// Of a stem: at every joint, at its forks, and where its paths turn back from those.
    double bendRings() const {
        constexpr double kMax = CCentreLine::kMaxBendRings;
        if (m_detail.maxTurn <= 0 || points() <= 3) return 0;
        const double between =
            std::min(m_detail.maxTurn / std::sqrt(m_thickness), kCoarsestTurn * m_detail.maxTurn);
        const double pieces = std::ceil(m_bound.turn / between);
        const double joint = pieces <= 1 ? 0 : std::min(kMax, 2 * std::floor((pieces + 1) / 2));
        const double fork = m_bound.forks ? 2 * (3 * m_bound.forkTurn / between) : 0;
        return std::min(kMax * (m_bound.segments - 1),
                        joint * (m_bound.segments - 1) + fork * (m_bound.paths - 1));
    }

    const BaseForm& m_base;
    const GenerationBound& m_bound;
    double m_thickness;
    bool m_trunk, m_smooth;
    const Detail& m_detail;
};

double stemVertices(const SizeBound& tree, std::size_t generation, const Detail& detail) {
    double vertices = 0;
    for (const auto& [share, thickness] : tree.generations[generation].thickness)
        vertices += share * CStemMeshBound(tree.base, tree.generations, generation, thickness, detail).vertices();
    return vertices * tree.generations[generation].stems;
}

/// The part of the last generation's stems that is drawn: see chooseStems(); where that leaves out others instead, it leaves out
/// more. What it is told of is itself a bound, hence the margin.
double twigShareBound(const SizeBound& tree, const Detail& detail) {
    constexpr double kMargin = 1.3, kVerticesPerTriangle = 1; // at most
    if (detail.woodShare >= 1) return 1;
    double left = 0;
    for (std::size_t g = 0; g < tree.generations.size(); ++g)
        left += detail.woodShare * stemVertices(tree, g, detailOf(detail.model, 0));
    if (detail.collarRings == 0) left = std::max(left, kVerticesPerTriangle * kFewWoodTriangles);
    for (std::size_t g = 0; g + 1 < tree.generations.size(); ++g) left -= stemVertices(tree, g, detail);
    const double share = left / std::max(1.0, stemVertices(tree, tree.generations.size() - 1, detail));
    const double least = detail.collarRings == 0 ? kLeastShareOfThinBranches : kMargin * detail.share;
    const double sampled = 8 / std::sqrt(std::max(1.0, tree.generations.back().stems)); // chosen by chance
    return std::min(1.0, std::max(kMargin * share, least) + sampled);
}

/// Organs that are grown for a detail, and what is drawn of them.
struct OrganBound {
    double grown = 0, vertices = 0, corners = 0;
};

/// Of so many leaves those of a kind, which is chosen by chance.
double kindBound(double leaves, double share) {
    if (share <= 0 || share >= 1) return leaves * share;
    return std::min(leaves, leaves * share + 6 * std::sqrt(leaves * share * (1 - share)) + 6);
}

/// Of so many that are grown. Which of them have fallen is chance: of none or all of them it is known.
OrganBound drawnBound(double grown, Organ organ, const MeshParams& params, const Detail& detail) {
    if (params.seasonOf(organ).share <= 0) return {grown, 0, 0};
    OrganBound bound{grown, 0, 0};
    for (std::size_t kind = 0; kind < (organ == Organ::Leaf ? kLeafKinds : 1); ++kind) {
        const double count = organ == Organ::Leaf ? kindBound(grown, params.shareOf(kind)) : grown;
        if (count <= 0) continue;
        const LeafBlade blade = bladeOf(params, organ, detail, kind);
        bound.vertices += count * double(blade.points.size());
        bound.corners += count * double(blade.indices.size());
    }
    return bound;
}

/// Rectangles, for those on twigs.
OrganBound cardBound(double leaves, const TwigBound& twigs, const MeshParams& params, const Detail& detail) {
    const double grown = std::min(leaves, 2 * twigs.leaves); // of the typical one
    if (params.seasonOf(Organ::Leaf).share <= 0) return {grown, 0, 0};
    const double vertices = std::min(4 * std::ceil(leaves * detail.cardShare), twigs.stems * double(maxVerticesOfCard(detail)));
    return {grown, vertices, 1.5 * vertices};
}

OrganBound organBound(const SizeBound& tree, Organ organ, const MeshParams& params, const Detail& detail, bool onCards) {
    const double count = tree.organs[static_cast<std::size_t>(organ)], demanded = demandOf(detail, {}).bound(count);
    if (organ != Organ::Leaf || !onCards) return drawnBound(demanded, organ, params, detail);
    const OrganBound cards = cardBound(count, tree.twigs, params, detail);
    const OrganBound others = drawnBound(std::min(demanded, tree.twigs.otherLeaves), organ, params, detail);
    return {cards.grown + others.grown, cards.vertices + others.vertices, cards.corners + others.corners};
}
} // namespace

MeshBound meshBound(const SizeBound& tree, const MeshParams& params, const Detail& detail, bool onCards) {
    MeshBound bound;
    double corners = 0, maxPointBytes = 0, maxWallBytes = 0;
    const double threads = std::max(1u, std::thread::hardware_concurrency());
    const std::vector<GenerationBound>& wood = onCards ? tree.twigs.wood : tree.generations;
    for (std::size_t g = 0; g < wood.size(); ++g) {
        const bool sparse = !onCards && g >= 2 && g + 1 == wood.size();
        const double drawn = sparse ? twigShareBound(tree, detail) : 1;
        double pointBytes = 0;
        for (const auto& [share, thickness] : wood[g].thickness) {
            const CStemMeshBound each(tree.base, wood, g, thickness, detail);
            const double stems = drawn * share * wood[g].stems;
            bound.vertices += stems * each.vertices();
            corners += stems * each.corners();
            bound.bytes += 2 * stems * each.planBytes(); // its parts and the whole
            pointBytes += 2 * stems * each.pointBytes();
            bound.bytes += stems * each.joinedBytes();
            if (g + 1 < wood.size()) maxWallBytes = std::max(maxWallBytes, std::min(stems, threads) * each.wallBytes());
        }
        maxPointBytes = std::max(maxPointBytes, pointBytes);
    }
    bound.bytes += maxPointBytes + maxWallBytes;
    if (detail.woodShare < 1) bound.bytes += tree.stems() * kBytesPerChosenStem;
    for (const Organ organ : kOrgans) {
        const OrganBound own = organBound(tree, organ, params, detail, onCards);
        bound.vertices += own.vertices;
        corners += own.corners;
        bound.bytes += own.grown * (sizeof(CLeaf) + sizeof(std::uint32_t) + kCopies * sizeof(InstancePlace));
        if (tree.organs[static_cast<std::size_t>(organ)] > 0) bound.bytes += tree.stems() * sizeof(std::uint32_t); // counts
    }
    bound.bytes += kCopies * (bound.vertices * kBytesPerVertex + corners * sizeof(std::uint32_t));
    return bound;
}

} // namespace stromar
