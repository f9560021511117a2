#pragma once
#include "stem/BranchForks.h"
#include "stem/CentreLine.h"
#include "stem/Collar.h"
#include "stem/Smoother.h"
#include <optional>
#include <span>
#include <unordered_set>

namespace stromar {

/// Chooses which rings of a generation's stems are drawn at a level of detail, and how many points each has. Made once
/// for many stems.
class CSimplifier {
public:
    /// With the meshes below, branches get collars on them, as wide as there is `room` (see collarRoom()). With the branches that will
    /// grow on these stems, they may part at forks.
    CSimplifier(const CTree& tree, int generation, const MeshParams& params, const Detail& detail, StemsBelow below, std::span<const float> room,
                const Thickening& thickening, const BranchesAbove* above);

    /// Appends a stem's tubes; those that a fork joins follow each other.
    void planStem(std::uint32_t s, MeshPlan& plan);

private:
    /// How much of a plan there was.
    struct Mark {
        explicit Mark(const MeshPlan& plan)
            : rings(plan.rings.size()), tubes(plan.tubes.size()), collarPoints(plan.collarPoints.size()),
              forks(plan.forks.size()), forkPoints(plan.forkPoints.size()), branches(plan.branches.size()), branchPoints(plan.branchPoints.size()),
              barkJoints(plan.barkJoints.size()) {}
        void restore(MeshPlan& plan) const;
        std::size_t rings, tubes, collarPoints, forks, forkPoints, branches, branchPoints, barkJoints;
    };
    /// A ring as the flat round thing it covers.
    struct Disc {
        Ring ring;
        glm::dvec3 centre, axis, right;
        double radius;
    };

    /// A collar that is tried, and how its place is found.
    struct CollarTry {
        CollarShape shape;
        ExitSearch search;
    };

    void planPaths(std::uint32_t s, MeshPlan& plan);
    std::uint32_t planPath(std::uint32_t s, std::uint32_t p, MeshPlan& plan);
    bool isHidden(const CStem& stem, const CPath& path);
    void findCoinciding(const CStem& stem);
    bool coincides(const CStem& stem, const CPath& clone, const CPath& wood) const;
    bool planWithCollar(std::uint32_t s, std::uint32_t p, MeshPlan& plan);
    bool planWithCollar(std::uint32_t s, std::uint32_t p, double room, MeshPlan& plan);
    bool planTube(std::uint32_t s, std::uint32_t p, const std::optional<CollarTry>& collar, MeshPlan& plan);
    std::uint32_t surfaceOf(const Tube& tube, std::span<const Tube> own) const;

    double addCollar(const CStem& stem, const CollarTry& own, Tube& tube, MeshPlan& plan);
    bool addRings(const CStem& stem, const CPath& path, double start, Tube& tube, MeshPlan& plan);
    std::uint32_t addFirstRings(const CStem& stem, const CPath& path, double start, Tube& tube, MeshPlan& plan);
    bool addFork(const CStem& stem, Tube& tube, std::uint32_t segment, MeshPlan& plan);
    std::uint32_t addLimb(const CStem& stem, const ForkStart& start, Tube& tube, MeshPlan& plan);
    void startBark(const CStem& stem, Tube& tube, MeshPlan& plan);
    bool isRidged(const CStem& stem, const Tube& tube, const Ring& ring) const;
    void addRing(const CStem& stem, const Tube& tube, const Disc& disc, bool needed, MeshPlan& plan);
    template <typename Add> void addBetween(const CStem& stem, std::uint32_t segment, Add&& add);
    /// Since the last ring.
    struct Bend {
        double turn = 0, length = 0; ///< radians; metres
        double radius = 0;           ///< of the last ring, metres
    };
    bool isLeftOut(const CStem& stem, std::uint32_t segment, double radiusAbove, Bend& left) const;

    void popRing(const Tube& tube, MeshPlan& plan) {
        plan.rings.pop_back();
        m_halved = std::min(m_halved, ringCountOf(tube, plan));
    }
    void halvePoints(const CStem& stem, const Tube& tube, MeshPlan& plan);
    bool canHalve(const CStem& stem, std::uint32_t points, const Ring& ring) const;

    bool collarFolds(const Tube& tube, const MeshPlan& plan);
    bool forksFold(const Tube& tube, const MeshPlan& plan);
    bool unfold(const CStem& stem, Tube& tube, MeshPlan& plan);
    static void takeOut(std::span<const std::uint32_t> folded, std::uint32_t tries, Tube& tube, MeshPlan& plan);
    bool isTight(const CStem& stem, const Tube& tube, const MeshPlan& plan) const;

    Disc discAt(const CStem& stem, const Ring& ring) const;
    bool collide(const Disc& low, const Disc& high) const;
    std::uint32_t ringCountOf(const Tube& tube, const MeshPlan& plan) const {
        return static_cast<std::uint32_t>(plan.rings.size()) - tube.firstRing;
    }
    double alongOf(const Ring& ring) const;
    /// Of the wood, as it is without what a level of detail adds; metres.
    double ownRadius(const CStem& stem, const Ring& ring) const { return discAt(stem, ring).radius / m_surface.growthOf(stem); }
    bool endsInPoint(const CStem& stem, const CPath& path) const;
    ForkStart& startOf(const CStem& stem, std::uint32_t path) { return m_starts[path - stem.firstPath]; }
    std::uint32_t indexOf(const CSegment& segment) const {
        return static_cast<std::uint32_t>(&segment - m_generation.segments.data());
    }

    const Detail& m_detail;
    const CGeneration& m_generation;
    CStemSurface m_surface;
    CSmoother m_smoother;
    CCentreLine m_line;
    CForkMaker m_forkMaker;
    CTubeTrial m_trial;
    bool m_smooth;
    double m_maxSag; ///< metres
    std::span<const float> m_room; ///< for collars, by stem
    std::optional<CCollarMaker> m_collars;
    std::optional<CBranchForks> m_branches; ///< where they part at forks
    const MeshPlan* m_parents = nullptr;    ///< whose forks the stems may start at

    // Of the stem and the tube that are being planned:
    std::vector<ForkStart> m_starts;      ///< of its paths
    std::vector<std::uint32_t> m_drawnAs; ///< of each: itself, or the one whose wood it runs along in
    std::vector<std::uint32_t> m_planned; ///< forks of the tube, by the segment below
    std::vector<std::uint32_t> m_folded;  ///< those of them that fold
    bool m_startFolds = false;            ///< as the fork does that it starts at
    std::unordered_set<std::uint32_t> m_refused; ///< forks that fold: their clones start inside the wood
    Disc m_last{};
    std::uint32_t m_tries = 0;  ///< of the stem
    std::uint32_t m_halved = 0; ///< its rings that have their points
    std::size_t m_fixed = 1; ///< its rings that others do not push out
    double m_clear = 0;      ///< metres along the stem above which rings may stand
    double m_spacing = 0;    ///< metres below which rings coincide
    std::vector<double> m_places;
};

} // namespace stromar
