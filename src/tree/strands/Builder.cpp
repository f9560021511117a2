#include "stromar/tree/strands/StrandsBuilder.h"
#include "CommonValues.h"
#include "MeasuredBound.h"
#include "OrganSites.h"
#include "strands/Draw.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace stromar {

namespace {
constexpr double kTipWidth = 0.3;    // diameter of a tip over that of its base
constexpr double kBelowWhole = 1e-9; // 0.6 of 10 strands are 6
constexpr double kUpright = 1e-9;    // sine of a branch that hanging cannot turn to any side
constexpr double kSplitVariation = 0.5; // of the angle
constexpr double kPlaneVariation = std::numbers::pi / 2;
constexpr std::uint64_t kLeader = 1, kAside = 2; // steps of a path's name
constexpr std::uint64_t kTrunkId = 0x737472616e64;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The curves of one value, read once.
class CValueCurves {
public:
    CValueCurves(const StrandValue& value, const CParams& params)
        : m_byOrder(ParamRef{value.byOrder}.curve(params)), m_range(value.byOrder->range), m_over(*overOf(*value.byOrder, params)) {
        if (value.byDepth) m_byDepth = &ParamRef{value.byDepth}.curve(params);
    }

    double at(const StrandBranch& branch) const {
        const double factor = m_byDepth ? m_byDepth->at(branch.depth) : 1;
        return std::clamp(factor * m_byOrder.at(branch.quantity(m_over)), m_range.min, m_range.max);
    }

private:
    const CCurve& m_byOrder;
    const CCurve* m_byDepth = nullptr;
    Range m_range;
    CurveOver m_over;
};

/// How far a tree has come between two whole numbers of strands: that with `before` on the way to that with one more.
struct Stage {
    double age = 1;      ///< 0..1
    double before;       ///< strands
    double share = 0;    ///< of the way
    double diameter = 1; ///< of all branches, as a factor: below one strand

    double after() const { return share > 0 ? before + 1 : before; }
};

Stage stageOf(double strands, double age) {
    const double now = strands * age * age, whole = std::max(1.0, now);
    Stage stage{.age = age, .before = std::floor(whole), .share = whole - std::floor(whole)};
    if (now < 1) stage.diameter = std::sqrt(now);
    return stage;
}

/// A branch while it grows.
struct Growing {
    StrandBranch branch;
    double before, after; ///< strands in the two trees that its own lies between; before 0: it is not there yet
    double length; ///< drawn, metres
    Frame frame;
    glm::dvec3 base;
    std::uint64_t id; ///< of its path from the root
};

struct StemStart {
    Growing first;
    std::int32_t parent; ///< stem
    std::uint32_t position;
    double offset, parentRadius;
};

/// Turned towards the ground, at most until it hangs.
Frame hung(const Frame& frame, double angle) {
    const glm::dvec3 down(0, 0, -1), across = glm::cross(frame[2], down);
    const double sine = glm::length(across);
    if (sine < kUpright || angle <= 0) return frame;
    return rotatedAbout(frame, across / sine, std::min(angle, std::atan2(sine, glm::dot(frame[2], down))));
}

/// Grows all stems, generation by generation.
class CStrandWalk {
public:
    CStrandWalk(const CParams& params, bool varied, double age = 1)
        : m_params(strands(params)), m_stage(stageOf(m_params.strands, age)), m_random(static_cast<std::uint64_t>(static_cast<std::int64_t>(params.common.seed)), varied),
          m_varied(varied), m_turned(varied && params.common.seed != 0) {
        for (const StrandValue& value : strandValues()) m_values.emplace_back(value, params);
    }

    std::vector<std::shared_ptr<const CGeneration>> grow(const CProgress& progress) {
        std::vector<std::shared_ptr<const CGeneration>> generations;
        std::vector<StemStart> starts{{trunk(), -1, 0, 0, 0}};
        while (!starts.empty()) {
            progress.poll();
            auto generation = std::make_shared<CStrandGeneration>();
            std::vector<StemStart> next;
            for (const StemStart& start : starts) growStem(start, *generation, next);
            generations.push_back(std::move(generation));
            starts = std::move(next);
        }
        return generations;
    }

    /// Curves run over what its branches have: the heights and lengths of the grown tree, whose paths hold all of a younger one.
    void readCurvesOn(const CTree& grown) {
        for (const auto& generation : grown.generations()) {
            const auto& own = static_cast<const CStrandGeneration&>(*generation);
            for (const CStem& stem : own.stems) {
                std::uint64_t id = stem.id;
                for (std::uint32_t s = 0; s < stem.segmentCount; ++s, id = hashCombine(id, kLeader))
                    m_grown.emplace(id, &own.branches[stem.firstSegment + s]);
            }
        }
    }

    double height() const { return std::max(m_height, 1e-3); }

private:
    Growing trunk() const {
        const double plane = m_turned ? 2 * std::numbers::pi * m_random.uniform(kTrunkId, kDrawFirstPlane) : 0;
        const double strands = strandsBetween(m_stage.before, m_stage.after());
        return {{strands, m_stage.age * m_params.inheritedLength, 0, 0, diameterOf(strands), 0, 0}, m_stage.before, m_stage.after(),
                m_stage.age * m_params.trunkHeight, rotatedZ(Frame(1.0), plane), glm::dvec3(0), kTrunkId};
    }

    double strandsBetween(double before, double after) const {
        return before > 0 ? (1 - m_stage.share) * before + m_stage.share * after : after;
    }
    double diameterOf(double strands) const { return m_stage.diameter * m_params.strandThickness * std::sqrt(strands); }

    double value(StrandValueId id, const Growing& growing) const {
        const auto grown = m_grown.find(growing.id);
        return m_values[static_cast<std::size_t>(id)].at(grown == m_grown.end() ? growing.branch : *grown->second);
    }

    void growStem(const StemStart& start, CStrandGeneration& generation, std::vector<StemStart>& next) {
        CStem stem{};
        stem.id = start.first.id;
        stem.radius = start.first.branch.diameter / 2;
        stem.parent = start.parent;
        stem.position = start.position;
        stem.offset = start.offset;
        stem.parentRadius = start.parentRadius;
        stem.atNode = start.parent >= 0;
        stem.firstPath = static_cast<std::uint32_t>(generation.paths.size());
        stem.firstSegment = static_cast<std::uint32_t>(generation.segments.size());
        stem.pathCount = 1;
        const auto number = static_cast<std::int32_t>(generation.stems.size());
        for (std::optional<Growing> growing = start.first; growing;) {
            std::optional<Growing> leader, aside;
            if (growing->after > 1) part(*growing, leader, aside);
            addSegment(*growing, endDiameter(*growing, leader), stem, generation);
            if (aside)
                next.push_back({*aside, number, stem.segmentCount - 1, stem.length, generation.segments.back().radiusEnd});
            growing = leader;
        }
        generation.paths.push_back({stem.id, stem.firstSegment, stem.segmentCount, 0, -1});
        generation.stems.push_back(stem);
    }

    void addSegment(const Growing& growing, double endDiameter, CStem& stem, CStrandGeneration& generation) {
        generation.segments.push_back({growing.base, growing.frame, stem.length, growing.length, growing.branch.diameter / 2,
                                       endDiameter / 2, 0, false});
        generation.branches.push_back(growing.branch);
        m_height = std::max(m_height, generation.segments.back().axisPoint(1).z);
        stem.length += growing.length;
        ++stem.segmentCount;
    }

    /// A tip that begins to split widens to its leader.
    double endDiameter(const Growing& growing, const std::optional<Growing>& leader) const {
        const double tip = kTipWidth * growing.branch.diameter;
        if (!leader) return tip;
        const double grown = leader->branch.share;
        return grown < 1 ? (1 - grown) * tip + grown * leader->branch.diameter : leader->branch.diameter;
    }

    /// Zamuda & Strnad, eq. 1-4.
    void part(const Growing& below, std::optional<Growing>& leader, std::optional<Growing>& aside) const {
        const StrandBranch& branch = below.branch;
        const double share = value(StrandValueId::Share, below);
        const double leads = leaderOf(below.after, share), led = below.before > 1 ? leaderOf(below.before, share) : 0;
        const double leftBefore = below.before > 1 ? below.before - led : 0;
        const double s2 = strandsBetween(leftBefore, below.after - leads), s0 = branch.strands;
        const double angle = varied(value(StrandValueId::SplitAngle, below), below.id);
        const double leaderTurn = value(StrandValueId::LeaderTurn, below) * std::sqrt(s2 / s0) * angle;
        const double plane = radians(value(StrandValueId::PlaneTurn, below)) + m_random.vary(variation() * kPlaneVariation, below.id, kDrawPlaneTurn);
        const Frame turned = rotatedZ(below.frame, plane);
        leader = child(below, led, leads, rotatedX(turned, radians(leaderTurn)), 0, kLeader);
        aside = child(below, leftBefore, below.after - leads, rotatedX(turned, -radians(angle - leaderTurn)), 1, kAside);
    }

    /// How many of so many strands the leader gets.
    static double leaderOf(double strands, double share) { return 1 + std::ceil(share * (strands - 2) - kBelowWhole); }

    double variation() const { return m_varied ? m_params.strandVariation : 0; }
    double varied(double angle, std::uint64_t path) const {
        return std::clamp(angle * (1 + m_random.vary(variation() * kSplitVariation, path, kDrawSplitAngle)), 0.0, 180.0);
    }

    Growing child(const Growing& below, double before, double after, const Frame& frame, std::uint32_t turns, std::uint64_t step) const {
        const StrandBranch& branch = below.branch;
        const double strands = strandsBetween(before, after), share = before > 0 || m_stage.share == 0 ? 1 : m_stage.share;
        const double least = value(StrandValueId::LengthLeast, below), most = value(StrandValueId::LengthMost, below);
        const double inherited = std::max(std::min(std::sqrt(strands / branch.strands), most), least) * branch.inherited;
        const glm::dvec3 base = below.base + below.length * below.frame[2];
        return {{strands, inherited, base.z, branch.rootLength + below.length, share * diameterOf(strands), branch.order + turns,
                 branch.depth + 1, share},
                before, after, share * value(StrandValueId::LengthFactor, below) * inherited,
                hung(frame, radians(value(StrandValueId::Hanging, below))), base, hashCombine(below.id, step)};
    }

    const StrandsParams& m_params;
    Stage m_stage;
    CRandom m_random;
    bool m_varied, m_turned;
    std::vector<CValueCurves> m_values; ///< by StrandValueId
    std::unordered_map<std::uint64_t, const StrandBranch*> m_grown; ///< by path; empty: the branches' own
    double m_height = 0;
};

/// Places organs on the ends of one strand.
class CStrandOrgans {
public:
    CStrandOrgans(const CParams& params, const CTree& tree, Organ organ)
        : m_params(strands(params)), m_tree(tree), m_organ(organ), m_pose(poseOf(params.common, organ)),
          m_perTwig(perTwig(params, organ)), m_whorl(organ == Organ::Leaf ? params.common.leafWhorl : 1) {}

    static int perTwig(const CParams& params, Organ organ) {
        switch (organ) {
        case Organ::Blossom: return params.common.blossoms;
        case Organ::Fruit: return params.common.fruits;
        default: return static_cast<int>(std::lround(strands(params).stemLeaves * params.common.leafQuality));
        }
    }

    std::shared_ptr<const COrgans> grow(const OrganDemand& demand, const CProgress& progress) const {
        std::vector<std::vector<std::uint32_t>> counts(m_tree.generationCount());
        if (m_perTwig > 0)
            for (std::size_t g = 0; g < counts.size(); ++g)
                for (const CStem& stem : m_tree.generation(g).stems)
                    counts[g].push_back(static_cast<std::uint32_t>(tipSplits(g, stem) ? 2 * m_perTwig : m_perTwig));
        return placeOrgans(
            std::move(counts), demand, [this](const OrganSite& site) { return idOf(site); },
            [this](const OrganSite& site) { return place(site); }, progress);
    }

private:
    std::uint64_t idOf(const OrganSite& site) const {
        const CStem& stem = m_tree.generation(site.generation).stems[site.stem];
        return hashCombine(hashCombine(stem.id, kDrawStrandOrgan + static_cast<std::uint64_t>(m_organ)), site.number);
    }

    const StrandBranch& branchOf(std::size_t generation, std::uint32_t segment) const {
        return static_cast<const CStrandGeneration&>(m_tree.generation(generation)).branches[segment];
    }
    /// Whether the last branch has just appeared: then that below it still bears what it had.
    bool tipSplits(std::size_t generation, const CStem& stem) const {
        return stem.segmentCount > 1 && branchOf(generation, stem.firstSegment + stem.segmentCount - 1).share < 1;
    }

    /// Evenly along the twig: the i-th of m nodes at (i + 1/2) / m.
    CLeaf place(const OrganSite& site) const {
        const CGeneration& all = m_tree.generation(site.generation);
        const CStem& stem = all.stems[site.stem];
        const auto perTwig = static_cast<std::uint32_t>(m_perTwig), whorl = static_cast<std::uint32_t>(m_whorl);
        const std::uint32_t tip = stem.firstSegment + stem.segmentCount - 1, number = site.number % perTwig;
        const bool below = site.number >= perTwig;
        const double share = branchOf(site.generation, tip).share, size = below ? 1 - share : share;
        const CSegment& twig = all.segments[below ? tip - 1 : tip];
        const std::uint32_t node = number / whorl, nodes = (perTwig + whorl - 1) / whorl;
        const glm::dvec3 position = twig.axisPoint((node + 0.5) / nodes);
        const double inWhorl = double(number % whorl) / whorl;
        const double turn = m_params.leafRotate.radians() * node + 2 * std::numbers::pi * inWhorl;
        const Frame off = rotatedX(rotatedZ(twig.frame, turn), m_params.leafDownAngle.radians());
        const Frame frame = m_pose.applied(off, position);
        return {glm::vec3(position), glm::vec3(frame[2]), glm::vec3(frame[1]), static_cast<float>(size * m_pose.length),
                static_cast<float>(size * m_pose.width), site.stem, site.generation, site.number};
    }

    const StrandsParams& m_params;
    const CTree& m_tree;
    Organ m_organ;
    OrganPose m_pose;
    int m_perTwig, m_whorl;
};

/// Whether some curve needs to know where its branches are.
bool runsOverTheTree(const CParams& params) {
    return std::ranges::any_of(strandValues(), [&](const StrandValue& value) { return overOf(*value.byOrder, params) != CurveOver::Order; });
}

SizeBound boundOf(const CParams& params, const CProgress& progress) {
    const auto tree = CStrandsBuilder().build(params, nullptr, 0, progress);
    SizeBound bound;
    bound.base = tree->base();
    bound.generations = boundsOf(*tree);
    bound.scratchPerSegment = sizeof(StrandBranch);
    for (const Organ organ : kOrgans)
        bound.organs[static_cast<std::size_t>(organ)] = std::max(0, CStrandOrgans::perTwig(params, organ)) * bound.stems();
    const auto leaves = CStrandOrgans(params, *tree, Organ::Leaf).grow(OrganDemand::none(), progress);
    bound.twigs = twigBoundOf(*tree, *leaves, poseOf(params.common, Organ::Leaf).length);
    return bound;
}
} // namespace

double StrandBranch::quantity(CurveOver over) const {
    switch (over) {
    case CurveOver::Height: return height;
    case CurveOver::RootLength: return rootLength;
    case CurveOver::Thickness: return 100 * diameter;
    default: return order;
    }
}

std::shared_ptr<const CTree> CStrandsBuilder::build(const CParams& params, const CTree* previous, int firstInvalid,
                                                    const CProgress& progress) const {
    const BaseForm base = baseFormOf(params.common);
    if (previous && firstInvalid >= static_cast<int>(previous->generationCount()))
        return std::make_shared<const CTree>(previous->height(), previous->generations(), base);
    CStrandWalk walk(params, m_varied);
    auto generations = walk.grow(progress);
    return std::make_shared<const CTree>(walk.height(), std::move(generations), base);
}

std::shared_ptr<const CTree> CStrandsBuilder::atAge(const CParams& params, const std::shared_ptr<const CTree>& grown, double age,
                                                    const CProgress& progress) const {
    if (age >= 1) return grown;
    const BaseForm base = baseFormOf(params.common);
    if (!(age > 0)) return std::make_shared<const CTree>(0, std::vector<std::shared_ptr<const CGeneration>>(), base);
    CStrandWalk walk(params, m_varied, age);
    if (runsOverTheTree(params)) walk.readCurvesOn(*grown);
    auto generations = walk.grow(progress);
    return std::make_shared<const CTree>(walk.height(), std::move(generations), base);
}

std::shared_ptr<const COrgans> CStrandsBuilder::growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                                           const OrganDemand& demand, const CProgress& progress) const {
    return CStrandOrgans(params, tree, organ).grow(demand, progress);
}

SizeBound strandsBound(const CParams& params, const CProgress& progress) {
    // A step of a hand asks several times for the same tree.
    thread_local std::optional<std::pair<CParams, SizeBound>> last;
    if (!last || !(last->first == params)) last = {params, boundOf(params, progress)};
    return last->second;
}

} // namespace stromar
