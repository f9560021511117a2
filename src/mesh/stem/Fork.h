#pragma once
#include "stem/BranchBend.h"
#include "stem/Nodes.h"
#include "stromar/mesh/MeshBuilder.h"
#include <memory>
#include <optional>
#include <vector>

namespace stromar {

/// Where a stem parts into paths, or into one and branches nearly as thick.
struct ForkNode {
    std::vector<std::uint32_t> paths;    ///< of the stem; the first is the one that runs on
    std::vector<std::uint32_t> branches; ///< stems of the next generation
    std::uint32_t segmentBelow;       ///< of the generation
    double reach;                     ///< how far below that segment's end they part, metres

    std::size_t limbs() const { return paths.size() + branches.size(); }
};

/// A path or a branch above a fork: rings that start at valleys between it and its neighbours, open ones, but for the last.
struct ForkLimb {
    bool isBranch = false;
    std::uint32_t number = 0;       ///< of the path in the stem, or of the branch in its generation
    std::uint32_t share = 0;        ///< how many edges of the common ring its first has
    std::vector<ForkPoint> points;  ///< share + 1 of the first ring, one more than the common ring has of each other one
    std::vector<double> along;      ///< of those rings, and of the first that is the limb's own; metres from the base of the stem that forks
    std::int32_t turned = 0;        ///< how many points a branch's first lies from the common ring's
    std::int32_t seam = 0;          ///< at which point of that one the last ring starts, counted over whole turns

    /// That are given.
    std::uint32_t rings() const { return static_cast<std::uint32_t>(along.size()) - 1; }
};

struct ForkRings {
    std::vector<ForkPoint> common; ///< one more than it has points: its seam is doubled
    std::vector<ForkLimb> limbs;
};

/// A lid over a closed line: a fan about its middle, seen from the side from which the line runs counter-clockwise.
struct LidShape {
    glm::dvec3 middle, normal;
};
LidShape lidOf(std::span<const glm::dvec3> line);

/// Parts a ring among the limbs of a fork. Each takes the points on its side; between neighbours runs a valley, on the line
/// where their surfaces would meet, up to the one place where all valleys do: the saddle. Angles are kept, so that the bark
/// runs on.
class CForkMaker {
public:
    static constexpr double kMaxLevels = 7; ///< rings up to a saddle

    CForkMaker(const CTree& tree, std::size_t generation, const CStemSurface& surface, const Detail& detail)
        : m_tree(tree), m_number(generation), m_generation(tree.generation(generation)), m_surface(surface), m_detail(detail), m_base(m_generation, surface) {}

    /// Like paths, at the generation's nodes. Both have to outlive this.
    void letBranchesPart(const CNodes& nodes, const CStemSurface& branchSurface) {
        m_nodes = &nodes;
        m_branchSurface = &branchSurface;
    }

    /// Looks at a path of a stem; of its forks the others speak.
    void start(const CStem& stem, std::uint32_t path, double maxTurn, bool lobed);
    /// The fork where the path goes on at `segment`; nothing when neither clones nor branches can part there. `reach`: of
    /// the line's bend there.
    std::optional<ForkNode> nodeAt(std::uint32_t segment, double reach) const;
    /// `points` of the common ring. Nothing where there is no room for the limbs to part.
    std::optional<ForkRings> make(const ForkNode& node, std::uint32_t points);

private:
    /// A path or a branch above the fork.
    struct Limb {
        std::uint32_t number;
        double limit; ///< metres along the stem: where it forks again, or ends
        std::optional<CPathSurface> surface{}; ///< none: of the path that runs on
        std::optional<CBranchBend> bend{};     ///< of a branch
        double azimuth = 0;           ///< radians: to which side it leaves
        std::uint32_t first = 0, share = 0; ///< its points of the common ring
        double left = 0, right = 0;   ///< angles of the valleys beside it, at the height last looked at
        double clear = 0;             ///< metres along the stem: its own first ring
        std::int32_t turned = 0;      ///< points that a branch's first lies from the common ring's
    };
    /// All limbs at one place along the stem.
    struct Level {
        double along, radius; ///< metres
        double apart;         ///< from their middle, radii, on average
        glm::dvec3 middle;
        Frame frame;
        std::vector<RingShape> rings;
    };
    struct Valley {
        glm::dvec3 position, normal;
        double depth;
    };

    bool addReach(std::uint32_t segment, ForkNode& node) const;
    void startBase();
    bool startLimbs(const ForkNode& node);
    bool startBranches(const ForkNode& node, double foot);
    double limitOf(const CGeneration& generation, std::size_t number, const CStem& stem, const CPath& path, double from) const;
    bool canBeClosed(const ForkLimb& limb) const;
    bool allStandAside(const Level& top) const;
    void addCommonRing(ForkRings& rings) const;
    void clearLimbs(double top, double step);
    bool shareOut(const Level& top);
    Level levelAt(double along) const;
    double alongWhereApart(double apart) const;
    std::vector<double> levels(double top) const;
    bool standApart(const std::vector<double>& alongs) const;
    std::vector<glm::dvec3> valleysAt(const Level& level, double share) const;
    Valley valleyAt(const Level& level, std::size_t limb, const glm::dvec3& position, bool top) const;
    void turnTo(const Level& level, const std::vector<glm::dvec3>& valleys, bool top);
    void addLevel(const Level& level, double share, ForkRings& rings);
    void addRing(const Level& level, std::size_t limb, const Valley& left, const Valley& right, ForkLimb& made) const;
    bool isPair() const { return m_limbs.size() == 2; }
    const CPathSurface& surfaceOf(const Limb& limb) const { return limb.surface ? *limb.surface : m_base; }
    RingShape shapeAt(const Limb& limb, double along) const {
        return limb.bend ? limb.bend->shapeAt(surfaceOf(limb), along) : surfaceOf(limb).shapeAt(along);
    }
    std::size_t next(std::size_t limb) const { return (limb + 1) % m_limbs.size(); }

    const CTree& m_tree;
    std::size_t m_number;
    const CGeneration& m_generation;
    const CStemSurface& m_surface;
    const Detail& m_detail;
    const CNodes* m_nodes = nullptr; ///< none: branches do not part
    const CStemSurface* m_branchSurface = nullptr;
    std::vector<Limb> m_limbs; ///< by azimuth, once they have their shares
    CPathSurface m_base; ///< of the path that runs on, once one of its forks is made
    const CStem* m_stem = nullptr;
    std::uint32_t m_path = 0;
    double m_maxTurn = 0;
    bool m_lobed = false, m_baseStarted = false;
    RingShape m_common;
    std::uint32_t m_points = 0; ///< of the common ring
    double m_limit = 0; ///< metres along the stem that the saddle reaches at most
};

} // namespace stromar
