#pragma once
#include "stem/PathSurface.h"
#include "stromar/mesh/MeshBuilder.h"
#include <memory>
#include <optional>
#include <vector>

namespace stromar {

/// Where a stem parts into paths.
struct ForkNode {
    std::vector<std::uint32_t> paths; ///< of the stem; the first is the one that runs on
    std::uint32_t segmentBelow;       ///< of the generation
    double reach;                     ///< how far below that segment's end they part, metres
};

/// A path above a fork: rings that start at valleys between it and its neighbours, open ones, but for the last.
struct ForkLimb {
    std::uint32_t path;             ///< of the stem
    std::uint32_t share;            ///< how many edges of the common ring its first has
    std::vector<ForkPoint> points;  ///< share + 1 of the first ring, one more than the common ring has of each other one
    std::vector<double> along;      ///< of those rings, and of the first that is the path's own; metres from the stem's base
    std::int32_t seam;              ///< at which point of that one the last ring starts, counted over whole turns
};

struct ForkRings {
    std::vector<ForkPoint> common; ///< one more than it has points: its seam is doubled
    std::vector<ForkLimb> limbs;
};

/// Parts a ring among the paths of a fork. Each takes the points on its side; between neighbours runs a valley, on the line
/// where their surfaces would meet, up to the one place where all valleys do: the saddle. Angles are kept, so that the bark
/// runs on.
class CForkMaker {
public:
    static constexpr double kMaxLevels = 7; ///< rings up to a saddle

    CForkMaker(const CGeneration& generation, const CStemSurface& surface) : m_generation(generation), m_surface(surface) {}

    /// The fork where a path of a stem goes on at `segment`; nothing when no clone can part there.
    std::optional<ForkNode> nodeAt(const CStem& stem, std::uint32_t path, std::uint32_t segment, double reach) const;
    /// `points` of the common ring. Nothing where there is no room for the paths to part.
    std::optional<ForkRings> make(const CStem& stem, const ForkNode& node, std::uint32_t points, double maxTurn, bool lobed);

private:
    /// A path above the fork.
    struct Limb {
        std::uint32_t path;
        double limit; ///< metres along the stem: where it forks again, or ends
        CPathSurface surface;
        double azimuth = 0;           ///< radians: to which side it leaves
        std::uint32_t first = 0, share = 0; ///< its points of the common ring
        double left = 0, right = 0;   ///< angles of the valleys beside it, at the height last looked at
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

    bool startLimbs(const CStem& stem, const ForkNode& node, double maxTurn, bool lobed);
    double limitOf(const CStem& stem, std::uint32_t path, std::uint32_t segmentBelow) const;
    bool shareOut(const Level& top);
    Level levelAt(double along) const;
    double alongWhereApart(double apart) const;
    std::vector<double> levels(double top) const;
    bool standApart(const CStem& stem, const std::vector<double>& alongs) const;
    std::vector<glm::dvec3> valleysAt(const Level& level, double share) const;
    Valley valleyAt(const Level& level, std::size_t limb, const glm::dvec3& position, bool top) const;
    void turnTo(const Level& level, const std::vector<glm::dvec3>& valleys, bool top);
    void addLevel(const Level& level, double share, ForkRings& rings);
    void addRing(const Level& level, std::size_t limb, const Valley& left, const Valley& right, ForkLimb& made) const;
    bool isPair() const { return m_limbs.size() == 2; }
    std::size_t next(std::size_t limb) const { return (limb + 1) % m_limbs.size(); }

    const CGeneration& m_generation;
    const CStemSurface& m_surface;
    std::vector<Limb> m_limbs; ///< by azimuth, once they have their shares
    RingShape m_common;
    std::uint32_t m_points = 0; ///< of the common ring
    double m_limit = 0; ///< metres along the stem that the saddle reaches at most
};

} // namespace stromar
