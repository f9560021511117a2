#include "Draw.h"
#include "CommonValues.h"
#include "Grown.h"
#include "LeafGrower.h"
#include "Maturity.h"
#include "Placement.h"
#include "StemAxis.h"
#include "Young.h"
#include "YoungOrgans.h"
#include "stromar/params/methods/weberpenn/TreeParams.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include "stromar/util/Parallel.h"
#include <cmath>
#include <iterator>
#include <numbers>

namespace stromar {

namespace {
constexpr std::uint64_t kTrunkId = 1;
constexpr double kTrunkPhase = 0.20710678118654752; // (√2 − 1) / 2
constexpr double kMinLength = 1e-5;             // metres; shorter stems are not grown
constexpr std::size_t kParentGrain = 16, kStemGrain = 64;

/// A place where a stem will grow, with all that its parent says about it.
struct Site {
    std::uint64_t id;
    double countPhase;
    Frame frame;
    glm::dvec3 base;
    StemMeasures measures; ///< length before pruning; radius not yet known
    StemMeasures parentMeasures;
    double woodThere;
    double birth;
    std::int32_t parent;
    std::uint32_t path, position;
};

template <typename Array>
void append(Array& whole, const Array& part) {
    whole.insert(whole.end(), part.begin(), part.end());
}

/// Appends `part`, whose indices count from its own arrays.
void append(CGrownGeneration& whole, CGrownGeneration&& part) {
    const auto paths = static_cast<std::uint32_t>(whole.paths.size());
    const auto segments = static_cast<std::uint32_t>(whole.segments.size());
    for (CStem& stem : part.stems) {
        stem.firstPath += paths;
        stem.firstSegment += segments;
    }
    for (CPath& path : part.paths) path.firstSegment += segments;
    append(whole.stems, part.stems);
    append(whole.paths, part.paths);
    append(whole.segments, part.segments);
    append(whole.scratch, part.scratch);
    append(whole.rotationPhase, part.rotationPhase);
    append(whole.density, part.density);
}

void reserve(CGrownGeneration& whole, const std::vector<CGrownGeneration>& parts) {
    std::size_t stems = 0, paths = 0, segments = 0;
    for (const CGrownGeneration& part : parts) {
        stems += part.stems.size();
        paths += part.paths.size();
        segments += part.segments.size();
    }
    whole.stems.reserve(stems);
    whole.scratch.reserve(stems);
    whole.paths.reserve(paths);
    whole.rotationPhase.reserve(paths);
    whole.segments.reserve(segments);
    whole.density.reserve(segments);
}

/// Finds where children of one generation grow on the stems of the one before.
class CSiteFinder {
public:
    /// `base` is the form of the parents' bases.
    CSiteFinder(const CTreeParams& parents, const BaseForm& base, const CTreeParams& children, const CRandom& random)
        : m_parents(parents), m_base(base), m_children(children), m_random(random) {}

    std::vector<Site> find(const CGrownGeneration& generation, const CProgress& progress) const {
        const std::size_t count = generation.stems.size();
        std::vector<std::vector<Site>> parts((count + kParentGrain - 1) / kParentGrain);
        parallelFor(
            count, kParentGrain,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t s = begin; s < end; ++s)
                    findOn(generation, static_cast<std::int32_t>(s), parts[begin / kParentGrain]);
            },
            progress);
        std::vector<Site> sites;
        for (std::vector<Site>& part : parts)
            if (sites.empty())
                sites = std::move(part);
            else
                sites.insert(sites.end(), part.begin(), part.end());
        return sites;
    }

private:
    void findOn(const CGrownGeneration& generation, std::int32_t parent, std::vector<Site>& sites) const {
        const auto p = static_cast<std::size_t>(parent);
        const CStem& stem = generation.stems[p];
        const LevelParams& level = m_children.level();
        const double number = m_parents.calc().childCount(level.branches, generation.measuresOf(p)) / level.whorl;
        const double phase = generation.scratch[p].countPhase;
        const double error = centred(phase + 1.0 / 3 + m_random.phase(stem.id, kDrawCountPhase));
        CRotation rotation(level.rotate.radians());
        std::uint32_t path = stem.pathCount;
        distribute(generation, stem, m_parents.calc().bareLength(), number, error, [&](const SegmentShare& share) {
            if (share.path != path) rotation.startPath(generation.rotationPhase[stem.firstPath + share.path]);
            path = share.path;
            for (int i = 0; i < share.count; ++i) addNode(generation, parent, share, i, rotation, sites);
        });
    }

    /// A branch, or a whorl of them.
    void addNode(const CGrownGeneration& generation, std::int32_t parent, const SegmentShare& share, int node,
                 CRotation& rotation, std::vector<Site>& sites) const {
        const LevelParams& level = m_children.level();
        const CStem& stem = generation.stems[static_cast<std::size_t>(parent)];
        double w = 0, turn = 0;
        for (int j = 0; j < level.whorl; ++j) {
            const int i = node * level.whorl + j;
            const std::uint64_t id = siteId(stem, generation.paths[stem.firstPath + share.path], share.position, i);
            const double variation = m_random.vary(level.rotateV.radians(), id, kDrawRotation);
            if (j == 0) {
                w = placeInSegment(share, node, level.branchDist, m_random.vary(level.branchDistV, id, kDrawPlace));
                turn = rotation.next(variation);
            }
            const double around = turn + 2 * std::numbers::pi * j / level.whorl + (j > 0 ? variation : 0);
            const Site site = makeSite(generation, parent, share, i, id, w, around);
            if (site.measures.length > kMinLength) sites.push_back(site);
        }
    }

    Site makeSite(const CGrownGeneration& generation, std::int32_t parent, const SegmentShare& share, int i,
                  std::uint64_t id, double w, double turn) const {
        const auto p = static_cast<std::size_t>(parent);
        const CStem& stem = generation.stems[p];
        const StemMeasures measures = generation.measuresOf(p);
        const CSegment& segment = generation.segments[share.segment];
        const LevelParams& level = m_children.level();
        Site site{};
        site.id = id;
        site.countPhase = fraction(generation.scratch[p].countPhase + 0.6180339887498949 * (i + 1) + 0.7320508075688772 * share.position +
                            0.41421356237309515 * share.path);
        const double offset = (share.position + w) * segment.length;
        const double down =
            downAngle(level, m_parents.calc(), measures, offset, m_random.uniform(site.id, kDrawDownAngle));
        site.frame = rotatedX(rotatedZ(segment.frame, turn), down);
        site.base = segment.centre(w);
        site.measures.lengthMax = level.length + m_random.vary(level.lengthV, site.id, kDrawLength);
        site.measures.length = m_children.calc().length(site.measures.lengthMax, measures, offset);
        site.measures.offset = offset;
        site.measures.parentLength = stem.length;
        site.parentMeasures = measures;
        site.woodThere = woodRadius(measures, offset);
        site.birth = passedAt(stem.birth, offset / stem.length);
        site.parent = parent;
        site.path = share.path;
        site.position = share.position;
        return site;
    }

    /// The wood that a child has to fit on.
    double woodRadius(const StemMeasures& stem, double offset) const {
        const double tapered = taperProfile(m_parents.level().taper).radiusAt(offset, stem.length, stem.radius);
        return m_base.flare == 0 ? tapered : tapered * m_base.flareAt(offset / stem.length);
    }

    static std::uint64_t siteId(const CStem& stem, const CPath& path, std::uint32_t position, int i) {
        return hashCombine(hashCombine(stem.id, path.id),
                           (std::uint64_t{position} << 32) | static_cast<std::uint32_t>(i));
    }

    const CTreeParams& m_parents;
    BaseForm m_base;
    const CTreeParams& m_children;
    const CRandom& m_random;
};

/// Grows stems at their sites: form, pruning, radius, segments.
class CStemGrower {
public:
    CStemGrower(const CTreeParams& params, const CRandom& random)
        : m_params(params), m_taper(taperProfile(params.level().taper)), m_grower(params, random) {}

    void grow(const Site& site, CGrownGeneration& generation) {
        m_grower.grow(site.id, site.countPhase, site.frame, m_axis);
        StemMeasures measures = site.measures;
        if (site.parent >= 0) {
            measures.length = prunedLength(site);
            if (measures.length <= kMinLength) return;
            measures.radius = m_params.calc().childRadius(site.parentMeasures, measures.length, site.woodThere);
        }
        addStem(site, measures, generation);
    }

private:
    /// Weber & Penn §4.6; every segment's end of every path is tested.
    double prunedLength(const Site& site) const {
        const double original = site.measures.length, ratio = m_params.tree().pruneRatio;
        if (ratio == 0) return original;
        double fitted = original;
        while (!fits(site.base, fitted)) {
            fitted *= 0.9;
            if (fitted >= 0.05 * original) continue;
            fitted = 0;
            break;
        }
        return original * (1 - ratio) + fitted * ratio;
    }

    bool fits(const glm::dvec3& base, double length) const {
        for (const StemAxis::Segment& segment : m_axis.segments) {
            const glm::dvec3 end = base + length * m_axis.end(segment);
            if (!insideEnvelope(end.x, end.y, end.z, m_params.tree(), m_params.calc().scaleTree())) return false;
        }
        return true;
    }

    void addStem(const Site& site, const StemMeasures& measures, CGrownGeneration& generation) const {
        CStem stem{};
        stem.id = site.id;
        stem.length = measures.length;
        stem.radius = measures.radius;
        stem.offset = measures.offset;
        stem.parentRadius = site.woodThere;
        stem.profile = m_params.level().taper > 1 ? m_taper : RadiusProfile();
        stem.birth = site.birth;
        stem.parent = site.parent;
        stem.path = site.path;
        stem.position = site.position;
        stem.firstPath = static_cast<std::uint32_t>(generation.paths.size());
        stem.pathCount = static_cast<std::uint32_t>(m_axis.paths.size());
        stem.firstSegment = static_cast<std::uint32_t>(generation.segments.size());
        stem.segmentCount = static_cast<std::uint32_t>(m_axis.segments.size());
        for (CPath path : m_axis.paths) {
            for (std::uint32_t s = 0; s < path.segmentCount; ++s) {
                const StemAxis::Segment& form = m_axis.segments[path.firstSegment + s];
                generation.segments.push_back(makeSegment(site, stem, form, path.firstPosition + s));
                generation.density.push_back(form.density);
            }
            path.firstSegment += stem.firstSegment;
            generation.paths.push_back(path);
        }
        append(generation.rotationPhase, m_axis.rotationPhase);
        generation.stems.push_back(stem);
        generation.scratch.push_back({site.countPhase, measures.lengthMax, measures.parentLength});
    }

    CSegment makeSegment(const Site& site, const CStem& stem, const StemAxis::Segment& form,
                         std::uint32_t position) const {
        const double n = m_axis.curveRes, length = stem.length / n;
        const auto radius = [&](double along) { return m_taper.radiusAt(along, stem.length, stem.radius); };
        const double curveV = m_params.level().curveV.radians();
        return {.position = site.base + stem.length * form.position,
                .frame = form.frame,
                .start = position * length,
                .length = length,
                .radiusBase = radius(position * length),
                .radiusEnd = radius(position + 1 < n ? (position + 1) * length : stem.length),
                .helixRadius = curveV < 0 ? length * std::tan(-curveV) / (2 * std::numbers::pi) : 0,
                .forks = form.forks};
    }

    const CTreeParams& m_params;
    RadiusProfile m_taper;
    CAxisGrower m_grower;
    StemAxis m_axis;
};

std::shared_ptr<const CGrownGeneration> growStems(const CTreeParams& params, const CRandom& random,
                                             const std::vector<Site>& sites, const CProgress& progress) {
    std::vector<CGrownGeneration> parts((sites.size() + kStemGrain - 1) / kStemGrain);
    parallelFor(
        sites.size(), kStemGrain,
        [&](std::size_t begin, std::size_t end) {
            CStemGrower grower(params, random);
            for (std::size_t s = begin; s < end; ++s) grower.grow(sites[s], parts[begin / kStemGrain]);
        },
        progress);
    auto generation = std::make_shared<CGrownGeneration>();
    generation->curveRes = static_cast<std::uint32_t>(params.level().curveRes);
    reserve(*generation, parts);
    for (CGrownGeneration& part : parts) append(*generation, std::move(part));
    return generation;
}

/// Where the i-th of several trunks stands, seeds in a sunflower: 0..1 of the spread, and at which angle.
std::pair<double, double> placeOfTrunk(int i, int count) {
    constexpr double kGoldenAngle = 2.399963229728653;
    return {count == 1 ? 0 : std::sqrt((i + 0.5) / (count - 0.5)), i * kGoldenAngle};
}

Site trunkSite(const CTreeParams& params, const CRandom& random, int i) {
    const WeberPennParams& g = params.tree();
    const auto [out, around] = placeOfTrunk(i, g.trunks);
    Site site{};
    site.id = i == 0 ? kTrunkId : hashCombine(kTrunkId, static_cast<std::uint64_t>(i));
    site.countPhase = fraction(kTrunkPhase + 0.6180339887498949 * i);
    site.frame = Frame(1.0);
    if (g.trunks > 1) {
        site.base = out * g.trunksSpread * glm::dvec3(std::cos(around), std::sin(around), 0);
        site.frame = rotatedX(rotatedZ(site.frame, around + std::numbers::pi / 2), out * g.trunksLean.radians());
    }
    site.parent = -1;
    site.measures.lengthMax = params.level().length + random.vary(params.level().lengthV, site.id, kDrawLength);
    site.measures.length = params.calc().length(site.measures.lengthMax, {}, 0);
    const double factor = g.trunkScale + random.vary(g.trunkScaleV, site.id, kDrawTrunkScale);
    site.measures.radius = site.measures.length * g.ratio * std::max(factor, 0.1 * g.trunkScale);
    return site;
}

std::vector<Site> sitesOf(int generation, const std::vector<std::shared_ptr<const CGrownGeneration>>& grown,
                          const std::vector<CTreeParams>& params, const BaseForm& base, const CRandom& random,
                          const CProgress& progress) {
    const auto g = static_cast<std::size_t>(generation);
    if (generation > 0)
        return CSiteFinder(params[g - 1], g == 1 ? base : BaseForm(), params[g], random).find(*grown[g - 1], progress);
    std::vector<Site> trunks;
    for (int i = 0; i < params[0].tree().trunks; ++i)
        if (const Site trunk = trunkSite(params[0], random, i); trunk.measures.length > kMinLength)
            trunks.push_back(trunk);
    return trunks;
}

CRandom randomOf(const CParams& params, bool varied) {
    return {static_cast<std::uint64_t>(static_cast<std::int64_t>(params.common.seed)), varied};
}
} // namespace

double scaleOfTree(const CParams& params, bool varied) {
    const WeberPennParams& g = weberPenn(params);
    return std::max(g.scale + randomOf(params, varied).vary(g.scaleV, kTrunkId, kDrawTreeScale), 0.1 * g.scale);
}

std::shared_ptr<const CTree> CWeberPennBuilder::build(const CParams& params, const CTree* previous, int firstInvalid,
                                                      const CProgress& progress) const {
    const CRandom random = randomOf(params, m_varied);
    const double scale = scaleOfTree(params, m_varied);
    const BaseForm base = baseFormOf(params.common);
    const int levels = weberPenn(params).levels;
    std::vector<CTreeParams> seen;
    for (int g = 0; g < levels; ++g) seen.emplace_back(params, g, scale);
    std::vector<std::shared_ptr<const CGrownGeneration>> grown;
    for (int g = 0; g < levels; ++g) {
        progress.poll();
        const auto slot = static_cast<std::size_t>(g);
        const bool kept = previous && g < firstInvalid && slot < previous->generationCount();
        grown.push_back(kept ? std::static_pointer_cast<const CGrownGeneration>(previous->generations()[slot])
                             : growStems(seen[slot], random, sitesOf(g, grown, seen, base, random, progress), progress));
    }
    return std::make_shared<const CTree>(
        scale, std::vector<std::shared_ptr<const CGeneration>>(grown.begin(), grown.end()), base);
}

std::shared_ptr<const CTree> CWeberPennBuilder::atAge(const CParams& params, const std::shared_ptr<const CTree>& grown, double age,
                                                      const CProgress& progress) const {
    if (age >= 1) return grown;
    const auto young = youngGenerations(params, *grown, age, progress);
    return std::make_shared<const CTree>(maturity(age, 0) * grown->height(),
                                         std::vector<std::shared_ptr<const CGeneration>>(young.begin(), young.end()), grown->base());
}

std::shared_ptr<const COrgans> CWeberPennBuilder::growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                                             const OrganDemand& demand,
                                                             const CProgress& progress) const {
    if (tree.generationCount() == 0) return std::make_shared<const COrgans>();
    if (dynamic_cast<const CYoungGeneration*>(&tree.generation(0)))
        return growYoungOrgans(params, tree, organ, randomOf(params, m_varied), demand, progress);
    const OrganRule rule = organRule(params, organ);
    const int levels = weberPenn(params).levels;
    if (levels < 2 || rule.number == 0) return std::make_shared<const COrgans>();
    const CTreeParams bearing(params, levels - 1, tree.height()), leafLevel(params, levels, tree.height());
    return CLeafGrower(bearing, leafLevel, randomOf(params, m_varied), rule)
        .grow(grownOf(tree, static_cast<std::size_t>(levels) - 1), demand, progress);
}

} // namespace stromar
